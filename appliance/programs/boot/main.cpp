// kaori-boot: the first program of the box. Lights its screens with the picture of her last face, or of the
// show's first one, makes ready what the stage needs at once, and becomes the system's own first program.
//
// It says nothing, whatever fails: a box that cannot show a still starts all the same, and a moment later the
// stage says what is wrong.
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "appliance/programs/boot/ahead.h"
#include "appliance/programs/boot/card.h"
#include "appliance/programs/boot/data_partition.h"
#include "appliance/programs/boot/known_shaders.h"
#include "appliance/programs/boot/profile.h"
#include "appliance/programs/boot/root_hash.h"
#include "appliance/programs/boot/still.h"
#include "firmware/wire/last_face.h"

namespace {

constexpr const char* kStill = "/usr/share/kaori/still.ppm";
constexpr const char* kLastFace = "/var/lib/kaori/own/last-face";
constexpr const char* kPack = "/usr/share/kaori/kaori.kaori";
constexpr const char* kKnownShaders = "/usr/share/kaori/shaders.known";
constexpr const char* kStageFolder = "/run/kaori";  // Where its unit tells Mesa to keep shaders.
constexpr const char* kAhead = "/usr/share/kaori/ahead";
constexpr const char* kCard = "/dev/dri/card0";
constexpr const char* kData = "/var/lib/kaori";
constexpr const char* kProfiles = "/run/kaori-profile";
constexpr const char* kSystem = "/usr/lib/systemd/systemd";

constexpr int kLongestMount_ms = 1000;  // A disk that takes longer is not waited for, and
constexpr int kLongestLight_ms = 2500;  // neither is a card.
constexpr unsigned kLook_us = 200'000;  // How often the light looks whether it is still needed,
constexpr int kMostLooks = 5 * 60 * 5;  // and how often at most: five minutes.

// A whole file, or as much of its beginning, mapped for as long as the program lives.
std::span<const std::uint8_t> Map(const char* path, std::size_t most = SIZE_MAX) {
  const int fd = ::open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  struct stat status {};
  if (fd < 0 || ::fstat(fd, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0) return {};
  const auto bytes = std::min(static_cast<std::size_t>(status.st_size), most);
  void* const at = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_POPULATE, fd, 0);
  ::close(fd);
  if (at == MAP_FAILED) return {};
  return {static_cast<const std::uint8_t*>(at), bytes};
}

// Ends once the stage shows its own pictures: before, the screens would go dark with this program.
void KeepLit(const kaori::boot::Card& card, const std::vector<kaori::boot::Lit>& lit) {
  for (int looks = 0; looks < kMostLooks && card.Shows(lit); ++looks) ::usleep(kLook_us);
}

// Her last face is shown only to be gone on with: not without the disk from which the stage will take it.
std::optional<kaori::boot::Still> ChooseStill() {
  namespace wire = kaori::wire;
  const auto last = kaori::boot::ReadLastStill(Map(kLastFace, wire::kLargestLastFace_bytes + 1),
                                               Map(kPack, wire::kShowMark_bytes));
  return last ? last : kaori::boot::ReadStill(Map(kStill));
}

void Await(int closed, int longest_ms) {
  pollfd look{.fd = closed, .events = POLLIN, .revents = 0};
  ::poll(&look, 1, longest_ms);
}

// `mounted` is closed when the data partition is there, `done` when the card is free for the next program.
void Light(int mounted, int done) {
  Await(mounted, kLongestMount_ms);
  const auto still = ChooseStill();
  if (!still) return;
  const kaori::boot::Card card(kCard);
  const auto lit = card.Light(*still);
  card.GiveWay();
  ::close(done);
  KeepLit(card, lit);
}

// Cards are the stage's before udev, which runs later, says the same.
void GiveCards() {
  constexpr gid_t kVideo = 44;  // As the root's etc/group has them.
  constexpr gid_t kRender = 102;
  constexpr mode_t kGroupsToo = 0660;
  constexpr const char* kDraws = "/dev/dri/renderD128";
  if (::chown(kCard, 0, kVideo) == 0) ::chmod(kCard, kGroupsToo);
  if (::chown(kDraws, 0, kRender) == 0) ::chmod(kDraws, kGroupsToo);
}

// What it said, for whoever looks at the box's status.
std::string g_faults;

// Into the kernel's log, which the journal reads. Nothing of it comes to the show's screens.
void Say(const std::string& words) {
  g_faults += words + "\n";
  const std::string line = "<4>kaori-boot: " + words + "\n";
  const int fd = ::open("/dev/kmsg", O_WRONLY | O_CLOEXEC);
  if (::write(fd, line.data(), line.size()) < 0) return;
  ::close(fd);
}

// What a show keeps. Where this fails the system tries once more, and the show plays without.
void MountData() {
  constexpr unsigned long kPlain = MS_NODEV | MS_NOSUID | MS_NOEXEC;
  ::mount("sysfs", "/sys", "sysfs", kPlain, nullptr);
  const auto partition = kaori::boot::FindDataPartition("/sys/class/block");
  if (!partition) return Say("there is no data partition beside the root: nothing is kept");
  const std::string device = "/dev/" + *partition;
  if (::mount(device.c_str(), kData, "ext4", kPlain, nullptr) != 0)
    Say("the data partition " + device + " cannot be mounted: nothing is kept");
}

// Meanwhile, while a processor has nothing else to do; but not more than half of the memory that is left.
void StartReadingAhead() {
  struct sysinfo now {};
  if (::sysinfo(&now) != 0 || ::fork() != 0) return;
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_IDLE, &none);
  kaori::boot::ReadAhead(kAhead, std::size_t{now.freeram} * now.mem_unit / 2);
  ::_exit(0);
}

