#include "appliance/programs/input/input_service.h"

#include <poll.h>

#include <algorithm>
#include <cctype>

#include "appliance/programs/input/dial_slot.h"
#include "appliance/programs/input/keyboard_slot.h"
#include "appliance/programs/input/pointer_slot.h"
#include "appliance/programs/input/stick_slot.h"
#include "appliance/programs/input/tally.h"
#include "drivers/base/log.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kReportBytes =
    1024;                            // Ours have up to 32, those of keyboards 64, of a Stream Deck 512.
constexpr int kReportsAtOnce = 256;  // A quarter of a second of a device that reports every millisecond.
// The pause before a device that is present and cannot be opened, or a bus that failed, is tried again.
constexpr Duration kRetry = milliseconds(250);
// A device that the program had open before a restart is found again within this time, or it is gone.
constexpr Duration kFindTime = milliseconds(500);
constexpr int kFaultsToDetach = 64;  // One failed transfer is harmless; this many in a row are a dead device.
// A device that is gone sooner than this after its plug has a loose cable, and must not keep the program
// busy.
constexpr Duration kLoosePlug = milliseconds(10);
constexpr Duration kOldestReport = milliseconds(1000);  // An older time of arrival is a fault of the device.
// Index of the left stick among the bindings; the right one follows.
constexpr std::size_t kFirstStick = 1;
constexpr std::size_t kFirstFurtherSurface = 5;

// Whether a read would find something, without waiting. The loop wakes the service for any of its descriptors
// without saying for which one.
bool Readable(int fd) {
  pollfd poll{fd, POLLIN, 0};
  return ::poll(&poll, 1, 0) > 0;
}

// A device's name goes into the log, where it must not end the line or send codes to a terminal.
std::string Printable(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
  return text;
}

// The ports that the two sticks had before the program started (HashOfPort); 0 where the board knows of none.
std::array<std::uint32_t, kSticks> PortsBefore(const board::Board& board) {
  return {board.Read<board::Stick>(0).value.port, board.Read<board::Stick>(1).value.port};
}

}  // namespace

// Slots read their sections here, before any device is opened.
InputService::InputService(const board::Board& board, InputWriters writers, InputSources sources,
                           const InputSettings& settings, const Clock& clock)
    : board_(board),
      clock_(clock),
      lines_(board, std::move(writers.lines), std::move(writers.calls), std::move(sources.lines),
             sources.wired_lines),
      maps_(std::move(sources.maps)),
      surface_(board, std::move(writers.surface), settings.counts_per_turn, 1 + kFurtherSurfaces),
      turns_(std::move(sources.turns)),
      lessons_(board, turns_, lines_),
      midi_tap_(sources.midi),
      midi_(board, std::move(writers.midi), maps_),
      roles_(settings.stick_ports, PortsBefore(board)),
      started_(clock.now()) {
  using decode::DeviceKind;
  for (ports::HidBus* bus : sources.buses) buses_.push_back({.bus = bus});
  auto &dials = bindings_[0], &left = bindings_[1], &right = bindings_[2], &keys = bindings_[3],
       &pointer = bindings_[4];
  const auto make_surface = [&](Binding& binding, std::size_t device, DeviceKind kind) {
    auto slot = std::make_unique<DialSlot>(board, surface_, device, maps_, turns_);
    lessons_.Add(*slot);
    binding.slot = std::move(slot);
    binding.kind = kind;
  };
  make_surface(dials, 0, DeviceKind::kDialBox);
  for (std::size_t n = 0; n < kFurtherSurfaces; ++n)
    make_surface(bindings_[kFirstFurtherSurface + n], 1 + n, DeviceKind::kSurface);
  dials.only_port = settings.dial_box_port;
  left.slot = std::make_unique<StickSlot>(board, std::move(writers.sticks[0]), 0, settings);
  right.slot = std::make_unique<StickSlot>(board, std::move(writers.sticks[1]), 1, settings);
  left.kind = right.kind = DeviceKind::kJoystick;  // StickRoles decides about their ports.
  keys.slot = std::make_unique<KeyboardSlot>(board, std::move(writers.keys));
  keys.kind = DeviceKind::kKeyboard;
  keys.only_port = settings.keyboard_port;
  pointer.slot = std::make_unique<PointerSlot>(board, std::move(writers.pointer), settings.pointer);
  pointer.kind = DeviceKind::kPointer;
  pointer.only_port = settings.pointer_port;
}

// Devices first, so that a stick which was plugged in is read in the same step; the tally lamp last, since it
// shows what the lines say now.
void InputService::Step() {
  const Time now = clock_.now();
  Scan(now);
  for (Binding& binding : bindings_) {
    if (binding.device) ReadReports(binding, now);
    binding.slot->Tick(now, binding.device.get());
  }
  if (!absent_detached_ && now - started_ >= kFindTime) DetachAbsent(now);
  if (midi_tap_ != nullptr) midi_.Publish(*midi_tap_);
  lessons_.Step(now);
  lines_.Step(now);
  lines_.SetTally(TallyLit(board_.Read<board::StageStatus>(), board_.Read<board::Lines>(), now));
}

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
void InputService::TryToAttach(const BusPort& port, Time now) {
  auto device = buses_[port.bus].bus->Open(port.name);
  if (!device && device.error().cause != std::errc::not_supported)
    return RetryLater(port, device.error(), now);
  std::erase_if(skipped_, [&](const SkippedPort& skipped) { return skipped.port == port; });
  if (!device) return Skip(port, decode::DeviceKind::kOther, device.error().message());
  const auto layout = decode::LayoutOf((*device)->identity());
  if (!layout) return Skip(port, decode::DeviceKind::kOther, layout.error().message());
  const bool has_map = MapFor(maps_, (*device)->identity().vendor, (*device)->identity().product) != nullptr;
  const decode::DeviceKind kind = has_map ? decode::DeviceKind::kSurface : decode::Recognise(*layout);
  if (kind == decode::DeviceKind::kOther)
    return Skip(port, kind,
                Printable((*device)->identity().name) + ": the device is not one that the show uses");
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
  binding.attached_at = now;
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
  std::array<bool, kSticks> occupied{};
  for (std::size_t i = 0; i < occupied.size(); ++i)
    occupied[i] = bindings_[kFirstStick + i].device != nullptr;
  const auto role = roles_.RoleOf(port.name, occupied);
  return role ? &bindings_[kFirstStick + static_cast<std::size_t>(*role)] : nullptr;
}

