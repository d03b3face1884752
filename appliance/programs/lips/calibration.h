// Getting to know an operator's paint and mouth on site, in under a minute.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/lip_settings.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// What the operator does while a step is taken.
enum class CalibrationStep : std::uint8_t { kShut, kOpen, kWide, kNarrow, kSpeak };

// Commands in, settings out; pure: no file, no clock. The settings change when a step is done, all of its
// values at once, and every change can be taken back.
class Calibration {
 public:
  explicit Calibration(const LipSettings& settings) : settings_(settings) {}

  // Takes the paint's colour from the samples of chroma round a click at (x, y), in parts of the picture,
  // `reach` of them to each side: their median, and from their spread how similar a colour has to be. Errors:
  //   invalid_argument  nothing changed: the click is outside, or on grey, or on more than one colour
  static constexpr int kReach = 4;
  Result<void> SamplePaint(const decode::Planes& planes, float x, float y, int reach = kReach);

  // The operator holds the pose for a second, or speaks for ten. A step that was under way is given up.
  void Begin(CalibrationStep step);
  void GiveUp() { taking_.reset(); }

  // Each measured frame while a step is under way. Frames in which no good mouth is seen do not count, and
  // the step waits for better ones. True when the step is done by this frame.
  bool Feed(const board::Lips& lips, Time at);

  std::optional<CalibrationStep> step() const;
  float progress() const;  // Of the step that is under way, 0 .. 1.

  // A hand that sets values itself. All of one gesture, say a slider that is drawn, is one change; 0 is no
  // gesture.
  void Set(const LipSettings& to, std::uint32_t gesture = 0);

  // Takes back the newest change; false where there is none.
  bool Revert();
  // Takes back all but the first `changes`.
  void RevertTo(std::size_t changes);
  std::size_t changes() const { return before_.size(); }

  const LipSettings& settings() const { return settings_; }

 private:
  struct Taking {
    CalibrationStep step;
    std::optional<Time> last;  // The newest frame that counted.
    Duration seen{};
    std::vector<float> heights, widths, rests;
  };
  void Change(const LipSettings& to);
  LipSettings Concluded(Taking& taking) const;
  float ScaleOf(Taking& taking) const;

  LipSettings settings_;
  std::vector<LipSettings> before_;  // The oldest first.
  std::uint32_t gesture_ = 0;        // Of the newest change.
  std::optional<Taking> taking_;
  std::optional<Time> shut_at_;  // When the mouth at rest was learnt.
};

}  // namespace kaori::lips
