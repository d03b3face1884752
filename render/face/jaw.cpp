#include "render/face/jaw.h"

#include <algorithm>

namespace kaori::face {
namespace {

// Of the expression's mouth, when a channel opens the jaw all the way.
constexpr float kYields = 0.5F;

}  // namespace

// Drops are compared as they are written, on the reference face.
void LimitJaw(const Cast& cast, Weights& weights) {
  if (weights.channels.empty()) return;
  const auto point = std::ranges::find(cast.net.points, "LC", &ControlPoint::name);
  if (point == cast.net.points.end()) return;
  const auto lip = static_cast<std::size_t>(point - cast.net.points.begin());
  const auto drop_m = [&](std::size_t j) { return -cast.expressions[j].displacement[lip].y; };
  // How far each part opens the jaw on the reference face; channels that lift it do not count.
  float own_m = 0;
  float played_m = 0;
  float widest_m = 0;
  for (const Term& t : weights.expressions) own_m += t.weight * drop_m(t.index);
  for (const Term& t : weights.channels) played_m += t.weight * std::max(drop_m(t.index), 0.0F);
  for (std::size_t j = 0; j < cast.expressions.size(); ++j) widest_m = std::max(widest_m, drop_m(j));
  if (!(widest_m > 0 && played_m > 0)) return;

  const float yields = kYields * std::min(played_m / widest_m, 1.0F);
  weights.mouth_given_away = std::max(weights.mouth_given_away, yields);
  const float own = std::clamp(own_m * (1 - weights.mouth_given_away) / widest_m, 0.0F, 1.0F);
  const Terms all = weights.channels;
  weights.channels.clear();
  for (const Term& t : all) {
    weights.channels.Push(t.index, drop_m(t.index) > 0 ? t.weight * (1 - own) : t.weight);
  }
}

}  // namespace kaori::face
