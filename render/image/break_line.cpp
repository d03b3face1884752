#include "render/image/break_line.h"

#include <algorithm>

namespace kaori::image {
namespace {

// Two spaces part what belongs together from the next, as in lists of keys.
constexpr std::string_view kWide = "  ";
constexpr std::string_view kNarrow = " ";
constexpr auto kNone = std::string_view::npos;

std::string_view Trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == kNone) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// Where the longest beginning that fits ends, at a gap; npos where none does.
std::size_t LastGap(std::string_view text, std::string_view gap, const Fits& fits) {
  std::size_t last = kNone;
  for (std::size_t at = text.find(gap); at != kNone; at = text.find(gap, text.find_first_not_of(' ', at))) {
    if (!fits(text.substr(0, at))) break;
    last = at;
  }
  return last;
}

// Where the next line ends: at a wide gap if one fits, else at a narrow one, else behind the first word,
// however long it is.
std::size_t BreakAt(std::string_view text, const Fits& fits) {
  if (fits(text)) return text.size();
  for (const std::string_view gap : {kWide, kNarrow}) {
    if (const auto at = LastGap(text, gap, fits); at != kNone) return at;
  }
  return std::min(text.find(' '), text.size());
}

}  // namespace

// At least one piece, so that an empty line stays a line.
void BreakLine(std::string_view line, const Fits& fits, std::vector<std::string>& into) {
  std::string_view rest = Trimmed(line);
  do {
    const std::size_t end = BreakAt(rest, fits);
    into.emplace_back(Trimmed(rest.substr(0, end)));
    rest = Trimmed(rest.substr(end));
  } while (!rest.empty());
}

}  // namespace kaori::image
