// An expression of the box's own, as text: the form of a show's expressions.toml.
//
//   [[expression]]
//   name = "my_smile"
//   lids = [0.1, 0.1]
//
//   [expression.both]
//   B2 = [0.1, 0.4, 0]
//
// Moves are [u, v, outwards] in centimetres; outwards from the middle of the face is positive u on both
// sides.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "appliance/programs/editor/points.h"
#include "appliance/programs/editor/work.h"
#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::editor {

// The work as a text that people can read and put into a show: centimetres to a micrometre, what is alike on
// both sides once, and nothing of what does not move. ReadOwn of it gives the same work to that precision,
// but for slot and origin. Pure.
std::string WriteOwn(const Work& work, const Points& points);

// `file` names the text in errors. The text may build ("from") on expressions of the cast. Errors:
//   invalid_argument  no TOML, not one expression, an unknown key, a control point or an expression that the
//                     cast has not, or a number out of range; file and line are named
// No part of a move is more than 5 cm. The slot is -1: the file's name says it. Pure.
Result<Work> ReadOwn(std::string_view text, const std::string& file, const Points& points,
                     const face::Cast& cast);

inline constexpr std::size_t kLongestName = 24;

// Letters, digits and "_", a letter first, kLongestName at most.
bool IsName(std::string_view name);

}  // namespace kaori::editor
