#include "appliance/programs/input/input_service.h"

#include <algorithm>

#include "appliance/programs/input/dial_slot.h"
#include "appliance/programs/input/keyboard_slot.h"
#include "appliance/programs/input/pointer_slot.h"
#include "appliance/programs/input/stick_slot.h"
#include "appliance/programs/input/tally.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kReportBytes =
    1024;                            // Ours have up to 32, those of keyboards 64, of a Stream Deck 512.
constexpr int kReportsAtOnce = 256;  // A quarter of a second of a device that reports every millisecond.
// A device that the program had open before a restart is found again within this time, or it is gone.
constexpr Duration kFindTime = milliseconds(500);
constexpr int kFaultsToDetach = 64;  // One failed transfer is harmless; this many in a row are a dead device.
// A device that is gone sooner than this after its plug has a loose cable, and must not keep the program
// busy.
constexpr Duration kLoosePlug = milliseconds(10);
constexpr Duration kOldestReport = milliseconds(1000);  // An older time of arrival is a fault of the device.
constexpr std::size_t kFirstFurtherSurface = 5;

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
      lines_(board, std::move(writers.lines), std::move(writers.calls), std::move(sources.lines), clock,
             sources.wired_lines),
      maps_(std::move(sources.maps)),
      surface_(board, std::move(writers.surface), settings.counts_per_turn, 1 + kFurtherSurfaces),
      turns_(std::move(sources.turns)),
      lessons_(board, turns_, lines_),
      has_keyboards_(sources.has_keyboards),
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
  Scan(clock_.now());
  const Time now = clock_.now();  // A device may have taken long to open.
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
  ExpectLongCall();
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
        {.port = binding.port, .kind = binding.kind, .try_again = true, .not_before = clock_.now() + kRetry});
}

// Once, half a second after the start: what was plugged in before the restart and has not come back by then
// is gone, and its section must not stay live.
void InputService::DetachAbsent(Time now) {
  absent_detached_ = true;
  for (Binding& binding : bindings_)
    if (!binding.device) binding.slot->Unplug(now);
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
