#include "appliance/authoring/model/obj_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace kaori::model {
namespace {

using Corner = std::pair<int, int>;  // Of position and of texture coordinate.

// What the library read: positions and coordinates of the whole file, corners by object.
struct Loaded {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
};

// The library cuts a polygon into triangles in a time that grows with the square of its corners, and reads a
// line of many numbers in full. This is a polygon of some 300 corners.
constexpr std::size_t kLongestLine_bytes = 4096;

// The library takes a word that is no number for 0. So lines of numbers may hold nothing but digits, signs,
// points and exponents behind their keyword.
bool HoldsOnlyNumbers(std::string_view line) {
  return line.find_first_not_of("0123456789+-.eE \t", line.find_first_of(" \t")) == std::string_view::npos;
}

// The lines that are needed: v, vt, f, o, g. What else an OBJ may hold (materials, weights, curves, tags)
// the library reads with less care. None, and a fault with the line's number, where a line is too long or no
// line of numbers.
std::optional<std::string> NeededLines(const std::string& file, std::span<const std::uint8_t> bytes,
                                       Findings& findings) {
  constexpr std::array<std::string_view, 5> kNeeded{"v", "vt", "f", "o", "g"};
  std::string text(bytes.begin(), bytes.end());
  std::ranges::replace(text, '\r', '\n');  // To the library, both end a line.
  std::istringstream all(text);
  std::string needed;
  std::size_t number = 0;
  for (std::string line; std::getline(all, line);) {
    ++number;
    line.erase(0, std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view word = std::string_view(line).substr(0, line.find_first_of(" \t"));
    if (std::ranges::find(kNeeded, word) == kNeeded.end()) continue;
    if (line.size() > kLongestLine_bytes) {
      findings.Add(file, fmt::format("line {}", number),
                   fmt::format("has more than {} letters", kLongestLine_bytes));
      return std::nullopt;
    }
    if (word.starts_with('v') && !HoldsOnlyNumbers(line)) {
      findings.Add(file, fmt::format("line {}", number), "holds a word that is no number");
      return std::nullopt;
    }
    needed += line + '\n';
  }
  return needed;
}

// The library triangulates by itself. It says several lines; people are told the first.
std::optional<Loaded> Load(const std::string& file, std::span<const std::uint8_t> bytes, Findings& findings) {
  const auto needed = NeededLines(file, bytes, findings);
  if (!needed) return std::nullopt;
  std::istringstream text(*needed);
  Loaded loaded;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  if (tinyobj::LoadObj(&loaded.attributes, &loaded.shapes, &materials, &warning, &error, &text))
    return loaded;
  findings.Add(file, "", error.empty() ? "is no OBJ file" : error.substr(0, error.find('\n')));
  return std::nullopt;
}

// Two passes: the pairs of position and coordinate that are used are listed first, in a sorted map, and
// numbered in its order; then the triangles name them. So equal files give equal vertices, whatever the order
// of their faces.
class ObjFileBuilder {
 public:
  ObjFileBuilder(std::string file, const Loaded& loaded, Findings& findings)
      : loaded_(loaded), findings_(findings) {
    model_.file = std::move(file);
  }

  // Two passes over the corners; see the class.
  std::optional<Model> Build() {
    const std::size_t before = findings_.size();
    for (const tinyobj::shape_t& shape : loaded_.shapes) ListCorners(shape);
    if (corners_.empty()) findings_.Add(model_.file, "", "holds no triangle");
    if (findings_.size() > before) return std::nullopt;
    NumberVertices();
    for (const tinyobj::shape_t& shape : loaded_.shapes) AddTriangles(shape);
    NameMeshes();
    return std::move(model_);
  }

 private:
  // Counts faults of an object instead of naming each corner. The map is not filled far beyond its bound.
  void ListCorners(const tinyobj::shape_t& shape) {
    const auto positions = static_cast<int>(loaded_.attributes.vertices.size() / 3);
    const auto places = static_cast<int>(loaded_.attributes.texcoords.size() / 2);
    std::size_t missing = 0;
    std::size_t wrong = 0;
    for (const tinyobj::index_t& index : shape.mesh.indices) {
      if (index.texcoord_index < 0) ++missing;
      if (index.vertex_index < 0 || index.vertex_index >= positions || index.texcoord_index >= places)
        ++wrong;
      if (corners_.size() <= kMostVertices)
        corners_.emplace(Corner{index.vertex_index, index.texcoord_index}, 0);
    }
    const std::string item = fmt::format("object \"{}\"", shape.name);
    if (missing > 0)
      findings_.Add(model_.file, item, fmt::format("{} corners have no texture coordinate", missing));
    if (wrong > 0)
      findings_.Add(model_.file, item, fmt::format("{} corners name what does not exist", wrong));
    if (corners_.size() > kMostVertices) findings_.Add(model_.file, item, "has too many vertices");
  }

  void NumberVertices() {
    for (auto& [corner, number] : corners_) {
      number = static_cast<Index>(model_.positions.size());
      const auto v = 3 * static_cast<std::size_t>(corner.first);
      const auto t = 2 * static_cast<std::size_t>(corner.second);
      const auto& from = loaded_.attributes;
      model_.positions.emplace_back(from.vertices[v], from.vertices[v + 1], from.vertices[v + 2]);
      model_.uv.emplace_back(from.texcoords[t], from.texcoords[t + 1]);
    }
  }

  // Objects are meshes where each has a stretch of vertices of its own, as tools write them; else all is one.
  void NameMeshes() {
    std::ranges::sort(objects_, {}, &MeshRange::first);
    const auto overlaps = [](const MeshRange& a, const MeshRange& b) { return b.first < a.first + a.count; };
    if (std::ranges::adjacent_find(objects_, overlaps) != objects_.end())
      objects_ = {{"obj", 0, static_cast<Index>(model_.positions.size())}};
    model_.meshes = std::move(objects_);
  }

  // Every corner is known to exist here.
  void AddTriangles(const tinyobj::shape_t& shape) {
    const auto& indices = shape.mesh.indices;
    const std::size_t before = model_.triangles.size();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = corners_.at({indices[i + k].vertex_index, indices[i + k].texcoord_index});
      model_.triangles.push_back(triangle);
    }
    if (model_.triangles.size() == before) return;
    // The stretch of vertices that this object names, whether or not others lie within it.
    Index least = model_.triangles.back()[0], most = least;
    for (std::size_t i = before; i < model_.triangles.size(); ++i)
      for (const Index corner : model_.triangles[i]) {
        least = std::min(least, corner);
        most = std::max(most, corner);
      }
    objects_.push_back({shape.name.empty() ? "obj" : shape.name, least, most - least + 1});
  }

  const Loaded& loaded_;
  Findings& findings_;
  Model model_;
  std::map<Corner, Index> corners_;
  std::vector<MeshRange> objects_;
};

}  // namespace

std::optional<Model> ReadObj(const std::string& file, std::span<const std::uint8_t> bytes,
                             Findings& findings) {
  const auto loaded = Load(file, bytes, findings);
  if (!loaded) return std::nullopt;
  return ObjFileBuilder(file, *loaded, findings).Build();
}

}  // namespace kaori::model
