#include "hw-sim/console/held.h"

#include <optional>
#include <utility>

namespace kaori::console {
namespace {

using sim::OperatorAction;
using sim::Verb;

// Lips as the camera sees them when nobody speaks: sizes in widths of the mouth at rest.
constexpr double kShutHeight = 0.25;
constexpr double kRestWidth = 1;

// The action that undoes `action`; nothing for what stays as it is put: dials, sliders, the pointer, lens,
// cables.
std::optional<OperatorAction> Undoing(const OperatorAction& action) {
  switch (action.verb) {
    case Verb::kPush:
    case Verb::kRelease:
      if (action.port == sim::DevicePort::kLines && action.index != 0) return std::nullopt;  // It latches.
      return OperatorAction{action.port, Verb::kRelease, action.index};
    case Verb::kMove:
      if (action.port == sim::DevicePort::kPointer) return std::nullopt;
      [[fallthrough]];
    case Verb::kTwist:
      return OperatorAction{action.port, action.verb};
    case Verb::kHat:
      return OperatorAction{action.port, Verb::kHat, -1};
    case Verb::kLips:
      // Releasing what is not held does nothing, so that a release undoes a push as well as itself.
      return OperatorAction{action.port, Verb::kLips, 0, kShutHeight, kRestWidth};
    case Verb::kVoice:
      return OperatorAction{action.port, Verb::kVoice};
    default:
      return std::nullopt;
  }
}

}  // namespace

void Held::Note(const OperatorAction& action) {
  const auto undoing = Undoing(action);
  if (!undoing) return;
  // The newest action on a control counts alone; moving it to its rest takes it off the list.
  std::erase(releases_, *undoing);
  if (action != *undoing) releases_.push_back(*undoing);
}

std::vector<OperatorAction> Held::LetGo() {
  return std::exchange(releases_, {});
}

}  // namespace kaori::console
