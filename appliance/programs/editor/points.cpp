#include "appliance/programs/editor/points.h"

#include <algorithm>
#include <limits>
#include <map>

#include <glm/geometric.hpp>

#include "drivers/base/checksum.h"

namespace kaori::editor {
namespace {

// Two points that move a vertex together by at least this weight have skin between them. Upper and lower lip
// lie on one place of the parameter space, but no vertex follows both.
constexpr float kTogether = 0.02F;

// By names alone: "corner.l" and "corner.r". A name whose other side is missing stands alone.
std::vector<int> PartnersOf(const std::vector<std::string>& names) {
  std::map<std::string, int> index;
  for (std::size_t i = 0; i < names.size(); ++i) index[names[i]] = static_cast<int>(i);
  std::vector<int> partners;
  for (const std::string& name : names) {
    std::string other = name;
    if (name.ends_with(".l")) other.back() = 'r';
    if (name.ends_with(".r")) other.back() = 'l';
    const auto found = index.find(other);
    partners.push_back(other == name || found == index.end() ? -1 : found->second);
  }
  return partners;
}

// In the parameter space, unrolled to the size of a head, so that the distance is about that along the skin.
float PlacesApart_m(const face::ControlPoint& a, const face::ControlPoint& b) {
  return glm::length((a.uv - b.uv) * glm::vec2(face::kParameterWidth_m, face::kParameterHeight_m));
}

// Straight ways between the points that move a vertex together.
void JoinNeighbours(const face::ControlNet& net, std::vector<float>& apart_m) {
  const face::SparseRows& rows = net.to_cage;
  const std::size_t count = net.points.size();
  for (std::size_t row = 0; row < rows.rows(); ++row)
    for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i)
      for (auto k = rows.row_start[row]; k < i; ++k) {
        if (std::min(rows.weight[i], rows.weight[k]) < kTogether) continue;
        const std::size_t a = rows.column[i], b = rows.column[k];
        apart_m[a * count + b] = apart_m[b * count + a] = PlacesApart_m(net.points[a], net.points[b]);
      }
}

// Floyd and Warshall: the shortest way from each to each. Cubic in the number of points: a million steps for
// a hundred. Points that nothing joins stay infinitely far apart.
void FindWays(std::size_t count, std::vector<float>& apart_m) {
  for (std::size_t over = 0; over < count; ++over)
    for (std::size_t a = 0; a < count; ++a) {
      const float first_m = apart_m[a * count + over];
      for (std::size_t b = 0; b < count; ++b)
        apart_m[a * count + b] = std::min(apart_m[a * count + b], first_m + apart_m[over * count + b]);
    }
}

// The interpolant, where the points themselves lie. Edges of lips and lids follow wholly, a cheek by half.
// follows = surface x to_cage, a dense matrix: point a's skin moves by follows[a][b] of a pull at b.
std::vector<float> FollowsOf(const face::ControlNet& net) {
  const std::size_t count = net.points.size();
  std::vector<float> follows(count * count);
  for (std::size_t skin = 0; skin < count; ++skin)
    for (auto i = net.surface.row_start[skin]; i < net.surface.row_start[skin + 1]; ++i) {
      const std::size_t vertex = net.surface.column[i];
      if (vertex >= net.to_cage.rows()) continue;
      for (auto k = net.to_cage.row_start[vertex]; k < net.to_cage.row_start[vertex + 1]; ++k)
        follows[skin * count + net.to_cage.column[k]] += net.surface.weight[i] * net.to_cage.weight[k];
    }
  return follows;
}

// Left and right alike to the bit, whatever order the ways were added up in.
void Even(Points& points) {
  const auto mirrored = [&points](std::size_t i) {
    return points.partners[i] < 0 ? i : static_cast<std::size_t>(points.partners[i]);
  };
  const std::vector<float> ways_m = points.apart_m;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = 0; b < points.size(); ++b)
      points.apart_m[a * points.size() + b] =
          std::min(ways_m[a * points.size() + b], ways_m[mirrored(a) * points.size() + mirrored(b)]);
}

}  // namespace

// Neighbours first, then the ways over them; the mirror image is evened out last.
Points PointsOf(const face::ControlNet& net) {
  Points points;
  const std::size_t count = net.points.size();
  for (const face::ControlPoint& point : net.points) points.names.push_back(point.name);
  points.partners = PartnersOf(points.names);
  points.apart_m.assign(count * count, std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < count; ++i) points.apart_m[i * count + i] = 0;
  JoinNeighbours(net, points.apart_m);
  FindWays(count, points.apart_m);
  Even(points);
  points.follows = FollowsOf(net);
  return points;
}

// Of the names in their order: a journal holds pulls by number, which mean something for the same points
// only.
std::uint64_t Fingerprint(const Points& points) {
  std::string all;
  for (const std::string& name : points.names) all += name + '\n';
  return Fnv1a(all);
}

}  // namespace kaori::editor
