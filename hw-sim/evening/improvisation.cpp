#include "hw-sim/evening/improvisation.h"

#include <algorithm>
#include <array>
#include <random>
#include <string_view>

#include "hw-sim/scenario/reader.h"
#include "hw-sim/scenario/speech.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

// Nobody speaks from so long before a fault until so long after it.
constexpr Duration kQuietBefore = 3s, kQuietAfter = 20s;
// What is said.
constexpr std::array<std::string_view, 8> kPhrases{
    "kon ni ti wa", "wa ta si wa ka o ri", "a ri ga to o",     "hi to ri de wa na i",
    "e e",          "so o de su ne",       "a na ta wa da re", "mi na sa ma yo u ko so"};
// Dials of face, expression, strength and life: they are turned, and turned back.
constexpr std::array kDials{0, 1, 2, 6};
// Buttons of the first sheet that call expressions.
constexpr int kFirstExpression = 10, kLastExpression = 31;

// Numbers are made of the generator's bits alone: the library's distributions differ from one library to
// another.
class Improvisation {
 public:
  explicit Improvisation(std::uint64_t seed) : bits_(seed) {}

  double Between(double low, double high) {
    // The upper 53 bits of the generator are used, since a double cannot hold all 64.
    constexpr double kSteps = 9007199254740992.0;  // 2^53: what a double holds exactly.
    return low + (high - low) * (static_cast<double>(bits_() >> 11U) / kSteps);
  }
  Duration Wait(double low_s, double high_s) { return FromSeconds(Between(low_s, high_s)); }
  template <class Items>
  auto OneOf(const Items& items) {
    return items[bits_() % items.size()];
  }
  // Both ends are included. The remainder favours small numbers by less than one in 10^17.
  int Number(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 bits_;  // Its numbers are laid down by the standard.
};

void AddAction(std::vector<TimedAction>& to, Duration at, Duration over, const OperatorAction& action) {
  to.push_back({at, over, action});
}

// A stick goes somewhere, stays, and now and then rests; twist goes along with some of it.
void PlayStick(std::vector<TimedAction>& to, DevicePort stick, Duration end, Improvisation& hand) {
  // Sticks stay within 0.7 of their way across and 0.5 of it up and down, of 1 at the stops.
  for (Duration at = hand.Wait(2, 8); at < end; at += hand.Wait(2, 9)) {
    const bool rests = hand.Between(0, 1) < 0.3;
    const double x = rests ? 0 : hand.Between(-0.7, 0.7), y = rests ? 0 : hand.Between(-0.5, 0.5);
    AddAction(to, at, hand.Wait(0.3, 1.4), {stick, Verb::kMove, 0, x, y});
    if (hand.Between(0, 1) < 0.3)
      AddAction(to, at, hand.Wait(0.4, 1), {stick, Verb::kTwist, 0, rests ? 0 : x / 2, 0});
  }
}

// A dial is turned down and up again by as much: what it moves begins at its upper end, or turns either way.
void PlayDialBox(std::vector<TimedAction>& to, Duration end, Improvisation& hand) {
  for (Duration at = hand.Wait(4, 10); at < end; at += hand.Wait(8, 25)) {
    if (hand.Between(0, 1) < 0.4) {
      const int button = hand.Number(kFirstExpression, kLastExpression);
      AddAction(to, at, {}, {DevicePort::kDialBox, Verb::kPush, button, 0, 0});
      AddAction(to, at + kTap, {}, {DevicePort::kDialBox, Verb::kRelease, button, 0, 0});
      continue;
    }
    const int dial = hand.OneOf(kDials);
    const double turns = hand.Between(0.1, 0.5);
    AddAction(to, at, 800ms, {DevicePort::kDialBox, Verb::kTurn, dial, -turns, 0});
    AddAction(to, at + 3s, 800ms, {DevicePort::kDialBox, Verb::kTurn, dial, turns, 0});
  }
}

void PlaySpeaker(std::vector<TimedAction>& to, const RunningOrder& order, Improvisation& mouth) {
  for (Duration at = mouth.Wait(3, 6); at < order.length; at += mouth.Wait(4, 14)) {
    const Duration over = mouth.Wait(0.8, 2.2);
    const std::string_view phrase = mouth.OneOf(kPhrases);
    // A phrase is dropped when any part of it would lie in that span; the next one is drawn all the same.
    const bool quiet = std::ranges::any_of(order.faults, [&](const Fault& fault) {
      return at + over > fault.at - kQuietBefore && at < fault.at + kQuietAfter;
    });
    if (quiet) continue;
    const auto spoken = Speak(phrase, at, over);
    to.insert(to.end(), spoken.begin(), spoken.end());
  }
}

}  // namespace

// Each operator has a generator of his own: what one does changes nothing of the others.
std::vector<TimedAction> ImprovisedActions(const RunningOrder& order, std::uint64_t seed) {
  std::vector<TimedAction> actions;
  // Each evening uses four neighbouring seeds, so that no two of them share a generator.
  Improvisation head(seed * 4), gaze(seed * 4 + 1), dials(seed * 4 + 2), mouth(seed * 4 + 3);
  PlayStick(actions, DevicePort::kStickLeft, order.length, head);
  PlayStick(actions, DevicePort::kStickRight, order.length, gaze);
  PlayDialBox(actions, order.length, dials);
  PlaySpeaker(actions, order, mouth);
  return actions;
}

}  // namespace kaori::sim
