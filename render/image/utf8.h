// Decodes UTF-8 into code points.
#pragma once

#include <cstddef>
#include <string_view>

namespace kaori::image {

// A code point and its length in the text.
struct Letter {
  char32_t code = 0;
  // How many of the text it is made of; 1 at least.
  std::size_t bytes = 0;
};

// The first letter of `text`, which must not be empty. A byte that begins no valid sequence (too short, too
// long for its code, a surrogate, above U+10FFFF) is U+FFFD, and one byte long.
Letter FirstLetter(std::string_view text);

}  // namespace kaori::image
