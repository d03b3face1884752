#include "hw-sim/devices/owned_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kaori::sim {
namespace {

// Descriptors that these devices send. The dials' own say little that is of use: a vendor's usages and bytes. Their length is
// right, since Linux gives nobody a report that is shorter than its descriptor says.
template <std::uint8_t kBytes>
constexpr auto VagueDescriptor() {
  return std::to_array<std::uint8_t>({
      0x05, 0x0C, 0x09, 0x01, 0xA1, 0x01, 0x06, 0x00,   0xFF, 0x09, 0x01, 0x15,
      0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, kBytes, 0x81, 0x02, 0xC0,
  });
}
constexpr auto kVagueKnob = VagueDescriptor<6>();
constexpr auto kVagueShuttle = VagueDescriptor<5>();
// X, Y 10 bits, hat 4, twist 8, 8 buttons, slider 8, 4 buttons.
constexpr auto kExtreme3d = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0xA1, 0x02, 0x09, 0x30, 0x09, 0x31, 0x15, 0x00, 0x26, 0xFF,
    0x03, 0x75, 0x0A, 0x95, 0x02, 0x81, 0x02, 0x09, 0x39, 0x25, 0x07, 0x75, 0x04, 0x95, 0x01, 0x81,
    0x42, 0x09, 0x35, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x81, 0x02, 0xA4, 0x05, 0x09, 0x19, 0x01, 0x29,
    0x08, 0x25, 0x01, 0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0xB4, 0x09, 0x36, 0x81, 0x02, 0x05, 0x09,
    0x19, 0x09, 0x29, 0x0C, 0x25, 0x01, 0x75, 0x01, 0x95, 0x04, 0x81, 0x02, 0x81, 0x01, 0xC0, 0xC0,
});
// X, Y, throttle of 8 bits, 11 buttons.
constexpr auto kAttack = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x15, 0x00,
    0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x03, 0x81, 0x02, 0x05, 0x09, 0x19, 0x01, 0x29,
    0x0B, 0x25, 0x01, 0x75, 0x01, 0x95, 0x0B, 0x81, 0x02, 0x95, 0x05, 0x81, 0x01, 0xC0,
});
// 16 buttons, hat, X and Y of 14 bits in 16, twist and slider of 8.
constexpr auto kThrustmaster = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x10, 0x15, 0x00, 0x25, 0x01,
    0x75, 0x01, 0x95, 0x10, 0x81, 0x02, 0x05, 0x01, 0x09, 0x39, 0x25, 0x07, 0x75, 0x04, 0x95, 0x01,
    0x81, 0x42, 0x81, 0x01, 0x09, 0x30, 0x09, 0x31, 0x26, 0xFF, 0x3F, 0x75, 0x10, 0x95, 0x02, 0x81,
    0x02, 0x09, 0x35, 0x09, 0x36, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x81, 0x02, 0xC0,
});

// Bytes of which all but the last are called X, four bits without a usage, 10 buttons, 10 bits of a vendor's, and an output: 101
// bytes, as Linux wants them of the one that it mends (drivers/hid/hid-dr.c lists the items). Really it has three bytes that stand
// still, X and Y.
constexpr auto kDragonRise = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0xA1, 0x02, 0x75, 0x08, 0x95, 0x05, 0x15, 0x00, 0x26, 0xFF, 0x00,
    0x35, 0x00, 0x46, 0xFF, 0x00, 0x09, 0x30, 0x09, 0x30, 0x09, 0x30, 0x09, 0x30, 0x09, 0x31, 0x81, 0x02,
    0x75, 0x04, 0x95, 0x01, 0x25, 0x07, 0x46, 0x3B, 0x01, 0x65, 0x14, 0x09, 0x00, 0x81, 0x42, 0x65, 0x00,
    0x75, 0x01, 0x95, 0x0A, 0x25, 0x01, 0x45, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x0A, 0x81, 0x02, 0x06,
    0x00, 0xFF, 0x75, 0x01, 0x95, 0x0A, 0x25, 0x01, 0x45, 0x01, 0x09, 0x01, 0x81, 0x02, 0xC0, 0xA1, 0x02,
    0x75, 0x08, 0x95, 0x04, 0x46, 0xFF, 0x00, 0x26, 0xFF, 0x00, 0x09, 0x02, 0x91, 0x02, 0xC0, 0xC0,
});
static_assert(kDragonRise.size() == 101);

// From -1 .. 1 to 0 .. `most`, whose middle is (most + 1) / 2.
unsigned Axis(float value, int most) {
  return static_cast<unsigned>(
      std::clamp<long>(std::lround((value + 1) / 2 * static_cast<float>(most + 1)), 0, most));
}

std::uint8_t Byte(unsigned value) {
  return static_cast<std::uint8_t>(value & 0xFFU);
}

}  // namespace

OwnedDevice::OwnedDevice(OwnedKind kind) : kind_(kind) {}

