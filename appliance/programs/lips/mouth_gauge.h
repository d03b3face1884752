// From a mouth's outline in the picture to its sizes, in widths of the mouth at rest, whatever the head does.
#pragma once

#include <optional>
#include <vector>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/one_euro.h"
#include "appliance/programs/lips/outline.h"

namespace kaori::lips {

// One frame's mouth, and how far it is to be believed.
struct Sight {
  Shape shape;
  float picture_width_px = 0;
  float filled = 1;             // Part of its box that is paint.
  bool cut = false;             // By the picture's edge.
  std::optional<Point> marker;  // In pixels of the picture.
};

// The mouth at rest is the median of the first second in which a clean mouth is seen. A head that comes
// nearer or leans does not change the sizes: the marker's distance and direction tell it at once; without a
// marker the lean is taken from the mouth's own long axis, and the distance from each mouth that has the
// shape of the mouth at rest but another size.
class MouthGauge {
 public:
  // Goes on from `before`: its rest width where it has one, its frame count, and its sizes while no paint is
  // seen.
  explicit MouthGauge(const board::Lips& before, const GaugeSettings& settings = {});

  // Takes a frame's mouth, or the news that there is none: then sizes hold and the quality is 0.
  const board::Lips& Measure(const std::optional<Sight>& sight, Time at);

  // The width of the mouth at rest, in widths of the picture; 0 measures it anew.
  void SetRest(float width);

  const board::Lips& lips() const { return lips_; }

  // How far the head leans now, as it is known before the next frame; positive: clockwise in the picture.
  float tilt_rad() const { return tilt_rad_; }

 private:
  struct Sizes {  // In widths of the picture.
    float width;
    float height;
    float marker;  // From it to where the upper lip is when the mouth is shut; 0: no marker.
  };
  Sizes SizesOf(const Sight& sight);
  void LearnUpperPart(float marker, float height);
  void FollowTilt(const Sight& sight, Time at);
  void FollowDistance(const Sizes& sizes, Time at);
  bool IsHalfHidden(const Sight& sight, Time at);
  void Show(const Sight& sight, const Sizes& sizes, Time at);
  void LearnRest(const Sizes& sizes, Time at);

  board::Lips lips_;
  OneEuro height_;
  OneEuro width_;
  OneEuro opening_;
  struct Learning {
    Time since;
    std::vector<float> widths, heights, markers;
  };
  std::optional<Learning> learning_;
  float rest_height_ = 0.25F;  // In widths of the mouth at rest.
  float tilt_rad_ = 0;
  // How much of an opening mouth is its upper lip that rises: learnt from frame to frame, while the head is
  // slow.
  struct UpperPart {
    float marker = 0, height = 0;  // Of the frame before.
    float products = 0.2F * 1e-3F, squares = 1e-3F;
    float value() const { return products / squares; }
  };
  UpperPart upper_;
  std::optional<Time> seen_;
  std::optional<Time> whole_;  // When the mouth was last seen whole.
};

}  // namespace kaori::lips
