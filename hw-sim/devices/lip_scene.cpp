#include "hw-sim/devices/lip_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace kaori::sim {
namespace {

constexpr Rgb kLipSceneSkin{0.80F, 0.59F, 0.47F};
constexpr Rgb kLipSceneThroat{0.24F, 0.08F, 0.10F};
constexpr Rgb kTeeth{0.86F, 0.84F, 0.78F};
constexpr Rgb kLipSceneRoom{0.12F, 0.125F, 0.14F};

// In widths of the mouth at rest. As lip_picture.cpp has them: a height above
// that of shut lips opens the mouth.
constexpr float kShutHeight = 0.24F;
constexpr float kUpperPart = 0.3F;  // Of an opening mouth: the upper lip hardly moves, the jaw does.
constexpr float kLipSceneOpeningOfWidth = 0.74F;
constexpr float kFaceHalf = 1.35F;
constexpr float kChin = 0.85F;
constexpr float kMarkerAbove = 1.0F;
constexpr float kMarkerHalf = 0.07F;
constexpr float kHandHalfWidth = 0.45F;
constexpr float kHandHalfHeight = 0.8F;
// Half of a shadow is soft over this width.
constexpr float kShadowEdge = 0.12F;

constexpr double kLipSceneMouthX = 0.5;  // In parts of the picture.
constexpr double kLipSceneMouthY = 0.52;
constexpr int kExposures = 5;  // That a smeared picture is put together from.

// Steps of the encoding curve: finer than a byte, and a table instead of a power for each pixel.
constexpr int kCurve = 2048;

// Bytes of sRGB to linear light by the power 2.2, which is near enough to sRGB's
// own curve for a simulated camera.
std::array<float, 256> MakeLinear() {
  std::array<float, 256> table{};
  for (std::size_t n = 0; n < table.size(); ++n) table[n] = std::pow(static_cast<float>(n) / 255.0F, 2.2F);
  return table;
}

std::array<float, kCurve + 1> MakeCurve() {
  std::array<float, kCurve + 1> table{};
  for (std::size_t n = 0; n < table.size(); ++n)
    table[n] = std::pow(static_cast<float>(n) / static_cast<float>(kCurve), 1 / 2.2F);
  return table;
}

// Linear light to sRGB, by a table of kCurve steps.
float Encode(float linear) {
  static const auto curve = MakeCurve();
  return curve[static_cast<std::size_t>(std::clamp(linear, 0.0F, 1.0F) * kCurve)];
}

// sRGB to linear light, by a table of its 256 values.
Rgb Linear(const Rgb& colour) {
  static const auto table = MakeLinear();
  const auto one = [](float value) {
    return table[static_cast<std::size_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255))];
  };
  return {one(colour.red), one(colour.green), one(colour.blue)};
}

Rgb Mix(const Rgb& a, const Rgb& b, float part) {
  return {a.red + (b.red - a.red) * part, a.green + (b.green - a.green) * part,
          a.blue + (b.blue - a.blue) * part};
}

// Light of one colour on a surface of another.
Rgb Times(const Rgb& a, const Rgb& b, float level) {
  return {a.red * b.red * level, a.green * b.green * level, a.blue * b.blue * level};
}

