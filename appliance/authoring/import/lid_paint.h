// Paint about the eyes of an imported head, by its own lids: the show's paint, made for other lids, would lie
// in blotches where the two do not agree.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "appliance/authoring/import/eye_opening.h"

namespace kaori::import {

// Red, green, blue as sRGB, and gloss.
using PaintColour = std::array<std::uint8_t, 4>;

// The mean of both, as they are stored; `share` 0..1 is that of `to`.
PaintColour MixPaint(const PaintColour& from, const PaintColour& to, float share);

// What is painted: bare skin where the show's lids would be, and the margins of the own ones.
struct LidColours {
  PaintColour skin{};
  PaintColour liner{};  // Of the upper margin.
  PaintColour rim{};    // Of the lower one.
};

// Knows where the lids of a head are open, as seen from the front. Immutable.
class LidPaint {
 public:
  // An eye that is shut, hidden or without a ball has no opening, and nothing is painted about it.
  explicit LidPaint(const HeadShape& head);

  // The colour at a point of the head's surface (metres, the head's axes), over `under`: that of the margins
  // beside the opening, bare skin to 5 mm from it, and `under` itself from 9 mm on, at the back of the head,
  // and where there is no opening.
  PaintColour Over(const PaintColour& under, const glm::vec3& at, const LidColours& colours) const;

  // The distance to the nearer opening in the picture plane, 0 within it; nothing where there is none.
  std::optional<float> DistanceOf(const glm::vec3& at) const;

 private:
  struct Place {
    float off_m = 0;        // From the opening.
    bool is_upper = false;  // Above its middle.
    float outwards = 0;     // 0 at the corner near the nose, 1 at the other one.
  };
  std::optional<Place> PlaceOf(const glm::vec3& at) const;

  std::array<std::optional<EyeOpening>, 2> openings_{};
  std::array<face::EyeBall, 2> balls_{};
};

}  // namespace kaori::import
