#include "hw-sim/scenario/player.h"

#include <algorithm>
#include <cmath>

namespace kaori::sim {
namespace {

// Less of a turn waits until there is more: a quarter of the count that a dial can tell.
constexpr double kLeastTurn = 1.0 / 1024;

double Eased(double part) {
  return part * part * (3 - 2 * part);
}

bool SameLimb(const Hand& a, const Hand& b) {
  return a.place == b.place && a.verb == b.verb && a.index == b.index;
}

struct Values {
  double a = 0;
  double b = 0;
};

// Where the hand's control stands now; a dial has no place, only a way that it goes.
Values Standing(Instruments& on, const Hand& hand) {
  if (hand.place == Place::kCamera) return {on.camera.mouth().height, on.camera.mouth().width};
  if (hand.place == Place::kPointer) return {on.pointer.x(), on.pointer.y()};
  if (hand.place != Place::kStickLeft && hand.place != Place::kStickRight) return {};
  const StickPod& stick = on.stick(hand.place);
  if (hand.verb == Verb::kMove) return {stick.x(), stick.y()};
  return {hand.verb == Verb::kTwist ? stick.twist() : stick.slider(), 0};
}

}  // namespace

Player::Player(Scenario scenario, Playground& playground, Time start)
    : scenario_(std::move(scenario)), playground_(playground), start_(start) {}

void Player::Restart(Time start) {
  start_ = start;
  position_ = {};
  began_ = false;
  next_ = 0;
  motions_.clear();
}

void Player::Perform(Time now) {
  const Duration to = now - start_;
  if (to < Duration::zero()) return;
  began_ = true;
  while (next_ < scenario_.actions.size() && scenario_.actions[next_].at <= to) {
    const Action& action = scenario_.actions[next_++];
    MoveAll(action.at);
    Begin(action);
  }
  MoveAll(to);
  position_ = to;
}

void Player::Begin(const Action& action) {
  // Who grips a control takes it over from a hand that is still on its way; turns of a dial add up.
  if (action.hand.verb != Verb::kTurn)
    std::erase_if(motions_, [&](const Motion& motion) { return SameLimb(motion.action->hand, action.hand); });
  if (action.over == Duration::zero()) {
    static_cast<void>(
        playground_.Do(action.hand));  // A socket that cannot be made is seen as a device that is not there.
    return;
  }
  const Values from = Standing(playground_.instruments(), action.hand);
  motions_.push_back({&action, from.a, from.b});
}

void Player::MoveAll(Duration to) {
  for (Motion& motion : motions_) Move(motion, to);
  std::erase_if(motions_, [to](const Motion& m) { return to >= m.action->at + m.action->over; });
}

void Player::Move(Motion& motion, Duration to) {
  const Action& action = *motion.action;
  const bool arrived = to >= action.at + action.over;
  const double way = arrived ? 1 : Eased(Seconds(to - action.at) / Seconds(action.over));
  Hand hand = action.hand;
  if (hand.verb == Verb::kTurn) {
    hand.a = action.hand.a * way - motion.from_a;
    if (!arrived && std::abs(hand.a) < kLeastTurn) return;
    motion.from_a += hand.a;
  } else if (!arrived) {
    hand.a = motion.from_a + (hand.a - motion.from_a) * way;
    hand.b = motion.from_b + (hand.b - motion.from_b) * way;
  }
  static_cast<void>(playground_.Do(hand));
}

std::string_view Player::beat() const {
  std::string_view name;
  for (const Beat& beat : scenario_.beats) {
    if (began_ && beat.at <= position_) name = beat.name;
  }
  return name;
}

}  // namespace kaori::sim
