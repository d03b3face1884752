#include "hw-sim/scenario/writer.h"

#include <fmt/format.h>

#include "hw-sim/devices/line_panel.h"
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

// A recording has both halves of a push, never a push.
std::string ButtonVerb(Verb verb) {
  return verb == Verb::kPush ? "hold" : "release";
}

std::string OnBox(const OperatorAction& action) {
  // fmt gives the shortest decimals that read back as the same double.
  if (action.verb == Verb::kTurn) return fmt::format("dial {} turn {}", action.index + 1, action.a);
  return fmt::format("{} {}", ButtonVerb(action.verb), action.index + 1);
}

std::string OnStick(const OperatorAction& action) {
  const char* side = action.port == DevicePort::kStickLeft ? "left" : "right";
  switch (action.verb) {
    case Verb::kMove:
      return fmt::format("{} move {} {}", side, Short(action.a), Short(action.b));
    case Verb::kTwist:
      return fmt::format("{} twist {}", side, Short(action.a));
    case Verb::kSlide:
      return fmt::format("{} slide {}", side, Short(action.a));
    case Verb::kHat:
      return fmt::format("{} hat {}", side, HatName(action.index));
    default:
      return fmt::format("{} {} {}", side, ButtonVerb(action.verb), action.index + 1);
  }
}

std::string OnKeyboard(const OperatorAction& action) {
  return fmt::format("key {} {}", KeyName(static_cast<std::uint8_t>(action.index)),
                     action.verb == Verb::kPush ? "press" : "release");
}

std::string OnCamera(const OperatorAction& action) {
  if (action.verb == Verb::kCoverLens) return action.index != 0 ? "lens cover" : "lens uncover";
  if (action.verb == Verb::kStall) return action.index != 0 ? "camera stall" : "camera run";
  return fmt::format("lips {} {}", action.a, action.b);
}

// A silent voice is "off", whatever vowel it had.
std::string OnSound(const OperatorAction& action) {
  if (action.verb == Verb::kStall)
    return fmt::format("{} {}", PortName(action.port), action.index != 0 ? "stall" : "run");
  const auto vowel = static_cast<std::size_t>(action.index) % kVowelLetters.size();
  return action.a > 0 ? fmt::format("voice {} {}", kVowelLetters[vowel], action.a) : "voice off";
}

// Doubles, in the shortest decimals that read back as the same.
std::string OnPointer(const OperatorAction& action) {
  if (action.verb == Verb::kMove) return fmt::format("pointer {} {}", action.a, action.b);
  if (action.verb == Verb::kRoll) return fmt::format("roll pointer {}", action.a);
  return fmt::format("{} pointer {}", action.verb == Verb::kPush ? "press" : "release", action.index + 1);
}

std::string OnLines(const OperatorAction& action) {
  const auto line = static_cast<std::size_t>(action.index) % kLineNames.size();
  return fmt::format("line {} {}", kLineNames[line], action.verb == Verb::kPush ? "on" : "off");
}

// Cables first: they belong to no device.
std::string Text(const OperatorAction& action) {
  if (action.verb == Verb::kPlug) return fmt::format("plug {}", PortName(action.port));
  if (action.verb == Verb::kUnplug) return fmt::format("unplug {}", PortName(action.port));
  if (action.port == DevicePort::kDialBox) return OnBox(action);
  if (action.port == DevicePort::kKeyboard) return OnKeyboard(action);
  if (action.port == DevicePort::kPointer) return OnPointer(action);
  if (action.port == DevicePort::kMicrophone || action.port == DevicePort::kLoudspeaker)
    return OnSound(action);
  if (action.port == DevicePort::kLines) return OnLines(action);
  return action.port == DevicePort::kCamera ? OnCamera(action) : OnStick(action);
}

}  // namespace

std::string WriteAction(const TimedAction& timed) {
  if (timed.over == Duration::zero()) return fmt::format("at {} {}", Span(timed.at), Text(timed.action));
  return fmt::format("at {} over {} {}", Span(timed.at), Span(timed.over), Text(timed.action));
}

std::string WriteBeat(const Beat& beat) {
  return fmt::format("at {} scene \"{}\"", Span(beat.at), beat.name);
}

// Beats behind the last action come at the end.
std::string WriteScenario(const Scenario& scenario) {
  std::string text;
  auto beat = scenario.beats.begin();
  // A beat stands before the actions of its time, as its name is for what follows.
  const auto write_beats_until = [&](Duration at) {
    for (; beat != scenario.beats.end() && beat->at <= at; ++beat) text += WriteBeat(*beat) + "\n";
  };
  for (const TimedAction& timed : scenario.actions) {
    write_beats_until(timed.at);
    text += WriteAction(timed) + "\n";
  }
  write_beats_until(Duration::max());
  return text;
}

}  // namespace kaori::sim
