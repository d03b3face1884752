#include "appliance/programs/data/mend.h"

#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/log.h"

namespace kaori::data {
namespace {

constexpr const char* kCheck = "/sbin/e2fsck";
constexpr const char* kMake = "/sbin/mke2fs";
constexpr const char* kSystemctl = "/bin/systemctl";
// e2fsck(8): 1 errors were mended, 2 the same and the system should start anew; greater ones were not mended.
constexpr int kMostMended = 3;
// How kaori-boot begins each line about the partition.
constexpr std::string_view kOfPartition = "the data partition ";

// Errors: io_error where the program's status is greater than `most`.
Result<void> RunWell(const Partition& partition, const std::vector<std::string>& words, int most = 0) {
  const auto status = partition.run(words);
  if (!status) return tl::unexpected(status.error());
  if (*status <= most) return {};
  return Fail(std::errc::io_error, fmt::format("{} {}: status {}", words[0], partition.device, *status));
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

// Whatever keeps the old file system from being mended and mounted leads to a new one, also an e2fsck that
// could not be run or did not come to its end.
Result<Mended> Mend(const Partition& partition) {
  auto saved = RunWell(partition, {kCheck, "-f", "-y", partition.device}, kMostMended);
  if (saved) saved = Mount(partition);
  if (saved) return Mended::kWhole;
  LogWarning("{}; the data partition is made anew", saved.error().message());
  if (auto made = MakeAnew(partition); !made) return tl::unexpected(made.error());
  if (auto mounted = Mount(partition); !mounted) return tl::unexpected(mounted.error());
  return Mended::kMadeAnew;
}

// Faults of other things stay, in their order.
std::string FaultsAfter(const std::string& faults, Mended mended) {
  std::string after;
  std::istringstream lines(faults);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with(kOfPartition)) after += line + "\n";
  return after + std::string(kOfPartition) +
         (mended == Mended::kWhole ? "was damaged and is mended: what is kept is there again\n"
                                   : "was beyond mending and is made anew: what was kept is lost\n");
}

}  // namespace kaori::data
