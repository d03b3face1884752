#include "appliance/core/update/pending.h"

#include "drivers/base/number.h"
#include "drivers/base/read_file.h"

namespace kaori::update {
namespace {

constexpr std::size_t kMostNote_bytes = 64;  // A version's number and little else: a longer file is none.

// The text up to the next space or line end, which is taken off.
std::string_view NextWord(std::string_view& text) {
  const std::size_t end = text.find_first_of(" \n");
  const std::string_view word = text.substr(0, end);
  text = end == text.npos ? std::string_view() : text.substr(end + 1);
  return word;
}

}  // namespace

std::string Format(const Pending& pending) {
  return std::to_string(pending.version) + (pending.slot == ports::Slot::kA ? " A " : " B ") +
         std::to_string(pending.tries) + "\n";
}

std::optional<Pending> ParsePending(std::string_view text) {
  const auto version = ParseNumber<std::uint32_t>(NextWord(text));
  const std::string_view slot = NextWord(text);
  const auto tries = ParseNumber<std::uint32_t>(NextWord(text));
  if (!version || !tries || (slot != "A" && slot != "B") || !text.empty()) return std::nullopt;
  return Pending{*version, slot == "A" ? ports::Slot::kA : ports::Slot::kB, *tries};
}

std::optional<Pending> ReadPending(const std::filesystem::path& file) {
  return ParsePending(ReadFile(file, {.most_bytes = kMostNote_bytes}).value_or(""));
}

}  // namespace kaori::update
