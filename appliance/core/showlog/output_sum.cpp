#include "appliance/core/showlog/output_sum.h"

#include <bit>

#include "drivers/base/checksum.h"

namespace kaori::showlog {
namespace {

// FNV-1a over words instead of bytes: a quarter of the products, and no defence is needed.
class Sum {
 public:
  void Add(std::uint32_t word) { sum_ = (sum_ ^ word) * kFnvPrime; }
  void Add(float number) { Add(std::bit_cast<std::uint32_t>(number)); }
  void Add(const glm::vec2& v) { Add(v.x), Add(v.y); }
  void Add(const glm::vec3& v) { Add(v.x), Add(v.y), Add(v.z); }
  void Add(const face::Terms& terms) {
    Add(static_cast<std::uint32_t>(terms.size()));
    for (const face::Term& term : terms) Add(std::uint32_t{term.index}), Add(term.weight);
  }
  void Add(const scene::Backdrop& b) {
    Add(b.top), Add(b.bottom), Add(b.glow);
    Add(static_cast<std::uint32_t>(b.kind)), Add(static_cast<std::uint32_t>(b.picture));
  }
  // The highest bits have seen every bit of all words, the low ones of a product only those below them.
  std::uint16_t value() const { return static_cast<std::uint16_t>(sum_ >> 48U); }

 private:
  std::uint64_t sum_ = kFnvBasis;
};

}  // namespace

// The order of the fields is part of the log's format: another order, or one field more, makes every
// frame of older logs differ.
std::uint16_t OutputSum(const performance::Performed& made) {
  const scene::Scene& scene = made.scene;
  Sum sum;
  sum.Add(scene.weights.faces), sum.Add(scene.weights.expressions), sum.Add(scene.weights.channels);
  sum.Add(scene.weights.mouth_given_away);
  for (const float shut : scene.weights.lids_shut) sum.Add(shut);
  for (const scene::Gaze& gaze : scene.gaze) sum.Add(gaze.yaw_rad), sum.Add(gaze.pitch_rad);
  sum.Add(scene.head.yaw_rad), sum.Add(scene.head.pitch_rad), sum.Add(scene.head.roll_rad);
  sum.Add(scene.head.shift_m);
  for (const float style : scene.styles) sum.Add(style);
  sum.Add(scene.light.key), sum.Add(scene.light.exposure);
  sum.Add(scene.camera.target_m), sum.Add(scene.camera.distance_m), sum.Add(scene.camera.yaw_rad);
  sum.Add(scene.camera.height_rad), sum.Add(scene.camera.field_of_view_rad);
  sum.Add(scene.backdrop);
  for (const scene::FadingBackdrop& fading : scene.fading) sum.Add(fading.backdrop), sum.Add(fading.weight);
  sum.Add(scene.present);
  for (const glm::vec2& sway : scene.hair_sway_rad) sum.Add(sway);
  sum.Add(scene.breath), sum.Add(scene.pupil);
  sum.Add(made.lamps);
  return sum.value();
}

}  // namespace kaori::showlog
