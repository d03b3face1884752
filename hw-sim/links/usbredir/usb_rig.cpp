#include "hw-sim/links/usbredir/usb_rig.h"

#include <sys/epoll.h>

#include <algorithm>

namespace kaori::sim {
namespace {

// UVC counts in units of 100 ns, so 30 frames a second are 333 333 of them.
constexpr Duration kCameraPeriod = std::chrono::nanoseconds(33'333'300);
constexpr ports::CameraFormat kCameraFormat{640, 480, ports::PixelFormat::kYuyv};

tl::unexpected<Error> NoSuch(std::string_view name) {
  return FailInput("no USB socket is called " + std::string(name));
}

std::optional<std::size_t> NumberOf(std::string_view name) {
  const auto it = std::ranges::find(kUsbSockets, name);
  if (it == kUsbSockets.end()) return std::nullopt;
  return static_cast<std::size_t>(it - kUsbSockets.begin());
}

}  // namespace

std::string UsbSocketPath(const std::string& folder, std::string_view name) {
  return folder + "/" + std::string(name) + ".usb";
}

UsbRig::UsbRig(const std::string& folder, const Clock& clock, UniqueFd epoll)
    : context_{clock, {}},
      devices_(context_, kCameraFormat),
      dial_box_(devices_.dial_box),
      left_stick_(devices_.left_stick),
      right_stick_(devices_.right_stick),
      keyboard_(devices_.keyboard),
      pointer_(devices_.pointer),
      camera_(devices_.camera, kCameraPeriod),
      own_{&dial_box_, &left_stick_, &right_stick_, &keyboard_, &pointer_, &camera_, &gpio_},
      epoll_(std::move(epoll)) {
  for (std::size_t n = 0; n < ports_.size(); ++n)
    ports_[n] = std::make_unique<UsbredirPort>(UsbSocketPath(folder, kUsbSockets[n]), epoll_.get(), *own_[n]);
}

// Nothing is called yet: each port calls its machine once its cable is in.
Result<std::unique_ptr<UsbRig>> UsbRig::Open(const std::string& folder, const Clock& clock) {
  UniqueFd epoll(::epoll_create1(EPOLL_CLOEXEC));
  if (!epoll.valid()) return FailErrno("create the simulator's epoll set");
  return std::unique_ptr<UsbRig>(new UsbRig(folder, clock, std::move(epoll)));
}

void UsbRig::Pump() {
  const Time now = context_.clock.now();
  for (auto& port : ports_) port->Pump(now);
}

Time UsbRig::next_due() const {
  // A device may say "now": it is asked with the same time that the caller will wait against.
  const Time now = context_.clock.now();
  Time soonest = Time::max();
  for (const auto& port : ports_)
    if (const auto due = port->next_due(now)) soonest = std::min(soonest, *due);
  return soonest;
}

const UsbredirPort* UsbRig::port(std::string_view name) const {
  const auto number = NumberOf(name);
  return number ? ports_[*number].get() : nullptr;
}

Result<void> UsbRig::Plug(std::string_view name) {
  const auto number = NumberOf(name);
  if (!number) return NoSuch(name);
  ports_[*number]->Plug();
  return {};
}

Result<void> UsbRig::Unplug(std::string_view name) {
  const auto number = NumberOf(name);
  if (!number) return NoSuch(name);
  ports_[*number]->Unplug();
  return {};
}

Result<void> UsbRig::Hold(std::string_view name, UsbDevice* device) {
  const auto number = NumberOf(name);
  if (!number) return NoSuch(name);
  ports_[*number]->Hold(device != nullptr ? *device : *own_[*number]);
  return {};
}

// Ports 1 and 2 are those of the sticks, as kUsbSockets has them.
void UsbRig::CrossSticks(bool crossed) {
  ports_[1]->Hold(*own_[crossed ? 2 : 1]);
  ports_[2]->Hold(*own_[crossed ? 1 : 2]);
}

Result<void> UsbRig::Do(const OperatorAction& action) {
  if (action.verb == Verb::kPlug) return Plug(PortName(action.port));
  if (action.verb == Verb::kUnplug) return Unplug(PortName(action.port));
  devices_.Do(action);
  // Switches on USB hang on the bridge, in the order of its lines.
  if (action.port == DevicePort::kLines && action.verb == Verb::kPush) gpio_.Close(action.index);
  if (action.port == DevicePort::kLines && action.verb == Verb::kRelease) gpio_.Open(action.index);
  return {};
}

}  // namespace kaori::sim
