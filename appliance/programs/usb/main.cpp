// kaori-usb: whether a USB device is authorised. udev's rules (60-kaori-usb.rules) start it for each device that comes, and
// once more when it goes; without its word the kernel authorises none. It is linked statically and ends within a moment.
#include <fcntl.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "appliance/programs/usb/policy.h"
#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"

namespace {

namespace fs = std::filesystem;
using kaori::UniqueFd;

// The exit status: udev takes 0 for yes and all else for no.
enum Answer { kAuthorised = 0, kStaysOut = 1, kMisused = 2 };

constexpr const char* kHelp = R"(kaori-usb: whether a USB device is authorised; udev's rules start it

  kaori-usb look FOLDER [RUN [LOG]]   the device of this folder of sysfs: ends with 0 where it is authorised, else with 1, and
                                      why stands in RUN/kaori-usb under its port, and in LOG
  kaori-usb forget PORT [RUN]         it was unplugged: nothing is said of it any more

RUN is /run, where the service key and the profile are looked up too, and where the port of the box's GPIO bridge is kept; LOG is the kernel's, /dev/kmsg.
)";

constexpr std::size_t kLongestPort = 32;       // The kernel's have 16 at most: seven hubs one behind another.
constexpr std::size_t kMostSaid_bytes = 4096;  // Of what was said of a device before.
constexpr unsigned kNobody = 65534;            // User and group of no right.
constexpr mode_t kFolderMode = 0755, kFileMode = 0644;

// What the arguments say.
struct Request {
  fs::path device, run = "/run", log = "/dev/kmsg";
};

// The kernel's name of a device: "1-2.4" (Documentation/usb: bus, then ports).
bool IsPort(std::string_view name) {
  const auto is_of_it = [](char c) { return (c >= '0' && c <= '9') || c == '-' || c == '.'; };
  return !name.empty() && name.size() <= kLongestPort && name.front() != '.' &&
         std::ranges::all_of(name, is_of_it);
}

// Before anything that a device says is looked at: what is open stays open, and nothing else can be. True
// where there was no right to begin with, as in a test.
bool GaveUpAllRights() {
  if (::geteuid() != 0) return true;
  return ::setgroups(0, nullptr) == 0 && ::setresgid(kNobody, kNobody, kNobody) == 0 &&
         ::setresuid(kNobody, kNobody, kNobody) == 0 && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

// As the kernel has kept them since the device was plugged in, authorised or not; nothing is asked of the device anew. One
// byte more than an honest one has: then it is seen that there are too many. Errors: those of ReadBeginning.
kaori::Result<std::string> ReadDescriptors(const fs::path& device) {
  return kaori::ReadBeginning(device / "descriptors", kaori::decode::kMostUsbDescriptor_bytes + 1);
}

kaori::Result<kaori::decode::UsbOffer> OfferOf(const kaori::Result<std::string>& bytes) {
  if (!bytes) return tl::unexpected(bytes.error());
  const auto* const first = reinterpret_cast<const std::uint8_t*>(bytes->data());
  return kaori::decode::ReadUsbOffer({first, bytes->size()});
}

// The file of this device, with what was said of it before.
struct Said {
  UniqueFd file;
  std::string before;
};

// Invalid where the folder cannot be written: the decision does not wait for that.
Said OpenSaid(const Request& request) {
  const fs::path folder = request.run / "kaori-usb", file = folder / request.device.filename();
  ::umask(0);
  ::mkdir(folder.c_str(), kFolderMode);
  std::string before = kaori::ReadBeginning(file, kMostSaid_bytes).value_or("");
  return {UniqueFd(::open(file.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, kFileMode)),
          std::move(before)};
}

// Again and again, as each time that the key is turned, a device is said in the log once. "<5>" is the
// severity of a notice; one write is one record of the kernel's log (kmsg(4)).
void Say(const std::optional<kaori::store::RefusedUsb>& refused, const Said& said, const UniqueFd& log) {
  const std::string text = refused ? kaori::store::FormatRefusedUsb(*refused) : "";
  if (text == said.before) return;
  if (!said.file.valid() || ::ftruncate(said.file.get(), 0) != 0 ||
      ::pwrite(said.file.get(), text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    std::fputs("kaori-usb: what is said of the device cannot be written\n", stderr);
  if (!refused) return;
  const std::string record = "<5>kaori-usb: " + refused->english + " / " + refused->japanese + "\n";
  [[maybe_unused]] const auto written = ::write(log.get(), record.data(), record.size());
}

// The port of the bridge that has come first, and the file that says so to all that come later.
struct OwnBridge {
  UniqueFd file;
  std::string port;
};

// Before the rights are given up. Where the file cannot be opened nothing is kept, and the first bridge that a start shows is
// its own all the same.
OwnBridge OpenOwnBridge(const fs::path& run) {
  const fs::path file = run / "kaori-bridge";
  std::string port = kaori::ReadBeginning(file, kLongestPort).value_or("");
  return {UniqueFd(::open(file.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, kFileMode)),
          std::move(port)};
}

void KeepOwnBridge(const OwnBridge& own, const std::string& port) {
  if (!own.port.empty()) return;
  [[maybe_unused]] const auto written = ::pwrite(own.file.get(), port.data(), port.size(), 0);
}

// Files are opened first and bytes are looked at last: what goes wrong with these has no rights. Where the rights cannot be
// given up nothing is looked at, and the device stays out. A program that a signal ends is a no to udev as well.
int Look(const Request& request) {
  const std::string port = request.device.filename().string();
  const OwnBridge own = OpenOwnBridge(request.run);
  const kaori::usb::Situation situation{.key_is_on = kaori::IsThere(request.run / "kaori-service/open"),
                                        .is_kiosk = kaori::IsThere(request.run / "kaori-profile/kiosk"),
                                        .own_bridge = own.port,
                                        .has_started = kaori::IsThere(request.run / "kaori-service/started")};
  const auto bytes = ReadDescriptors(request.device);
  const Said said = OpenSaid(request);
  const UniqueFd log(::open(request.log.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (!GaveUpAllRights()) return std::perror("kaori-usb: give up all rights"), kStaysOut;
  const auto offer = OfferOf(bytes);
  const auto refused = kaori::usb::WhyRefused(offer, port, situation);
  Say(refused, said, log);
  if (!refused && kaori::usb::IsLineBridge(*offer)) KeepOwnBridge(own, port);
  return refused ? kStaysOut : kAuthorised;
}

int Misused(std::string_view why) {
  std::fprintf(stderr, "kaori-usb: %.*s; see --help\n", static_cast<int>(why.size()), why.data());
  return kMisused;
}

}  // namespace

// Words and no options: their reader is not linked statically. Its one line of misuse is in the log of udev, at the level
// of debugging; no rule of the box misuses it.
int main(int count, char** arguments) {
  const auto word = [&](int n) { return n < count ? std::string(arguments[n]) : std::string(); };
  if (word(1) == "--help") return std::fputs(kHelp, stdout), kAuthorised;
  if (count < 3 || count > 5) return Misused("it wants a verb and a device");
  Request request{.device = word(2)};
  if (count > 3) request.run = word(3);
  if (count > 4) request.log = word(4);
  if (!IsPort(request.device.filename().string())) return Misused("the device has no name of a USB port");
  if (word(1) == "look") return Look(request);
  if (word(1) != "forget") return Misused("there is no verb " + word(1));
  ::unlink((request.run / "kaori-usb" / request.device.filename()).c_str());
  return kAuthorised;
}
