#include "appliance/programs/update/running.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "drivers/base/number.h"
#include "drivers/base/read_file.h"

namespace kaori::update {
namespace {

constexpr std::size_t kMost_bytes = 256;

// Of the line that begins with this word.
std::optional<std::uint32_t> NumberOf(std::string_view text, std::string_view word) {
  if (!text.starts_with(word)) return std::nullopt;
  text.remove_prefix(word.size());
  return ParseNumber<std::uint32_t>(text.substr(0, text.find('\n')));
}

}  // namespace

Result<Running> ReadRunning(const std::filesystem::path& version, const std::filesystem::path& slot) {
  const auto said = ReadFile(version, {.most_bytes = kMost_bytes});
  if (!said) return tl::unexpected(said.error());
  const auto letter = ReadFile(slot, {.most_bytes = kMost_bytes});
  if (!letter) return tl::unexpected(letter.error());
  const std::string_view text = *said;
  const auto number = NumberOf(text, "version ");
  const auto least = NumberOf(text.substr(std::min(text.size(), text.find('\n') + 1)), "least ");
  if (!number || !least) return FailInput(version.string() + ": it names no version");
  if (*letter != "A" && *letter != "B") return FailInput(slot.string() + ": it names no slot");
  return Running{*number, *least, *letter == "A" ? ports::Slot::kA : ports::Slot::kB};
}

}  // namespace kaori::update
