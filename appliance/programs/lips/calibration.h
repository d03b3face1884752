// The calibration of an operator's paint and mouth on site, in under a minute.
//
//   shut     the width and height of the mouth at rest: rest_width, mouth.shut
//   open     held as far as it goes: mouth.open
//   wide     stretched: mouth.wide
//   narrow   pursed: mouth.narrow
//   speak    ten seconds of speech: all four of mouth.*, by the ends of what was seen
//
// A sample of the paint sets paint.*, key.similarity and key.spill.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/protocol/protocol.h"
#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// Turns commands and measured mouths into settings. It is pure: it uses no file and no clock. The settings
// change when a step is done, all of its values at once, and every change can be undone. One thread. Nothing
// of it is drawn or saved: Tuning applies the settings that it gives.
class Calibration {
 public:
  // Begins with the settings in use; nothing can be undone yet.
  explicit Calibration(const LipSettings& settings) : settings_(settings) {}

  // Samples of chroma to each side of a click: 9 x 9 of them.
  static constexpr int kReach = 4;

  // Sets the paint's colour to the median of the samples of chroma around a click at (x, y), in parts of the
  // picture from its left top corner, `reach` samples to each side; their spread sets the similarity. Errors:
  //   invalid_argument  the click is outside, on grey, or on more than one colour; nothing changed
  Result<void> SamplePaint(const decode::Planes& planes, float x, float y, int reach = kReach);

  // Begins to measure a pose, which the operator holds for a second, or speech of ten seconds. A step that
  // was under way is cancelled. Poses can be measured in any order and as often as one likes; shut comes
  // first where the mouth at rest is not yet known, since the other sizes are in its widths.
  void Begin(CalibrationStep step);
  // Drops the step that is under way; the settings are as before.
  void Cancel() { measurement_.reset(); }

  // Adds a measured frame to the step that is under way. A frame without a learnable mouth (board/mouth.h)
  // does not count; the step waits for better ones. Returns whether this frame completed the step. `at` is
  // when the picture was exposed.
  bool Feed(const board::Lips& lips, Time at);

  // The step that is under way, if any.
  std::optional<CalibrationStep> step() const;
  float progress() const;  // Of the step that is under way, 0 .. 1; 0 without one.

  // Sets values directly. All calls of one gesture, such as the drag of a slider, are one change; 0 is no
  // gesture.
  void Set(const LipSettings& to, std::uint32_t gesture = 0);

  // Undoes the newest change. Returns false where there is none.
  bool Revert();
  // Undoes all but the first `changes`, as far back as changes are kept.
  void RevertTo(std::size_t changes);
  // How many changes there are that were not undone; of them the last 1000 can be.
  std::size_t changes() const { return forgotten_ + before_.size(); }

  // The settings with all changes that were not undone.
  const LipSettings& settings() const { return settings_; }

 private:
  // What a step has seen so far. `rests` are the rest widths that the gauge had at each frame, in widths of
  // the picture; heights and widths are in widths of the mouth at rest.
  struct Measurement {
    CalibrationStep step;
    std::optional<Time> last;  // The time of the newest frame that counted.
    Duration seen{};
    std::vector<float> heights, widths, rests;
  };
  // Notes the settings that there are and takes over others.
  void Change(const LipSettings& to);
  // The settings that a step which is done leads to. It reorders what was measured.
  LipSettings Conclude(Measurement& measured) const;
  // By how much the gauge has taken the mouth for nearer than it was, since shut was measured; 1 where that
  // is not known.
  float ScaleOf(Measurement& measured) const;

  LipSettings settings_;
  std::vector<LipSettings> before_;  // The oldest first; one entry for each change that can be undone.
  std::size_t forgotten_ = 0;        // Older changes, which no longer can.
  std::uint32_t gesture_ = 0;        // Of the newest change.
  std::optional<Measurement> measurement_;
  std::optional<Time> shut_at_;  // When the mouth at rest was measured.
};

}  // namespace kaori::lips
