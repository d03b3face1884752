#include "render/image/break_line.h"

#include <algorithm>

#include "drivers/base/utf8.h"

namespace kaori::image {
namespace {

// Two spaces part what belongs together from the next, as in lists of keys.
constexpr std::string_view kWide = "  ";
constexpr auto kNone = std::string_view::npos;

std::string_view Trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == kNone) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// What no line begins with (JIS X 4051, the customary part of it): what closes or ends, what lengthens or repeats
// the letter before, and small kana.
constexpr std::u32string_view kNeverFirst =
    U"、。，．・：；？！゛゜ヽヾゝゞ々ー）〕］｝〉》」』】〟…‥%％℃｡｣､･ｰﾞﾟ"
    U"ぁぃぅぇぉっゃゅょゎァィゥェォッャュョヮヵヶｧｨｩｪｫｬｭｮｯ,.:;?!)]}\u3000";
// What no line ends with: what opens.
constexpr std::u32string_view kNeverLast = U"（〔［｛〈《「『【〝｢([{";

// Japanese is written without spaces; the narrow kana of old file names too.
bool IsWithoutSpaces(char32_t code) {
  return utf8::IsWide(code) || (code >= U'\uFF61' && code <= U'\uFF9F');
}

bool MayPart(char32_t before, char32_t after) {
  return before != U' ' && after != U' ' && (IsWithoutSpaces(before) || IsWithoutSpaces(after)) &&
         kNeverFirst.find(after) == std::u32string_view::npos &&
         kNeverLast.find(before) == std::u32string_view::npos;
}

// Where a line may end, in bytes, in order: before each wide gap.
std::vector<std::size_t> WideGaps(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t at = text.find(kWide); at != kNone; at = text.find(kWide, text.find_first_not_of(' ', at)))
    ends.push_back(at);
  return ends;
}

// The same: before each gap, and between letters that may be parted.
std::vector<std::size_t> AnyGaps(std::string_view text) {
  std::vector<std::size_t> ends;
  char32_t before = U' ';
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, bytes] = utf8::FirstLetter(text.substr(at));
    if ((code == U' ' && before != U' ') || MayPart(before, code)) ends.push_back(at);
    before = code;
    at += bytes;
  }
  return ends;
}

// Where the next line ends: at the last wide gap that fits, else at the last place of any kind, else at the first
// one, however long the line is then.
std::size_t BreakAt(std::string_view text, const Fits& fits) {
  if (fits(text)) return text.size();
  const auto any = AnyGaps(text);
  for (const auto& ends : {WideGaps(text), any}) {
    const auto too_long =
        std::ranges::partition_point(ends, [&](std::size_t end) { return fits(text.substr(0, end)); });
    if (too_long != ends.begin()) return *(too_long - 1);
  }
  return any.empty() ? text.size() : any.front();
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
