// Lines of text, broken where they would be too long.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::image {

// Whether a piece of text fits into one line; a longer piece must not fit where a shorter one does not.
using Fits = std::function<bool(std::string_view)>;

// Appends the pieces of `line`, UTF-8, to `into`: each as long as fits, broken at gaps of two spaces or more, and
// where a piece between such gaps is too long alone, at single ones or beside a Japanese letter, of which any two
// may be parted, but for those that no line begins with (small kana, what closes) or ends with (what opens). A word
// that is too long stays whole. An empty line stays an empty line. Pure.
void BreakLine(std::string_view line, const Fits& fits, std::vector<std::string>& into);

}  // namespace kaori::image
