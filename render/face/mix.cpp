#include "render/face/mix.h"

#include <algorithm>

#include "render/face/eyelids.h"

namespace kaori::face {
namespace {

// As the blend moves the lip: the expression's part yields, the channels' part does not.
float JawDropOfFace_m(const Composites& composites, std::size_t face, const Weights& weights) {
  float own_m = 0;
  float channels_m = 0;
  for (const Term& t : weights.expressions) own_m += t.weight * composites.jaw_drop_m(face, t.index);
  for (const Term& t : weights.channels) channels_m += t.weight * composites.jaw_drop_m(face, t.index);
  return own_m * (1 - weights.mouth_given_away * composites.jaw_mouth_share()) + channels_m;
}

}  // namespace

// A ball that only one face has grows with that face's weight.
std::array<EyeBall, 2> MixEyes(std::span<const Face> faces, const Weights& weights) {
  std::array<EyeBall, 2> mixed{};
  for (const Term& t : weights.faces) {
    for (std::size_t side = 0; side < 2; ++side) {
      const EyeBall& eye = faces[t.index].eyes[side];
      mixed[side].centre += t.weight * eye.centre;
      mixed[side].radius_m += t.weight * eye.radius_m;
      mixed[side].lid_thickness_m += t.weight * eye.lid_thickness_m;
    }
  }
  return mixed;
}

// Faces sum to 1, so that the sum is a mean; the iris's colour is mixed in linear light, as all paint here.
EyeLook MixEyeLook(std::span<const Face> faces, const Weights& weights) {
  EyeLook mixed;
  for (const Term& t : weights.faces) {
    const EyeLook& look = faces[t.index].eye_look;
    mixed.iris += t.weight * look.iris;
    mixed.iris_radius_m += t.weight * look.iris_radius_m;
    mixed.lash_length_m += t.weight * look.lash_length_m;
    mixed.lash_wing_m += t.weight * look.lash_wing_m;
  }
  return mixed;
}

// An EyeSurface of its own begins as an eye that is seen, and so each value is set to 0 before the sum.
EyeSurface MixEyeSurface(std::span<const Face> faces, std::span<const Expression> expressions,
                         const Weights& weights) {
  EyeSurface mixed{{}, 0, 0, 0, 0, 0, 0, 0};
  float of_expressions = 1;
  for (const Terms* terms : {&weights.expressions, &weights.channels})
    for (const Term& t : *terms) of_expressions += t.weight * (expressions[t.index].pupil - 1);
  for (const Term& t : weights.faces) {
    const EyeSurface& eye = faces[t.index].eye_surface;
    mixed.white += t.weight * eye.white;
    mixed.veins += t.weight * eye.veins;
    mixed.pupil += t.weight * eye.pupil;
    mixed.limbus += t.weight * eye.limbus;
    mixed.spokes += t.weight * eye.spokes;
    mixed.rings += t.weight * eye.rings;
    mixed.wet += t.weight * eye.wet;
    mixed.glow += t.weight * eye.glow;
  }
  mixed.pupil *= of_expressions;
  return mixed;
}

// Strengthened expressions are no redder than red.
float MixFlush(std::span<const Face> faces, std::span<const Expression> expressions, const Weights& weights) {
  float shown = 0;
  float red = 0;
  for (const Term& t : weights.faces) shown += t.weight * faces[t.index].surface.flush;
  for (const Term& t : weights.expressions) red += t.weight * expressions[t.index].flush;
  return std::clamp(shown, 0.0F, 1.0F) * std::clamp(red, 0.0F, 1.0F);
}

// Begins at zero everywhere: a MouthFit of its own begins as a mouth that is shown.
MouthFit MixMouth(std::span<const Face> faces, const Weights& weights) {
  MouthFit mixed{.scale = 0, .offset = {}, .upper_teeth = 0, .lower_teeth = 0, .tongue = 0};
  for (const Term& t : weights.faces) {
    const MouthFit& mouth = faces[t.index].mouth;
    mixed.scale += t.weight * mouth.scale;
    mixed.offset += t.weight * mouth.offset;
    mixed.upper_teeth += t.weight * mouth.upper_teeth;
    mixed.lower_teeth += t.weight * mouth.lower_teeth;
    mixed.tongue += t.weight * mouth.tongue;
  }
  return mixed;
}

// Expressions and channels add up to one way of shutting, the operator's lids are the other.
std::array<float, 2> MixLids(std::span<const Expression> expressions, const Weights& weights) {
  std::array<float, 2> mixed{};
  for (std::size_t side = 0; side < 2; ++side) {
    float own = 0;
    for (const Term& t : weights.expressions) own += t.weight * expressions[t.index].lids[side];
    for (const Term& t : weights.channels) own += t.weight * expressions[t.index].lids[side];
    mixed[side] = EitherShut(weights.lids_shut[side], std::clamp(own, 0.0F, 1.0F));
  }
  return mixed;
}

float MixJawDrop(const Composites& composites, const Weights& weights) {
  float drop_m = 0;
  for (const Term& t : weights.faces) drop_m += t.weight * JawDropOfFace_m(composites, t.index, weights);
  return std::max(drop_m, 0.0F);
}

}  // namespace kaori::face