void WriteFile(const std::string& path, const std::string& text) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0444);
  if (::write(fd, text.data(), text.size()) < 0) return;
  ::close(fd);
}

// The hash at the root of the tree that the kernel checks the box's root against; empty where it checks none.
std::string RootHash() {
  ::mount("proc", "/proc", "proc", MS_NODEV | MS_NOSUID | MS_NOEXEC, nullptr);
  std::array<char, 4096> line{};
  const int fd = ::open("/proc/cmdline", O_RDONLY | O_CLOEXEC);
  if (fd < 0) return {};
  const ssize_t bytes = ::read(fd, line.data(), line.size());
  ::close(fd);
  return kaori::boot::RootHashOf({line.data(), bytes < 0 ? 0 : static_cast<std::size_t>(bytes)});
}

// In a folder that is there before everything else: for udev's rules a file named after the profile, for
// kaori-input what its lines are, for kaori-stage which screen is people's, and what its status says.
void ApplySettings() {
  const auto profile = kaori::boot::ChooseProfile(std::string(kData) + "/settings");
  if (!profile.fault.empty()) Say(profile.fault);
  ::mount("tmpfs", "/run", "tmpfs", MS_NODEV | MS_NOSUID | MS_STRICTATIME, "mode=755,size=20%");
  ::mkdir(kProfiles, 0755);
  WriteFile(std::string(kProfiles) + "/" + profile.name, {});
  WriteFile(std::string(kProfiles) + "/lines", EnvironmentOf(profile.wiring));
  WriteFile(std::string(kProfiles) + "/status_screen", profile.status_screen);
  WriteFile(std::string(kProfiles) + "/root_hash", RootHash());
  WriteFile(std::string(kProfiles) + "/faults", g_faults);
}

}  // namespace

int main(int, char** argv) {
  std::array<int, 2> mounted{-1, -1}, done{-1, -1};
  if (::pipe2(mounted.data(), O_CLOEXEC) == 0 && ::pipe2(done.data(), O_CLOEXEC) == 0) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(mounted[1]);
      ::close(done[0]);
      Light(mounted[0], done[1]);
      ::_exit(0);
    }
    ::close(mounted[0]);
    ::close(done[1]);
    MountData();
    ::close(mounted[1]);
    GiveCards();
    ApplySettings();
    if (!kaori::boot::TellKnownShaders(kKnownShaders, kStageFolder)) Say("Mesa is not told which shaders it has");
    if (child > 0) Await(done[0], kLongestLight_ms);
    StartReadingAhead();
  }
  ::execv(kSystem, argv);
  return 1;
}
