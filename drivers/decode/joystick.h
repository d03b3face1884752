// Decodes any HID joystick: reports to axes, hat and buttons, with dead zone, centre and response curve.
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

// The newest state of a joystick in the frame of its operator, whatever the device's own range and signs.
struct StickSample {
  Time at{};              // When the newest good report arrived.
  float x = 0;            // -1 left .. 1 right.
  float y = 0;            // -1 pulled back .. 1 pushed forwards.
  float twist = 0;        // -1 counter-clockwise .. 1 clockwise, seen from above.
  float slider = 0;       // 0 .. 1 from the device's lowest value to its highest.
  std::int32_t hat = -1;  // 0 up, clockwise in eighths to 7; -1 centred.
  // Of the Button page: button 1 is switch 0.
  Switches<1> buttons;
};

// The response of X, Y and twist, by the profile of the show; the slider knows only its direction.
struct StickSettings {
  float dead_zone = 0.05f;  // Of the way to the end, around the centre: 0 there, and no jump at its edge.
  float reach = 1.0f;       // Of the way to the end at which the axis says 1: worn sticks do not get there.
  float curve = 0.0f;       // 0 straight .. 1 cubic: fine about the centre.
  // A throttle whose device counts towards its user.
  bool slider_reversed = false;
};

// The response of one axis: -1 .. 1 to -1 .. 1, odd and monotonic. With d the dead
// zone and r the reach, w = (|raw| - d) / (r - d) clamped to 0 .. 1, and the result is
// w + curve * (w^3 - w) with the sign of `raw`. Pure.
float Shape(float raw, const StickSettings& settings);

// Pure: no file descriptor, no clock. It may outlive the device. Any joystick is read by its descriptor;
// there is no table of models. Decode allocates nothing once a report of each id has come.
class JoystickDecoder {
 public:
  // The axes are at 0 until a report has them, and the centres are
  // the middles of the logical ranges. Errors:
  //   invalid_argument  the report descriptor is broken
  //   not_supported     the device is no joystick
  static Result<JoystickDecoder> For(const ports::HidIdentity& identity, const StickSettings& settings = {});

  // Decodes one input report and returns the new sample. Errors:
  //   bad_message  the report is torn, short, long or of an unknown id; the sample stays as it was
  Result<StickSample> Decode(std::span<const std::uint8_t> report, Time at);

  // To be called when the cable was pulled: X, Y, twist and hat are neutral until a report has them again,
  // and buttons go up. The slider has no neutral position and keeps its value.
  void Release();

  // Makes the present positions of X, Y and twist their centres, and changes the sample accordingly. Nobody
  // may touch the stick meanwhile. An axis that is more than a third of the way from its middle is not at
  // rest, and keeps its centre.
  void CalibrateCentre();

  // The centres of X, Y and twist in the device's own frame (Y grows towards the operator),
  // from -1 to 1; 0 is the middle of the logical range. They are kept in a file between two
  // shows. An axis that the device does not have is 0. A centre further than a third from the
  // middle counts as 0: such a file belongs to another stick.
  using Centres = std::array<float, 3>;
  Centres centres() const;
  void SetCentres(const Centres& centres);

  // The newest sample, also after Release and CalibrateCentre.
  const StickSample& sample() const { return sample_; }

 private:
  // An axis, in the device's logical units. The middle is the descriptor's; the centre is where it
  // rests. A stick that is worn or bent rests elsewhere than in the middle.
  struct Axis {
    // In which report and field it is.
    ElementRef where;
    // min and max are the ends of the logical range; the centre lies between them.
    std::int64_t min = 0, middle = 0, centre = 0, max = 0;
    std::optional<std::int64_t> raw;  // None before a report had it.
  };
  JoystickDecoder(ReportLayout layout, const StickSettings& settings);
  // The first absolute input of this usage; none where the device has no such axis.
  std::optional<Axis> FindAxis(Usage usage) const;
  // The slider, throttle or Z axis, in this order.
  std::optional<Axis> FindSlider() const;
  // The axes that have a centre, in the order of Centres.
  std::array<const std::optional<Axis>*, 3> centred() const { return {&x_, &y_, &twist_}; }
  std::array<std::optional<Axis>*, 3> centred() { return {&x_, &y_, &twist_}; }
  // These read one report into the axes' raw values, and into the sample's hat.
  void DecodeAxes(const InputReport& report);
  void DecodeHat(const InputReport& report);
  // The response of an axis at its raw value, from its centre to either end; 0 where it is not known.
  float Position(const std::optional<Axis>& axis) const;
  // Derives the sample's axes from the raw values.
  void UpdateAxes();

  // Of the device's own descriptor.
  ReportLayout layout_;
  StickSettings settings_;
  std::optional<Axis> x_, y_, twist_, slider_;
  // None where the device has no hat.
  std::optional<ElementRef> hat_;
  SwitchReader<1> buttons_;
  StickSample sample_;
};

}  // namespace kaori::decode
