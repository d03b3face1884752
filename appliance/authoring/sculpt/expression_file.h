// Reads a show's expressions: control points on the left half of the face, and how each expression moves
// them.
//
// The file is expressions.toml: [point] by name, a list border, and [[expression]] with name, kind, lids,
// from, both, left, right. Lengths are centimetres on the reference face.
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

// A control point as written: once for a pair, its uv on the left half (u >= 0).
struct AuthoredPoint {
  // Without a side; the net adds ".l" and ".r".
  std::string name;
  glm::dvec2 uv_cm{};
  // Has a mirror image on the right: it does not lie in the middle.
  bool paired = false;
  // The vertex that the file names it by, on the edge of a lid or a lip; none where it is written as u and v.
  std::optional<Key> vertex{};
};

// By point name: along u, along v, outwards, in centimetres on the reference face. Outwards from the middle
// of the face is positive u on both sides. At most 5 cm an axis.
using Moves = std::map<std::string, glm::dvec3>;

// One [[expression]] as written; all that is said adds up.
struct AuthoredExpression {
  std::string name;
  face::ExpressionKind kind = face::ExpressionKind::kExpression;
  // How far lids are shut, 0..1: left, right.
  std::array<double, 2> lids{};
  double pupil = 1;  // A factor, 0.5..1.5.
  double flush = 0;  // How red, 0..1.
  // Earlier expressions that it builds on, by this much.
  std::map<std::string, double> from{};
  // On both sides alike; `left` and `right` add to one side alone.
  Moves both{};
  // Of one side alone, added to `both`; in the middle `right` pulls against `left`.
  Moves left{};
  Moves right{};
};

// Points keep the file's order, which becomes that of every displacement list in the pack.
struct ExpressionFile {
  // In the file's order.
  std::vector<AuthoredPoint> points;
  // Points that never move, on the left and in the middle.
  std::vector<glm::dvec2> border_cm;
  // The first is "neutral"; names are unique.
  std::vector<AuthoredExpression> expressions;
};

// `reference` gives the uv of points that are named by a vertex. Errors: as ReadToml's where the
// file cannot be read or is no TOML; else invalid_argument, with every fault by file, line, item and
// reason: unknown keys and points, uv off the left half, names that are given twice or build on a
// later expression, moves of more than 5 cm, and expressions that move nothing by 0.2 mm, which were
// written in metres.
Result<ExpressionFile> ReadExpressionFile(const std::filesystem::path& path, const HalfTopology& half,
                                          const HalfShape& reference);

}  // namespace kaori::sculpt
