#include "hw-sim/hil/qemu.h"

#include <signal.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

constexpr Duration kLongestBeginning = std::chrono::seconds(60);  // Of QEMU itself, on a busy machine.

// dummy_hcd makes so many controllers, one for each gadget.
constexpr const char* kControllers = " dummy_hcd.num=3";

// As QEMU calls it, on the port that the rig leaves free.
json::Object DeviceOf(UnauthorisedDevice device) {
  // The rig has the ports 1 to 7 (qemu_command.cpp).
  json::Object arguments{{"id", "unauthorised"}, {"bus", "xhci.0"}, {"port", "8"}};
  switch (device) {
    case UnauthorisedDevice::kStorage:
      arguments.emplace_back("driver", "usb-storage");
      arguments.emplace_back("drive", "stick");
      break;
    case UnauthorisedDevice::kNetwork:
      arguments.emplace_back("driver", "usb-net");
      arguments.emplace_back("netdev", "net");
      break;
    case UnauthorisedDevice::kKeyboard:
      arguments.emplace_back("driver", "usb-kbd");
      break;
  }
  return arguments;
}

// Empty where there is no such file.
// The bound of 256 MiB is above any log of a run, and keeps a log that grows without end out of memory.
std::string TextOf(const std::string& path) {
  return ReadFile(path, {.most_bytes = std::size_t{256} << 20U}).value_or("");
}

}  // namespace

// Each step needs the one before. Where one fails, what is up stays up until Off.
Result<void> QemuDriver::On() {
  if (setup_.bench_kernel && options_.bench_kernel.empty())
    return Fail(std::errc::not_supported, "start a kernel of the bench (none was named)");
  // Pictures that the bench draws for the machine need a screen of X, which must be there before QEMU.
  if (GraphicsOf(options_, setup_) == Graphics::kVirgl) {
    auto window =
        XScreen::Open({options_.folder, WidthOf(options_, setup_), HeightOf(options_, setup_)}, waiter_);
    if (!window) return tl::unexpected(window.error());
    window_.emplace(std::move(*window));
  }
  if (auto ok = Start(); !ok) return ok;
  const std::string monitor = options_.folder + "/qmp";
  // QEMU makes the socket of its monitor before it runs the guest.
  const auto begins = [&] { return !process_->runs() || std::filesystem::exists(monitor); };
  static_cast<void>(waiter_.Until(begins, kLongestBeginning));
  if (!process_->runs()) return Fail(std::errc::no_such_process, "QEMU ended at once; it said: " + log());
  auto qmp = Qmp::Call(monitor, waiter_);
  if (!qmp) return tl::unexpected(qmp.error());
  qmp_.emplace(std::move(*qmp));
  for (int head = 0; head < setup_.screens; ++head) {
    auto screen = VncScreen::Connect(ScreenPath(options_, head), waiter_);
    if (!screen) return tl::unexpected(screen.error());
    screens_.push_back(std::move(*screen));
  }
  return {};
}

// The image's own disk is used without a copy where no settings are put on it.
Result<std::string> QemuDriver::Disk() {
  const std::string disk = setup_.disk.empty() ? options_.image + "/kaori.disk" : setup_.disk;
  if (setup_.settings.empty()) return disk;
  return CopyWithSettings(disk, setup_, options_.folder);
}

// Files of a machine before are removed first: a socket that nobody serves would be taken for the new one's.
Result<void> QemuDriver::Start() {
  const auto of_the_image = ReadCommandLine(ImageOf(options_, setup_));
  if (!of_the_image) return tl::unexpected(of_the_image.error());
  const auto disk = Disk();
  if (!disk) return tl::unexpected(disk.error());
  const std::string shipped = setup_.disk_bus == DiskBus::kUsb ? OnUsb(*of_the_image) : *of_the_image;
  const std::string line =
      setup_.agent ? BenchCommandLine(shipped, BenchDisk(setup_)) + (setup_.bench_kernel ? kControllers : "")
                   : LoggedCommandLine(options_, shipped);
  std::error_code ignored;
  for (const std::string& old : {ConsolePath(options_), options_.folder + "/qmp", LinesPath(options_)})
    std::filesystem::remove(old, ignored);  // Of the machine before.
  // QEMU opens a log that is there.
  for (const std::string& log : {setup_.write_log, setup_.variables_log})
    if (!log.empty()) std::ofstream(log).flush();
  std::vector<std::string> variables;
  // SDL is told which screen, since a desktop's own may be there as well.
  if (window_) variables = {"DISPLAY=" + window_->name(), "SDL_VIDEODRIVER=x11"};
  auto process =
      Process::Start(QemuCommand(options_, setup_, line, *disk), options_.folder + "/qemu.log", variables);
  if (!process) return tl::unexpected(process.error());
  process_.emplace(std::move(*process));
  return {};
}

// Power is cut without a warning to the guest. A second call does nothing.
void QemuDriver::Off() {
  // The lines to it first: they break with the process.
  screens_.clear();
  lines_.reset();
  qmp_.reset();
  process_.reset();
  window_.reset();
}

