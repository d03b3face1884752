// Single lines of a box's settings, those above the first [section] of box.toml: replaced in the text as it stands, so that
// comments and everything else that a person wrote stay.
#pragma once

#include <string>
#include <string_view>

namespace kaori::shows {

// `text` with the lines `key = ...` of `own` in place of its own ones: with none where `own` has none. Both are
// texts of box.toml. The lines come first in the result. Pure.
std::string WithLineOf(std::string_view text, std::string_view own, std::string_view key);

// `text` with `key = "value"` as its first line in place of what it says of `key`; without such a line where `value` is
// empty. The value has neither quotes nor backslashes. Pure.
std::string WithSetting(std::string_view text, std::string_view key, std::string_view value);

}  // namespace kaori::shows