// Within 0 .. 1.
float Held(double value) {
  return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

// A lens with pointed corners: half its height so far from its middle; negative beyond them.
float LensHalfHeight(float half_height, float half_width, float from_middle) {
  const float part = from_middle / half_width;
  return std::abs(part) >= 1 ? -1 : half_height * std::pow(1 - part * part, 0.75F);
}

// Draws one moment. All lengths in widths of the mouth at rest, in the head's own axes.
class Moment {
 public:
  Moment(const LipScene& scene, const HeadPose& head, const YuyvPicture& into)
      : scene_(scene),
        paint_(Linear(scene.person.paint)),
        skin_(Linear(kLipSceneSkin)),
        throat_(Linear(kLipSceneThroat)),
        teeth_(Linear(kTeeth)),
        room_(Linear(kLipSceneRoom)),
        shirt_(Linear(scene.person.shirt.value_or(Rgb{}))) {
    const double width_px = kRestMouthOfPicture * into.width_px;
    middle_x_ = static_cast<float>(kLipSceneMouthX * into.width_px + head.x * width_px);
    middle_y_ = static_cast<float>(kLipSceneMouthY * into.height_px + head.y * width_px);
    per_px_ = static_cast<float>(1 / (width_px * head.scale));
    cos_ = static_cast<float>(std::cos(head.tilt_rad));
    sin_ = static_cast<float>(std::sin(head.tilt_rad));
    const Mouth& mouth = scene.person.mouth;
    half_width_ = static_cast<float>(mouth.width / 2);
    half_height_ = static_cast<float>(mouth.height / 2);
    half_opening_ = std::max(0.0F, half_height_ - kShutHeight / 2);
    // The middle of the mouth moves down as it opens: of an opening the upper lip makes
    // kUpperPart, and the jaw the rest.
    drop_ = (0.5F - kUpperPart) * 2 * half_opening_;
  }

  // The colour that the camera's chip gets at a pixel, with its gain and balance.
  Rgb At(float x_px, float y_px) const {
    const float x = (x_px - middle_x_) * per_px_;
    const float y = (y_px - middle_y_) * per_px_;
    // Turned back by the head's tilt: u runs along the mouth, v down the face.
    const float u = x * cos_ + y * sin_;
    const float v = y * cos_ - x * sin_;
    Rgb colour = Face(u, v);
    if (scene_.person.hand) colour = Hand(colour, u, v);
    return Times(Lit(colour, u), scene_.camera.balance, static_cast<float>(scene_.camera.gain));
  }

 private:
  // How much of a pixel lies within an edge, from its signed distance in
  // widths: one pixel wide, hence smooth.
  float Inside(float distance) const { return std::clamp(distance / per_px_ + 0.5F, 0.0F, 1.0F); }

  Rgb Face(float u, float v) const {
    // The cheeks narrow towards the chin.
    const float side = u / (kFaceHalf - 0.12F * v * v);
    // Skin that turns away from the camera is darker.
    const float roundness = 1.06F - 0.3F * side * side;
    Rgb colour = Mix(room_, Times(skin_, {1, 1, 1}, roundness), Inside((1 - std::abs(side)) * kFaceHalf));
    if (scene_.person.shirt) colour = Mix(colour, shirt_, Inside(v - kChin - 0.1F * std::abs(u)));
    if (scene_.person.marker)
      colour = Mix(colour, paint_, Inside(kMarkerHalf - std::hypot(u, v + kMarkerAbove)));
    return std::abs(u) < half_width_ + 0.02F ? WithMouth(colour, u, v) : colour;
  }

  Rgb WithMouth(const Rgb& face, float u, float v) const {
    const double smile = u < 0 ? scene_.person.smile_left : scene_.person.smile_right;
    const float part = u / half_width_;
    // Corners are raised with the square of their distance from the middle.
    const float down = v - drop_ + static_cast<float>(smile) * part * part;
    const float lips = Inside(LensHalfHeight(half_height_, half_width_, u) - std::abs(down));
    if (lips <= 0) return face;
    const float hole =
        half_opening_ > 0
            ? Inside(LensHalfHeight(half_opening_, kLipSceneOpeningOfWidth * half_width_, u) - std::abs(down))
            : 0;
    // The upper part of the opening shows teeth, the rest is dark.
    const Rgb within = down < -0.45F * half_opening_ ? teeth_ : throat_;
    const float relief = 1.05F - 0.35F * down * down / (half_height_ * half_height_);
    return Mix(Mix(face, Times(paint_, {1, 1, 1}, relief), lips), within, std::min(hole, lips));
  }

  Rgb Hand(const Rgb& behind, float u, float v) const {
    const auto x = u - static_cast<float>(*scene_.person.hand);
    const float away = std::hypot(x / kHandHalfWidth, v / kHandHalfHeight);
    return Mix(behind, Times(skin_, {1, 1, 1}, 0.9F), Inside((1 - away) * kHandHalfWidth));
  }

  Rgb Lit(const Rgb& colour, float u) const {
    const StageLight& light = scene_.light;
    double level = light.level;
    if (light.shadow_from) {
      // A soft edge: the light falls off over kShadowEdge.
      const float in_shadow = Held((u - *light.shadow_from) / kShadowEdge + 0.5);
      level *= 1 + in_shadow * (light.shadow_level - 1);
    }
    return Times(colour, light.colour, static_cast<float>(level));
  }

  const LipScene& scene_;
  Rgb paint_, skin_, throat_, teeth_, room_, shirt_;
  float middle_x_, middle_y_, per_px_, cos_, sin_;
  float half_width_, half_height_, half_opening_, drop_;
};

// Y, Cb and Cr in steps of a byte, not yet rounded.
struct Ycc {
  float y = 0, cb = 0, cr = 0;
};

// ITU-R BT.601, limited range: Y 16 .. 235, Cb and Cr 16 .. 240 about 128. The matrix is
// the standard's, for values of 0 .. 1.
Ycc ToYcc(const Rgb& linear) {
  const float r = Encode(linear.red);
  const float g = Encode(linear.green);
  const float b = Encode(linear.blue);
  return {16 + 65.481F * r + 128.553F * g + 24.966F * b, 128 - 37.797F * r - 74.203F * g + 112 * b,
          128 + 112 * r - 93.786F * g - 18.214F * b};
}

// As Scatter in lip_picture.cpp: folders are compiled together, and their private names differ.
std::uint32_t ScatterPoint(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x85EBCA6Bu;
  x = (x ^ (x >> 13)) * 0xC2B2AE35u;
  return x ^ (x >> 16);
}

// Of mean 0 and deviation 1, near enough normal: four bytes added.
float Grain(std::uint32_t seed) {
  const std::uint32_t random = ScatterPoint(seed);
  const auto sum =
      static_cast<float>((random & 255) + (random >> 8 & 255) + (random >> 16 & 255) + (random >> 24));
  // A sum of four bytes has the mean 4 * 127.5 = 510 and the deviation sqrt(4 * (256^2 - 1) / 12) = 148.
  return (sum - 510) / 148;
}

// Adds the share of one moment to a sum of pictures, in YUYV's order.
void AddMoment(const Moment& moment, const YuyvPicture& size, float share, std::vector<float>& into) {
  std::size_t at = 0;
  for (int y = 0; y < size.height_px; ++y) {
    for (int x = 0; x < size.width_px; x += 2) {
      const float row = static_cast<float>(y) + 0.5F;
      const Ycc left = ToYcc(moment.At(static_cast<float>(x) + 0.5F, row));
      const Ycc right = ToYcc(moment.At(static_cast<float>(x) + 1.5F, row));
      into[at++] += share * left.y;
      into[at++] += share * (left.cb + right.cb) / 2;
      into[at++] += share * right.y;
      into[at++] += share * (left.cr + right.cr) / 2;
    }
  }
}

// The way between two poses, each number by itself.
HeadPose Between(const HeadPose& a, const HeadPose& b, double part) {
  const auto mix = [part](double from, double to) { return from + (to - from) * part; };
  return {mix(a.x, b.x), mix(a.y, b.y), mix(a.scale, b.scale), mix(a.tilt_rad, b.tilt_rad)};
}

}  // namespace

void PaintScene(const LipScene& scene, const YuyvPicture& into) {
  std::vector<float> sum(into.bytes.size());
  const HeadPose& now = scene.person.head;
  const int exposures = scene.head_before ? kExposures : 1;
  for (int n = 0; n < exposures; ++n) {
    const double part = (n + 0.5) / exposures;
    // Moments lie in the middles of equal parts of the exposure.
    const HeadPose head = scene.head_before ? Between(*scene.head_before, now, part) : now;
    AddMoment(Moment(scene, head, into), into, 1 / static_cast<float>(exposures), sum);
  }
  const auto noise = static_cast<float>(scene.camera.noise_steps);
  // One more than the number: Scatter keeps 0 as 0.
  const std::uint32_t seed = ScatterPoint(scene.camera.sequence + 1);
  for (std::size_t n = 0; n < sum.size(); ++n) {
    const float value = sum[n] + noise * Grain(seed ^ static_cast<std::uint32_t>(n) * 0x9E3779B9u);
    // 0 and 255 are reserved in BT.601's digital form.
    into.bytes[n] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 1.0F, 254.0F)));
  }
}

}  // namespace kaori::sim
