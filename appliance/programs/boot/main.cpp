// kaori-boot: process 1 of the box. Shows the boot splash (the picture of the last face, or of the show's
// first one), mounts what is kept, applies the settings, and then becomes systemd.
//
// Nothing stops it: a box that cannot show a splash starts all the same, and a moment later the stage says what is
// wrong. What it has to say itself goes to the kernel's log.
#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "appliance/core/last_face/last_face.h"
#include "appliance/core/restore/apply.h"
#include "appliance/core/store/choice.h"
#include "appliance/core/update/pending.h"
#include "appliance/programs/boot/ahead.h"
#include "appliance/programs/boot/card.h"
#include "appliance/programs/boot/data_partition.h"
#include "appliance/programs/boot/known_shaders.h"
#include "appliance/programs/boot/machine_id.h"
#include "appliance/programs/boot/network.h"
#include "appliance/programs/boot/pc_faults.h"
#include "appliance/programs/boot/pipe.h"
#include "appliance/programs/boot/profile.h"
#include "appliance/programs/boot/report.h"
#include "appliance/programs/boot/reset.h"
#include "appliance/programs/boot/root_hash.h"
#include "appliance/programs/boot/still.h"
#include "appliance/programs/boot/usb_medium.h"
#include "drivers/base/graphics_cards.h"
#include "drivers/base/read_file.h"
#include "drivers/base/root_disk.h"
#include "drivers/base/whole_file.h"

namespace {

using kaori::UniqueFd;

constexpr std::string_view kHelp = R"(kaori-boot: the first program of the box

It shows the boot splash, mounts the data partition, /proc, /sys and /run, applies the settings, and becomes systemd.
It has no options, and does nothing unless it is process 1, as the kernel starts it (init=/usr/bin/kaori-boot).
)";

// Paths of the image: read-only below /usr, kept on the data partition below /var/lib/kaori, in memory below
// /run.
constexpr const char* kStill = "/usr/share/kaori/still.ppm";
constexpr const char* kLastFace = "/var/lib/kaori/own/last-face";
constexpr const char* kPack = "/usr/share/kaori/kaori.kaori";
constexpr const char* kShows = "/var/lib/kaori/shows";
constexpr const char* kKnownShaders = "/usr/share/kaori/shaders.known";
constexpr const char* kStageFolder = "/run/kaori";  // Where its unit tells Mesa to keep shaders.
constexpr const char* kAhead = "/usr/share/kaori/ahead";
constexpr const char* kCards = "/dev/dri";
constexpr const char* kData = "/var/lib/kaori";
constexpr const char* kZones = "/usr/share/zoneinfo";
constexpr const char* kProfiles = "/run/kaori-profile";
constexpr const char* kSystem = "/usr/lib/systemd/systemd";

// The process id by which the program knows that the kernel has started it, and its status when it is misused.
constexpr pid_t kFirstProcess = 1;
constexpr int kMisused = 2;
constexpr int kLongestMount_ms = 1000;         // A disk that takes longer is not waited for, and
constexpr int kLongestSplash_ms = 2500;        // neither is a card.
constexpr unsigned kCheckPeriod_us = 200'000;  // How often the splash asks whether it is still shown.

