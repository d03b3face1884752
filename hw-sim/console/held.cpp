#include "hw-sim/console/held.h"

#include <optional>
#include <utility>

namespace kaori::console {
namespace {

using sim::Hand;
using sim::Verb;

// Lips as the camera sees them when nobody speaks.
constexpr double kShutHeight = 0.25;
constexpr double kRestWidth = 1;

// The hand that undoes `hand`; nothing for what stays as it is put: dials, sliders, the pointer, lens,
// cables.
std::optional<Hand> Undoing(const Hand& hand) {
  switch (hand.verb) {
    case Verb::kPush:
    case Verb::kRelease:
      return Hand{hand.place, Verb::kRelease, hand.index};
    case Verb::kMove:
      if (hand.place == sim::Place::kPointer) return std::nullopt;
      [[fallthrough]];
    case Verb::kTwist:
      return Hand{hand.place, hand.verb};
    case Verb::kHat:
      return Hand{hand.place, Verb::kHat, -1};
    case Verb::kLips:
      return Hand{hand.place, Verb::kLips, 0, kShutHeight, kRestWidth};
    case Verb::kVoice:
      return Hand{hand.place, Verb::kVoice};
    default:
      return std::nullopt;
  }
}

}  // namespace

void Held::Note(const Hand& hand) {
  const auto undoing = Undoing(hand);
  if (!undoing) return;
  std::erase(releases_, *undoing);
  if (hand != *undoing) releases_.push_back(*undoing);
}

std::vector<Hand> Held::LetGo() {
  return std::exchange(releases_, {});
}

}  // namespace kaori::console
