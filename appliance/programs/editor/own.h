// An expression of the box's own, as text: the form of a show's expressions.toml.
#pragma once

#include <string>
#include <string_view>

#include "appliance/programs/editor/points.h"
#include "appliance/programs/editor/work.h"
#include "drivers/base/result.h"
#include "render/face/cast.h"

namespace kaori::editor {

// For people: centimetres to a micrometre, what is alike on both sides once, and nothing of what does not move.
std::string WriteOwn(const Work& work, const Points& points);

// `file` names the text in errors. The text may build ("from") on expressions of the cast. Errors:
//   invalid_argument  no TOML, not one expression, an unknown key, a control point or an expression that the
//                     cast has not, or a number out of range; file and line are named
Result<Work> ReadOwn(std::string_view text, const std::string& file, const Points& points,
                     const face::Cast& cast);

// Letters, digits and "_", a letter first, 24 at most.
bool IsName(std::string_view name);

}  // namespace kaori::editor
