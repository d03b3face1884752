#include "render/image/utf8.h"

namespace kaori::image {
namespace {

// What is drawn for a byte that is no UTF-8.
constexpr Letter kUnsound{U'\uFFFD', 1};

// What a first byte says (RFC 3629, section 3): how many bytes, which of its bits belong to the code, and the
// least code that needs that many, since longer forms of a code are not allowed.
struct Lead {
  unsigned mask;
  unsigned mark;
  std::size_t bytes;
  char32_t least;
};
// By the number of bytes: which bits of the first byte tell it, how they stand, the length, and the smallest
// code that needs so many (RFC 3629, section 3). A smaller code in this form is refused.
constexpr Lead kLeads[] = {
    {0x80, 0x00, 1, 0}, {0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}};

// No surrogate, and no code beyond Unicode.
bool IsCode(char32_t code) {
  return code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
}

// Reads the bytes that `lead` asks for. One byte alone is given up where they are wrong, so that reading
// finds its way back.
Letter Follow(std::string_view text, const Lead& lead) {
  if (text.size() < lead.bytes) return kUnsound;
  char32_t code = static_cast<unsigned char>(text[0]) & ~lead.mask & 0xFFU;
  for (const char more : text.substr(1, lead.bytes - 1)) {
    const auto byte = static_cast<unsigned char>(more);
    if ((byte & 0xC0U) != 0x80U) return kUnsound;
    code = code << 6U | (byte & 0x3FU);
  }
  return IsCode(code) && code >= lead.least ? Letter{code, lead.bytes} : kUnsound;
}

}  // namespace

// The first byte's upper bits say how many follow; 10xxxxxx begins nothing.
Letter FirstLetter(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  for (const Lead& lead : kLeads)
    if ((first & lead.mask) == lead.mark) return Follow(text, lead);
  return kUnsound;
}

}  // namespace kaori::image
