#include "appliance/authoring/import/form.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/depth_view.h"
#include "appliance/authoring/import/eye_opening.h"
#include "appliance/authoring/import/mouth_slit.h"

namespace kaori::import {
namespace {

// Radii of the ball above its centre.
constexpr float kBrowAboveEye = 1.75F;
// The hump falls to 1/e at this distance; as broad as a brow is long, half of it to each side.
constexpr float kBrowWide_m = 0.009F;
// How far a raised brow goes at its middle.
constexpr float kBrowUp_m = 0.006F;

const char* Side(std::size_t side) {
  return side == 0 ? "left" : "right";
}

// Marks and motion come from one opening, so that landmarks and blink agree.
std::string CompleteEye(std::size_t side, HeadShape& head) {
  if (!(head.eyes[side].radius_m > 0))
    return fmt::format("{} eye: no ball was found: it does not shut", Side(side));
  const auto opening = OpeningOf(head, side);
  if (!opening) return fmt::format("{} eye: hidden or shut; its lids were not found", Side(side));
  head.lids[side] = MarksOf(*opening, head, side);
  head.blink[side] = ShutLids(*opening, head, side);
  return fmt::format("{} lids: by form; they shut along the ball", Side(side));
}

// A hump of motion about the place above the eye.
std::string CompleteBrow(std::size_t side, HeadShape& head) {
  const face::EyeBall& eye = head.eyes[side];
  if (!(eye.radius_m > 0)) return fmt::format("{} brow: not found, since its eye was not", Side(side));
  const glm::vec2 place = glm::vec2(eye.centre) + glm::vec2(0, kBrowAboveEye * eye.radius_m);
  const std::vector<bool> seen = SeenFromFront(head);
  Offsets up(head.positions.size(), glm::vec3(0));
  for (std::size_t v = 0; v < up.size(); ++v) {
    const float from = glm::distance(glm::vec2(head.positions[v]), place) / kBrowWide_m;
    // Straight up. What lies behind (an ear, the back of the head) has no share.
    if (seen[v]) up[v].y = kBrowUp_m * std::exp(-from * from);
  }
  head.brow_up[side] = std::move(up);
  return fmt::format("{} brow: by form, above the eye", Side(side));
}

// The graph is made here, of the skin alone, and is needed by both steps.
std::string CompleteMouth(const std::vector<PartOf>& part, HeadShape& head) {
  if (!(head.eyes[0].radius_m > 0 && head.eyes[1].radius_m > 0))
    return "mouth: not found, since the eyes were not";
  const MeshGraph graph(head.positions, head.triangles);
  const std::vector<LipPair> lips = LipsOf(head, graph);
  if (lips.empty()) return "mouth: no slit between lips was found: it does not open";
  head.jaw = JawByForm(part, lips, head, graph);
  return fmt::format("mouth and jaw: by form, {} pairs of vertices along the lips", lips.size());
}

}  // namespace

// The mouth comes before the brows in what people are told, and needs the balls of both eyes, not their lids.
std::vector<std::string> CompleteByForm(const std::vector<PartOf>& part, HeadShape& head) {
  std::vector<std::string> said;
  for (std::size_t side = 0; side < 2; ++side)
    if (head.blink[side].empty()) said.push_back(CompleteEye(side, head));
  if (head.jaw.empty()) said.push_back(CompleteMouth(part, head));
  for (std::size_t side = 0; side < 2; ++side)
    if (head.brow_up[side].empty()) said.push_back(CompleteBrow(side, head));
  return said;
}

}  // namespace kaori::import
