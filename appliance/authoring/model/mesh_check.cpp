#include "appliance/authoring/model/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::model {
namespace {

// A head whose file counts in centimetres comes out at some 25 m, one in inches at 10 m.
constexpr float kSmallest_m = 0.02F;
constexpr float kLargest_m = 3;
// Of the unit square: less than a hundredth of a texel of the largest texture.
constexpr double kFlatPlace = 1e-10;
// Of the mean triangle; one that is turned over by less does no harm, and tools leave such at
// corners of lids.
constexpr double kSliver = 0.02;
// Of the doubled area: a tenth of a micrometre by as much.
constexpr float kFlat_m2 = 1e-14F;

// Vectors with a component that is infinite or no number.
template <class Vec>
std::size_t CountNotFinite(const std::vector<Vec>& values) {
  return static_cast<std::size_t>(std::ranges::count_if(values, [](const Vec& v) {
    for (int k = 0; k < Vec::length(); ++k)
      if (!std::isfinite(v[k])) return true;
    return false;
  }));
}

template <class Vec>
bool AreNumbers(const Model& model, const std::string& item, const std::vector<Vec>& values,
                Findings& findings) {
  const std::size_t wrong = CountNotFinite(values);
  if (wrong > 0) findings.Add(model.file, item, fmt::format("{} of {} are no numbers", wrong, values.size()));
  return wrong == 0;
}

// The largest side of the box, since a bust is higher than it is wide.
void CheckSize(const Model& model, Findings& findings) {
  glm::vec3 least = model.positions.front();
  glm::vec3 most = least;
  for (const glm::vec3& p : model.positions) {
    least = glm::min(least, p);
    most = glm::max(most, p);
  }
  const glm::vec3 size = most - least;
  const float largest = std::max({size.x, size.y, size.z});
  if (largest >= kSmallest_m && largest <= kLargest_m) return;
  // Whoever forgot the scale has forgotten a factor of a hundred or a thousand.
  const char* hint = largest > 10 * kLargest_m ? ": it is in centimetres or millimetres; scale it" : "";
  findings.Add(model.file, "",
               fmt::format("is {:.4g} m large; a head in metres is expected{}", largest, hint));
}

// Signed: positive where the triangle runs counter-clockwise in the chart, v up.
double PlaceArea(const Model& model, const Triangle& t) {
  const glm::dvec2 a = glm::dvec2(model.uv[t[1]]) - glm::dvec2(model.uv[t[0]]);
  const glm::dvec2 b = glm::dvec2(model.uv[t[2]]) - glm::dvec2(model.uv[t[0]]);
  return 0.5 * (a.x * b.y - a.y * b.x);
}

// Of which meshes triangles are, where the file has several: the three that have most, ", 7 of "Body"" each.
std::string InMeshes(const Model& model, const std::vector<Triangle>& triangles) {
  // Of a file with one mesh its name tells nothing.
  if (model.meshes.size() < 2) return {};
  std::vector<std::pair<std::size_t, std::string>> counts;
  for (const MeshRange& mesh : model.meshes) {
    const auto is_here = [&](const Triangle& t) { return mesh.Holds(t[0]); };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(triangles, is_here));
    if (count > 0) counts.emplace_back(count, mesh.name);
  }
  std::ranges::stable_sort(counts, std::ranges::greater{}, &std::pair<std::size_t, std::string>::first);
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(counts.size(), 3); ++i)
    text += fmt::format(", {} of \"{}\"", counts[i].first, counts[i].second);
  return text;
}

}  // namespace

// Without vertices there is nothing more to say. Else every list is checked, whatever is wrong with the one
// before; a size is taken of positions that are numbers only.
void CheckModel(const Model& model, Findings& findings) {
  if (model.positions.empty()) return findings.Add(model.file, "", "has no vertices");
  if (AreNumbers(model, "positions", model.positions, findings)) CheckSize(model, findings);
  AreNumbers(model, "texture coordinates", model.uv, findings);
  for (const Target& target : model.targets)
    AreNumbers(model, fmt::format("target \"{}\"", target.name), target.offsets, findings);
}

// Counts first: where they differ, so do the triangles, and that need not be said.
void CheckSameTopology(const Model& reference, const Model& other, Findings& findings) {
  if (other.positions.size() != reference.positions.size()) {
    findings.Add(other.file, "",
                 fmt::format("{} vertices, {} has {}", other.positions.size(), reference.file,
                             reference.positions.size()));
  } else if (other.triangles != reference.triangles) {
    findings.Add(other.file, "", "its triangles join other vertices than those of " + reference.file);
  }
}

// Two bounds: what has no area at all cannot be painted, what is turned over by more than a sliver
// folds the chart.
void CheckUnfolding(const Model& model, std::span<const Triangle> triangles, Findings& findings) {
  double all = 0;
  for (const Triangle& t : triangles) all += std::abs(PlaceArea(model, t));
  // By the mean of the triangles' areas, since charts differ in how much of the square they use.
  const double sliver = kSliver * all / static_cast<double>(std::max<std::size_t>(triangles.size(), 1));
  std::vector<Triangle> flat, turned, no_area;
  for (const Triangle& t : triangles) {
    const double place = PlaceArea(model, t);
    // A triangle may be counted as flat in the chart and as flat in space.
    if (std::abs(place) <= kFlatPlace) flat.push_back(t);
    if (place < -sliver) turned.push_back(t);
    const glm::vec3 cross = glm::cross(model.positions[t[1]] - model.positions[t[0]],
                                       model.positions[t[2]] - model.positions[t[0]]);
    if (!(glm::dot(cross, cross) > kFlat_m2 * kFlat_m2)) no_area.push_back(t);
  }
  const auto say = [&](const std::vector<Triangle>& found, const char* what) {
    if (!found.empty())
      findings.Add(
          model.file, what,
          fmt::format("{} of {} triangles{}", found.size(), triangles.size(), InMeshes(model, found)));
  };
  say(flat, "without area in the texture");
  say(turned, "turned over in the texture");
  say(no_area, "without area in space");
}

}  // namespace kaori::model
