// A simulated joystick: two axes, twist, slider, hat and 12 buttons.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/surface/stick_pod.h"
#include "firmware/wire/stick_pod.h"
#include "hw-sim/devices/hid_device.h"
#include "hw-sim/devices/operator_action.h"

namespace kaori::sim {

// An operator's hand on the potentiometers and switches of the pod's own firmware (firmware/surface). It does
// not spring back by itself: whoever lets it go moves it to the middle. Positions are as fine as the pod's
// converter tells them, four codes of 12 bits at a time. The hand is quicker than any: what the firmware sees
// of an action it sees within the call. One thread.
class StickPod final : public HidDevice {
 public:
  // `port` is kStickLeft or kStickRight. Borrows the context.
  StickPod(DevicePort port, const DeviceContext& context);

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
  int hat() const { return hat_; }
  std::uint16_t buttons_down() const { return buttons_; }

  // Appliance's side, as HidDevice says.
  HidDeviceName device_name() const override;
  std::optional<Time> next_due() const override;
  std::optional<Report> NextReport(Time now) override;
  Report Standing() const override;
  void HandleOutput(std::span<const std::uint8_t>) override {}
  void HostCame() override;
  void HostLeft() override { firmware_->SetHost(surface::Host::kGone); }
  void PowerCycle() override { PowerOn(); }

 private:
  void PowerOn();
  // What the firmware sees at some looks: the switches as they are held, and the axes where they stand.
  void Look(unsigned looks);
  // As many looks as its filters need until they say where the axes stand.
  void Settle();
  // The switches close or open, and chatter before they rest.
  void Switch(std::uint32_t changed, unsigned looks);
  // Told to the watcher only where it changes.
  void SetButton(int button, bool down);
  // Does something to the firmware's lines, and notes since when it has something to say.
  template <class Do>
  void Change(Do act);

  // Which of the two: for the watcher, and for nothing else.
  DevicePort port_;
  const DeviceContext& context_;
  // Made anew when the power comes.
  std::optional<surface::StickPod> firmware_;
  // Exact, as they were set; the slider 0 .. 1, the others -1 .. 1.
  float x_ = 0;
  float y_ = 0;
  float twist_ = 0;
  float slider_ = 0;
  int hat_ = -1;
  std::uint16_t buttons_ = 0;  // Bit n: button n is held.
  std::uint32_t closed_ = 0;   // The switches, as surface::StickPod::Tick has them.
  // What the potentiometers give, in sums of four codes.
  std::array<std::uint16_t, surface::StickPod::kAxes> sums_{};
  unsigned code_of_four_ = 0;
  // When a report first had something to say, and when the bus takes the next one.
  Time changed_at_{};
  Time free_at_{};
};

}  // namespace kaori::sim
