// From a mouth's contour in the picture to its sizes in widths of the mouth at rest, wherever the head is.
//
// With w, h the size of the paint's outline in widths of the picture, and r the width of the mouth at rest:
//
//   width = w / r',  height = h / r',  r' = r m / m0
//
// where m is the distance from the marker to the upper lip of the shut mouth now and m0 what it was at rest.
// Without a marker r' = r, and r follows mouths that have the proportions of the mouth at rest.
#pragma once

#include <optional>
#include <vector>

#include "appliance/core/board/sections.h"
#include "appliance/programs/lips/contour.h"
#include "appliance/programs/lips/lip_settings.h"
#include "appliance/programs/lips/one_euro.h"

namespace kaori::lips {

// The mouth that was detected in a frame, with what its quality depends on. It is of one picture and borrows
// nothing.
struct Detection {
  // Sizes and positions in pixels of the picture.
  Contour contour;
  float picture_width_px = 0;
  float filled = 1;             // The part of its bounding box that is paint.
  bool cut = false;             // The picture's edge cuts it.
  std::optional<Point> marker;  // The marker's middle, in pixels of the picture.
};

// The mouth at rest is the median of the first second in which a learnable mouth is seen. Sizes do not change
// when the head comes nearer or leans: with a marker its distance and direction show that at once. Without a
// marker the lean is that of the mouth's own long axis, and the distance follows every mouth that has the
// proportions of the mouth at rest in another size. Pure: time is in the arguments.
class MouthGauge {
 public:
  // Goes on from `before`: its rest width where that is known, its frame count, and its sizes until paint is
  // seen.
  explicit MouthGauge(const board::Lips& before, const GaugeSettings& settings = {});

  // Measures a frame's mouth. Without one the sizes stay and the quality is 0. What it gives holds until the
  // next call. `at` is when the picture was exposed.
  const board::Lips& Measure(const std::optional<Detection>& detection, Time at);

  // Sets the width of the mouth at rest, in widths of the picture; 0 measures it again. The marker's distance
  // is learnt anew as well.
  void SetRest(float width);

  const board::Lips& lips() const { return lips_; }

  // How far the head leans, as known before the next frame; positive is clockwise in the picture.
  float tilt_rad() const { return tilt_rad_; }

 private:
  struct Sizes {  // In widths of the picture.
    // Width and height as the contour has them, over the width of the picture.
    float width;
    float height;
    float marker;  // From the marker to the upper lip of the shut mouth; 0: there is no marker.
  };
  // The sizes of this picture's mouth, before distance and smoothing.
  Sizes SizesOf(const Detection& detection);
  // Learns how much of an opening the upper lip does.
  void LearnUpperPart(float marker, float height);
  // How the head leans, and how far it is; each where this picture says anything about it.
  void FollowTilt(const Detection& detection, Time at);
  void FollowDistance(const Sizes& sizes, Time at);
  // Whether something covers one corner of the mouth.
  bool IsHalfHidden(const Detection& detection, Time at);
  // Writes sizes and corners to lips_, in widths of the mouth at rest.
  void Show(const Detection& detection, const Sizes& sizes, Time at);
  // Measures the mouth at rest where it is not known, for a second.
  void LearnRest(const Sizes& sizes, Time at);

  // The result, as the board has it; rest width and marker distance are kept in it as well.
  board::Lips lips_;
  // A filter for each size; they are reset where no mouth is seen.
  OneEuro height_;
  OneEuro width_;
  OneEuro opening_;
  // What the second of the mouth at rest has seen so far, in widths of the picture.
  struct Learning {
    Time since;
    std::vector<float> widths, heights, markers;
  };
  std::optional<Learning> learning_;
  float rest_height_ = 0.25F;  // In widths of the mouth at rest.
  // The tilt as followed so far, within 0.7 rad each way.
  float tilt_rad_ = 0;
  // How much of an opening mouth is the rise of its upper lip: a regression over the frames in which the head
  // is slow.
  struct UpperPart {
    // Those of the last frame.
    float marker = 0, height = 0;
    // A regression through the origin: products over squares. It begins with a fifth, and with so little
    // weight that the first frames outweigh it.
    float products = 0.2F * 1e-3F, squares = 1e-3F;
    float value() const { return products / squares; }
  };
  UpperPart upper_;
  // When the last mouth was measured.
  std::optional<Time> seen_;
  std::optional<Time> whole_;  // When the mouth was last seen whole.
};

}  // namespace kaori::lips
