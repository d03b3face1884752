#include "hw-sim/scenario/statements.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "firmware/wire/dial_box.h"
#include "firmware/wire/pointer.h"
#include "firmware/wire/stick_pod.h"
#include "hw-sim/scenario/key_names.h"
#include "hw-sim/scenario/reader.h"
#include "hw-sim/scenario/speech.h"

namespace kaori::sim {
namespace {

constexpr int kDials = static_cast<int>(wire::kDials);
constexpr int kBoxButtons = static_cast<int>(wire::kDialBoxButtons);
constexpr int kStickButtons = static_cast<int>(wire::kStickPodButtons);
constexpr int kPointerButtons = static_cast<int>(wire::kPointerButtons);
constexpr double kMostTurns = 1000;
constexpr double kMostNotches = 1000;
constexpr std::size_t kLongestName_bytes = 100;

void AddTap(Place place, int index, Statement& into) {
  into.steps.push_back({{}, {place, Verb::kPush, index, 0, 0}});
  into.steps.push_back({kTap, {place, Verb::kRelease, index, 0, 0}});
}

void AddOne(const Hand& hand, Statement& into) {
  into.steps.push_back({{}, hand});
}

// push, hold or release: of button `index`.
void AddButton(std::string_view verb, Place place, int index, Statement& into) {
  if (verb == "push") return AddTap(place, index, into);
  AddOne({place, verb == "hold" ? Verb::kPush : Verb::kRelease, index, 0, 0}, into);
}

void ReadDial(Words& words, std::string_view, Statement& into) {
  const auto dial = words.Numbered("dial", kDials);
  if (!dial) return;
  if (!words.Accept("turn")) return words.Complain(words.next_column(), "expected turn");
  const auto turns = words.Number("a number of turns", -kMostTurns, kMostTurns);
  if (turns) AddOne({Place::kDialBox, Verb::kTurn, *dial - 1, *turns, 0}, into);
}

void ReadPointer(Words& words, std::string_view, Statement& into) {
  const auto x = words.Number("x, left to right", 0, 1);
  const auto y = words.Number("y, from above", 0, 1);
  if (x && y) AddOne({Place::kPointer, Verb::kMove, 0, *x, *y}, into);
}

// press, click or release pointer; of the button that follows, or else of the first.
void ReadPointerButton(Words& words, std::string_view verb, Statement& into) {
  const auto button = words.NumberFollows() ? words.Numbered("pointer button", kPointerButtons) : 1;
  if (!button) return;
  if (verb == "click") return AddTap(Place::kPointer, *button - 1, into);
  AddOne({Place::kPointer, verb == "press" ? Verb::kPush : Verb::kRelease, *button - 1, 0, 0}, into);
}

// What is done with the pointer alone.
void ReadAtPointer(Words& words, std::string_view verb, Statement& into) {
  if (!words.Accept("pointer")) return words.Complain(words.next_column(), "expected pointer");
  if (verb != "roll") return ReadPointerButton(words, verb, into);
  const auto notches = words.Number("a number of notches", -kMostNotches, kMostNotches);
  if (notches) AddOne({Place::kPointer, Verb::kRoll, 0, *notches, 0}, into);
}

void ReadBoxButton(Words& words, std::string_view verb, Statement& into) {
  if (verb == "release" && words.Accept("pointer")) return ReadPointerButton(words, verb, into);
  const auto button = words.Numbered("button", kBoxButtons);
  if (button) AddButton(verb, Place::kDialBox, *button - 1, into);
}

void ReadMove(Words& words, Place place, Statement& into) {
  const auto x = words.Number("x, left to right", -1, 1);
  const auto y = words.Number("y, back to forwards", -1, 1);
  if (x && y) AddOne({place, Verb::kMove, 0, *x, *y}, into);
}

void ReadHat(Words& words, Place place, Statement& into) {
  const auto word = words.Next("a direction of the hat");
  if (!word) return;
  const auto direction = HatNamed(word->text);
  if (direction) return AddOne({place, Verb::kHat, *direction, 0, 0}, into);
  words.Complain(word->column,
                 fmt::format("the hat knows no \"{}\"; it goes up, up-right, right, down-right, "
                             "down, down-left, left, up-left, centre",
                             word->text));
}

void ReadStick(Words& words, std::string_view side, Statement& into) {
  const Place place = side == "left" ? Place::kStickLeft : Place::kStickRight;
  const auto verb = words.Next("move, twist, slide, hat, push, hold or release");
  if (!verb) return;
  if (verb->text == "move") return ReadMove(words, place, into);
  if (verb->text == "hat") return ReadHat(words, place, into);
  if (verb->text == "twist" || verb->text == "slide") {
    const bool twist = verb->text == "twist";
    const auto value = words.Number(twist ? "a twist" : "a slider's place", twist ? -1 : 0, 1);
    if (value) AddOne({place, twist ? Verb::kTwist : Verb::kSlide, 0, *value, 0}, into);
    return;
  }
  if (verb->text == "push" || verb->text == "hold" || verb->text == "release") {
    const auto button = words.Numbered("stick button", kStickButtons);
    if (button) AddButton(verb->text, place, *button - 1, into);
    return;
  }
  words.Complain(verb->column,
                 fmt::format("a stick does not \"{}\"; it does move, twist, slide, hat, push, hold "
                             "and release",
                             verb->text));
}

void ReadKey(Words& words, std::string_view, Statement& into) {
  const auto name = words.Next("the name of a key");
  if (!name) return;
  const auto usage = KeyNamed(name->text);
  if (!usage) {
    return words.Complain(name->column,
                          fmt::format("no key \"{}\"; keys are a to z, 0 to 9, f1 to f12, space, enter, "
                                      "escape, left, right, up, down",
                                      name->text));
  }
  const auto verb = words.Next("tap, press or release");
  if (!verb) return;
  if (verb->text == "tap") return AddTap(Place::kKeyboard, *usage, into);
  if (verb->text == "press") return AddOne({Place::kKeyboard, Verb::kPush, *usage, 0, 0}, into);
  if (verb->text == "release") return AddOne({Place::kKeyboard, Verb::kRelease, *usage, 0, 0}, into);
  words.Complain(verb->column,
                 fmt::format("a key does not \"{}\"; it does tap, press and release", verb->text));
}

void ReadLips(Words& words, std::string_view, Statement& into) {
  const auto height = words.Number("a height of the mouth", 0, 2);
  const auto width = words.Number("a width of the mouth", 0, 2);
  if (height && width) AddOne({Place::kCamera, Verb::kLips, 0, *height, *width}, into);
}

// voice a 0.8, voice off.
void ReadVoice(Words& words, std::string_view, Statement& into) {
  const auto vowel = words.Next("a vowel (a, i, u, e, o) or off");
  if (!vowel) return;
  if (vowel->text == "off") return AddOne({Place::kMicrophone, Verb::kVoice, 0, 0, 0}, into);
  const auto number = kVowelLetters.find(vowel->text);
  if (vowel->text.size() != 1 || number == std::string_view::npos)
    return words.Complain(vowel->column,
                          fmt::format("no vowel \"{}\"; vowels are a, i, u, e, o, or off", vowel->text));
  const auto loudness = words.Number("a loudness", 0, 4);
  if (loudness) AddOne({Place::kMicrophone, Verb::kVoice, static_cast<int>(number), *loudness, 0}, into);
}

void ReadSay(Words& words, std::string_view, Statement& into) {
  const auto text = words.Next("syllables in quotes");
  if (!text) return;
  if (!CanSay(text->text))
    return words.Complain(text->column, "this cannot be said; syllables are such as \"ka o ri\"");
  into.say = std::string(text->text);
}

// microphone stall, microphone run; the same of the loudspeaker.
void ReadSound(Words& words, std::string_view thing, Statement& into) {
  const Place place = thing == "microphone" ? Place::kMicrophone : Place::kLoudspeaker;
  if (words.Accept("stall")) return AddOne({place, Verb::kStall, 1, 0, 0}, into);
  if (words.Accept("run")) return AddOne({place, Verb::kStall, 0, 0, 0}, into);
  words.Complain(words.next_column(), "expected stall or run");
}

// lens cover, lens uncover, camera stall, camera run.
void ReadCamera(Words& words, std::string_view thing, Statement& into) {
  const bool lens = thing == "lens";
  const Verb verb = lens ? Verb::kCoverLens : Verb::kStall;
  if (words.Accept(lens ? "cover" : "stall")) return AddOne({Place::kCamera, verb, 1, 0, 0}, into);
  if (words.Accept(lens ? "uncover" : "run")) return AddOne({Place::kCamera, verb, 0, 0, 0}, into);
  words.Complain(words.next_column(), lens ? "expected cover or uncover" : "expected stall or run");
}

void ReadCable(Words& words, std::string_view verb, Statement& into) {
  const auto port = words.Next("the name of a device");
  if (!port) return;
  const auto place = PlaceNamed(port->text);
  if (place) return AddOne({*place, verb == "plug" ? Verb::kPlug : Verb::kUnplug, 0, 0, 0}, into);
  words.Complain(port->column,
                 fmt::format("no device \"{}\"; devices are dial-box, stick-left, stick-right, keyboard, "
                             "camera, screen, pointer, microphone, loudspeaker",
                             port->text));
}

void ReadScene(Words& words, std::string_view, Statement& into) {
  const auto name = words.Next("the name of a scene");
  if (!name) return;
  if (name->text.size() > kLongestName_bytes)
    return words.Complain(name->column, "a scene's name of more than 100 bytes");
  into.scene = std::string(name->text);
}

struct Form {
  std::string_view word;
  void (*read)(Words&, std::string_view word, Statement&);
};
constexpr auto kForms = std::to_array<Form>({
    {"dial", ReadDial},         {"push", ReadBoxButton},   {"hold", ReadBoxButton},
    {"release", ReadBoxButton}, {"left", ReadStick},       {"right", ReadStick},
    {"key", ReadKey},           {"pointer", ReadPointer},  {"press", ReadAtPointer},
    {"click", ReadAtPointer},   {"roll", ReadAtPointer},   {"lips", ReadLips},
    {"voice", ReadVoice},       {"say", ReadSay},          {"lens", ReadCamera},
    {"camera", ReadCamera},     {"microphone", ReadSound}, {"loudspeaker", ReadSound},
    {"plug", ReadCable},        {"unplug", ReadCable},     {"scene", ReadScene},
});
constexpr std::string_view kFormWords =
    "dial, push, hold, release, left, right, key, pointer, press, click, roll, lips, voice, say, "
    "lens, camera, microphone, loudspeaker, plug, unplug or scene";

}  // namespace

bool ReadStatement(Words& words, Statement& into) {
  const auto word = words.Next(kFormWords);
  if (!word) return false;
  const auto* const form = std::ranges::find(kForms, word->text, &Form::word);
  if (form == kForms.end())
    words.Complain(word->column, fmt::format("unknown word \"{}\"; expected {}", word->text, kFormWords));
  else
    form->read(words, word->text, into);
  return !words.bad();
}

}  // namespace kaori::sim