// Maps a whole file, or as much of its beginning, for as long as the program lives: the splash waits for no copy.
std::span<const std::uint8_t> Map(const char* path, std::size_t most = SIZE_MAX) {
  const UniqueFd fd(::open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat status {};
  if (!fd.valid() || ::fstat(fd.get(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0)
    return {};
  const auto bytes = std::min(static_cast<std::size_t>(status.st_size), most);
  void* const at = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE | MAP_POPULATE, fd.get(), 0);
  if (at == MAP_FAILED) return {};
  return {static_cast<const std::uint8_t*>(at), bytes};
}

// Returns once the stage shows its own pictures, however late: before, the screens would go dark with this program.
void AwaitStage(const kaori::boot::Card& card, const std::vector<kaori::boot::Splash>& shown) {
  while (card.IsShown(shown)) ::usleep(kCheckPeriod_us);
}

// The last face is shown only where the stage will resume it: not without the disk on which its state lies,
// nor where another show was chosen since.
std::optional<kaori::boot::Still> ChooseStill() {
  namespace last_face = kaori::last_face;
  const auto pack = kaori::store::PackOf(kaori::store::ReadChoice(kShows).current, kShows, kPack);
  const auto last = kaori::boot::ReadLastStill(Map(kLastFace, last_face::kLargest_bytes + 1),
                                               Map(pack.c_str(), last_face::kShowMark_bytes));
  return last ? last : kaori::boot::ReadStill(Map(kStill));
}

// `mounted` is closed when the data partition is there, and before it /sys; `done` is closed when the card is free for the stage.
// Where the kernel's list cannot be read, or has no screens yet, the first card is asked: that does no harm.
void ShowSplash(const UniqueFd& mounted, UniqueFd done) {
  kaori::boot::AwaitClose(mounted, kLongestMount_ms);
  const auto still = ChooseStill();
  if (!still) return;
  const std::string name = kaori::CardWithScreens("/sys/class/drm").value_or("card0");
  const kaori::boot::Card card((std::string(kCards) + "/" + name).c_str());
  const auto shown = card.ShowOnAll(*still);
  card.DropMaster();
  done.reset();
  AwaitStage(card, shown);
}

// The stage's groups, as the root's etc/group has them.
constexpr gid_t kVideo = 44;
constexpr gid_t kRender = 102;

using kaori::boot::Report, kaori::boot::Trouble;

// Nothing that is kept may bring devices, rights or programs with it.
constexpr unsigned long kPlainMount = MS_NODEV | MS_NOSUID | MS_NOEXEC;

// Mounts what a show keeps, below /proc and /sys, which come first: the partition is looked for in the latter. systemd finds both
// mounted.
kaori::boot::DataPartition MountData() {
  ::mount("proc", "/proc", "proc", kPlainMount, nullptr);
  ::mount("sysfs", "/sys", "sysfs", kPlainMount, nullptr);
  return kaori::boot::MountDataPartition(kData, kPlainMount);
}

// Before anybody reads what it changes. One that cannot be finished is tried again at each start.
void Restore() {
  const auto restored = kaori::restore::FinishRestore(kData);
  if (!restored) Report("the restore is not done: " + restored.error().message(), Trouble::kNotRestored);
  if (restored.value_or(false))
    Report("the backup is restored; what was there before is kept", Trouble::kRestored);
}

// Reads ahead in a process of its own, while a processor has nothing else to do; at most half of the free
// memory.
void StartReadingAhead() {
  struct sysinfo now {};
  if (::sysinfo(&now) != 0 || ::fork() != 0) return;
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_IDLE, &none);
  kaori::boot::ReadAhead(kAhead, std::size_t{now.freeram} * now.mem_unit / 2);
  ::_exit(0);
}

// One setting as a file of its name in kProfiles. WriteWholeFile wants /proc, which is mounted by now.
void WriteSetting(const std::string& name, std::string_view text) {
  constexpr unsigned kReadOnly = 0444;
  const std::string file = std::string(kProfiles) + "/" + name;
  if (auto written = kaori::WriteWholeFile(file, {kaori::AsBytes(text)}, kReadOnly); !written)
    Report(written.error().message());
}

// `network` lies there where the box has an address, and lets systemd start the desk with the service key.
void JoinNetwork(const kaori::boot::NetworkAddress& address) {
  const auto joined = kaori::boot::JoinNetwork(address, "/sys/class/net", "/run/systemd/system");
  if (!joined) return Report("the box has no network: " + joined.error().message(), Trouble::kNetwork);
  WriteSetting("network", NetworkOf(address) + "\n");
}

// Leaves in a folder that is there before everything else: for udev's rules a file that is named after the
// profile, for kaori-input which lines are what, for kaori-stage its time zone and which screens are
// the technicians' and the operators', and what the status says. Returns the name that the settings give the box, or nothing.
std::string ApplySettings(const kaori::boot::DataPartition& data) {
  auto profile = kaori::boot::ChooseProfile(std::string(kData) + "/settings");
  if (!profile.fault.empty()) Report(profile.fault, Trouble::kSettings);
  if (const auto fault = DropUnknownZone(profile, kZones); !fault.empty()) Report(fault, Trouble::kSettings);
  ::mount("tmpfs", "/run", "tmpfs", MS_NODEV | MS_NOSUID | MS_STRICTATIME, "mode=755,size=20%");
  ::mkdir(kProfiles, 0755);
  WriteSetting(profile.name, {});
  WriteSetting("lines", EnvironmentOf(profile.wiring));
  WriteSetting("dials", DialsEnvironmentOf(profile));
  WriteSetting("clock", ClockEnvironmentOf(profile));
  WriteSetting("status_screen", profile.status_screen);
  WriteSetting("monitor_screen", profile.monitor_screen);
  const std::string command_line = kaori::ReadFile("/proc/cmdline").value_or("");
  WriteSetting("root_hash", kaori::boot::RootHashOf(command_line));
  const std::string slot = kaori::boot::SlotOf(command_line);
  WriteSetting("slot", slot);
  // Whether this start is a try of an update, for a timer that ends one which comes to no verdict.
  if (kaori::boot::IsTried(kaori::ReadFile(kaori::update::kPendingFile).value_or(""), slot))
    WriteSetting("trial", {});
  // From it systemd takes the argument of a restart (systemctl(1)); kaori-update may write it, and no other file there.
  ::mkdir("/run/systemd", 0755);
  if (auto made = kaori::WriteWholeFile("/run/systemd/reboot-param", {}); !made)
    Report(made.error().message());
  if (profile.network) JoinNetwork(*profile.network);
  WriteSetting("faults", kaori::boot::Reported());
  // By it udev makes the link that systemd mounts: another disk may have a partition of the same number.
  if (!data.name.empty()) WriteSetting("data-" + data.name, {});
  if (data.has_errors) WriteSetting("data_errors", {});
  if (data.is_ruined()) WriteSetting("data_ruined", "/dev/" + data.name);
  return profile.box_name;
}

// Writes a setting and lays it over an empty or general file of the root: a copy in memory, so that nothing holds the
// partition.
void LayOver(const std::string& file, const std::string& setting, const std::string& text) {
  WriteSetting(setting, text + "\n");
  const std::string copy = std::string(kProfiles) + "/" + setting;
  if (::mount(copy.c_str(), file.c_str(), nullptr, MS_BIND, nullptr) != 0)
    Report("the box's own " + setting + " cannot be laid over " + file);
}

// A box on a USB disk: udev's rules know its devices by these files, and leave them alone.
void KeepMedium() {
  const auto medium = kaori::boot::UsbMedium("/sys/class/block");
  for (const std::string& device : medium) WriteSetting("medium-" + device, {});
  kaori::boot::DeauthoriseOthers("/sys/bus/usb/devices", medium);
}

// Lays the box's own number over the root's empty /etc/machine-id, since the journal keeps its files in a folder of that
// name and systemd would else make up another number at each start; and its name over /etc/hostname, which systemd takes.
void ApplyIdentity(const std::string& wanted_name) {
  const auto number =
      kaori::boot::KeptMachineId(std::string(kData) + "/machine-id", kaori::boot::MachineMark("/sys"));
  if (number)
    LayOver("/etc/machine-id", "machine-id", *number);
  else
    Report(number.error().message());
  LayOver("/etc/hostname", "name", kaori::boot::NameOfBox(wanted_name, number.value_or("")));
}

// Everything before systemd. The splash has a process of its own, so that a slow card holds nothing up.
void Boot() {
  auto mounted = kaori::boot::MakePipe();
  auto done = kaori::boot::MakePipe();
  if (!mounted || !done) return;
  const pid_t child = ::fork();
  if (child == 0) {
    mounted->write_end.reset();
    done->read_end.reset();
    ShowSplash(mounted->read_end, std::move(done->write_end));
    ::_exit(0);
  }
  mounted->read_end.reset();
  done->write_end.reset();
  const auto data = MountData();
  if (const auto said = data.is_mounted ? kaori::boot::Reset(kData) : ""; !said.empty()) Report(said);
  if (data.is_mounted) Restore();
  mounted->write_end.reset();
  kaori::boot::GiveCards(kCards, kVideo, kRender);
  for (const auto& [line, trouble] : kaori::boot::PcFaults(kStill, kData)) Report(line, trouble);
  const std::string wanted_name = ApplySettings(data);
  KeepMedium();
  if (data.is_mounted) ApplyIdentity(wanted_name);
  if (!kaori::boot::TellKnownShaders(kKnownShaders, kStageFolder))
    Report("Mesa cannot be told which shaders it has");
  if (child > 0) kaori::boot::AwaitClose(done->read_end, kLongestSplash_ms);
  StartReadingAhead();
}

// As any other process it would mount over a running system's /proc, /sys and /run.
int Refuse(int argc, char** argv) {
  const bool asks_for_help =
      argc == 2 && (std::string_view(argv[1]) == "--help" || std::string_view(argv[1]) == "-h");
  const std::string_view text =
      asks_for_help ? kHelp : "kaori-boot: this is the first program of a box; it runs as process 1 only\n";
  const int to = asks_for_help ? STDOUT_FILENO : STDERR_FILENO;
  [[maybe_unused]] const auto written = ::write(to, text.data(), text.size());
  return asks_for_help ? 0 : kMisused;
}

}  // namespace

// Where systemd cannot be executed the kernel panics, which is what happens to a box without an init in any
// case.
int main(int argc, char** argv) {
  if (::getpid() != kFirstProcess) return Refuse(argc, argv);
  Boot();
  ::execv(kSystem, argv);
  return 1;
}
