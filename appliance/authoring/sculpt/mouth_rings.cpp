#include "appliance/authoring/sculpt/mouth_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace kaori::sculpt {
namespace {

// How far the slit is held open to each side of the line, in the unrolled surface.
constexpr double kSlitHalf_cm = 0.28;
// Of each lip, where they meet. Subdivision draws lips apart by about 0.2 mm each; with less than this a
// light line shows.
constexpr double kOverlap_cm = 0.05;
constexpr double kTubercle_cm = 0.05;   // The upper lip's drop in the middle,
constexpr double kCupidsBow_cm = 0.13;  // and the dip in its border above it.

// Of the way from the rim to the lip's border: rings 0 .. 2.
constexpr std::array<double, 3> kTowardsBorder{0, 0.42, 0.78};
constexpr std::array<double, 4> kTowardsContact{0, 0.45, 0.82, 1.0};  // Rings 3 .. 6, and how far they bulge:
constexpr std::array<double, 4> kBulgeUpper_cm{0.02, 0.24, 0.26, -0.12};
constexpr std::array<double, 4> kBulgeLower_cm{0.0, 0.38, 0.36, -0.08};
// The bag, rings 7 .. 10: how far behind the contact line, how far above and below it, and how wide compared
// with it. It must hold teeth and tongue.
constexpr std::array<double, 4> kBagDepth_cm{0.35, 0.9, 2.2, 3.6};
constexpr std::array<double, 4> kBagHeight_cm{0.12, 0.75, 1.1, 0.8};
constexpr std::array<double, 4> kBagWidth{1.0, 1.0, 0.95, 0.8};

// A Gaussian without its factor: 1 at 0, 1/e at `width`.
double Bump(double x, double width) {
  return std::exp(-(x / width) * (x / width));
}

// What a rim position means: all that depends on j alone. Centimetres, seen from the front.
struct Station {
  bool upper;
  double side;       // +1 above, -1 below.
  double x;          // On the contact line,
  double border_x;   // and on the lip's border.
  double contact_y;  // Without and with the tubercle.
  double tubercle_y;
  double border_y;
  double taper;  // 1 in the middle, 0 at the corner.
};

// Rim positions 0 .. 8 run along the upper lip from the middle to the corner, 16 .. 8 along the lower one. x
// follows a sine, so that vertices gather at the corner; heights of lips fall as powers of 1 - (x /
// half_width)^2, which is an ellipse at the power 0.5 and fuller below it.
Station StationAt(const MouthRecipe& mouth, int j) {
  Station at{};
  at.upper = j <= kMouthCorner;
  at.side = at.upper ? 1 : -1;
  const double s = static_cast<double>(at.upper ? j : kMouthRim - 1 - j) / kMouthCorner;
  at.x = mouth.half_width * std::pow(std::sin(std::numbers::pi / 2 * s), 0.96);
  const double across = at.x / mouth.half_width;
  const double rest = std::clamp(1 - across * across, 0.0, 1.0);
  at.taper = std::sqrt(rest);
  at.contact_y = mouth.y + mouth.upturn * across * across;
  at.tubercle_y = at.contact_y - kTubercle_cm * Bump(at.x, 0.5);
  at.border_x = at.x * 1.02;
  at.border_y =
      at.upper ? at.tubercle_y + mouth.upper_height * std::pow(rest, 0.72) - kCupidsBow_cm * Bump(at.x, 0.30)
               : at.contact_y - mouth.lower_height * std::pow(rest, 0.55);
  return at;
}

// A vertex's position in space and its uv on the unrolled surface.
struct Point {
  glm::dvec3 position;
  glm::dvec2 uv_cm;
};

// Straight along z, from 12 cm before the origin: the front of the face.
glm::dvec3 OnSkin(const std::vector<Body>& bodies, glm::dvec2 p) {
  return Project(bodies, {p, 7}, {0, 0, 1});
}

// The rings as functions of station and ring. Borrows the solid and the recipe.
class Mouth {
 public:
  Mouth(const std::vector<Body>& bodies, const MouthRecipe& recipe) : bodies_(bodies), recipe_(recipe) {}

