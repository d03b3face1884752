#include "appliance/core/store/choice.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "drivers/base/checksum.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"

namespace kaori::store {
namespace {

constexpr std::size_t kIdDigits = 64;
constexpr std::size_t kMostChoice_bytes = 4096;
constexpr std::string_view kHead = "kaori-shows 1\n";
constexpr std::string_view kSum = "sum ";

// Of an id, which is written in small letters: two names of one show would be two shows.
bool IsDigit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
}

bool IsShow(std::string_view text) {
  return text == kRootShow || IsId(text);
}

std::string Hex(std::uint64_t value) {
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
  const auto count = static_cast<std::size_t>(end - digits.data());
  return std::string(digits.size() - count, '0') + std::string(digits.data(), count);
}

// Takes "WORD VALUE\n" off the beginning of `text`; nothing where another line stands there.
std::optional<std::string_view> ReadLine(std::string_view& text, std::string_view word) {
  const auto end = text.find('\n');
  if (!text.starts_with(word) || end == std::string_view::npos) return std::nullopt;
  const auto value = text.substr(word.size(), end - word.size());
  text.remove_prefix(end + 1);
  return value;
}

// Of one of the two generations; empty where it cannot be read.
std::string TextOf(const std::filesystem::path& shows, std::size_t which) {
  return ReadFile(shows / kChoiceFiles[which], {.most_bytes = kMostChoice_bytes}).value_or("");
}

}  // namespace

bool IsId(std::string_view text) {
  return text.size() == kIdDigits && std::ranges::all_of(text, IsDigit);
}

std::string PackName(std::string_view id) {
  return std::string(id) + ".kaori";
}

// The checksum is over all lines before it, the head included.
std::string Format(const Choice& choice) {
  std::string text(kHead);
  text += "generation " + std::to_string(choice.generation) + "\n";
  text += "current " + choice.current + "\n";
  text += "previous " + choice.previous + "\n";
  return text + std::string(kSum) + Hex(Fnv1a(text)) + "\n";
}

// The checksum first, so that nothing of a torn file is believed.
std::optional<Choice> ParseChoice(std::string_view text) {
  const auto sum_at = text.rfind(kSum);
  if (!text.starts_with(kHead) || sum_at == std::string_view::npos) return std::nullopt;
  if (text.substr(sum_at) != std::string(kSum) + Hex(Fnv1a(text.substr(0, sum_at))) + "\n")
    return std::nullopt;
  text.remove_prefix(kHead.size());
  const auto generation = ReadLine(text, "generation ");
  const auto current = ReadLine(text, "current ");
  const auto previous = ReadLine(text, "previous ");
  if (!generation || !current || !previous || !IsShow(*current) || !IsShow(*previous)) return std::nullopt;
  Choice choice{0, std::string(*current), std::string(*previous)};
  const auto read =
      std::from_chars(generation->data(), generation->data() + generation->size(), choice.generation);
  if (read.ec != std::errc() || read.ptr != generation->data() + generation->size()) return std::nullopt;
  return choice;
}

// Generations never meet: the writer takes the older file's place with the next number.
std::optional<Choice> NewerSound(std::string_view first, std::string_view second) {
  auto a = ParseChoice(first), b = ParseChoice(second);
  return !a || (b && b->generation > a->generation) ? b : a;
}

Choice Newer(std::string_view first, std::string_view second) {
  return NewerSound(first, second).value_or(Choice());
}

bool HasChoice(const std::filesystem::path& shows) {
  return NewerSound(TextOf(shows, 0), TextOf(shows, 1)).has_value();
}

Choice ReadChoice(const std::filesystem::path& shows) {
  return Newer(TextOf(shows, 0), TextOf(shows, 1));
}

// The older of two sound files is written over, never the newer one.
std::uint64_t NextGeneration(const Choice& newest, std::uint64_t told) {
  const std::uint64_t next = std::max(newest.generation, told) + 1;
  return newest.generation > 0 && next % 2 == newest.generation % 2 ? next + 1 : next;
}

std::uint64_t ReadTold(const std::filesystem::path& file) {
  constexpr std::size_t kMostNumber_bytes = 32;
  const std::string text = ReadFile(file, {.most_bytes = kMostNumber_bytes}).value_or("");
  return ParseNumber<std::uint64_t>(std::string_view(text).substr(0, text.find('\n'))).value_or(0);
}

std::vector<std::string> InOrder(const Choice& choice) {
  std::vector<std::string> order;
  for (const std::string& id : {choice.current, choice.previous, std::string(kRootShow)})
    if (std::ranges::find(order, id) == order.end()) order.push_back(id);
  return order;
}

std::filesystem::path PackOf(std::string_view id, const std::filesystem::path& shows,
                             const std::filesystem::path& root_pack) {
  if (id == kCopiedShow) return shows / kCopyName;
  return IsId(id) ? shows / PackName(id) : root_pack;
}

}  // namespace kaori::store
