#include "appliance/programs/input/input_desk.h"

#include <poll.h>

#include <algorithm>
#include <cctype>

#include "appliance/programs/input/dial_seat.h"
#include "appliance/programs/input/key_seat.h"
#include "appliance/programs/input/pointer_seat.h"
#include "appliance/programs/input/stick_seat.h"
#include "appliance/programs/input/tally.h"
#include "drivers/base/log.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kReportBytes = 256;       // Ours have 32 at most; keyboards and pads up to 64.
constexpr int kReportsAtOnce = 256;             // A quarter of a second of the quickest device.
constexpr Duration kRetry = milliseconds(250);  // For a device that is there and cannot be opened yet.
constexpr Duration kFindTime =
    milliseconds(500);              // What a predecessor had open is found by then, or is gone.
constexpr int kFaultsToLeave = 64;  // One failed transfer is nothing; this many are a dead device.
constexpr Duration kSettled = milliseconds(10);   // Gone sooner: a loose plug, which must not keep us busy.
constexpr Duration kOldest = milliseconds(1000);  // A stamp further off than this is the device's mistake.
constexpr std::size_t kFirstStick = 1;

bool Readable(int fd) {
  pollfd poll{fd, POLLIN, 0};
  return ::poll(&poll, 1, 0) > 0;
}

// A device's name goes into the log: it must not end the line or colour the terminal.
std::string Printable(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
  return text;
}

std::array<std::uint32_t, kSticks> PortsBefore(const board::Board& board) {
  return {board.Read<board::Stick>(0).value.port, board.Read<board::Stick>(1).value.port};
}

}  // namespace

Result<DeskWriters> DeskWriters::Acquire(const board::Board& board) {
  auto surface = board.AcquireWriter<board::Surface>();
  if (!surface) return tl::unexpected(surface.error());
  auto left = board.AcquireWriter<board::Stick>(0);
  if (!left) return tl::unexpected(left.error());
  auto right = board.AcquireWriter<board::Stick>(1);
  if (!right) return tl::unexpected(right.error());
  auto keys = board.AcquireWriter<board::Keys>();
  if (!keys) return tl::unexpected(keys.error());
  auto pointer = board.AcquireWriter<board::Pointer>();
  if (!pointer) return tl::unexpected(pointer.error());
  auto lines = board.AcquireWriter<board::Lines>();
  if (!lines) return tl::unexpected(lines.error());
  return DeskWriters{std::move(*surface),
                     {std::move(*left), std::move(*right)},
                     std::move(*keys),
                     std::move(*pointer),
                     std::move(*lines)};
}

InputDesk::InputDesk(const board::Board& board, DeskWriters writers, DeskSources sources,
                     const InputSettings& settings, const Clock& clock)
    : board_(board),
      clock_(clock),
      lines_(board, std::move(writers.lines), std::move(sources.lines)),
      roles_(settings.stick_ports, PortsBefore(board)),
      started_(clock.now()) {
  using decode::DeviceKind;
  for (ports::HidBus* bus : sources.buses) buses_.push_back({.bus = bus});
  auto& [dials, left, right, keys, pointer] = places_;
  dials.seat = std::make_unique<DialSeat>(board, std::move(writers.surface), settings.counts_per_turn);
  dials.kind = DeviceKind::kDialBox;
  dials.port = settings.dial_box_port;
  left.seat = std::make_unique<StickSeat>(board, std::move(writers.sticks[0]), 0, settings);
  right.seat = std::make_unique<StickSeat>(board, std::move(writers.sticks[1]), 1, settings);
  left.kind = right.kind = DeviceKind::kJoystick;  // Their ports are the roles' business.
  keys.seat = std::make_unique<KeySeat>(board, std::move(writers.keys));
  keys.kind = DeviceKind::kKeyboard;
  keys.port = settings.keyboard_port;
  pointer.seat = std::make_unique<PointerSeat>(board, std::move(writers.pointer), settings.pointer);
  pointer.kind = DeviceKind::kPointer;
  pointer.port = settings.pointer_port;
}

