// From a region of paint to the mouth's height and width, in widths of the mouth at rest.
#pragma once

#include <optional>
#include <vector>

#include "appliance/board/sections.h"
#include "appliance/lips/one_euro.h"
#include "appliance/lips/region.h"
#include "drivers/camera/planes.h"

namespace kaori::lips {

// The mouth at rest is the median of the first second in which a clean mouth is seen.
class MouthGauge {
 public:
  // Goes on from `before`: its rest width where it has one, its frame count, and its sizes while no paint is
  // seen.
  explicit MouthGauge(const board::Lips& before) : lips_(before) {}

  // Takes a frame's region, or the news that there is none: then sizes hold and the quality is 0.
  const board::Lips& Measure(const std::optional<Found>& found, const camera::Planes& planes, Time at);

  // The width of the mouth at rest, in widths of the picture; 0 measures it anew.
  void SetRest(float width);

  const board::Lips& lips() const { return lips_; }

 private:
  void LearnRest(float width, Time at);

  board::Lips lips_;
  OneEuro height_;
  OneEuro width_;
  std::vector<float> widths_;  // Of the first second.
  std::optional<Time> learning_since_;
};

}  // namespace kaori::lips
