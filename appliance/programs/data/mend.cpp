#include "appliance/programs/data/mend.h"

#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>
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

// What of the mounted file system is not as it was kept, as far as can be known: e2fsck cuts off names that lead nowhere without
// a trace, and its status is the same where it has put a whole root in place of one that was gone.
Mended WhatIsSaved(const Partition& partition) {
  std::error_code none;
  const std::filesystem::path nameless = std::filesystem::path(partition.place) / "lost+found";
  const bool lost_names =
      std::filesystem::is_directory(nameless, none) && !std::filesystem::is_empty(nameless, none);
  const auto made = MakeMissingFolders(partition.place, partition.kept);
  if (!made) LogWarning("{}", made.error().message());
  if (made && *made > 0)
    LogWarning("{} had lost {} folders; they are there again, empty", partition.device, *made);
  return !lost_names && made == 0 ? Mended::kSaved : Mended::kInPart;
}

struct Words {
  std::string_view english, japanese;
};

// Behind kOfPartition and kJapaneseOfPartition.
Words WordsOf(Mended mended) {
  switch (mended) {
    case Mended::kSaved:
      return {"was damaged and is mended: what could be saved is there again",
              "を修復しました。救えた内容は残っています"};
    case Mended::kInPart:
      return {"was damaged and is mended in part: some of what was kept is lost",
              "を修復しましたが、内容の一部は失われました"};
    case Mended::kMadeAnew:
      break;
  }
  return {"was beyond mending and is made anew: what was kept is lost",
          "を作り直しました。前の内容は失われました"};
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
  return *saved ? WhatIsSaved(partition) : Mended::kMadeAnew;
}

// Faults of other things stay, in their order.
std::string FaultsAfter(const std::string& faults, Mended mended) {
  std::string after;
  std::istringstream lines(faults);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with(kOfPartition) && !line.starts_with(kJapaneseOfPartition)) after += line + "\n";
  const Words words = WordsOf(mended);
  return fmt::format("{}{}{}\n{}{}\n", after, kOfPartition, words.english, kJapaneseOfPartition,
                     words.japanese);
}

}  // namespace kaori::data
