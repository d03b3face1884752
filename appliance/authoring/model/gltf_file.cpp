#include "appliance/authoring/model/gltf_file.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "appliance/authoring/model/gltf_parse.h"

namespace kaori::model {
namespace {

// `numbers` holds whole rows of the vector's length.
template <class Vec>
std::vector<Vec> AsVectors(const std::vector<float>& numbers) {
  std::vector<Vec> vectors(numbers.size() / static_cast<std::size_t>(Vec::length()));
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (int k = 0; k < Vec::length(); ++k)
      vectors[i][k] = numbers[i * static_cast<std::size_t>(Vec::length()) + static_cast<std::size_t>(k)];
  return vectors;
}

// Builds the model mesh by mesh. A fault does not stop it, so that people are told all; Build then gives no
// model. Borrows the parsed file.
class Builder {
 public:
  Builder(const std::string& file, const tinygltf::Model& from, Findings& findings)
      : from_(from), findings_(findings) {
    model_.file = file;
  }

  // Presets and picture are looked for only in a file without a fault.
  std::optional<Model> Build() {
    // Findings may hold faults of other files already.
    const std::size_t before = findings_.size();
    for (const PlacedMesh& placed : PlacedMeshes(from_)) AddMesh(placed);
    if (findings_.size() == before && model_.triangles.empty())
      findings_.Add(model_.file, "", "holds no triangle");
    if (findings_.size() > before) return std::nullopt;
    // Meshes that come after a target's own have no offsets of it: they rest.
    for (Target& target : model_.targets) target.offsets.resize(model_.positions.size());
    model_.presets = VrmPresets(from_);
    FindPicture();
    return std::move(model_);
  }

 private:
  // The vertices of an accessor in the model.
  struct VertexRange {
    Index first = 0;
    Index count = 0;
  };
  Index VertexCount() const { return static_cast<Index>(model_.positions.size()); }

  // Names the mesh in work.
  void Fault(std::string_view reason) { findings_.Add(model_.file, item_, reason); }

  // Vertices are those of the file, primitive by primitive; nothing is welded, so that
  // several files correspond.
  void AddMesh(const PlacedMesh& placed) {
    const tinygltf::Mesh& mesh = from_.meshes[static_cast<std::size_t>(placed.mesh)];
    const std::string& name =
        // Tools name the node and leave the mesh nameless, or the other way round.
        mesh.name.empty() ? from_.nodes[static_cast<std::size_t>(placed.node)].name : mesh.name;
    item_ = fmt::format("mesh \"{}\"", name);
    const Index first = VertexCount();
    // Primitives of a mesh may share their vertices: by accessor of the positions.
    std::map<int, VertexRange> shared;
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (position == primitive.attributes.end()) {
        Fault("has no positions");
        continue;
      }
      const auto [at, fresh] = shared.emplace(position->second, VertexRange{VertexCount(), 0});
      if (fresh && !AddVertices(mesh, primitive, placed.to_world)) return;
      if (fresh) at->second.count = VertexCount() - at->second.first;
      // A node that mirrors turns the triangles inside out.
      AddTriangles(primitive, at->second, glm::determinant(glm::mat3(placed.to_world)) < 0);
    }
    model_.meshes.push_back({name, first, VertexCount() - first});
  }

  // The numbers of an accessor as vectors; none, and a fault that begins with `what`, where they cannot be
  // read or have another number of columns.
  template <class Vec>
  std::optional<std::vector<Vec>> Read(int accessor, const std::string& what) {
    const auto found = FindAccessor(from_, accessor);
    if (!found || found->base.columns != Vec::length()) {
      Fault(what + ": no such numbers in the file, or its buffer ends before them");
      return std::nullopt;
    }
    const Numbers numbers = ReadNumbers(*found);
    if (numbers.fault.empty()) return AsVectors<Vec>(numbers.values);
    Fault(fmt::format("{}: {}", what, numbers.fault));
    return std::nullopt;
  }

  // False where there are no positions, or too many: nothing else of the mesh can then be read.
  bool AddVertices(const tinygltf::Mesh& mesh, const tinygltf::Primitive& primitive,
                   const glm::mat4& to_world) {
    const std::size_t first = model_.positions.size();
    const auto positions = Read<glm::vec3>(primitive.attributes.at("POSITION"), "positions");
    if (!positions) return false;
    if (first + positions->size() > kMostVertices) {
      Fault(fmt::format("has more than {} vertices", kMostVertices));
      return false;
    }
    for (const glm::vec3& p : *positions) model_.positions.emplace_back(to_world * glm::vec4(p, 1));
    AddPlaces(primitive, positions->size());
    AddTargets(mesh, primitive, first, glm::mat3(to_world));
    return true;
  }