  // Rings 0 to 2: skin between the block's rim and the border of the lip.
  Point Skin(const Station& at, int k, const Point& rim) const {
    const double t = kTowardsBorder[static_cast<std::size_t>(k)];
    const glm::dvec2 border(at.border_x, at.border_y);
    Point point{OnSkin(bodies_, glm::mix(glm::dvec2(rim.position), border, t)),
                glm::mix(rim.uv_cm, border, t)};
    if (k == 2) point.position.z += 0.04 * at.taper;
    return point;
  }

  // Rings 3 to 6: from the lip's border over its bulge to where the lips meet. At the corners lips are tucked
  // in behind the skin, 1 mm and more with each ring.
  Point Lip(const Station& at, int k) const {
    const auto ring = static_cast<std::size_t>(k - kLipBorderRing);
    const double t = kTowardsContact[ring];
    const double bulge_cm = at.upper ? kBulgeUpper_cm[ring] : kBulgeLower_cm[ring];
    const double x = glm::mix(at.border_x, at.x, t);
    Point point{OnSkin(bodies_, {x, glm::mix(at.border_y, at.tubercle_y, t)}),
                {x, glm::mix(at.border_y, SlitEdge(at), t)}};
    const double tuck_cm = 0.10 + 0.06 * static_cast<double>(ring);
    point.position.z += bulge_cm * at.taper * recipe_.fullness - tuck_cm * (1 - at.taper);
    if (k == kLipContactRing) point.position.y -= at.side * kOverlap_cm * std::min(1.5 * at.taper, 1.0);
    return point;
  }

  // Rings 7 to 10: the bag behind the lips, up to 3.6 cm deep. It holds teeth and tongue, and opens with the
  // jaw.
  Point Bag(const Station& at, int k, glm::dvec3 contact) const {
    const auto ring = static_cast<std::size_t>(k - kLipContactRing - 1);
    const double open = ring == 0 ? at.taper : std::min(1.3 * at.taper, 1.0);
    const double sag_cm = ring == 0 ? 0 : 0.25;
    const double y =
        recipe_.y + 0.5 * (contact.y - recipe_.y) + at.side * kBagHeight_cm[ring] * open - sag_cm;
    const double shrink = static_cast<double>(ring + 1);
    return {
        {contact.x * kBagWidth[ring], y, contact.z - kBagDepth_cm[ring]},
        {at.x * (1 - 0.1 * shrink), at.contact_y + at.side * kSlitHalf_cm * at.taper * (1 - 0.2 * shrink)}};
  }

 private:
  // v of the lip's edge: the slit is a lens that closes at the corners.
  static double SlitEdge(const Station& at) { return at.contact_y + at.side * kSlitHalf_cm * at.taper; }

  const std::vector<Body>& bodies_;
  const MouthRecipe& recipe_;
};

}  // namespace

// Station by station, from ring 1 inwards: the bag hangs from the contact ring of its own station.
void PlaceMouthRings(const HalfTopology& half, const std::vector<Body>& bodies, const MouthRecipe& mouth,
                     HalfShape& shape) {
  const Mouth rings(bodies, mouth);
  for (int j = 0; j < kMouthRim; ++j) {
    const Station at = StationAt(mouth, j);
    // Both halves share these vertices.
    const bool middle = j == 0 || j == kMouthRim - 1;
    const Index rim = half.At(Region::kMouth, j, 0);
    // Ring 6 of this station, from which the bag hangs.
    glm::dvec3 contact{};
    for (int k = 1; k <= kMouthRings; ++k) {
      Point point = k < kLipBorderRing     ? rings.Skin(at, k, {shape.position[rim], shape.uv_cm[rim]})
                    : k <= kLipContactRing ? rings.Lip(at, k)
                                           : rings.Bag(at, k, contact);
      if (k == kLipContactRing) contact = point.position;
      if (middle) point.position.x = point.uv_cm.x = 0;
      const Index vertex = half.At(Region::kMouth, j, k);
      shape.position[vertex] = point.position;
      shape.uv_cm[vertex] = point.uv_cm;
    }
  }
}

}  // namespace kaori::sculpt
