#include "appliance/authoring/import/doubts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/depth_view.h"
#include "appliance/authoring/import/mesh_graph.h"

namespace kaori::import {
namespace {

// Eyes of which so many times as much is seen from another side look there. From above and below one sees a part of
// those that stand out.
constexpr float kClearly = 1.5F;
// An edge of the skin this near to the middle of a lip belongs to the hole between the lips, which turn inwards before they end;
// nostrils are farther.
constexpr float kAtLip_m = 0.012F;

// One of the axes that a head may look along by mistake, and the turn that brings it to +Z.
struct Direction {
  const char* name;
  glm::vec3 (*turned)(const glm::vec3&);
};
constexpr std::array<Direction, 5> kWrongDirections{{
    {"-Z", [](const glm::vec3& p) { return glm::vec3(-p.x, p.y, -p.z); }},
    {"-Y", [](const glm::vec3& p) { return glm::vec3(p.x, p.z, -p.y); }},
    {"+Y", [](const glm::vec3& p) { return glm::vec3(p.x, -p.z, p.y); }},
    {"+X", [](const glm::vec3& p) { return glm::vec3(-p.z, p.y, p.x); }},
    {"-X", [](const glm::vec3& p) { return glm::vec3(p.z, p.y, -p.x); }},
}};

// How much of the eye of which less is seen can be seen along -Z; square metres but for a factor, since columns are equally wide.
float SeenOfEyes(const HeadShape& head) {
  float least = std::numeric_limits<float>::max();
  for (const face::EyeBall& eye : head.eyes) {
    float seen = 0;
    for (const BallColumn& column : SeenOfBall(head, eye)) seen += column.high_m - column.low_m;
    least = std::min(least, seen);
  }
  return least;
}

// The head as it would stand if it looked along +Z where it looks along that direction. Motions are left as they are: only
// what is seen at rest is asked for.
HeadShape Turned(HeadShape head, const Direction& direction) {
  for (glm::vec3& p : head.positions) p = direction.turned(p);
  for (face::EyeBall& eye : head.eyes) eye.centre = direction.turned(eye.centre);
  return head;
}

// Vertices on edges that one triangle alone has, copies across texture seams being one; in any order.
std::vector<Index> OnBorder(const HeadShape& head) {
  const std::vector<Index> weld = Weld(head.positions);
  std::map<std::pair<Index, Index>, int> triangles;
  for (const Triangle& t : head.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++triangles[std::minmax(weld[t[i]], weld[t[(i + 1) % 3]])];
  std::vector<Index> border;
  for (const auto& [edge, count] : triangles)
    if (count == 1) border.push_back(edge.first);
  return border;
}

// Whether the skin ends at both lips, so that nothing closes the mouth behind them.
bool IsHollow(const HeadShape& head, const std::vector<Landmark>& marks) {
  const std::vector<Index> border = OnBorder(head);
  const auto ends_at = [&](const char* lip) {
    const auto mark = LandmarkAt(marks, lip);
    return mark && std::ranges::any_of(
                       border, [&](Index v) { return glm::distance(head.positions[v], *mark) < kAtLip_m; });
  };
  return ends_at("upper lip") && ends_at("lower lip");
}

}  // namespace

// A head whose lids are shut at rest shows its eyes to no side, and is not doubted.
void CheckPose(const Model& model, const Heads& heads, Findings& findings) {
  const Head& first = heads.heads.front();
  // Such balls tell nothing about where a head looks to, so that this comes first.
  for (const PartOf eye : {PartOf::kLeftEye, PartOf::kRightEye})
    if (!IsOneBall(model, heads.parts, eye))
      findings.Add(model.file, std::string(NameOf(eye)) + "ball",
                   "more than one ball of an eye's size lies on this side: one head is expected in a file, "
                   "which looks along +Z, "
                   "without pearls or buttons of that size");
  if (!findings.empty() || !(first.eyes[0].radius_m > 0) || !(first.eyes[1].radius_m > 0)) return;
  const HeadShape head = ShapeOfHeads(heads);
  const float in_front = SeenOfEyes(head);
  const Direction* best = nullptr;
  float most = kClearly * in_front;
  for (const Direction& direction : kWrongDirections) {
    const float seen = SeenOfEyes(Turned(head, direction));
    if (seen <= most) continue;
    most = seen;
    best = &direction;
  }
  if (best != nullptr)
    findings.Add(
        model.file, "",
        fmt::format(
            "looks along {}, and must look along +Z with +Y up: turn it, or export it with these axes",
            best->name));
}

// A head whose lips are not known is not asked about the inside of its mouth.
std::vector<std::string> DoubtsAbout(const Heads& heads, const HeadShape& head,
                                     const std::vector<Landmark>& marks, Index moving) {
  // Each says what is seen, and what would be wanted instead.
  std::vector<std::string> doubts;
  for (std::size_t side = 0; side < 2; ++side)
    if (!(heads.heads.front().eyes[side].radius_m > 0))
      doubts.push_back(
          fmt::format("the {} eye is a hole: there is no eyeball, a ball with a radius of 6 to 35 mm as a "
                      "piece of its own",
                      side == 0 ? "left" : "right"));
  if (head.jaw.empty())
    doubts.emplace_back(
        "the mouth stays shut: there is no shape jaw_open, and no slit between the lips was found");
  else if (IsHollow(head, marks))
    doubts.emplace_back(
        "through the open mouth one sees what is behind the head: close it behind the lips with an inside of "
        "the mouth");
  if (moving == 0)
    doubts.emplace_back(
        "nothing of the head moves: give it shapes, or eyeballs and lips by which a show's expressions are "
        "carried over");
  return doubts;
}

}  // namespace kaori::import
