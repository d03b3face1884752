#include "appliance/programs/data/mend.h"

#include <sstream>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "drivers/base/log.h"

namespace kaori::data {
namespace {

constexpr const char* kCheck = "/sbin/e2fsck";
constexpr const char* kMake = "/sbin/mke2fs";
constexpr const char* kSystemctl = "/bin/systemctl";
// e2fsck(8): 1 errors were mended, 2 the same and the system should start anew; 4 errors are left, 8 it finds
// no file system that it could mend. Any other status, or a signal, says nothing of the file system.
constexpr int kMostMended = 3, kErrorsLeft = 4, kNoFileSystem = 8;
// How kaori-boot begins each line about the partition, in English and Japanese.
constexpr std::string_view kOfPartition = "the data partition ", kJapaneseOfPartition = "データの領域";

tl::unexpected<Error> FailedWith(int status, const Partition& partition, const std::string& program) {
  return Fail(std::errc::io_error, fmt::format("{} {}: status {}", program, partition.device, status));
}

// Errors: io_error where the program's status is not 0.
Result<void> RunWell(const Partition& partition, const std::vector<std::string>& words) {
  const auto status = partition.run(words);
  if (!status) return tl::unexpected(status.error());
  if (*status == 0) return {};
  return FailedWith(*status, partition, words[0]);
}

// Whether the file system is whole, or was mended; false where it is beyond mending. A second check often ends what a first
// one left, and its 8 is also that of a device which is busy, or could not be read for once. Errors: those of a check that
// came to no end, which says nothing of what is kept.
Result<bool> Save(const Partition& partition) {
  constexpr int kChecks = 3;
  for (int checks = 0; checks < kChecks; ++checks) {
    if (checks > 0) std::this_thread::sleep_for(partition.pause);
    const auto status = partition.run({kCheck, "-f", "-y", partition.device});
    if (!status) return tl::unexpected(status.error());
    if (*status >= 0 && *status <= kMostMended) return true;
    if (*status < 0 || *status > (kMostMended | kErrorsLeft | kNoFileSystem))
      return FailedWith(*status, partition, kCheck);
  }
  return false;
}

// A unit that failed when the box started is not started again before it is reset.
Result<void> Mount(const Partition& partition) {
  static_cast<void>(partition.run({kSystemctl, "reset-failed", partition.unit}));
  return RunWell(partition, {kSystemctl, "start", partition.unit});
}

// As the image's builder makes it. -F: what is left of the old file system is no reason to ask.
Result<void> MakeAnew(const Partition& partition) {
  return RunWell(partition, {kMake, "-q", "-F", "-t", "ext4", "-m", "0", "-L", "kaori-data", "-d",
                             partition.folders, partition.device});
}

}  // namespace

// Only what e2fsck has found beyond mending is replaced. A check that was killed, or a mount that systemd
// refuses although the file system is whole, is tried again later: what is kept is worth the wait.
Result<Mended> Mend(const Partition& partition) {
  const auto saved = Save(partition);
  if (!saved) return tl::unexpected(saved.error());
  if (!*saved) {
    LogWarning("{} cannot mend {}; the data partition is made anew", kCheck, partition.device);
    if (auto made = MakeAnew(partition); !made) return tl::unexpected(made.error());
  }
  if (auto mounted = Mount(partition); !mounted) return tl::unexpected(mounted.error());
  return *saved ? Mended::kWhole : Mended::kMadeAnew;
}

// Faults of other things stay, in their order.
std::string FaultsAfter(const std::string& faults, Mended mended) {
  std::string after;
  std::istringstream lines(faults);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with(kOfPartition) && !line.starts_with(kJapaneseOfPartition)) after += line + "\n";
  const bool is_whole = mended == Mended::kWhole;
  return fmt::format(
      "{}{}{}\n{}{}\n", after, kOfPartition,
      is_whole ? "was damaged and is mended: what is kept is there again"
               : "was beyond mending and is made anew: what was kept is lost",
      kJapaneseOfPartition,
      is_whole ? "を修復しました。内容は残っています" : "を作り直しました。前の内容は失われました");
}

}  // namespace kaori::data
