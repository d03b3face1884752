#include "appliance/authoring/inspect/poses.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace kaori::inspect {
namespace {

using face::ExpressionKind;

// What is played on top of an expression: a mouth shape, or a channel with its other side.
struct Extra {
  std::string name;
  ExpressionKind kind;
  std::vector<std::uint16_t> terms;
};

// "brow_up" of "brow_up_left"; artists write "browUpLeft".
std::string BothSides(std::string_view name) {
  constexpr std::array<std::string_view, 4> kSides{"_left", "_right", "Left", "Right"};
  for (const std::string_view side : kSides)
    if (name.ends_with(side)) return std::string(name.substr(0, name.size() - side.size()));
  return std::string(name);
}

// In the cast's order; left and right of one name are one.
std::vector<Extra> Extras(const std::vector<face::Expression>& expressions) {
  std::vector<Extra> extras;
  for (std::uint16_t i = 0; i < expressions.size(); ++i) {
    const face::Expression& e = expressions[i];
    if (e.kind == ExpressionKind::kExpression) continue;
    const std::string name = e.kind == ExpressionKind::kChannel ? BothSides(e.name) : e.name;
    const auto known = std::ranges::find(extras, name, &Extra::name);
    if (known == extras.end()) {
      extras.push_back({name, e.kind, {i}});
    } else {
      known->terms.push_back(i);
    }
  }
  return extras;
}

// Mouth shapes and channels are worn on the face at rest.
Pose Alone(const std::vector<face::Expression>& expressions, std::uint16_t i) {
  Pose pose{.name = expressions[i].name, .weights = {}, .alone = true};
  const bool called = expressions[i].kind == ExpressionKind::kExpression;
  pose.weights.expressions.Push(called ? i : 0, 1);
  if (!called) pose.weights.channels.Push(i, 1);
  return pose;
}

// The extra at its whole weight, both sides of it. A mouth shape has the mouth to itself, as the
// lips' operator has.
Pose With(Pose pose, const Extra& extra) {
  pose.name += " with " + extra.name;
  pose.alone = false;
  for (const std::uint16_t term : extra.terms) pose.weights.channels.Push(term, 1);
  if (extra.kind == ExpressionKind::kMouth) pose.weights.mouth_given_away = 1;
  return pose;
}

// Both lids; winks are looked at on contact sheets.
Pose Shut(Pose pose) {
  pose.name += ", lids shut";
  pose.weights.lids_shut = {1, 1};
  pose.shut = true;
  return pose;
}

}  // namespace

// Expression 0 is "neutral": with an extra it would be that extra alone.
std::vector<Pose> PosesToSee(const std::vector<face::Expression>& expressions) {
  std::vector<Pose> poses;
  const auto add = [&poses](const Pose& pose, bool also_shut) {
    poses.push_back(pose);
    if (also_shut) poses.push_back(Shut(pose));
  };
  const auto extras = Extras(expressions);
  for (std::uint16_t i = 0; i < expressions.size(); ++i) {
    const Pose alone = Alone(expressions, i);
    add(alone, true);
    // The face at rest with an extra is the extra alone.
    if (i == 0 || expressions[i].kind != ExpressionKind::kExpression) continue;
    for (const Extra& extra : extras) add(With(alone, extra), extra.kind == ExpressionKind::kChannel);
  }
  return poses;
}

}  // namespace kaori::inspect
