#include "tests/appliance/authoring/import_glb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kaori::model {

int GlbMaker::AddView(const std::vector<std::uint8_t>& bytes, int stride_bytes) {
  while (buffer_.size() % 4 != 0) buffer_.push_back(0);
  const std::string stride = stride_bytes > 0 ? fmt::format(",\"byteStride\":{}", stride_bytes) : "";
  views_.push_back(fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}{}}}", buffer_.size(),
                               bytes.size(), stride));
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  return static_cast<int>(views_.size()) - 1;
}

int GlbMaker::AddAccessor(int view, Component component, std::size_t count, const std::string& type,
                          const std::string& extra) {
  const std::string in = view < 0 ? "" : fmt::format("\"bufferView\":{},", view);
  accessors_.push_back(fmt::format("{{{}\"componentType\":{},\"count\":{},\"type\":\"{}\"{}{}}}", in,
                                   static_cast<int>(component), count, type, extra.empty() ? "" : ",",
                                   extra));
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbMaker::AddVec3(const std::vector<glm::vec3>& values) {
  return AddAccessor(AddView(BytesOf(values)), Component::kFloat, values.size(), "VEC3");
}

int GlbMaker::AddVec2(const std::vector<glm::vec2>& values) {
  return AddAccessor(AddView(BytesOf(values)), Component::kFloat, values.size(), "VEC2");
}

int GlbMaker::AddIndices(const std::vector<Triangle>& triangles) {
  return AddAccessor(AddView(BytesOf(triangles)), Component::kUint32, 3 * triangles.size(), "SCALAR");
}

void GlbMaker::AddModel(const Model& model, const std::string& name) {
  std::vector<glm::vec2> uv;
  for (const glm::vec2& p : model.uv) uv.emplace_back(p.x, 1 - p.y);
  const int positions = AddVec3(model.positions);
  const std::string places = uv.empty() ? "" : fmt::format(",\"TEXCOORD_0\":{}", AddVec2(uv));
  const int indices = AddIndices(model.triangles);
  std::vector<std::string> targets;
  std::vector<std::string> names;
  for (const Target& target : model.targets) {
    targets.push_back(fmt::format("{{\"POSITION\":{}}}", AddVec3(target.offsets)));
    names.push_back('"' + target.name + '"');
  }
  const std::string morphs = targets.empty() ? "" : fmt::format(",\"targets\":[{}]", fmt::join(targets, ","));
  AddMesh(fmt::format(
      "{{\"name\":\"{}\",\"primitives\":[{{\"attributes\":{{\"POSITION\":{}{}}},\"indices\":{}{}}}],"
      "\"extras\":{{\"targetNames\":[{}]}}}}",
      name, positions, places, indices, morphs, fmt::join(names, ",")));
  AddNode(fmt::format("{{\"mesh\":{}}}", meshes_.size() - 1));
}

std::string GlbMaker::Json() const {
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < nodes_.size(); ++i) roots.push_back(i);
  return fmt::format(
      "{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],"
      "\"meshes\":[{}],"
      "\"buffers\":[{{\"byteLength\":{}}}],\"bufferViews\":[{}],\"accessors\":[{}]{}}}",
      fmt::join(roots, ","), fmt::join(nodes_, ","), fmt::join(meshes_, ","), buffer_.size(),
      fmt::join(views_, ","), fmt::join(accessors_, ","), extra_);
}

std::vector<std::uint8_t> GlbMaker::Glb() const {
  std::string json = Json();
  while (json.size() % 4 != 0) json += ' ';
  std::vector<std::uint8_t> binary = buffer_;
  while (binary.size() % 4 != 0) binary.push_back(0);
  constexpr std::uint32_t kMagic = 0x46546C67;
  constexpr std::uint32_t kJson = 0x4E4F534A;
  constexpr std::uint32_t kBinary = 0x004E4942;
  const auto json_bytes = static_cast<std::uint32_t>(json.size());
  const auto binary_bytes = static_cast<std::uint32_t>(binary.size());
  std::vector<std::uint8_t> glb =
      BytesOf<std::uint32_t>({kMagic, 2, 28 + json_bytes + binary_bytes, json_bytes, kJson});
  glb.insert(glb.end(), json.begin(), json.end());
  const auto header = BytesOf<std::uint32_t>({binary_bytes, kBinary});
  glb.insert(glb.end(), header.begin(), header.end());
  glb.insert(glb.end(), binary.begin(), binary.end());
  return glb;
}

Model Plate(int cells, bool slit) {
  Model plate;
  plate.file = "plate";
  const int columns = cells + 1;
  const float step = 0.1F / static_cast<float>(cells);
  const auto add = [&](int column, int row) {
    plate.positions.emplace_back(static_cast<float>(column) * step, static_cast<float>(row) * step, 0);
    plate.uv.push_back(glm::vec2(static_cast<float>(column), static_cast<float>(row)) /
                       static_cast<float>(cells));
  };
  for (int row = 0; row < columns; ++row)
    for (int column = 0; column < columns; ++column) add(column, row);
  const int middle = cells / 2;
  const auto first_copy = static_cast<Index>(plate.positions.size());
  for (int column = 0; slit && column < middle; ++column) {
    add(column, middle);
    plate.positions.back().y += 1e-5F;  // Apart, or they would be one.
  }
  const auto at = [&](int column, int row, bool above) {
    if (slit && above && row == middle && column < middle) return first_copy + static_cast<Index>(column);
    return static_cast<Index>(row * columns + column);
  };
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      const bool above = row >= middle;
      const Index a = at(column, row, above);
      const Index b = at(column + 1, row, above);
      const Index c = at(column + 1, row + 1, above);
      const Index d = at(column, row + 1, above);
      plate.triangles.push_back({a, b, c});
      plate.triangles.push_back({a, c, d});
    }
  return plate;
}

std::string ObjText(const Model& model) {
  std::string text = "# a test\no plate\n";
  for (const glm::vec3& p : model.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const glm::vec2& p : model.uv) text += fmt::format("vt {} {}\n", p.x, p.y);
  for (const Triangle& t : model.triangles)
    text += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

}  // namespace kaori::model
