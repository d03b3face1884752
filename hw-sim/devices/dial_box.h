// The simulated dial and button box: 8 relative dials, 32 buttons with lamps.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/surface/dial_box.h"
#include "firmware/wire/dial_box.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/devices/operator_action.h"

namespace kaori::sim {

// An operator's hand on the lines of the box's own firmware (firmware/surface): dials whose edges tremble,
// switches that chatter. Dials 0..7 and buttons 0..31, from the upper left; other numbers are ignored. The
// hand is quicker than any: what the firmware sees of an action, look by look, it sees within the call.
// Nothing here knows of a computer: links carry the reports, one in a millisecond, as a full-speed bus does.
// One thread.
class DialBox final : public HidDevice {
 public:
  // Borrows the context.
  explicit DialBox(const DeviceContext& context);

  // Test's side: what the operator does. Clockwise is positive; parts of a count are kept
  // for the next turn. What is no number, or further than 1000 turns, is ignored. Each
  // change is told to the context's watcher.
  void Turn(int dial, double turns);
  // Down and up; a button that is so already is left alone.
  void Push(int button);
  void Release(int button);
  std::uint32_t lamps() const { return firmware_->lamps(); }  // Bit n: lamp n is lit.
  std::uint32_t buttons_down() const { return firmware_->pressed(); }
  double turned(int dial) const;  // All turns since the box was made.

  // Appliance's side, as HidDevice says. Lamps go dark with the power; dials
  // and buttons are where they are.
  HidDeviceName device_name() const override;
  std::optional<Time> next_due() const override;
  std::optional<Report> NextReport(Time now) override;
  Report Standing() const override;
  void HandleOutput(std::span<const std::uint8_t> report) override;
  void HostCame() override;
  void HostLeft() override { firmware_->SetHost(surface::Host::kGone); }
  void PowerCycle() override { PowerOn(); }

 private:
  // `turns` is exact, so that many small turns add up to the same counts as one large turn.
  struct Dial {
    double turns = 0;        // Where the shaft stands, in turns since the start.
    std::int64_t edges = 0;  // Edges that its encoder has made of them.
  };
  void PowerOn();
  // Push and Release; a button that is so already is told to nobody.
  void SetButton(int button, bool down);
  // The edges of so many counts on the dial's two lines, each with a tremble.
  void MakeEdges(std::size_t dial, std::int64_t counts);
  // What the firmware sees at one look at the dials, and at some looks at the switches.
  void LookAtDials();
  void LookAtSwitches(std::uint32_t closed, unsigned looks);
  // Does something to the firmware's lines, and notes since when it has something to say.
  template <class Do>
  void Change(Do act);

  const DeviceContext& context_;
  // Made anew when the power comes.
  std::optional<surface::DialBox> firmware_;
  std::array<Dial, wire::kDials> dials_{};
  std::uint32_t closed_ = 0;  // Bit n: switch n is held closed.
  // When a report first had something to say, and when the bus takes the next one.
  Time changed_at_{};
  Time free_at_{};
};

}  // namespace kaori::sim