void InputService::Skip(const BusPort& port, decode::DeviceKind kind, const std::string& why) {
  LogWarning("port {}: {}", port.name, why);
  skipped_.push_back({.port = port, .kind = kind});
}

// udev may give the device's file its group only after the device is listed, so that "permission denied" may
// come first. Each new cause is one line.
void InputService::RetryLater(const BusPort& port, const Error& error, Time now) {
  const auto known = std::ranges::find(skipped_, port, &SkippedPort::port);
  if (known != skipped_.end() && known->cause == error.cause) return;
  LogWarning("{}; trying again every 250 ms", error.message());
  std::erase_if(skipped_, [&](const SkippedPort& skipped) { return skipped.port == port; });
  skipped_.push_back({.port = port, .try_again = true, .cause = error.cause});
  next_scan_ = now + kRetry;
}

// The time of arrival is bounded on both sides: the kernel stamps it, but a faulty driver's stamp must not
// date input into the future or hold it back by an hour. A report that is longer than the buffer counts as
// far as it fits, and the decoder refuses its length.
void InputService::ReadReports(Binding& binding, Time now) {
  std::array<std::uint8_t, kReportBytes> bytes;
  for (int i = 0; i < kReportsAtOnce; ++i) {
    const auto input = binding.device->Read(bytes);
    if (!input) {
      binding.slot->Publish();
      return HandleReadError(binding, input.error(), now);
    }
    binding.faults = 0;
    const auto report = std::span(bytes).first(std::min(input->bytes, bytes.size()));
    const auto accepted = binding.slot->Accept(report, std::clamp(input->at, now - kOldestReport, now));
    if (accepted || std::exchange(binding.bad_report_logged, true)) continue;
    LogWarning("{}: {}; further such reports are ignored silently", binding.slot->name(),
               accepted.error().message());
  }
  binding.slot->Publish();
}

// A transfer that failed once is harmless on USB. ENODEV is final, and so are kFaultsToDetach others in a
// row.
void InputService::HandleReadError(Binding& binding, const Error& error, Time now) {
  if (error.cause == std::errc::resource_unavailable_try_again) return;
  const bool gone = error.cause == std::errc::no_such_device || ++binding.faults == kFaultsToDetach;
  // What came, but torn, is worth a line; a transfer that failed is tried again by itself.
  if (!gone && error.cause == std::errc::bad_message && !std::exchange(binding.bad_report_logged, true))
    LogWarning("{}: {}; further ones are passed over silently", binding.slot->name(), error.attempt);
  if (gone) Detach(binding, error, now);
}

// The slot is told at once, so that no button stays held while nobody can let it go.
void InputService::Detach(Binding& binding, const Error& error, Time now) {
  LogWarning("{}: {}; waiting until it is plugged in again", binding.slot->name(), error.message());
  binding.device.reset();
  binding.slot->Unplug(now);
  ++generation_;
  // A spare dial box, keyboard or mouse may now fill the slot. A spare stick may not, since a loose plug
  // would then swap the roles of two sticks.
  if (binding.kind != decode::DeviceKind::kJoystick)
    std::erase_if(skipped_, [&](const SkippedPort& skipped) { return skipped.kind == binding.kind; });
  scan_now_ = now - binding.attached_at >= kLoosePlug;
  if (!scan_now_)
    skipped_.push_back(
        {.port = binding.port, .kind = binding.kind, .try_again = true, .not_before = now + kRetry});
}

// Once, half a second after the start: what was plugged in before the restart and has not come back by then
// is gone, and its section must not stay live.
void InputService::DetachAbsent(Time now) {
  absent_detached_ = true;
  for (Binding& binding : bindings_)
    if (!binding.device) binding.slot->Unplug(now);
}

// A port holds one device. One with several interfaces has a port for each (drivers/hid).
bool InputService::IsAttached(const BusPort& port) const {
  return std::ranges::any_of(bindings_, [&](const Binding& p) { return p.device && p.port == port; });
}

// A bus that failed is left out: its descriptor may be readable for ever.
std::vector<int> InputService::pollables() const {
  std::vector<int> fds;
  for (const Bus& bus : buses_)
    if (!bus.failed()) fds.push_back(bus.bus->pollable());
  for (const Binding& binding : bindings_)
    if (binding.device) fds.push_back(binding.device->pollable());
  if (lines_.pollable() >= 0) fds.push_back(lines_.pollable());
  return fds;
}

int InputService::attached_devices() const {
  return static_cast<int>(
      std::ranges::count_if(bindings_, [](const Binding& p) { return p.device != nullptr; }));
}

}  // namespace kaori::input
