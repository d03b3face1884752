// How devices come to the service: the ports of its buses, and what is done with a device at each.
#include <poll.h>

#include <algorithm>
#include <cctype>

#include "appliance/programs/input/input_service.h"
#include "appliance/programs/input/stick_slot.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"

namespace kaori::input {
namespace {

// Index of the left stick among the bindings; the right one follows.
constexpr std::size_t kFirstStick = 1;
// Between two sticks that are plugged in as the box starts; a slow one of old make takes a few seconds.
constexpr Duration kSticksApart = std::chrono::seconds(10);

// Whether a read would find something, without waiting. The loop wakes the service for any of its descriptors
// without saying for which one.
bool Readable(int fd) {
  pollfd poll{fd, POLLIN, 0};
  return ::poll(&poll, 1, 0) > 0;
}

// The slider has no rest.
bool IsUntouched(const board::Stick& stick) {
  return IsAtRest(stick) && std::ranges::all_of(stick.pushes, [](auto pushes) { return pushes == 0; });
}

// A device's name goes into the log, where it must not end the line or send codes to a terminal.
std::string Printable(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
  return text;
}

}  // namespace

// Listing ports costs system calls for each of them, so that it is done only for a bus that has news, and for
// all of them when a port waits to be tried again or when a slot has become free.
void InputService::Scan(Time now) {
  const bool all =
      scan_now_ || (now >= next_scan_ && (std::ranges::any_of(skipped_, &SkippedPort::try_again) ||
                                          std::ranges::any_of(buses_, &Bus::failed)));
  if (all) scan_now_ = false, next_scan_ = now + kRetry;
  for (std::size_t bus = 0; bus < buses_.size(); ++bus)
    if (all || (!buses_[bus].failed() && Readable(buses_[bus].bus->pollable()))) ScanBus(bus, now);
}

// Ports are tried in the order of PortBefore, so that two equal sticks get their roles by their ports and not
// by which answers first. What was skipped is forgotten when its port is empty: the next device there is
// another one.
void InputService::ScanBus(std::size_t bus, Time now) {
  auto ports = buses_[bus].bus->Ports();
  if (!ports) return HandleBusError(buses_[bus], ports.error());
  if (std::exchange(buses_[bus].failure, {}) != std::errc{}) ++generation_;
  std::ranges::sort(*ports, PortBefore);
  std::erase_if(skipped_, [&](const SkippedPort& skipped) {
    return skipped.port.bus == bus && std::ranges::find(*ports, skipped.port.name) == ports->end();
  });
  for (const std::string& name : *ports) {
    const BusPort port{bus, name};
    const auto skipped = std::ranges::find(skipped_, port, &SkippedPort::port);
    const bool may_attach = skipped == skipped_.end() || (skipped->try_again && now >= skipped->not_before);
    if (may_attach && !IsAttached(port)) TryToAttach(port, now);
  }
}

// A bus that fails is not waited for, since its descriptor might be readable for ever; generation_ tells the
// loop so. The same cause is not logged again.
void InputService::HandleBusError(Bus& bus, const Error& error) {
  if (std::exchange(bus.failure, error.cause) == error.cause) return;
  LogWarning("{}; the bus is asked again every 250 ms", error.message());
  ++generation_;
}

// A device is opened before it can be known what it is: its report descriptor says so. A device that fills no
// slot is closed again at the end of this function, so that other programs may use it.
//
// The kernel opens and closes no node while another one is asked for a report (minors_rwsem of its hidraw), and one that does
// not answer is asked for 5 s.
void InputService::TryToAttach(const BusPort& port, Time now) {
  ExpectLongCall();
  const Time asked = clock_.now();
  auto device = buses_[port.bus].bus->Open(port.name);
  if (!device && device.error().cause != std::errc::not_supported)
    return RetryLater(port, device.error(), clock_.now() - asked);
  // One that is not used is closed here, which may take as long again.
  ExpectLongCall();
  std::erase_if(skipped_, [&](const SkippedPort& skipped) { return skipped.port == port; });
  if (!device) return Skip(port, decode::DeviceKind::kOther, device.error().message());
  const auto layout = decode::LayoutOf((*device)->identity());
  if (!layout) return Skip(port, decode::DeviceKind::kOther, layout.error().message());
  const bool has_map = MapFor(maps_, (*device)->identity().vendor, (*device)->identity().product) != nullptr;
  const decode::DeviceKind kind = has_map ? decode::DeviceKind::kSurface : decode::Recognise(*layout);
  if (kind == decode::DeviceKind::kOther)
    return Skip(port, kind,
                Printable((*device)->identity().name) + ": the device is not one that the show uses");
  if (kind == decode::DeviceKind::kKeyboard && !has_keyboards_)
    return Skip(port, kind, "a keyboard is not used, since this box is a kiosk");
  Binding* binding = BindingFor(kind, port);
  if (binding == nullptr)
    return Skip(port, kind, "the slot for this kind of device is occupied; the device is a spare");
  Attach(*binding, port, std::move(*device), now);
}

// Where the slot cannot decode the device it stays empty for the next one, and the port is skipped until it
// is empty.
void InputService::Attach(Binding& binding, const BusPort& port, std::unique_ptr<ports::HidChannel> device,
                          Time now) {
  if (auto plugged = binding.slot->Plug(device->identity(), now); !plugged)
    return Skip(port, binding.kind, plugged.error().message());
  Log("{}: {} is plugged in at port {}", binding.slot->name(), Printable(device->identity().name), port.name);
  binding.device = std::move(device);
  binding.port = port;
  binding.attached_at = clock_.now();
  binding.bad_report_logged = false;
  binding.faults = 0;
  ++generation_;
}

// Of the kinds with one slot; two sticks are told apart by their ports.
InputService::Binding* InputService::BindingFor(decode::DeviceKind kind, const BusPort& port) {
  if (kind == decode::DeviceKind::kJoystick) return StickBinding(port);
  for (Binding& binding : bindings_) {
    const bool fits = binding.only_port.empty() || binding.only_port == port.name;
    if (binding.kind == kind && !binding.device && fits) return &binding;
  }
  return nullptr;
}

// Spares stay spares: StickRoles gives no role that another stick has.
InputService::Binding* InputService::StickBinding(const BusPort& port) {
  OrderSticks(port);
  std::array<bool, kSticks> occupied{};
  for (std::size_t i = 0; i < occupied.size(); ++i)
    occupied[i] = bindings_[kFirstStick + i].device != nullptr;
  const auto role = roles_.RoleOf(port.name, occupied);
  return role ? &bindings_[kFirstStick + static_cast<std::size_t>(*role)] : nullptr;
}

// Somebody who has moved the stick or pushed its buttons plays what it plays. The device at `port` may have taken long to open.
void InputService::OrderSticks(const BusPort& port) {
  Binding &left = bindings_[kFirstStick], &right = bindings_[kFirstStick + 1];
  if (!left.device || right.device || !roles_.IsBeforeLeft(port.name)) return;
  const Time now = clock_.now();
  if (now - left.attached_at > kSticksApart || !IsUntouched(board_.Read<board::Stick>(0).value)) return;
  Log("a stick at port {} comes before the one at port {}, which is the right stick now", port.name,
      left.port.name);
  roles_.MoveLeftToRight();
  left.slot->Unplug(now);
  Attach(right, left.port, std::move(left.device), now);
}

void InputService::Skip(const BusPort& port, decode::DeviceKind kind, const std::string& why) {
  LogWarning("port {}: {}", port.name, why);
  skipped_.push_back({.port = port, .kind = kind});
}

// udev may give the device's file its group only after the device is listed, so that "permission denied" may
// come first. Each new cause is one line. The pause begins when the attempt has ended: one that took 5 s would
// otherwise be made again at once, and no other input would be heard.
void InputService::RetryLater(const BusPort& port, const Error& error, Duration took) {
  const Time now = clock_.now();
  next_scan_ = now + kRetry;
  const auto known = std::ranges::find(skipped_, port, &SkippedPort::port);
  const bool is_news = known == skipped_.end() || known->cause != error.cause;
  if (is_news) LogWarning("{}; trying again until it opens", error.message());
  std::erase_if(skipped_, [&](const SkippedPort& skipped) { return skipped.port == port; });
  skipped_.push_back(
      {.port = port, .try_again = true, .cause = error.cause, .not_before = now + PauseAfter(took, kRetry)});
}

// A port holds one device. One with several interfaces has a port for each (drivers/hid).
bool InputService::IsAttached(const BusPort& port) const {
  return std::ranges::any_of(bindings_, [&](const Binding& p) { return p.device && p.port == port; });
}

}  // namespace kaori::input
