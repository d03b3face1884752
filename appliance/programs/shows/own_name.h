// The name of a box in its settings file: a restore leaves each box its own, so that a second box made of a backup is
// no second one of that name.
#pragma once

#include <string>
#include <string_view>

namespace kaori::shows {

// `text` with the line `name = ...` of `own` in place of its own one: with none where `own` has none. Both are texts of
// box.toml; the line stands above the first [section]. Pure.
std::string WithNameOf(std::string_view text, std::string_view own);

}  // namespace kaori::shows