  // In glTF, v runs down. Places are filled up with zeros after a fault, so that the lists stay
  // of one length.
  void AddPlaces(const tinygltf::Primitive& primitive, std::size_t count) {
    const auto at = primitive.attributes.find("TEXCOORD_0");
    if (at == primitive.attributes.end()) {
      Fault("has no texture coordinates, which are its parameter space");
    } else if (const auto uv = Read<glm::vec2>(at->second, "texture coordinates")) {
      if (uv->size() != count)
        Fault(fmt::format("{} texture coordinates for {} vertices", uv->size(), count));
      for (const glm::vec2& p : *uv) model_.uv.emplace_back(p.x, 1 - p.y);
    }
    model_.uv.resize(model_.positions.size());
  }

  // Every mesh has its own targets; those of one name are one shape (a blink moves skin and lashes). `turn`
  // leads offsets as the node turns its mesh; a shift does not change them.
  void AddTargets(const tinygltf::Mesh& mesh, const tinygltf::Primitive& primitive, std::size_t first,
                  const glm::mat3& turn) {
    const std::size_t count = model_.positions.size() - first;
    const std::vector<std::string> names = TargetNames(mesh, primitive.targets.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto at = primitive.targets[i].find("POSITION");
      // A target may move normals alone.
      if (at == primitive.targets[i].end()) continue;
      Target* target = FindTarget(names[i]);
      if (target == nullptr) return;
      const auto offsets = Read<glm::vec3>(at->second, fmt::format("target \"{}\"", names[i]));
      if (!offsets) continue;
      if (offsets->size() != count) {
        Fault(fmt::format("target \"{}\": {} offsets for {} vertices", names[i], offsets->size(), count));
        continue;
      }
      target->offsets.resize(model_.positions.size());
      for (std::size_t v = 0; v < count; ++v) target->offsets[first + v] = turn * (*offsets)[v];
    }
  }

  // The target of this name, made where there is none. Null, and a fault, beyond the bounds of model.h.
  Target* FindTarget(const std::string& name) {
    const auto same = std::ranges::find(model_.targets, name, &Target::name);
    if (same != model_.targets.end()) return &*same;
    const bool too_many = model_.targets.size() >= kMostTargets ||
                          (model_.targets.size() + 1) * model_.positions.size() > kMostOffsets;
    if (too_many) {
      Fault(fmt::format("has more than {} targets, or too many offsets", kMostTargets));
      return nullptr;
    }
    model_.targets.push_back({name, {}});
    return &model_.targets.back();
  }

  // Strips, fans, lines and points are refused, and corners beyond the vertices of the primitive, whatever
  // other primitives have added since.
  void AddTriangles(const tinygltf::Primitive& primitive, const VertexRange& vertices, bool mirrored) {
    // The library says -1 where the file says nothing, which means triangles.
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1)
      return Fault("is not made of triangles");
    std::vector<std::uint32_t> corners;
    if (primitive.indices < 0) {
      // Without indices, three vertices in a row are a triangle.
      for (Index i = 0; i < vertices.count; ++i) corners.push_back(i);
    } else {
      const auto found = FindAccessor(from_, primitive.indices);
      Indices indices = found ? ReadIndices(found->base)
                              : Indices{{}, "no such numbers in the file, or its buffer ends before them"};
      if (!indices.fault.empty()) return Fault("triangles: " + indices.fault);
      corners = std::move(indices.values);
    }
    if (corners.size() % 3 != 0) return Fault("the last triangle is not whole");
    if (model_.triangles.size() + corners.size() / 3 > kMostTriangles) return Fault("has too many triangles");
    // Counted from the first of the vertices.
    const auto beyond =
        std::ranges::count_if(corners, [&](Index corner) { return corner >= vertices.count; });
    if (beyond > 0) return Fault(fmt::format("{} corners name vertices that do not exist", beyond));
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      Triangle t{vertices.first + corners[i], vertices.first + corners[i + 1],
                 vertices.first + corners[i + 2]};
      if (mirrored) std::swap(t[1], t[2]);
      model_.triangles.push_back(t);
    }
  }

  void FindPicture() {
    // The first material that has a picture; a head whose parts have pictures of their own shows
    // that one everywhere.
    for (const tinygltf::Material& material : from_.materials) {
      const int texture = material.pbrMetallicRoughness.baseColorTexture.index;
      if (texture < 0) continue;
      const bool exists = static_cast<std::size_t>(texture) < from_.textures.size();
      const int image = exists ? from_.textures[static_cast<std::size_t>(texture)].source : -1;
      const bool found = image >= 0 && static_cast<std::size_t>(image) < from_.images.size();
      if (found) model_.picture = from_.images[static_cast<std::size_t>(image)].image;
      if (!model_.picture.empty()) return;
      findings_.Add(model_.file, fmt::format("material \"{}\"", material.name), "its texture is missing");
      return;
    }
  }

  const tinygltf::Model& from_;
  Findings& findings_;
  Model model_;
  std::string item_;
};

}  // namespace

std::optional<Model> ReadGltf(const std::string& file, std::span<const std::uint8_t> bytes,
                              const ReadBeside& beside, Findings& findings) {
  const auto parsed = ParseGltf(file, bytes, beside, findings);
  if (!parsed) return std::nullopt;
  return Builder(file, *parsed, findings).Build();
}

}  // namespace kaori::model
