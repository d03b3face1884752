// The input desk: whatever HID devices are plugged in sit down at their seats and play onto the board.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/line_desk.h"
#include "appliance/programs/input/roles.h"
#include "appliance/programs/input/seat.h"
#include "appliance/programs/input/settings.h"
#include "drivers/base/clock.h"
#include "drivers/decode/recognise.h"
#include "drivers/ports/gpio_lines.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::input {

// The sections that the desk writes.
struct DeskWriters {
  board::Writer<board::Surface> surface;
  std::array<board::Writer<board::Stick>, kSticks> sticks;
  board::Writer<board::Keys> keys;
  board::Writer<board::Pointer> pointer;
  board::Writer<board::Lines> lines;

  // Errors: as Board::AcquireWriter, of the first section that cannot be had.
  static Result<DeskWriters> Acquire(const board::Board& board);
};

// What the desk listens to.
struct DeskSources {
  std::vector<ports::HidBus*> buses;  // Outlive the desk.
  ports::GpioOpener lines;            // Empty where the box has none.
};

// One thread. Goes on from what the board holds.
class InputDesk {
 public:
  // Borrows the board, the buses and the clock.
  InputDesk(const board::Board& board, DeskWriters writers, DeskSources sources,
            const InputSettings& settings, const Clock& clock);

  // Does everything that waits: devices that come and go, reports, edges, lamps. Never blocks, and never
  // stays with one device that floods. Call it when any of pollables() is readable, and every 10 ms or
  // sooner.
  void Step();

  // What to wait for. Numbers may be those of other descriptors when generation() changed: watch all anew.
  std::vector<int> pollables() const;
  std::uint32_t generation() const { return generation_ + lines_.generation(); }

  // How many devices sit at the desk.
  int seated() const;

 private:
  struct Bus {
    ports::HidBus* bus = nullptr;
    std::errc trouble{};  // Why it cannot list its ports: asked again now and then, and not waited for.
    bool troubled() const { return trouble != std::errc{}; }
  };
  // Buses give ports; two buses may use the same name.
  struct Socket {
    std::size_t bus = 0;
    std::string port;
    friend bool operator==(const Socket&, const Socket&) = default;
  };
  struct Place {
    std::unique_ptr<Seat> seat;
    decode::DeviceKind kind = decode::DeviceKind::kOther;
    std::string port;  // The only one that may sit here; empty: any.
    Socket socket;     // Where the device that sits here is plugged in.
    std::unique_ptr<ports::HidChannel> device;
    Time seated_at{};
    bool complained = false;  // Of a bad report, since the plug.
    int faults = 0;           // Failed transfers in a row.
  };
  // A port whose device has no seat, or could not be opened yet.
  struct Passed {
    Socket socket;
    decode::DeviceKind kind = decode::DeviceKind::kOther;
    bool try_again = false;
    std::errc cause{};
    Time not_before{};
  };

  void Scan(Time now);
  void ScanBus(std::size_t bus, Time now);
  bool ScanIsDue(Time now) const;
  void HandleFailure(Bus& bus, const Error& error);
  void Come(const Socket& socket, Time now);
  void PassBy(const Socket& socket, decode::DeviceKind kind, const std::string& why);
  void TryLater(const Socket& socket, const Error& error);
  Place* PlaceFor(decode::DeviceKind kind, const Socket& socket);
  Place* StickPlace(const Socket& socket);
  void Sit(Place& place, const Socket& socket, std::unique_ptr<ports::HidChannel> device, Time now);
  void Listen(Place& place, Time now);
  void HandleFault(Place& place, const Error& error, Time now);
  void Leave(Place& place, const Error& error, Time now);
  void LeaveAbsent(Time now);
  bool Seated(const Socket& socket) const;

  const board::Board& board_;
  const Clock& clock_;
  std::vector<Bus> buses_;
  LineDesk lines_;
  std::array<Place, 5> places_;  // Dial box, left stick, right stick, keyboard, pointer.
  StickRoles roles_;
  std::vector<Passed> passed_;
  Time started_;
  Time next_scan_{};
  bool scan_now_ = true;
  bool absent_known_ = false;
  std::uint32_t generation_ = 0;
};

}  // namespace kaori::input
