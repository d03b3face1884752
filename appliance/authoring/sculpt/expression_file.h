// Reads a show's expressions: control points on the left half of the face, and how each expression moves
// them.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/authoring/sculpt/cage.h"
#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::sculpt {

// A control point as written: once for a pair, its place on the left.
struct AuthoredPoint {
  std::string name;
  glm::dvec2 place_cm{};
  bool paired = false;          // Has a mirror image on the right.
  std::optional<Key> vertex{};  // On the edge of a lid or a lip.
};

// By point name: along u, along v, outwards, in centimetres on the reference face. Outwards from the middle
// of the face is positive u on both sides.
using Moves = std::map<std::string, glm::dvec3>;

struct AuthoredExpression {
  std::string name;
  face::ExpressionKind kind = face::ExpressionKind::kExpression;
  std::array<double, 2> lids{};          // Left, right.
  std::map<std::string, double> from{};  // Earlier expressions that it builds on, by this much.
  Moves both{};                          // All that is said adds up.
  Moves left{};
  Moves right{};
};

struct ExpressionFile {
  std::vector<AuthoredPoint> points;
  std::vector<glm::dvec2> border_cm;  // Points that never move, on the left and in the middle.
  std::vector<AuthoredExpression> expressions;
};

// `reference` gives the places of points that are named by a vertex. Every fault names file, line, item,
// reason.
Result<ExpressionFile> ReadExpressionFile(const std::filesystem::path& path, const HalfTopology& half,
                                          const HalfShape& reference);

}  // namespace kaori::sculpt
