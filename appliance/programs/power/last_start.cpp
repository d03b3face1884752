#include "appliance/programs/power/last_start.h"

#include <linux/watchdog.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "drivers/base/folder.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::power {
namespace {

// The file is one line, "BOOT-ID STATE".
constexpr const char* kRuns = "runs";
constexpr const char* kStopped = "stopped";
constexpr std::size_t kMostNoteBytes = 256;
constexpr unsigned kNoteMode = 0644;

// Without the end of its line; empty where the file cannot be read.
std::string LineOf(const std::filesystem::path& file) {
  std::string line = ReadFile(file, {.most_bytes = kMostNoteBytes}).value_or("");
  if (!line.empty() && line.back() == '\n') line.pop_back();
  return line;
}

}  // namespace

Result<std::string> LastStart::Begin() {
  const std::string before = LineOf(file_);
  const std::string boot = LineOf(machine_.boot_id);
  const auto space = before.find(' ');
  if (!boot.empty() && before.substr(0, space) == boot) return std::string();
  if (auto written = Write(kRuns); !written) return tl::unexpected(written.error());
  const std::string_view state =
      space == std::string::npos ? std::string_view() : std::string_view(before).substr(space + 1);
  if (state == kStopped) return std::string("the last start ended by a clean stop");
  if (state != kRuns) return std::string("nothing is known of a start before this one");
  if (WasResetByWatchdog()) return std::string("the last start ended by the machine's watchdog: it hung");
  return std::string("the last start ended without a stop: power cut, reset, or a crash of the kernel");
}

Result<void> LastStart::NoteStop() {
  return Write(kStopped);
}

Result<void> LastStart::Write(const char* state) {
  auto boot = ReadFile(machine_.boot_id, {.most_bytes = kMostNoteBytes});
  if (!boot) return tl::unexpected(boot.error());
  const std::string note = boot->substr(0, boot->find('\n')) + " " + state + "\n";
  return WriteWholeFile(file_, {AsBytes(note)}, kNoteMode);
}

bool LastStart::WasResetByWatchdog() const {
  const auto watchdogs = ListFolder(machine_.watchdogs);
  return watchdogs && std::ranges::any_of(*watchdogs, [](const std::filesystem::path& watchdog) {
           const auto bits = ParseNumber<std::uint32_t>(LineOf(watchdog / "bootstatus"));
           return bits && (*bits & WDIOF_CARDRESET) != 0;
         });
}

}  // namespace kaori::power
