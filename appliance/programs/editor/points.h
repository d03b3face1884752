// What the editor knows of a cast's control points: their names, their partners, and how far each is from
// each. Distances are what a smooth pull spreads by: along the skin, so that a pull of the upper lip does not
// reach across the mouth to the lower one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/face/cast.h"

namespace kaori::editor {

// Made once from a cast, and read-only from then on. Matrices are square, row by row, of size() squared.
struct Points {
  std::vector<std::string> names;
  std::vector<int> partners;   // The point of the same name on the other side (".l", ".r"); -1 in the middle.
  std::vector<float> apart_m;  // All pairs: the way between two points along the skin, round the slits.
  std::vector<float> follows;  // All pairs: how far the skin at the first goes with the handle of the second.

  std::size_t size() const { return names.size(); }
  // Symmetric, 0 from a point to itself; infinite where no skin joins the two. From one lip to the other the
  // way leads round the corner of the mouth.
  float Apart_m(std::size_t a, std::size_t b) const { return apart_m[a * size() + b]; }
  float Follows(std::size_t skin, std::size_t handle) const { return follows[skin * size() + handle]; }
  // Whether the point is on the character's right side. Points of the middle are on neither.
  bool OnTheRight(std::size_t point) const { return partners[point] >= 0 && names[point].ends_with(".r"); }
};

// Takes some milliseconds for a hundred points.
Points PointsOf(const face::ControlNet& net);

// Tells the control points of one cast from those of another: FNV-1a of their names in order. Where they lie
// does not matter, since pulls are kept by point.
std::uint64_t Fingerprint(const Points& points);

}  // namespace kaori::editor