// The picture is that of the moment; QEMU writes the file before it answers.
Result<void> QemuDriver::Shoot(int head, const std::string& file) {
  if (!qmp_) return Fail(std::errc::no_such_device, "take a picture of the screen");
  const auto dumped =
      qmp_->Do("screendump", {{"filename", file}, {"format", "png"}, {"device", "screens"}, {"head", head}});
  // QEMU has no picture of what was drawn on the bench, which is read from X. It has one of a screen that is off, on which its window
  // may show what was there before.
  return window_ && !dumped ? window_->Shoot(file) : dumped;
}

// A size tells the guest of a screen: QEMU makes an EDID of it and reports a change of the connector.
Result<void> QemuDriver::PlugScreen(int head, int width_px, int height_px) {
  const auto n = static_cast<std::size_t>(head);
  if (n >= screens_.size())
    return Fail(std::errc::no_such_device, fmt::format("plug in screen {}", head + 1));
  return screens_[n].Resize(width_px, height_px);
}

// All threads of QEMU stop at once; its sockets stay open meanwhile.
void QemuDriver::Freeze(bool frozen) const {
  if (process_) ::kill(process_->number(), frozen ? SIGSTOP : SIGCONT);
}

// One unauthorised device at a time: all of them have the same id and the same port.
Result<void> QemuDriver::PlugUnauthorised(UnauthorisedDevice device) {
  if (!qmp_) return Fail(std::errc::no_such_device, "plug in an unauthorised device");
  return qmp_->Do("device_add", DeviceOf(device));
}

// Read-only, so that two runs can share an image.
Result<void> QemuDriver::PlugStick(const std::string& image, bool writable) {
  return PlugDisk({{"driver", "file"}, {"filename", image}}, writable);
}

// QEMU's own drivers between the stick and its file: blkdebug counts sectors of 512 bytes, and a group of throttled disks needs a name.
Result<void> QemuDriver::PlugFailingStick(const std::string& image, const StickFault& fault) {
  if (!qmp_) return Fail(std::errc::no_such_device, "plug in a stick");
  constexpr std::uint64_t kSector_bytes = 512;
  json::Object node{{"driver", "file"}, {"filename", image}};
  if (fault.unreadable_at) {
    const json::Object rule{{"event", "none"},
                            {"iotype", "read"},
                            {"errno", EIO},
                            {"sector", *fault.unreadable_at / kSector_bytes},
                            {"once", false}};
    node = {{"driver", "blkdebug"}, {"image", node}, {"inject-error", json::List{rule}}};
  }
  if (fault.most_bytes_s > 0) {
    const std::string group = fmt::format("slow{}", sticks_);
    const json::Object limits{{"bps-read", fault.most_bytes_s}};
    if (auto ok = qmp_->Do("object-add", {{"qom-type", "throttle-group"}, {"id", group}, {"limits", limits}});
        !ok)
      return ok;
    node = {{"driver", "throttle"}, {"throttle-group", group}, {"file", node}};
  }
  return PlugDisk(std::move(node), false);
}

// An image keeps its name in QEMU after its stick was pulled: each stick gets the next one.
Result<void> QemuDriver::PlugDisk(json::Object file, bool writable) {
  if (!qmp_) return Fail(std::errc::no_such_device, "plug in a stick");
  const std::string name = fmt::format("stick{}", ++sticks_);
  if (auto ok = qmp_->Do(
          "blockdev-add",
          {{"driver", "raw"}, {"node-name", name}, {"read-only", !writable}, {"file", std::move(file)}});
      !ok)
    return ok;
  return qmp_->Do(
      "device_add",
      {{"driver", "usb-storage"}, {"drive", name}, {"id", "unauthorised"}, {"bus", "xhci.0"}, {"port", "8"}});
}

// At once, as a cable is pulled: the machine is not asked.
Result<void> QemuDriver::PullUnauthorised() {
  if (!qmp_) return Fail(std::errc::no_such_device, "unplug the unauthorised device");
  return qmp_->Do("device_del", {{"id", "unauthorised"}});
}

// QEMU reports the press to the guest by ACPI; what comes of it is the guest's decision.
Result<void> QemuDriver::PressPower() {
  if (!qmp_) return Fail(std::errc::no_such_device, "press the power button");
  return qmp_->Do("system_powerdown");
}

Result<void> QemuDriver::SetLine(int line, bool high) {
  if (!qmp_) return Fail(std::errc::no_such_device, "set a line of the machine");
  if (!lines_) {
    auto lines = MachineLines::Open(LinesPath(options_), *qmp_, waiter_);
    if (!lines) return tl::unexpected(lines.error());
    lines_.emplace(std::move(*lines));
  }
  return lines_->Set(line, high);
}

std::string QemuDriver::log() const {
  return TextOf(options_.folder + "/qemu.log");
}

std::string QemuDriver::console() const {
  return TextOf(ConsolePath(options_));
}

}  // namespace kaori::hil
