// A simulated tablet: an absolute position on the picture, three buttons and a wheel.
#pragma once

#include "firmware/wire/pointer.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {

// Absolute: what is moved to is where the pen is, whatever the screen's size. Nothing is told
// of a pen that does not move. One thread.
class Pointer final : public HidDevice {
 public:
  // Borrows the context.
  explicit Pointer(const DeviceContext& context) : context_(context) {}

  // Test's side. The pen begins in the middle. Values beyond the edges are held at the edges.
  void Move(double x, double y);  // 0 left .. 1 right; 0 above .. 1 below.
  void Push(int button);          // 0 the left one, 1 the right, 2 the middle; others are ignored.
  void Release(int button);
  // Away from the operator is positive; parts of a notch are kept for the next turn.
  void Roll(double notches);
  // Exact, as they were set; reports have counts.
  double x() const { return x_; }
  double y() const { return y_; }
  std::uint8_t buttons_down() const { return waiting_.newest().buttons_down; }

  // Appliance's side.
  HidDeviceName device_name() const override;
  std::optional<Time> next_due() const override { return waiting_.next_due(); }
  std::optional<Report> NextReport(Time now) override;
  Report Standing() const override;
  void HandleOutput(std::span<const std::uint8_t>) override {}
  void HostCame() override;
  void HostLeft() override { waiting_.set_hosted(false); }
  void PowerCycle() override { waiting_.Forget(); }

 private:
  // What the next report starts from: the position and the buttons stand, the wheel has not turned.
  static wire::PointerReport Next(const wire::PointerReport& last);
  void SetButton(int button, bool down);
  // Adds whole notches to the report that waits; may make several reports.
  void AddNotches(int notches);

  const DeviceContext& context_;
  // Position and buttons as the next reports say them.
  ReportQueue<wire::PointerReport> waiting_{&Next};
  // Of the picture, 0 .. 1; the middle at first.
  double x_ = 0.5;
  double y_ = 0.5;
  double unrolled_ = 0;  // Part of a notch.
};

}  // namespace kaori::sim
