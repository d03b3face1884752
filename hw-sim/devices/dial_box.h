// The simulated dial and button box: 8 relative dials, 32 buttons with lamps.
#pragma once

#include <array>

#include "firmware/wire/dial_box.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {

// Dials 0..7 and buttons 0..31, from the upper left; other numbers are ignored. The report is that of
// firmware/wire/dial_box.h: 256 counts a turn, what was turned since the last report. Nothing here knows
// of a computer: links carry the reports. One thread.
class DialBox final : public HidDevice {
 public:
  // Borrows the context.
  explicit DialBox(const DeviceContext& context) : context_(context) {}

  // Test's side: what the operator does. Clockwise is positive; parts of a count are kept
  // for the next turn. What is no number, or further than 1000 turns, is ignored. Each
  // change is told to the context's watcher.
  void Turn(int dial, double turns);
  // Down and up; a button that is so already is left alone.
  void Push(int button);
  void Release(int button);
  std::uint32_t lamps() const { return lamps_; }  // Bit n: lamp n is lit.
  std::uint32_t buttons_down() const { return waiting_.newest().buttons_down; }
  double turned(int dial) const;  // All turns since the box was made.

  // Appliance's side, as HidDevice says. Lamps go dark with the power; dials
  // and buttons are where they are.
  HidDeviceName device_name() const override;
  std::optional<Time> next_due() const override { return waiting_.next_due(); }
  std::optional<Report> NextReport(Time now) override;
  Report Standing() const override;
  void HandleOutput(std::span<const std::uint8_t> report) override;
  void HostCame() override;
  void HostLeft() override { waiting_.set_hosted(false); }
  void PowerCycle() override;

 private:
  // `turns` is exact, so that many small turns add up to the same counts as one large turn.
  struct Dial {
    double turns = 0;           // Where the shaft stands, in turns since the start.
    std::int64_t reported = 0;  // Counts of it that reports have said.
  };
  // What the next report starts from: buttons as they are, nothing turned.
  static wire::DialBoxReport Next(const wire::DialBoxReport& last) { return {last.buttons_down, {}}; }
  // Push and Release; a button that is so already is told to nobody.
  void SetButton(int button, bool down);
  // Adds to the report that waits; may make several reports of one turn.
  void AddCounts(int dial, std::int64_t counts);

  const DeviceContext& context_;
  // Reports that are on their way, with what was turned since the one before.
  ReportQueue<wire::DialBoxReport> waiting_{&Next};
  std::array<Dial, wire::kDials> dials_{};
  // Bit n: lamp n is lit. Set by the host alone.
  std::uint32_t lamps_ = 0;
};

}  // namespace kaori::sim
