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
constexpr std::chrono::seconds kLongestCheck(40);  // The splash is there meanwhile.

// ext4 keeps copies of its superblock. Without a word, and with the first copy, as it lies with blocks of 4 KiB and of 1 KiB, e2fsck finds
// the file system by these (e2fsck(8)).
constexpr std::array<std::array<const char*, 4>, 3> kSuperblocks{
    {{}, {"-b", "32768", "-B", "4096"}, {"-b", "8193", "-B", "1024"}}};

// By e2fsck, which is to ask nobody: what costs a file or a name is not done.
bool IsMended(const std::string& device) {
  return std::ranges::any_of(kSuperblocks, [&](const auto& superblock) {
    std::vector<std::string> words{"/sbin/e2fsck", "-p"};
    for (const char* word : superblock)
      if (word != nullptr) words.emplace_back(word);
    words.push_back(device);
    return IsMendedBy(words, kLongestCheck);
  });
}

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
  const auto mounts = [&] { return ::mount(device.c_str(), place, "ext4", flags, "") == 0; };
  const bool can_be_mounted = mounts();
  if (can_be_mounted && ErrorsOn("/sys/fs/ext4", *partition) == 0)
    return {.name = *partition, .is_mounted = true};
  if (can_be_mounted) ::umount(place);
  if (IsMended(device) && mounts()) {
    Report("the data partition " + device + " was damaged and is mended: what could be saved is there again",
           Trouble::kData);
    return {.name = *partition, .is_mounted = true};
  }
  ReportRuined(device, can_be_mounted ? "has errors that want a person's word" : "cannot be mounted");
  return {.name = *partition, .has_errors = can_be_mounted};
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
