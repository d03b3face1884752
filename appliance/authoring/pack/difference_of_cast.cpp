#include <algorithm>
#include <cstdlib>
#include <map>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "appliance/authoring/pack/difference_parts.h"

namespace kaori::authoring {
namespace {

// Lines say millimetres.
constexpr float kMillimetre_m = 1e-3F;

// How far points moved: the largest distance and the mean.
// The sum has double precision: a mesh has thousands of points, and their distances are fractions of a mm.
struct Motion {
  float most_m = 0;
  double sum_m = 0;
  std::size_t points = 0;

  void Add(const glm::vec3& a, const glm::vec3& b) {
    const float by_m = glm::distance(a, b);
    most_m = std::max(most_m, by_m);
    sum_m += by_m;
    ++points;
  }
  std::string Says() const {
    const double mean_m = points == 0 ? 0 : sum_m / static_cast<double>(points);
    return fmt::format("by up to {:.2f} mm ({:.2f} mm in the mean)", most_m / kMillimetre_m,
                       mean_m / kMillimetre_m);
  }
};

// Both lists have one length.
Motion MotionOf(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  Motion motion;
  for (std::size_t i = 0; i < a.size(); ++i) motion.Add(a[i], b[i]);
  return motion;
}

// Both eyes in one line: the larger of each.
// The centres are in the face's own space, in metres, as its vertices are.
void CompareEyes(const std::string& item, const face::Face& a, const face::Face& b, Lines& lines) {
  Motion centres;
  float radius_m = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    centres.Add(a.eyes[side].centre, b.eyes[side].centre);
    radius_m = std::max(radius_m, std::abs(a.eyes[side].radius_m - b.eyes[side].radius_m));
  }
  if (centres.most_m > 0) lines.push_back(fmt::format("{}: eyes moved {}", item, centres.Says()));
  if (radius_m > 0)
    lines.push_back(
        fmt::format("{}: eyes changed their radius by {:.2f} mm", item, radius_m / kMillimetre_m));
}

// Exactly equal: a pack holds what was written.
bool SameMouth(const face::MouthFit& a, const face::MouthFit& b) {
  return a.scale == b.scale && a.offset == b.offset && a.upper_teeth == b.upper_teeth &&
         a.lower_teeth == b.lower_teeth && a.tongue == b.tongue;
}

bool SameEyeSurface(const face::EyeSurface& a, const face::EyeSurface& b) {
  return a.white == b.white && a.veins == b.veins && a.pupil == b.pupil && a.limbus == b.limbus &&
         a.spokes == b.spokes && a.rings == b.rings && a.wet == b.wet && a.glow == b.glow;
}

// One line of the result stands for all of these fields.
// The texture is not among them: CompareTexture has a line of its own for it.
bool SameLook(const face::Face& a, const face::Face& b) {
  return a.eye_look.iris == b.eye_look.iris && a.eye_look.iris_radius_m == b.eye_look.iris_radius_m &&
         a.eye_look.lash_length_m == b.eye_look.lash_length_m &&
         a.eye_look.lash_wing_m == b.eye_look.lash_wing_m && a.surface.softness == b.surface.softness &&
         a.surface.metal == b.surface.metal && a.surface.flat == b.surface.flat &&
         a.surface.print == b.surface.print && a.surface.folds == b.surface.folds &&
         a.surface.flush == b.surface.flush && SameEyeSurface(a.eye_surface, b.eye_surface) &&
         a.outgrowth_kind == b.outgrowth_kind && a.withdrawn == b.withdrawn && a.hang_arms_m == b.hang_arms_m;
}

// Displacements by the names of their points, so that points that were added or put into another order
// do not matter.
std::map<std::string, glm::vec3> MovesByPoint(const WornExpression& worn) {
  std::map<std::string, glm::vec3> moves;
  for (std::size_t i = 0; i < worn.net.points.size(); ++i)
    // Displacements are in metres and in the order of the net's points, as CheckShow has made sure.
    moves[worn.net.points[i].name] = worn.expression.displacement[i];
  return moves;
}

// The point whose displacement changed most, and by how much in metres. A point that only one net has counts
// with its whole displacement where it is new.
std::pair<std::string, float> MostChanged(const WornExpression& a, const WornExpression& b) {
  std::pair<std::string, float> most{"", 0};
  const auto before = MovesByPoint(a);
  for (const auto& [point, move] : MovesByPoint(b)) {
    const auto old = before.find(point);
    const float by_m = glm::distance(old == before.end() ? glm::vec3(0) : old->second, move);
    if (by_m > most.second) most = {point, by_m};
  }
  return most;
}

}  // namespace

// Only the first difference is said: the others follow from it.
void CompareTopology(const face::Topology& a, const face::Topology& b, Lines& lines) {
  if (a.vertex_count != b.vertex_count || a.triangles.size() != b.triangles.size())
    lines.push_back(fmt::format("topology: {} vertices and {} triangles are now {} and {}", a.vertex_count,
                                a.triangles.size(), b.vertex_count, b.triangles.size()));
  else if (a.triangles != b.triangles || a.fine.triangles != b.fine.triangles)
    lines.emplace_back("topology: triangles join other vertices");
  else if (a.uv != b.uv)
    lines.emplace_back("topology: vertices lie elsewhere in the parameter space");
}

