#include "appliance/programs/update/running.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"

namespace kaori::update {
namespace {

constexpr std::size_t kMost_bytes = 256;

// What follows a word on the line that begins with it, wherever that stands; a root of before has fewer lines, and a newer one may have
// more.
std::optional<std::string_view> AfterWord(std::string_view text, std::string_view word) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.starts_with(word)) return line.substr(word.size());
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return std::nullopt;
}

// None where there is no such line, or something else than a number on it.
std::optional<std::uint32_t> NumberOf(std::string_view text, std::string_view word) {
  const auto number = AfterWord(text, word);
  return number ? ParseNumber<std::uint32_t>(*number) : std::nullopt;
}

}  // namespace

Result<ports::Slot> ReadSlot(const std::filesystem::path& slot) {
  const auto letter = ReadFile(slot, {.most_bytes = kMost_bytes});
  if (!letter) return tl::unexpected(letter.error());
  if (*letter != "A" && *letter != "B") return FailInput(slot.string() + ": it names no slot");
  return *letter == "A" ? ports::Slot::kA : ports::Slot::kB;
}

Result<Running> ReadRunning(const std::filesystem::path& version, const std::filesystem::path& slot) {
  const auto said = ReadFile(version, {.most_bytes = kMost_bytes});
  if (!said) return tl::unexpected(said.error());
  const auto running = ReadSlot(slot);
  if (!running) return tl::unexpected(running.error());
  const std::string_view text = *said;
  const auto number = NumberOf(text, "version ");
  const auto least = NumberOf(text, "least ");
  if (!number || !least) return FailInput(version.string() + ": it names no version");
  return Running{*number, *least, *running, std::string(AfterWord(text, "product ").value_or(kProduct))};
}

show::PublicKeys TrustedKeys(const std::filesystem::path& folder) {
  std::vector<std::string> faults;
  const std::vector<std::filesystem::path> folders{folder};
  const auto keys = show::ReadPublicKeys(folders, &faults);
  for (const std::string& fault : faults) LogWarning("{}", fault);
  return keys.value_or(show::PublicKeys{});
}

}  // namespace kaori::update
