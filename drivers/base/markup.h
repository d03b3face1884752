// Text in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace kaori {

// Without what ends a tag or an attribute; control letters, which XML 1.0 cannot hold, become
// spaces. What is not UTF-8 stays as it is.
inline std::string Escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '&') {
      out += "&amp;";
    } else if (letter == '<') {
      out += "&lt;";
    } else if (letter == '>') {
      out += "&gt;";
    } else if (letter == '"') {
      out += "&quot;";
    } else {
      out += static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t' ? ' ' : letter;
    }
  }
  return out;
}

}  // namespace kaori
