// The input service: assigns each HID device to its slot and publishes what operators do with it on the
// board. It knows no driver: buses and lines come in as ports, real or simulated.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "appliance/core/board/caller.h"
#include "appliance/programs/input/device_slot.h"
#include "appliance/programs/input/learnt_turns.h"
#include "appliance/programs/input/line_inputs.h"
#include "appliance/programs/input/midi_section.h"
#include "appliance/programs/input/settings.h"
#include "appliance/programs/input/stick_roles.h"
#include "appliance/programs/input/surface_map.h"
#include "appliance/programs/input/surface_section.h"
#include "appliance/programs/input/turn_lessons.h"
#include "drivers/base/clock.h"
#include "drivers/decode/recognise.h"
#include "drivers/ports/gpio_lines.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::input {

// The writers of all sections that the service writes. One program at a time holds them, so that a second
// kaori-input is refused when it starts.
struct InputWriters {
  board::Writer<board::Surface> surface;
  std::array<board::Writer<board::Stick>, kSticks> sticks;
  board::Writer<board::Keys> keys;
  board::Writer<board::Pointer> pointer;
  board::Writer<board::Lines> lines;
  board::Caller calls;
  board::Writer<board::MidiHeard> midi;

  // Errors are those of Board::AcquireWriter, for the first section that is not to be had.
  static Result<InputWriters> Acquire(const board::Board& board);
};

// Where input comes from.
struct InputSources {
  // Borrowed: the buses outlive the service.
  std::vector<ports::HidBus*> buses;
  // Empty where the box has no GPIO lines.
  ports::GpioOpener lines;
  // Of surfaces that people own.
  std::vector<SurfaceMap> maps{};
  // Borrowed; null where nobody listens to MIDI.
  const ports::MidiTap* midi = nullptr;
  // Bit n: line n is wired; for those who ask whether each of them works.
  std::uint32_t wired_lines = board::kEveryLine;
  // Where it is kept what one turn of a device's dials has; empty: nowhere.
  std::filesystem::path turns{};
  // Nobody types in a kiosk: keyboards are left alone, whatever they told the kernel that they are.
  bool has_keyboards = true;
};

// How many surfaces with a map may play beside the dial box.
inline constexpr std::size_t kFurtherSurfaces = 4;

// The service runs in one thread and goes on from what the board holds. A device that cannot be read, opened
// or recognised is logged once and never stops the service of the others.
//
// A device is in one of three states: it fills a slot (Binding), its port is skipped (SkippedPort: a spare, a
// device of another kind, or one that could not be opened), or its port is empty. A device that fails goes
// back through Scan like one that was just plugged in.
class InputService {
 public:
  // Borrows the board, the buses and the clock, which all outlive the service. Nothing is opened yet: the
  // first Step does that. `settings` is copied.
  InputService(const board::Board& board, InputWriters writers, InputSources sources,
               const InputSettings& settings, const Clock& clock);

  // Handles devices that come and go, reports, line edges and lamps that are due. It never blocks, and it
  // reads a bounded number of reports from each device, so that one that floods does not keep the others
  // waiting. Call it when any of pollables() is readable, and every 10 ms or sooner.
  void Step();

  // The file descriptors to wait for. When generation() has changed, the same number may mean another
  // descriptor: every watch must then be made anew. Buses whose list failed are left out, and so are lines
  // that could not be opened; they are asked again by time. The descriptors stay the service's.
  std::vector<int> pollables() const;
  // Changes whenever pollables() may have changed; it may wrap.
  std::uint32_t generation() const { return generation_ + lines_.generation(); }

  // How many devices fill a slot now.
  int attached_devices() const;

 private:
  // The pause before a device that is present and cannot be opened, or a bus that failed, is tried again.
  static constexpr Duration kRetry = std::chrono::milliseconds(250);

