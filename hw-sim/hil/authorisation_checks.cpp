// USB devices without a role stay unauthorised; the profile says which roles there are.
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/devices/unknown_device.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/unknown_devices.h"
#include "hw-sim/hil/unplugged_device.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// For machines that have little of a processor: the box is emulated, and its neighbours work too.
constexpr Duration kAuthorisationAnswer = seconds(120);
constexpr Duration kAuthorisationLongest = seconds(120);
// Frames that must come meanwhile: the show does not wait for a device that it does not know.
constexpr std::uint32_t kPlayedOn = 2;

// The profiles of these boxes. kKiosk authorises sticks and dials alone; kFaulty names one that does not
// exist, and the settings that were good before name one that authorises everything.
const Setup kKiosk{.keyboards = false, .settings = "profile = \"kiosk\"\n"};
const Setup kFaulty{.settings = "# tonight\nprofile = \"open house\"\n",
                    .last_settings = "profile = \"bench\"\n"};
constexpr std::string_view kFault = "box.toml, line 2: there is no profile \"open house\"";

// A device that QEMU emulates. `number` is how the agent finds it again among the machine's devices.
struct Kind {
  UnauthorisedDevice device;
  const char* name;
  const char* number;  // QEMU's vendor and product.
};

constexpr Kind kStorage{UnauthorisedDevice::kStorage, "a storage stick", "46f4:0001"};
constexpr Kind kNetwork{UnauthorisedDevice::kNetwork, "a network adapter", "0525:a4a2"};
constexpr Kind kKeyboard{UnauthorisedDevice::kKeyboard, "a keyboard", "0627:0001"};

// A device of the machine, as sysfs has it (Documentation/usb/authorization.rst).
struct UsbState {
  std::string port;
  bool authorised = false;
};

// The device with that vendor and product; nothing: it is not plugged in.
std::optional<UsbState> FindUsb(Scene& scene, const std::string& number) {
  const auto devices = scene.target.agent().Ask("usb", kAuthorisationAnswer);
  std::istringstream lines(devices ? *devices : "");
  std::string port, numbers;
  for (int authorised = 0; lines >> port >> numbers >> authorised;)
    if (numbers == number) return UsbState{port, authorised == 1};
  return std::nullopt;
}

