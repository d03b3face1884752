#include "appliance/core/toml/quoted.h"

#include <fmt/format.h>

namespace kaori::toml {
namespace {

// The letter that stands behind the backslash; 0 where there is none for this character.
char LetterOf(char c) {
  switch (c) {
    case '\b':
      return 'b';
    case '\t':
      return 't';
    case '\n':
      return 'n';
    case '\f':
      return 'f';
    case '\r':
      return 'r';
    case '"':
    case '\\':
      return c;
    default:
      return 0;
  }
}

}  // namespace

// Bytes of letters beyond ASCII stand as they are.
std::string Quoted(std::string_view text) {
  constexpr unsigned char kDelete = 0x7F;
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (const char letter = LetterOf(c); letter != 0)
      quoted += {'\\', letter};
    else if (byte < 0x20 || byte == kDelete)
      quoted += fmt::format("\\u{:04X}", byte);
    else
      quoted += c;
  }
  return quoted + '"';
}

}  // namespace kaori::toml
