#include "appliance/authoring/model/gltf_parse.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace kaori::model {
namespace {

// Extensions that a file may require. Those of materials change nothing that is read; a head in VRM
// 0.x declares "VRM".
constexpr std::array<std::string_view, 4> kUnderstood{"KHR_mesh_quantization", "KHR_materials_unlit",
                                                      "KHR_texture_transform", "VRM"};
// Far more than the bones of any figure.
constexpr std::size_t kMostNodes = 20'000;

// What the library asks about files, answered by `beside`, so that it opens none itself. `beside` must
// outlive the reading; the library's C callbacks take it as void*, and only read it.
tinygltf::FsCallbacks FilesBeside(const ReadBeside& beside) {
  tinygltf::FsCallbacks files{};
  files.FileExists = [](const std::string& name, void* user) {
    return (*static_cast<const ReadBeside*>(user))(name).has_value();
  };
  files.ExpandFilePath = [](const std::string& name, void*) { return name; };
  files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error, const std::string& name,
                           void* user) {
    auto bytes = (*static_cast<const ReadBeside*>(user))(name);
    if (bytes) *out = std::move(*bytes);
    if (!bytes && error != nullptr) *error += "cannot read " + name + "\n";
    return bytes.has_value();
  };
  // Nothing is ever written.
  files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  files.user_data = const_cast<ReadBeside*>(&beside);
  return files;
}

// Pictures stay as they are in the file, PNG or JPEG; DecodePicture reads them with bounds of its own.
// NOLINTNEXTLINE(readability-function-size): the library says which parameters it calls with.
bool KeepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                 const unsigned char* bytes, int size, void*) {
  image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

// The header of .glb: magic, version, length (glTF 2.0, section 4.4.2). The ending of the name
// does not count.
bool IsBinary(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kMagic = "glTF";
  return bytes.size() >= 4 && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

// The library's remarks are several lines; people are told the first.
std::string FirstLine(const std::string& text) {
  return text.empty() ? "is no glTF file" : text.substr(0, text.find('\n'));
}

// Node to parent: a matrix where there is one, else translation * rotation * scale (glTF 2.0, section 3.5.3).
// glTF writes quaternions as x, y, z, w; glm's constructor wants w first.
glm::mat4 Local(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return glm::mat4(glm::make_mat4(node.matrix.data()));
  glm::mat4 local(1);
  const auto& t = node.translation;
  const auto& r = node.rotation;
  const auto& s = node.scale;
  if (t.size() == 3) local = glm::translate(local, glm::vec3(t[0], t[1], t[2]));
  if (r.size() == 4) local *= glm::mat4_cast(glm::quat(glm::dquat(r[3], r[0], r[1], r[2])));
  if (s.size() == 3) local = glm::scale(local, glm::vec3(s[0], s[1], s[2]));
  return local;
}

// A walk through the scenes with a stack of its own: a file's depth is not to be trusted to ours. A node may
// be reached once: the graph of a valid file is a forest, and a wrong one must have an end.
class Walk {
 public:
  explicit Walk(const tinygltf::Model& model) : model_(model), seen_(model.nodes.size()) {}

  // All scenes count, not only the one that the file opens with.
  std::vector<PlacedMesh> All() {
    std::vector<int> roots;
    for (const tinygltf::Scene& scene : model_.scenes)
      roots.insert(roots.end(), scene.nodes.begin(), scene.nodes.end());
    if (roots.empty()) roots = Parentless();
    // The stack is last in, first out: pushed backwards, nodes are visited in the file's order, which Model's
    // order of vertices follows.
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) pending_.push_back({*root, glm::mat4(1)});
    while (!pending_.empty()) Step();
    return std::move(placed_);
  }

 private:
  struct Pending {
    int node;
    glm::mat4 parent;
  };

  // The roots of a file that names no scene: nodes that are nobody's children.
  std::vector<int> Parentless() const {
    std::vector<bool> is_child(model_.nodes.size());
    for (const tinygltf::Node& node : model_.nodes)
      for (const int child : node.children)
        if (child >= 0 && static_cast<std::size_t>(child) < is_child.size())
          is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
  }

  void Step() {
    const Pending at = pending_.back();
    pending_.pop_back();
    const auto index = static_cast<std::size_t>(at.node);
    if (at.node < 0 || index >= seen_.size() || seen_[index] || ++visited_ > kMostNodes) return;
    seen_[index] = true;
    const tinygltf::Node& node = model_.nodes[index];
    const glm::mat4 to_world = at.parent * Local(node);
    const bool has_mesh = node.mesh >= 0 && static_cast<std::size_t>(node.mesh) < model_.meshes.size();
    // A skinned mesh is placed by its joints, which stand for the rest pose; its node's place does not count.
    if (has_mesh) placed_.push_back({node.mesh, at.node, node.skin >= 0 ? glm::mat4(1) : to_world});
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      pending_.push_back({*child, to_world});
  }

  const tinygltf::Model& model_;
  std::vector<bool> seen_;
  std::vector<Pending> pending_;
  std::vector<PlacedMesh> placed_;
  std::size_t visited_ = 0;
};

// Null for an index that is not there.
template <class T>
const T* At(const std::vector<T>& all, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < all.size() ? &all[static_cast<std::size_t>(index)]
                                                                    : nullptr;
}

// The bytes of a buffer view from `offset_bytes` on. Comparisons are written so that no sum can overflow.
std::optional<Bytes> View(const tinygltf::Model& model, int view, std::size_t offset_bytes) {
  const tinygltf::BufferView* from = At(model.bufferViews, view);
  const tinygltf::Buffer* buffer = from == nullptr ? nullptr : At(model.buffers, from->buffer);
  if (buffer == nullptr) return std::nullopt;
  const Bytes all(buffer->data.data(), buffer->data.size());
  if (from->byteOffset > all.size() || from->byteLength > all.size() - from->byteOffset) return std::nullopt;
  const Bytes bytes = all.subspan(from->byteOffset, from->byteLength);
  if (offset_bytes > bytes.size()) return std::nullopt;
  return bytes.subspan(offset_bytes);
}

// 0 for matrices and for types that do not exist; ReadNumbers refuses it.
int Columns(int type) {
  const int columns = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
  return columns < 1 || columns > 4 ? 0 : columns;
}

// None where counts or offsets are negative, or views do not exist.
std::optional<Sparse> FindSparse(const tinygltf::Model& model, const tinygltf::Accessor& from) {
  const auto& sparse = from.sparse;
  if (sparse.count < 1 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) return std::nullopt;
  const auto at = View(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset));
  const auto values =
      View(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset));
  if (!at || !values) return std::nullopt;
  const auto count = static_cast<std::size_t>(sparse.count);
  return Sparse{{*at, 0, static_cast<Component>(sparse.indices.componentType), 1, count},
                {*values, 0, static_cast<Component>(from.componentType), Columns(from.type), count}};
}

}  // namespace