// Counts that differ end the comparison of positions; all else is still compared.
void CompareFace(const std::string& item, const face::Face& a, const face::Face& b, Lines& lines) {
  if (a.positions.size() != b.positions.size()) {
    lines.push_back(fmt::format("{}: {} vertices are now {}", item, a.positions.size(), b.positions.size()));
  } else if (const Motion motion = MotionOf(a.positions, b.positions); motion.most_m > 0) {
    lines.push_back(fmt::format("{}: moved {}", item, motion.Says()));
  }
  CompareEyes(item, a, b, lines);
  if (!SameMouth(a.mouth, b.mouth)) lines.push_back(item + ": teeth and tongue sit differently");
  if (!SameLook(a, b)) lines.push_back(item + ": eyes or skin answer light differently");
  if (a.occlusion != b.occlusion) lines.push_back(item + ": shade changed");
  if (a.expression_gain != b.expression_gain)
    lines.push_back(fmt::format("{}: gain of its expressions {:.2f} is now {:.2f}", item, a.expression_gain,
                                b.expression_gain));
}

// By texel, without looking at how much each changed: a new stroke is a change.
void CompareTexture(const std::string& item, const face::Texture* a, const face::Texture* b, Lines& lines) {
  if (a == nullptr || b == nullptr) {
    if (a != b) lines.push_back(item + (b == nullptr ? ": texture is gone" : ": texture is new"));
    return;
  }
  if (a->width_px != b->width_px || a->height_px != b->height_px) {
    lines.push_back(fmt::format("{}: texture {}x{} is now {}x{}", item, a->width_px, a->height_px,
                                b->width_px, b->height_px));
    return;
  }
  std::size_t changed = 0;
  for (std::size_t i = 0; i + 3 < a->rgba.size(); i += 4)
    changed += std::equal(a->rgba.data() + i, a->rgba.data() + i + 4, b->rgba.data() + i) ? 0 : 1;
  if (changed > 0)
    lines.push_back(fmt::format("{}: texture changed in {:.1f} % of its texels", item,
                                // By texels of four bytes, as a percentage.
                                400.0 * static_cast<double>(changed) / static_cast<double>(a->rgba.size())));
}

// Vertices are compared one by one only where the triangles are the same: else numbers mean nothing.
void CompareProp(const std::string& item, const face::Prop& a, const face::Prop& b, Lines& lines) {
  if (a.vertices.size() != b.vertices.size() || a.triangles != b.triangles) {
    lines.push_back(fmt::format("{}: {} triangles are now {}, joined anew", item, a.triangles.size(),
                                b.triangles.size()));
  } else {
    Motion motion;
    bool shade = false;
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
      motion.Add(a.vertices[i].position, b.vertices[i].position);
      shade = shade || a.vertices[i].shade != b.vertices[i].shade;
    }
    if (motion.most_m > 0) lines.push_back(fmt::format("{}: moved {}", item, motion.Says()));
    if (shade) lines.push_back(item + ": shade changed");
  }
  if (a.colour != b.colour) lines.push_back(item + ": colour changed");
}

void ComparePoint(const std::string& item, const face::ControlPoint& a, const face::ControlPoint& b,
                  Lines& lines) {
  const glm::vec2 scale(face::kParameterWidth_m, face::kParameterHeight_m);
  // In the parameter space's own size, where lengths in front are those of the reference face.
  const float by_m = glm::length((b.uv - a.uv) * scale);
  if (by_m > 0) lines.push_back(fmt::format("{}: lies {:.2f} mm elsewhere", item, by_m / kMillimetre_m));
}

// Lids are shares of shut, left and right. What control points cannot say (the residual) is compared vertex
// by vertex, and only where both have as many.
void CompareExpression(const std::string& item, const WornExpression& a, const WornExpression& b,
                       Lines& lines) {
  if (a.expression.kind != b.expression.kind) lines.push_back(item + ": is of another kind");
  if (const auto [point, by_m] = MostChanged(a, b); by_m > 0)
    lines.push_back(
        fmt::format("{}: moves by up to {:.2f} mm otherwise (point {})", item, by_m / kMillimetre_m, point));
  if (a.expression.lids != b.expression.lids)
    lines.push_back(fmt::format("{}: lids shut {:.2f} and {:.2f} are now {:.2f} and {:.2f}", item,
                                a.expression.lids[0], a.expression.lids[1], b.expression.lids[0],
                                b.expression.lids[1]));
  if (a.expression.pupil != b.expression.pupil)
    lines.push_back(fmt::format("{}: pupils {:.2f} as large are now {:.2f}", item, a.expression.pupil,
                                b.expression.pupil));
  if (a.expression.flush != b.expression.flush)
    lines.push_back(
        fmt::format("{}: a flush of {:.2f} is now {:.2f}", item, a.expression.flush, b.expression.flush));
  if (a.expression.residual.size() != b.expression.residual.size())
    lines.push_back(item + ": what its points cannot say is kept otherwise");
  else if (const Motion rest = MotionOf(a.expression.residual, b.expression.residual); rest.most_m > 0)
    lines.push_back(fmt::format("{}: what its points cannot say moved {}", item, rest.Says()));
}

}  // namespace kaori::authoring
