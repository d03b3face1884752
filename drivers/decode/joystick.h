// Any HID joystick: reports to axes, hat and buttons, with dead zone, centre and response curve.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/report_values.h"
#include "drivers/decode/switches.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::decode {

struct StickSample {
  Time at{};              // When the newest good report arrived.
  float x = 0;            // -1 left .. 1 right.
  float y = 0;            // -1 pulled back .. 1 pushed forwards.
  float twist = 0;        // -1 counter-clockwise .. 1 clockwise, seen from above.
  float slider = 0;       // 0 .. 1 from the device's lowest value to its highest.
  std::int32_t hat = -1;  // 0 up, clockwise in eighths to 7; -1 centred.
  Switches<1> buttons;
};

struct StickSettings {
  float dead_zone = 0.05f;  // Of the way to the end, around the centre: 0 there, and no jump at its edge.
  float reach = 1.0f;       // Of the way to the end at which the axis says 1: worn sticks do not get there.
  float curve = 0.0f;       // 0 straight .. 1 cubic: fine about the centre.
  bool slider_reversed = false;
};

// How one axis answers, for -1 .. 1 before and after. Pure.
float Shape(float raw, const StickSettings& settings);

// Pure: no descriptor, no clock. It outlives the device.
class JoystickDecoder {
 public:
  // Errors: invalid_argument (the descriptor), not_supported (no joystick by its descriptor).
  static Result<JoystickDecoder> For(const ports::HidIdentity& identity, const StickSettings& settings = {});

  // Takes one input report. Errors: bad_message  torn, short, long or unknown; the sample stays as it was.
  Result<StickSample> Decode(std::span<const std::uint8_t> report, Time at);

  // The cable was pulled: X, Y, twist and hat are neutral until a fresh report speaks of them, buttons go up;
  // the slider, which has no neutral, keeps its place.
  void Release();

  // Takes where X, Y and twist are now as their centres: hands off the stick. The newest sample follows. An
  // axis more than a third of the way from its middle is not at rest, and keeps its centre.
  void CalibrateCentre();

  // Centres of X, Y and twist as the device has them (Y grows towards the operator): 0 the middle, -1 and 1
  // the ends. What lies outside a third counts as 0.
  using Centres = std::array<float, 3>;
  Centres centres() const;
  void SetCentres(const Centres& centres);

  const StickSample& sample() const { return sample_; }

 private:
  struct Axis {
    ElementRef where;
    std::int64_t min = 0, middle = 0, centre = 0, max = 0;
    std::optional<std::int64_t> raw;  // Nothing until the first fresh report.
  };
  JoystickDecoder(ReportLayout layout, const StickSettings& settings);
  std::optional<Axis> FindAxis(Usage usage) const;
  std::optional<Axis> FindSlider() const;
  std::array<const std::optional<Axis>*, 3> centred() const { return {&x_, &y_, &twist_}; }
  std::array<std::optional<Axis>*, 3> centred() { return {&x_, &y_, &twist_}; }
  void DecodeAxes(const InputReport& report);
  void DecodeHat(const InputReport& report);
  float Placed(const std::optional<Axis>& axis) const;
  void Place();

  ReportLayout layout_;
  StickSettings settings_;
  std::optional<Axis> x_, y_, twist_, slider_;
  std::optional<ElementRef> hat_;
  SwitchReader<1> buttons_;
  StickSample sample_;
};

}  // namespace kaori::decode