// Errors: those of the board; timed_out where the show stands still.
Result<void> AwaitFrames(Scene& scene) {
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  const auto on = [&](const BoardView& board) {
    return board.stage.live && board.left.live && board.stage.frames >= before->stage.frames + kPlayedOn;
  };
  if (auto ok = scene.target.UntilBoard(on, kAuthorisationLongest, "see the box play on"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

// Plugs it in, waits until udev has handled it, and unplugs it. The show must play on all the while.
// Fails where the device is not treated as wanted.
Result<void> WantAuthorised(Scene& scene, const Kind& kind, bool wanted) {
  if (auto ok = scene.target.machine().PlugUnauthorised(kind.device); !ok) return ok;
  const auto there = [&] { return FindUsb(scene, kind.number).has_value(); };
  if (!scene.target.Until(there, kAuthorisationLongest))
    return Fail(std::errc::timed_out, fmt::format("see {} in the machine", kind.name));
  // The rules of udev authorise: before they have run every new device is unauthorised.
  if (auto ok = scene.target.agent().Ask("own /usr/bin/udevadm settle --timeout=90", kAuthorisationAnswer);
      !ok)
    return tl::unexpected(ok.error());
  auto played = AwaitFrames(scene);
  // Asked before it is pulled, and told after: a device must not stay behind for the next one.
  const auto found = FindUsb(scene, kind.number);
  if (auto ok = scene.target.machine().PullUnauthorised(); !ok) return ok;
  if (!scene.target.Until([&] { return !FindUsb(scene, kind.number); }, kAuthorisationLongest))
    return Fail(std::errc::timed_out, fmt::format("see {} gone", kind.name));
  if (!played) return played;
  if (found && found->authorised == wanted) return {};
  return FailInput(fmt::format("{} {}", kind.name, wanted ? "was not authorised" : "was authorised"));
}

sim::UnknownDevice DeviceOf(const Unknown& unknown) {
  if (unknown.configuration.empty()) return {unknown.vendor, unknown.product, unknown.interfaces};
  return {unknown.vendor, unknown.product, unknown.configuration};
}

// How the box judged a device. `said` is what the status picture and the support file have of it; empty: nothing.
struct Judgement {
  bool authorised = false;
  std::string said;
};

// Plugs it in where the pointer was, and unplugs it.
Result<Judgement> JudgementOf(Scene& scene, const Unknown& unknown) {
  sim::UsbRig& rig = scene.target.rig();
  sim::UnknownDevice device = DeviceOf(unknown);
  const std::string number = fmt::format("{:04x}:{:04x}", unknown.vendor, unknown.product);
  const auto is_there = [&] { return FindUsb(scene, number).has_value(); };
  static_cast<void>(rig.Hold("pointer", &device));
  static_cast<void>(rig.Plug("pointer"));
  const bool seen = scene.target.Until(is_there, kAuthorisationLongest);
  // The rules of udev have run for this device, and not only for the one before it at the same port.
  const auto settled =
      scene.target.agent().Ask(fmt::format("own /usr/bin/udevadm wait --timeout=90 /sys/bus/usb/devices/{}",
                                           FindUsb(scene, number).value_or(UsbState{}).port),
                               kAuthorisationAnswer);
  const auto found = FindUsb(scene, number);
  const auto said = scene.target.agent().Ask("read /run/kaori-usb/" + found.value_or(UsbState{}).port,
                                             kAuthorisationAnswer);
  static_cast<void>(rig.Unplug("pointer"));
  const bool gone = scene.target.Until([&] { return !is_there(); }, kAuthorisationLongest);
  static_cast<void>(rig.Hold("pointer", nullptr));
  if (!seen || !found) return Fail(std::errc::timed_out, fmt::format("see {} in the machine", unknown.name));
  if (!gone) return Fail(std::errc::timed_out, fmt::format("see {} gone", unknown.name));
  if (!settled) return tl::unexpected(settled.error());
  return Judgement{found->authorised, said.value_or("")};
}

// Devices that are treated as they should not be; `wrong` turns what is wanted round, for the control.
Result<void> TryUnknownDevices(Scene& scene, bool wrong) {
  std::string mistaken, untold;
  int tried = 0, liars = 0, let_in = 0;
  {
    const UnpluggedDevice pointer(scene, "pointer");
    for (const Unknown& unknown : UnknownDevices()) {
      const auto judgement = JudgementOf(scene, unknown);
      if (!judgement) return tl::unexpected(judgement.error());
      ++tried;
      liars += unknown.wanted ? 0 : 1;
      let_in += judgement->authorised && !unknown.wanted ? 1 : 0;
      if (judgement->authorised != (unknown.wanted != wrong))
        mistaken += (mistaken.empty() ? "" : "; ") + std::string(unknown.name);
      if (judgement->said.empty() != judgement->authorised)
        untold += (untold.empty() ? "" : "; ") + std::string(unknown.name);
    }
  }
  scene.finding.figures["usb_liars"] = liars;
  scene.finding.figures["usb_liars_let_in"] = let_in;
  if (!mistaken.empty()) return FailInput("wrongly authorised, or wrongly not: " + mistaken);
  if (!untold.empty())
    return FailInput("nothing is said of what stays out, or something of what does not: " + untold);
  if (auto played = AwaitFrames(scene); !played) return played;
  scene.finding.said = fmt::format(
      "{} unknown devices, {} of them liars, none of which was authorised; the box played on", tried, liars);
  return {};
}

// One after the other at the same port, each awaited until the box has judged it.
Result<void> Liars(Scene& scene) {
  return TryUnknownDevices(scene, false);
}

// The control: all of them are found wrong when the opposite is wanted.
Result<void> LiarsAreSeen(Scene& scene) {
  return WantFoundWrong(TryUnknownDevices(scene, true), "unknown devices pass either way");
}

// The control: the same steps with the wrong expectation must fail.
template <const Kind& kind, bool wrong>
Result<void> Refuses(Scene& scene) {
  return WantFoundWrong(WantAuthorised(scene, kind, wrong),
                        fmt::format("{} passes either way", kind.name).c_str());
}

Result<void> OnStage(Scene& scene) {
  for (const auto& [kind, wanted] : {std::pair{kStorage, false}, {kNetwork, false}, {kKeyboard, true}})
    if (auto ok = WantAuthorised(scene, kind, wanted); !ok) return ok;
  scene.finding.said =
      "a storage stick and a network adapter stayed unauthorised, a keyboard was authorised; the box played "
      "on";
  return {};
}

Result<void> InAKiosk(Scene& scene) {
  for (const auto& [kind, wanted] : {std::pair{kKeyboard, false}, {kStorage, false}})
    if (auto ok = WantAuthorised(scene, kind, wanted); !ok) return ok;
  const auto board = scene.target.Board();
  if (!board) return tl::unexpected(board.error());
  // Keyboards that were there when the kernel began have no event of their own:
  // they are caught by another rule.
  if (board->keys_live) return FailInput("the keyboard that was plugged in before power came is alive");
  scene.finding.said =
      "keyboards stayed unauthorised, plugged in before power came and after; dials and sticks are live";
  return {};
}

// The file names a profile that does not exist; the one before it, which authorised everything, counts.
Result<void> WithAFault(Scene& scene) {
  const auto log =
      scene.target.agent().Ask("own /usr/bin/journalctl -k -b --no-pager -o cat", kAuthorisationAnswer);
  if (!log) return tl::unexpected(log.error());
  const std::size_t at = log->find(kFault);
  if (at == std::string::npos) return FailInput("the fault is not named in the box's log");
  scene.finding.texts.emplace_back("the box's log", log->substr(at, log->find('\n', at) - at));
  for (const Kind& kind : {kStorage, kNetwork, kKeyboard})
    if (auto ok = WantAuthorised(scene, kind, true); !ok) return ok;
  scene.finding.said = fmt::format("the log says: {}; the profile before, bench, authorised everything",
                                   scene.finding.texts[0].second);
  return {};
}

}  // namespace

std::vector<Check> AuthorisationChecks() {
  return {{"unauthorised",
           "Storage and networks stay unauthorised, and the box plays on",
           false,
           OnStage,
           {},
           {},
           Refuses<kStorage, true>},
          {"liars",
           "Devices that call themselves something else stay unauthorised",
           false,
           Liars,
           {},
           {},
           LiarsAreSeen},
          {"kiosk",
           "In a kiosk keyboards stay unauthorised",
           false,
           InAKiosk,
           kKiosk,
           {},
           Refuses<kKeyboard, true>},
          {"faulty-settings",
           "A settings file with a mistake: the last good one counts, the mistake is named",
           false,
           WithAFault,
           kFaulty,
           {},
           Refuses<kStorage, false>}};
}

}  // namespace kaori::hil
