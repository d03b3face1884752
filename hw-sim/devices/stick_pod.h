// A simulated joystick: two axes, twist, slider, hat and 12 buttons.
#pragma once

#include "firmware/wire/stick_pod.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/devices/operator_action.h"
#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {

// It does not spring back by itself: whoever lets it go moves it to the middle. Positions are exact;
// reports round them to the device's counts. One thread.
class StickPod final : public HidDevice {
 public:
  // `port` is kStickLeft or kStickRight. Borrows the context.
  StickPod(DevicePort port, const DeviceContext& context) : port_(port), context_(context) {}

  // Test's side. Values beyond the stops are held at the stops.
  void Move(float x, float y);  // x: -1 left .. 1 right; y: -1 pulled back .. 1 pushed forwards.
  void Twist(float twist);      // -1 counter-clockwise .. 1 clockwise, seen from above.
  void Slide(float slider);     // 0 .. 1.
  void Hat(int direction);      // 0 up, clockwise in eighths to 7; -1 centred. Others are ignored.
  void Push(int button);        // 0 .. 11; others are ignored.
  void Release(int button);
  float x() const { return x_; }
  float y() const { return y_; }
  float twist() const { return twist_; }
  float slider() const { return slider_; }
  // 0 up, clockwise in eighths to 7; -1 centred.
  int hat() const;
  std::uint16_t buttons_down() const { return waiting_.newest().buttons_down; }

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
  // Nothing in this report is said once: all of it stands.
  static wire::StickPodReport Next(const wire::StickPodReport& last) { return last; }
  // The report that waits, for a change that may share it with others.
  wire::StickPodReport& Change();
  // Told to the watcher only where it changes.
  void SetButton(int button, bool down);

  // Which of the two: for the watcher, and for nothing else.
  DevicePort port_;
  const DeviceContext& context_;
  // Positions and buttons as the next reports say them.
  ReportQueue<wire::StickPodReport> waiting_{&Next};
  // Exact, as they were set; the slider 0 .. 1, the others -1 .. 1.
  float x_ = 0;
  float y_ = 0;
  float twist_ = 0;
  float slider_ = 0;
};

}  // namespace kaori::sim
