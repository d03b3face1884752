// Simulated twins of HID devices that people own, by the bytes of their public descriptions.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "hw-sim/devices/hid_device.h"

namespace kaori::sim {

// kDragonRise: 0079:0011, whose own descriptor says X four times; Linux gives it another one, with which it plays.
enum class OwnedKind : std::uint8_t {
  kPowerMate,
  kShuttlePro,
  kExtreme3dPro,
  kAttack3,
  kT16000m,
  kDragonRise
};

// One device. Verbs that it has no part for do nothing. Reports leave in the order of what was done, one for
// each change: the real ones are slower than a hand in a test. One thread.
class OwnedDevice final : public HidDevice {
 public:
  explicit OwnedDevice(OwnedKind kind);

  // Test's side. Clockwise, to the right, forwards and upwards are positive.
  void Turn(int clicks);        // PowerMate, and the Shuttle's jog wheel.
  void Ring(int place);         // The Shuttle's ring, -7 .. 7.
  void Move(float x, float y);  // Sticks, -1 .. 1.
  void Twist(float twist);      // -1 .. 1.
  void Slide(float slider);     // 0 .. 1.
  void Hat(int direction);      // 0 up, clockwise to 7; -1 centred.
  void Push(int button);        // From 0.
  void Release(int button);

  // Appliance's side, as HidDevice says.
  HidDeviceName device_name() const override;
  std::optional<Time> next_due() const override;
  std::optional<Report> NextReport(Time now) override;
  Report Standing() const override;
  void HandleOutput(std::span<const std::uint8_t>) override {}
  void HostCame() override {}
  void HostLeft() override {}
  void PowerCycle() override;

 private:
  void Say() { waiting_.push_back(Standing()); }
  void SetButton(int button, bool down);
  Report StickBytes() const;

  OwnedKind kind_;
  std::deque<Report> waiting_;
  int turned_ = 0;  // PowerMate: in the next report.
  std::uint8_t jog_ = 0;
  int ring_ = 0;
  float x_ = 0;
  float y_ = 0;
  float twist_ = 0;
  float slider_ = 0;
  int hat_ = -1;
  std::uint32_t buttons_ = 0;
};

}  // namespace kaori::sim
