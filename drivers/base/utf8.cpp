#include "drivers/base/utf8.h"

#include <algorithm>

namespace kaori::utf8 {
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
constexpr Lead kLeads[] = {
    {0x80, 0x00, 1, 0}, {0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}};

// Codes from `first` to `last`, both included.
struct Range {
  char32_t first;
  char32_t last;
};

// East Asian Width W and F, and codes of those blocks that have no letter yet.
constexpr Range kWide[] = {{0x1100, 0x115F},   {0x2E80, 0x303E},  {0x3041, 0x4DBF},   {0x4E00, 0xA4CF},
                           {0xA960, 0xA97F},   {0xAC00, 0xD7A3},  {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},
                           {0xFF01, 0xFF60},   {0xFFE0, 0xFFE6},  {0x1B000, 0x1B2FF}, {0x1F300, 0x1F64F},
                           {0x1F900, 0x1F9FF}, {0x20000, 0x3FFFD}};

// Marks without a shape of their own: joiners, the order of writing, line and paragraph ends, tags, and
// U+FFFD, which stands for what could not be read.
constexpr Range kUnseen[] = {{0x00AD, 0x00AD}, {0x061C, 0x061C},   {0x180E, 0x180E}, {0x200B, 0x200F},
                             {0x2028, 0x202E}, {0x2060, 0x206F},   {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF},
                             {0xFFF0, 0xFFFF}, {0xE0000, 0x10FFFF}};

template <std::size_t kCount>
bool IsIn(const Range (&ranges)[kCount], char32_t code) {
  return std::ranges::any_of(ranges,
                             [code](const Range& each) { return code >= each.first && code <= each.last; });
}

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

bool IsControl(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

bool IsWide(char32_t code) {
  return IsIn(kWide, code);
}

std::size_t Columns(std::string_view text) {
  std::size_t columns = 0;
  while (!text.empty()) {
    const Letter letter = FirstLetter(text);
    text.remove_prefix(letter.bytes);
    columns += IsWide(letter.code) ? 2 : 1;
  }
  return columns;
}

// The cut lies behind the last letter that leaves room for the dots.
std::string Printable(std::string_view text, std::size_t most) {
  constexpr std::string_view kCut = "...";
  std::string shown;
  std::size_t columns = 0, cut_at = 0;
  while (!text.empty()) {
    const Letter letter = FirstLetter(text);
    const bool is_seen = !IsControl(letter.code) && !IsIn(kUnseen, letter.code);
    shown += is_seen ? text.substr(0, letter.bytes) : std::string_view("?");
    text.remove_prefix(letter.bytes);
    columns += is_seen && IsWide(letter.code) ? 2 : 1;
    if (columns + kCut.size() <= most) cut_at = shown.size();
    if (columns > most) return shown.substr(0, cut_at).append(kCut);
  }
  return shown;
}

}  // namespace kaori::utf8