HidDeviceName OwnedDevice::device_name() const {
  switch (kind_) {
    case OwnedKind::kPowerMate:
      return {0x077D, 0x0410, "Griffin PowerMate", kVagueKnob};
    case OwnedKind::kShuttlePro:
      return {0x0B33, 0x0030, "Contour Design ShuttlePRO v2", kVagueShuttle};
    case OwnedKind::kExtreme3dPro:
      return {0x046D, 0xC215, "Logitech Extreme 3D Pro", kExtreme3d};
    case OwnedKind::kAttack3:
      return {0x046D, 0xC214, "Logitech Attack 3", kAttack};
    case OwnedKind::kT16000m:
      return {0x044F, 0xB10A, "Thrustmaster T.16000M", kThrustmaster};
    case OwnedKind::kDragonRise:
      return {0x0079, 0x0011, "DragonRise Generic USB Joystick", kDragonRise};
  }
  return {};
}

// A PowerMate tells a turn once, in a signed byte; a Shuttle tells a counter of eight bits, which wraps.
void OwnedDevice::Turn(int clicks) {
  if (kind_ == OwnedKind::kPowerMate) {
    turned_ = std::clamp(clicks, -127, 127);
    Say();
    turned_ = 0;
  } else if (kind_ == OwnedKind::kShuttlePro) {
    // A report for each click, as the wheel has detents.
    for (int n = 0; n < std::abs(clicks); ++n) {
      jog_ = static_cast<std::uint8_t>(jog_ + (clicks < 0 ? -1 : 1));
      Say();
    }
  }
}

void OwnedDevice::Ring(int place) {
  ring_ = std::clamp(place, -7, 7);
  Say();
}
void OwnedDevice::Move(float x, float y) {
  x_ = x;
  y_ = y;
  Say();
}
void OwnedDevice::Twist(float twist) {
  twist_ = twist;
  Say();
}
void OwnedDevice::Slide(float slider) {
  slider_ = slider;
  Say();
}
void OwnedDevice::Hat(int direction) {
  hat_ = direction;
  Say();
}
void OwnedDevice::Push(int button) {
  SetButton(button, true);
}
void OwnedDevice::Release(int button) {
  SetButton(button, false);
}

void OwnedDevice::SetButton(int button, bool down) {
  if (button < 0 || button >= 16) return;
  const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(button);
  buttons_ = down ? buttons_ | bit : buttons_ & ~bit;
  Say();
}

std::optional<Time> OwnedDevice::next_due() const {
  return waiting_.empty() ? std::nullopt : std::optional(Time{});
}

std::optional<Report> OwnedDevice::NextReport(Time) {
  if (waiting_.empty()) return std::nullopt;
  Report report = std::move(waiting_.front());
  waiting_.pop_front();
  return report;
}

Report OwnedDevice::Standing() const {
  if (kind_ == OwnedKind::kPowerMate)
    return {Byte(buttons_ & 1U), Byte(static_cast<unsigned>(turned_)), 0, 0x50, 0, 0};
  if (kind_ == OwnedKind::kShuttlePro)
    return {Byte(static_cast<unsigned>(ring_)), jog_, 0, Byte(buttons_), Byte(buttons_ >> 8U)};
  return StickBytes();
}

// Forwards is less on the wire, and so is the slider pushed up.
Report OwnedDevice::StickBytes() const {
  const unsigned hat = hat_ < 0 ? 8 : static_cast<unsigned>(hat_);
  const unsigned twist = Axis(twist_, 255), slider = Axis(1 - 2 * slider_, 255);
  if (kind_ == OwnedKind::kAttack3)
    return {Byte(Axis(x_, 255)), Byte(Axis(-y_, 255)), Byte(slider), Byte(buttons_), Byte(buttons_ >> 8U)};
  if (kind_ == OwnedKind::kExtreme3dPro) {
    const unsigned both = Axis(x_, 1023) | Axis(-y_, 1023) << 10U | hat << 20U;
    return {Byte(both),     Byte(both >> 8U), Byte(both >> 16U),           Byte(twist),
            Byte(buttons_), Byte(slider),     Byte(buttons_ >> 8U & 0x0FU)};
  }
  if (kind_ == OwnedKind::kDragonRise)
    return {0x01,
            0x80,
            0x80,
            Byte(Axis(x_, 255)),
            Byte(Axis(-y_, 255)),
            Byte(0x0F | buttons_ << 4U),
            Byte(buttons_ >> 4U & 0x3FU),
            0};
  const unsigned x = Axis(x_, 16383), y = Axis(-y_, 16383);
  return {Byte(buttons_), Byte(buttons_ >> 8U), Byte(hat_ < 0 ? 15 : hat),
          Byte(x),        Byte(x >> 8U),        Byte(y),
          Byte(y >> 8U),  Byte(twist),          Byte(slider)};
}

// The jog wheel's counter begins anew.
void OwnedDevice::PowerCycle() {
  waiting_.clear();
  jog_ = 0;
}

}  // namespace kaori::sim
