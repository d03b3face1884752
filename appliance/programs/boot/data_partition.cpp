#include "appliance/programs/boot/data_partition.h"

#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>

#include "appliance/programs/boot/report.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/root_disk.h"

namespace kaori::boot {
namespace {

// e2fsck(8): 1 errors were mended, 2 the same and the system should start anew, which it does here.
constexpr int kMostMended = 3;
constexpr int kNotStarted = 127;
constexpr std::chrono::seconds kLongestCheck(60);  // The splash is there meanwhile.

// ext4 keeps copies of its superblock. These are where it and its first copy lie, with blocks of 1 KiB and of
// 4 KiB (ext4(5), sb=, in KiB).
constexpr std::array<const char*, 3> kSuperblocks{"", "sb=8193", "sb=131072"};

void ReportRuined(const std::string& device, const std::string& why) {
  Report("the data partition " + device + " " + why + ": nothing is kept until the service key is on",
         Trouble::kData);
}

}  // namespace

DataPartition MountDataPartition(const char* place, unsigned long flags) {
  const auto partition = PartitionBesideRoot("/sys/class/block", "data");
  if (!partition)
    return Report("there is no data partition beside the root: nothing is kept", Trouble::kData),
           DataPartition{};
  const std::string device = "/dev/" + *partition;
  const auto mounts = [&](const char* options) {
    return ::mount(device.c_str(), place, "ext4", flags, options) == 0;
  };
  const auto* const by = std::ranges::find_if(kSuperblocks, mounts);
  if (by == kSuperblocks.end()) {
    ReportRuined(device, "cannot be mounted");
    return {.name = *partition, .is_ruined = true};
  }
  if (ErrorsOn("/sys/fs/ext4", *partition) > 0) {
    ::umount(place);
    if (!IsMendedBy({"/sbin/e2fsck", "-p", device}, kLongestCheck) || !mounts("")) {
      ReportRuined(device, "has errors that want a person's word");
      return {.name = *partition, .is_ruined = true, .has_errors = true};
    }
    Report("the data partition " + device + " had errors and is mended: what could be saved is there",
           Trouble::kData);
  } else if (by != kSuperblocks.begin()) {
    Report("the data partition " + device + " has lost its first superblock and is mounted by a copy",
           Trouble::kData);
  }
  return {.name = *partition, .is_mounted = true};
}

std::uint64_t ErrorsOn(const std::filesystem::path& folder, const std::string& partition) {
  const std::string said = ReadFile(folder / partition / "errors_count").value_or("");
  return ParseNumber<std::uint64_t>(std::string_view(said).substr(0, said.find('\n'))).value_or(0);
}

// An alarm outlives execv(2), so that nobody has to wake for it.
bool IsMendedBy(const std::vector<std::string>& words, std::chrono::seconds longest) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(static_cast<unsigned>(longest.count()));
    ::execv(argv[0], argv.data());
    ::_exit(kNotStarted);
  }
  int status = 0;
  if (child < 0) return false;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) <= kMostMended;
}

}  // namespace kaori::boot