void InputDesk::Step() {
  const Time now = clock_.now();
  if (ScanIsDue(now)) Scan(now);
  for (Place& place : places_) {
    if (place.device) Listen(place, now);
    place.seat->Tick(now, place.device.get());
  }
  if (!absent_known_ && now - started_ >= kFindTime) LeaveAbsent(now);
  lines_.Step(now);
  lines_.Light(TallyLit(board_.Read<board::StageStatus>(), board_.Read<board::Lines>(), now));
}

bool InputDesk::ScanIsDue(Time now) const {
  const auto speaks = [](const Bus& bus) { return !bus.troubled() && Readable(bus.bus->pollable()); };
  if (scan_now_ || std::ranges::any_of(buses_, speaks)) return true;
  return now >= next_scan_ &&
         (std::ranges::any_of(passed_, &Passed::try_again) || std::ranges::any_of(buses_, &Bus::troubled));
}

void InputDesk::Scan(Time now) {
  scan_now_ = false;
  next_scan_ = now + kRetry;
  for (std::size_t bus = 0; bus < buses_.size(); ++bus) ScanBus(bus, now);
}

void InputDesk::ScanBus(std::size_t bus, Time now) {
  auto ports = buses_[bus].bus->Ports();
  if (!ports) return HandleFailure(buses_[bus], ports.error());
  if (std::exchange(buses_[bus].trouble, {}) != std::errc{}) ++generation_;
  std::ranges::sort(*ports, PortBefore);
  std::erase_if(passed_, [&](const Passed& passed) {
    return passed.socket.bus == bus && std::ranges::find(*ports, passed.socket.port) == ports->end();
  });
  for (const std::string& port : *ports) {
    const Socket socket{bus, port};
    const auto passed = std::ranges::find(passed_, socket, &Passed::socket);
    const bool may_come = passed == passed_.end() || (passed->try_again && now >= passed->not_before);
    if (may_come && !Seated(socket)) Come(socket, now);
  }
}

void InputDesk::HandleFailure(Bus& bus, const Error& error) {
  if (std::exchange(bus.trouble, error.cause) == error.cause) return;
  LogWarning("{}; looking again", error.message());
  ++generation_;
}

void InputDesk::Come(const Socket& socket, Time now) {
  auto device = buses_[socket.bus].bus->Open(socket.port);
  if (!device) return TryLater(socket, device.error());
  std::erase_if(passed_, [&](const Passed& passed) { return passed.socket == socket; });
  const auto layout = decode::LayoutOf((*device)->identity());
  if (!layout) return PassBy(socket, decode::DeviceKind::kOther, layout.error().message());
  const decode::DeviceKind kind = decode::Recognise(*layout);
  if (kind == decode::DeviceKind::kOther) return PassBy(socket, kind, "not a device that plays");
  Place* place = PlaceFor(kind, socket);
  if (place == nullptr) return PassBy(socket, kind, "its seat is taken; it is a spare");
  Sit(*place, socket, std::move(*device), now);
}

void InputDesk::Sit(Place& place, const Socket& socket, std::unique_ptr<ports::HidChannel> device, Time now) {
  if (auto plugged = place.seat->Plug(device->identity(), now); !plugged)
    return PassBy(socket, place.kind, plugged.error().message());
  Log("{}: {} at port {}", place.seat->name(), Printable(device->identity().name), socket.port);
  place.device = std::move(device);
  place.socket = socket;
  place.seated_at = now;
  place.complained = false;
  place.faults = 0;
  ++generation_;
}