  struct Bus {
    ports::HidBus* bus = nullptr;
    // Why it cannot list its ports: it is asked again now and then, and not waited for.
    std::errc failure{};
    bool failed() const { return failure != std::errc{}; }
  };
  // A port of one bus; two buses may use the same port name.
  struct BusPort {
    std::size_t bus = 0;
    std::string name;
    friend bool operator==(const BusPort&, const BusPort&) = default;
  };
  // A slot, and the device that fills it.
  struct Binding {
    std::unique_ptr<DeviceSlot> slot;
    decode::DeviceKind kind = decode::DeviceKind::kOther;
    // The name of the one port whose device may fill the slot; empty: any port.
    std::string only_port;
    // Where the attached device is plugged in.
    BusPort port;
    std::unique_ptr<ports::HidChannel> device;
    Time attached_at{};
    // Since the plug.
    bool bad_report_logged = false;
    // Failed transfers in a row.
    int faults = 0;
  };
  // A port whose device fills no slot, or could not be opened yet.
  struct SkippedPort {
    BusPort port;
    decode::DeviceKind kind = decode::DeviceKind::kOther;
    // The device could not be opened (`cause`, as it was logged) or was pulled at once: it is tried again,
    // but not before `not_before`.
    bool try_again = false;
    std::errc cause{};
    Time not_before{};
  };

  // Lists the ports of the buses for which that is due, or of one, and tries to attach what is new there.
  void Scan(Time now);
  void ScanBus(std::size_t bus, Time now);
  // A bus that cannot list its ports: logged once for each cause, and asked again every 250 ms.
  void HandleBusError(Bus& bus, const Error& error);
  // Opens the device at a port, finds out what it is, and gives it to a slot or skips it.
  void TryToAttach(const BusPort& port, Time now);
  // Leaves a port alone until its device is pulled, or until a slot of this kind becomes free.
  void Skip(const BusPort& port, decode::DeviceKind kind, const std::string& why);
  // A device that is there and cannot be opened: tried again every 250 ms, or later where the attempt took long.
  void RetryLater(const BusPort& port, const Error& error, Duration took);
  // The free slot for a device of this kind at this port; null where there is none.
  Binding* BindingFor(decode::DeviceKind kind, const BusPort& port);
  Binding* StickBinding(const BusPort& port);
  // Makes the left stick the right one where a stick at `port` should be left of it and nobody plays yet.
  void OrderSticks(const BusPort& port);
  void Attach(Binding& binding, const BusPort& port, std::unique_ptr<ports::HidChannel> device, Time now);
  // Decodes the reports that wait, 256 at most, and publishes once.
  void ReadReports(Binding& binding, Time now);
  // Detaches the device where the error means that it is gone; a single failed transfer is passed over.
  void HandleReadError(Binding& binding, const Error& error, Time now);
  void Detach(Binding& binding, const Error& error, Time now);
  // Tells the slots that stayed empty after the start that their device is gone.
  void DetachAbsent(Time now);
  bool IsAttached(const BusPort& port) const;

  const board::Board& board_;
  // All times are of this clock, CLOCK_MONOTONIC: it is read once in each step, and after calls that may take long.
  const Clock& clock_;
  std::vector<Bus> buses_;
  LineInputs lines_;
  const std::vector<SurfaceMap> maps_;
  SurfaceSection surface_;
  // What devices' dials have in one turn, and the lessons by which it is learnt; slots borrow the former, and the
  // latter borrow slots and lines: they stand between them in this order.
  LearntTurns turns_;
  TurnLessons lessons_;
  const bool has_keyboards_;
  const ports::MidiTap* midi_tap_;
  MidiSection midi_;
  // The slots are made once and live as long as the service; devices come and go.
  // Dial box, left stick, right stick, keyboard, pointer, and further surfaces, which are devices with a map.
  std::array<Binding, 5 + kFurtherSurfaces> bindings_;
  StickRoles roles_;
  // At most one entry for each port of a bus; it is dropped when the port is empty or the device is attached.
  std::vector<SkippedPort> skipped_;
  Time started_;
  Time next_scan_{};
  bool scan_now_ = true;
  // Slots that stayed empty after the start were told so: see DetachAbsent.
  bool absent_detached_ = false;
  // Counts changes of the set of descriptors; the lines count their own.
  std::uint32_t generation_ = 0;
};

}  // namespace kaori::input
