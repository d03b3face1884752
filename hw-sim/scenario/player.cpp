#include "hw-sim/scenario/player.h"

#include <algorithm>
#include <cmath>

namespace kaori::sim {
namespace {

// Less of a turn waits until there is more: a quarter of the count that a dial can tell.
constexpr double kLeastTurn = 1.0 / 1024;

// Smoothstep: 0 to 1, at rest at both ends.
double Eased(double part) {
  return part * part * (3 - 2 * part);
}

// Only actions on one control end each other: a stick may be moved while it is twisted.
bool OnSameControl(const OperatorAction& a, const OperatorAction& b) {
  return a.port == b.port && a.verb == b.verb && a.index == b.index;
}

// The numbers of an action that move.
struct Values {
  double a = 0;
  double b = 0;
};

// Where the control stands now; a dial has no position, only the turns that it makes.
Values Standing(InputDevices& on, const OperatorAction& action) {
  if (action.port == DevicePort::kCamera) return {on.camera.mouth().height, on.camera.mouth().width};
  if (action.port == DevicePort::kPointer) return {on.pointer.x(), on.pointer.y()};
  if (action.port != DevicePort::kStickLeft && action.port != DevicePort::kStickRight) return {};
  const StickPod& stick = on.stick(action.port);
  if (action.verb == Verb::kMove) return {stick.x(), stick.y()};
  return {action.verb == Verb::kTwist ? stick.twist() : stick.slider(), 0};
}

}  // namespace

Player::Player(Scenario scenario, DeviceRig& rig, Time start)
    : scenario_(std::move(scenario)), rig_(rig), start_(start) {}

void Player::Restart(Time start) {
  start_ = start;
  position_ = {};
  began_ = false;
  next_ = 0;
  motions_.clear();
}

// Whatever the steps of `now`, the same actions are done in the same order; only the points between which
// slow ones move differ.
void Player::Perform(Time now) {
  const Duration to = now - start_;
  if (to < Duration::zero()) return;
  began_ = true;
  while (next_ < scenario_.actions.size() && scenario_.actions[next_].at <= to) {
    const TimedAction& timed = scenario_.actions[next_++];
    // What is under way comes first, up to the moment at which the next action begins.
    MoveAll(timed.at);
    Begin(timed);
  }
  MoveAll(to);
  position_ = to;
}

void Player::Begin(const TimedAction& timed) {
  // A newer action ends one on the same control that is still under way; turns of a dial add up.
  if (timed.action.verb != Verb::kTurn)
    std::erase_if(motions_,
                  [&](const Motion& motion) { return OnSameControl(motion.timed->action, timed.action); });
  if (timed.over == Duration::zero()) {
    static_cast<void>(
        rig_.Do(timed.action));  // A socket that cannot be made is seen as a device that is not there.
    return;
  }
  const Values from = Standing(rig_.devices(), timed.action);
  motions_.push_back({&timed, from.a, from.b});
}

// Those that have arrived took their last step just now, which went exactly to the end.
void Player::MoveAll(Duration to) {
  for (Motion& motion : motions_) Move(motion, to);
  std::erase_if(motions_, [to](const Motion& m) { return to >= m.timed->at + m.timed->over; });
}

// From where the control stood when the action began, eased at both ends. The last step lands on the target
// itself.
void Player::Move(Motion& motion, Duration to) {
  const TimedAction& timed = *motion.timed;
  const bool arrived = to >= timed.at + timed.over;
  const double way = arrived ? 1 : Eased(Seconds(to - timed.at) / Seconds(timed.over));
  OperatorAction action = timed.action;
  if (action.verb == Verb::kTurn) {
    // A dial is told differences: what it turned so far is kept, so that nothing is lost by rounding.
    action.a = timed.action.a * way - motion.from_a;
    if (!arrived && std::abs(action.a) < kLeastTurn) return;
    motion.from_a += action.a;
  } else if (!arrived) {
    action.a = motion.from_a + (action.a - motion.from_a) * way;
    action.b = motion.from_b + (action.b - motion.from_b) * way;
  }
  static_cast<void>(rig_.Do(action));
}

// By the position, so that a beat whose time is passed in one step is named all the same.
std::string_view Player::beat() const {
  std::string_view name;
  for (const Beat& beat : scenario_.beats) {
    if (began_ && beat.at <= position_) name = beat.name;
  }
  return name;
}

}  // namespace kaori::sim
