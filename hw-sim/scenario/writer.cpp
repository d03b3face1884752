#include "hw-sim/scenario/writer.h"

#include <fmt/format.h>

#include "hw-sim/scenario/key_names.h"
#include "hw-sim/scenario/speech.h"

namespace kaori::sim {
namespace {

// Exact: nanoseconds are nine decimals.
std::string Span(Duration time) {
  const auto ns = time.count();
  std::string text = fmt::format("{}.{:09}", ns / 1'000'000'000, ns % 1'000'000'000);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text + "s";
}

// A stick's values are floats: the shortest decimals that read back as the same float.
float Short(double value) {
  return static_cast<float>(value);
}

std::string ButtonVerb(Verb verb) {
  return verb == Verb::kPush ? "hold" : "release";
}

std::string OnBox(const Hand& hand) {
  if (hand.verb == Verb::kTurn) return fmt::format("dial {} turn {}", hand.index + 1, hand.a);
  return fmt::format("{} {}", ButtonVerb(hand.verb), hand.index + 1);
}

std::string OnStick(const Hand& hand) {
  const char* side = hand.place == Place::kStickLeft ? "left" : "right";
  switch (hand.verb) {
    case Verb::kMove:
      return fmt::format("{} move {} {}", side, Short(hand.a), Short(hand.b));
    case Verb::kTwist:
      return fmt::format("{} twist {}", side, Short(hand.a));
    case Verb::kSlide:
      return fmt::format("{} slide {}", side, Short(hand.a));
    case Verb::kHat:
      return fmt::format("{} hat {}", side, HatName(hand.index));
    default:
      return fmt::format("{} {} {}", side, ButtonVerb(hand.verb), hand.index + 1);
  }
}

std::string OnKeyboard(const Hand& hand) {
  return fmt::format("key {} {}", KeyName(static_cast<std::uint8_t>(hand.index)),
                     hand.verb == Verb::kPush ? "press" : "release");
}

std::string OnCamera(const Hand& hand) {
  if (hand.verb == Verb::kCoverLens) return hand.index != 0 ? "lens cover" : "lens uncover";
  if (hand.verb == Verb::kStall) return hand.index != 0 ? "camera stall" : "camera run";
  return fmt::format("lips {} {}", hand.a, hand.b);
}

std::string OnSound(const Hand& hand) {
  if (hand.verb == Verb::kStall)
    return fmt::format("{} {}", PortName(hand.place), hand.index != 0 ? "stall" : "run");
  const auto vowel = static_cast<std::size_t>(hand.index) % kVowelLetters.size();
  return hand.a > 0 ? fmt::format("voice {} {}", kVowelLetters[vowel], hand.a) : "voice off";
}

std::string OnPointer(const Hand& hand) {
  if (hand.verb == Verb::kMove) return fmt::format("pointer {} {}", hand.a, hand.b);
  if (hand.verb == Verb::kRoll) return fmt::format("roll pointer {}", hand.a);
  return fmt::format("{} pointer {}", hand.verb == Verb::kPush ? "press" : "release", hand.index + 1);
}

std::string Words(const Hand& hand) {
  if (hand.verb == Verb::kPlug) return fmt::format("plug {}", PortName(hand.place));
  if (hand.verb == Verb::kUnplug) return fmt::format("unplug {}", PortName(hand.place));
  if (hand.place == Place::kDialBox) return OnBox(hand);
  if (hand.place == Place::kKeyboard) return OnKeyboard(hand);
  if (hand.place == Place::kPointer) return OnPointer(hand);
  if (hand.place == Place::kMicrophone || hand.place == Place::kLoudspeaker) return OnSound(hand);
  return hand.place == Place::kCamera ? OnCamera(hand) : OnStick(hand);
}

}  // namespace

std::string WriteAction(const Action& action) {
  if (action.over == Duration::zero()) return fmt::format("at {} {}", Span(action.at), Words(action.hand));
  return fmt::format("at {} over {} {}", Span(action.at), Span(action.over), Words(action.hand));
}

std::string WriteBeat(const Beat& beat) {
  return fmt::format("at {} scene \"{}\"", Span(beat.at), beat.name);
}

std::string WriteScenario(const Scenario& scenario) {
  std::string text;
  auto beat = scenario.beats.begin();
  const auto write_beats_until = [&](Duration at) {
    for (; beat != scenario.beats.end() && beat->at <= at; ++beat) text += WriteBeat(*beat) + "\n";
  };
  for (const Action& action : scenario.actions) {
    write_beats_until(action.at);
    text += WriteAction(action) + "\n";
  }
  write_beats_until(Duration::max());
  return text;
}

}  // namespace kaori::sim
