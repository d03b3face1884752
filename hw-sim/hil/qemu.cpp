#include "hw-sim/hil/qemu.h"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

// One for each gadget.
constexpr const char* kControllers = " dummy_hcd.num=3";

// As QEMU calls it, on the port that the rig leaves free.
std::string DeviceOf(Stranger stranger) {
  constexpr const char* kPort = R"("id":"stranger","bus":"xhci.0","port":"8")";
  switch (stranger) {
    case Stranger::kStorage:
      return fmt::format(R"({{"driver":"usb-storage","drive":"stick",{}}})", kPort);
    case Stranger::kNetwork:
      return fmt::format(R"({{"driver":"usb-net","netdev":"net",{}}})", kPort);
    default:
      return fmt::format(R"({{"driver":"usb-kbd",{}}})", kPort);
  }
}

}  // namespace

Result<void> QemuDriver::On() {
  if (setup_.bench_kernel && options_.bench_kernel.empty())
    return Fail(std::errc::not_supported, "start a kernel of the bench (none was named)");
  if (setup_.drawn_outside) {
    auto window =
        XScreen::Open({options_.folder, WidthOf(options_, setup_), HeightOf(options_, setup_)}, waiter_);
    if (!window) return tl::unexpected(window.error());
    window_.emplace(std::move(*window));
  }
  if (auto ok = Start(); !ok) return ok;
  auto qmp = Qmp::Call(options_.folder + "/qmp", waiter_);
  if (!qmp) return tl::unexpected(qmp.error());
  qmp_.emplace(std::move(*qmp));
  return {};
}

Result<void> QemuDriver::Start() {
  std::ifstream file(options_.image + "/cmdline");
  std::string line;
  if (!std::getline(file, line)) return FailErrno("read " + options_.image + "/cmdline");
  std::string disk = options_.image + "/kaori.disk";
  if (!setup_.settings.empty()) {
    auto copy = CopyWithSettings(disk, setup_, options_.folder);
    if (!copy) return tl::unexpected(copy.error());
    disk = std::move(*copy);
  }
  line = BenchCommandLine(line) + (setup_.bench_kernel ? kControllers : "");
  std::vector<std::string> variables;
  if (window_) variables = {"DISPLAY=" + window_->name(), "SDL_VIDEODRIVER=x11"};
  auto process =
      Process::Start(QemuCommand(options_, setup_, line, disk), options_.folder + "/qemu.log", variables);
  if (!process) return tl::unexpected(process.error());
  process_.emplace(std::move(*process));
  return {};
}

void QemuDriver::Off() {
  qmp_.reset();
  process_.reset();
  window_.reset();
}

Result<void> QemuDriver::Shoot(int head, const std::string& file) {
  if (!qmp_) return Fail(std::errc::no_such_device, "take a picture of the screen");
  if (window_) return window_->Shoot(file);
  return qmp_->Do(
      "screendump",
      fmt::format(R"({{"filename":"{}","format":"png","device":"screens","head":{}}})", file, head));
}

Result<void> QemuDriver::PlugStranger(Stranger stranger) {
  if (!qmp_) return Fail(std::errc::no_such_device, "plug in a stranger");
  return qmp_->Do("device_add", DeviceOf(stranger));
}

Result<void> QemuDriver::PullStranger() {
  if (!qmp_) return Fail(std::errc::no_such_device, "pull a stranger");
  return qmp_->Do("device_del", R"({"id":"stranger"})");
}

std::string QemuDriver::log() const {
  std::ifstream file(options_.folder + "/qemu.log");
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace kaori::hil