InputDesk::Place* InputDesk::PlaceFor(decode::DeviceKind kind, const Socket& socket) {
  if (kind == decode::DeviceKind::kJoystick) return StickPlace(socket);
  for (Place& place : places_) {
    const bool may_sit = place.port.empty() || place.port == socket.port;
    if (place.kind == kind && !place.device && may_sit) return &place;
  }
  return nullptr;
}

InputDesk::Place* InputDesk::StickPlace(const Socket& socket) {
  std::array<bool, kSticks> taken{};
  for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = places_[kFirstStick + i].device != nullptr;
  const auto role = roles_.RoleOf(socket.port, taken);
  return role ? &places_[kFirstStick + static_cast<std::size_t>(*role)] : nullptr;
}

void InputDesk::PassBy(const Socket& socket, decode::DeviceKind kind, const std::string& why) {
  LogWarning("port {}: {}", socket.port, why);
  passed_.push_back({.socket = socket, .kind = kind});
}

void InputDesk::TryLater(const Socket& socket, const Error& error) {
  const auto known = std::ranges::find(passed_, socket, &Passed::socket);
  if (known != passed_.end() && known->cause == error.cause) return;
  LogWarning("{}; trying again", error.message());
  std::erase_if(passed_, [&](const Passed& passed) { return passed.socket == socket; });
  passed_.push_back({.socket = socket, .try_again = true, .cause = error.cause});
}

void InputDesk::Listen(Place& place, Time now) {
  std::array<std::uint8_t, kReportBytes> bytes;
  for (int i = 0; i < kReportsAtOnce; ++i) {
    const auto input = place.device->Read(bytes);
    if (!input) {
      place.seat->Publish();
      return HandleFault(place, input.error(), now);
    }
    place.faults = 0;
    const auto report = std::span(bytes).first(std::min(input->bytes, bytes.size()));
    const auto taken = place.seat->Accept(report, std::clamp(input->at, now - kOldest, now));
    if (taken || std::exchange(place.complained, true)) continue;
    LogWarning("{}: {}; such reports are ignored from here on", place.seat->name(), taken.error().message());
  }
  place.seat->Publish();
}

void InputDesk::HandleFault(Place& place, const Error& error, Time now) {
  if (error.cause == std::errc::resource_unavailable_try_again) return;
  const bool gone = error.cause == std::errc::no_such_device || ++place.faults == kFaultsToLeave;
  if (gone) Leave(place, error, now);
}

void InputDesk::Leave(Place& place, const Error& error, Time now) {
  LogWarning("{}: {}; waiting for it", place.seat->name(), error.message());
  place.device.reset();
  place.seat->Unplug(now);
  ++generation_;
  // A spare dial box, keyboard or mouse may take the seat. A stick may not: it would swap roles at a loose
  // plug.
  if (place.kind != decode::DeviceKind::kJoystick)
    std::erase_if(passed_, [&](const Passed& passed) { return passed.kind == place.kind; });
  scan_now_ = now - place.seated_at >= kSettled;
  if (!scan_now_)
    passed_.push_back(
        {.socket = place.socket, .kind = place.kind, .try_again = true, .not_before = now + kRetry});
}

void InputDesk::LeaveAbsent(Time now) {
  absent_known_ = true;
  for (Place& place : places_)
    if (!place.device) place.seat->Unplug(now);
}

bool InputDesk::Seated(const Socket& socket) const {
  return std::ranges::any_of(places_, [&](const Place& p) { return p.device && p.socket == socket; });
}

std::vector<int> InputDesk::pollables() const {
  std::vector<int> fds;
  for (const Bus& bus : buses_)
    if (!bus.troubled()) fds.push_back(bus.bus->pollable());
  for (const Place& place : places_)
    if (place.device) fds.push_back(place.device->pollable());
  if (lines_.pollable() >= 0) fds.push_back(lines_.pollable());
  return fds;
}

int InputDesk::seated() const {
  return static_cast<int>(std::ranges::count_if(places_, [](const Place& p) { return p.device != nullptr; }));
}

}  // namespace kaori::input