std::optional<tinygltf::Model> ParseGltf(const std::string& file, std::span<const std::uint8_t> bytes,
                                         const ReadBeside& beside, Findings& findings) {
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(FilesBeside(beside));
  reader.SetImageLoader(KeepEncoded, nullptr);
  // Made in place: the library's model is large, and need not be moved.
  std::optional<tinygltf::Model> model(std::in_place);
  std::string error;
  std::string warning;
  const auto size = static_cast<unsigned>(bytes.size());
  // The last argument of the reader is a folder for files beside this one; names go to `beside` as they are.
  const bool ok = IsBinary(bytes)
                      ? reader.LoadBinaryFromMemory(&*model, &error, &warning, bytes.data(), size)
                      : reader.LoadASCIIFromString(&*model, &error, &warning,
                                                   reinterpret_cast<const char*>(bytes.data()), size, "");
  if (!ok) {
    findings.Add(file, "", FirstLine(error));
    return std::nullopt;
  }
  for (const std::string& extension : model->extensionsRequired) {
    if (std::ranges::find(kUnderstood, extension) != kUnderstood.end()) continue;
    findings.Add(file, "", fmt::format("needs the extension {}, which is not understood", extension));
    return std::nullopt;
  }
  return model;
}

// Views are compared with their buffers here, whatever the library has checked.
std::optional<Accessor> FindAccessor(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor* from = At(model.accessors, index);
  if (from == nullptr) return std::nullopt;
  Accessor accessor;
  accessor.normalised = from->normalized;
  accessor.base = {{}, 0, static_cast<Component>(from->componentType), Columns(from->type), from->count};
  if (from->sparse.isSparse) {
    accessor.sparse = FindSparse(model, *from);
    if (!accessor.sparse) return std::nullopt;
  }
  // Without a view, an accessor is all zero, which says something only where sparse rows replace some.
  if (from->bufferView < 0) return accessor.sparse ? std::optional(accessor) : std::nullopt;
  const auto bytes = View(model, from->bufferView, from->byteOffset);
  if (!bytes) return std::nullopt;
  accessor.base.bytes = *bytes;
  accessor.base.stride_bytes = model.bufferViews[static_cast<std::size_t>(from->bufferView)].byteStride;
  return accessor;
}

std::vector<PlacedMesh> PlacedMeshes(const tinygltf::Model& model) {
  return Walk(model).All();
}

// glTF 2.0 gives targets no names; mesh.extras.targetNames is what its implementation note says that tools
// write.
std::vector<std::string> TargetNames(const tinygltf::Mesh& mesh, std::size_t count) {
  std::vector<std::string> names;
  const tinygltf::Value* given = mesh.extras.Has("targetNames") ? &mesh.extras.Get("targetNames") : nullptr;
  for (std::size_t i = 0; i < count; ++i) {
    // A file that is wrong may have fewer names than targets, or numbers for names.
    const bool named =
        given != nullptr && i < given->ArrayLen() && given->Get(static_cast<int>(i)).IsString();
    names.push_back(named ? given->Get(static_cast<int>(i)).Get<std::string>() : fmt::format("target {}", i));
  }
  return names;
}

}  // namespace kaori::model
