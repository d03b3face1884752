#include "hw-sim/scenario/statements.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "firmware/wire/dial_box.h"
#include "firmware/wire/pointer.h"
#include "firmware/wire/stick_pod.h"
#include "hw-sim/devices/line_panel.h"
#include "hw-sim/scenario/key_names.h"
#include "hw-sim/scenario/reader.h"
#include "hw-sim/scenario/speech.h"

namespace kaori::sim {
namespace {

// Counted as people do, from 1.
constexpr int kDials = static_cast<int>(wire::kDials);
constexpr int kBoxButtons = static_cast<int>(wire::kDialBoxButtons);
constexpr int kStickButtons = static_cast<int>(wire::kStickPodButtons);
constexpr int kPointerButtons = static_cast<int>(wire::kPointerButtons);
// What DialBox and Pointer accept in one action.
constexpr double kMostTurns = 1000;
constexpr double kMostNotches = 1000;
// A name is shown in a line of a terminal.
constexpr std::size_t kLongestName_bytes = 100;

// Down at the line's time, and up again after kTap.
void AddTap(DevicePort port, int index, Statement& into) {
  into.steps.push_back({{}, {port, Verb::kPush, index, 0, 0}});
  into.steps.push_back({kTap, {port, Verb::kRelease, index, 0, 0}});
}

// One action at the line's time.
void AddOne(const OperatorAction& action, Statement& into) {
  into.steps.push_back({{}, action});
}

// push, hold or release: of button `index`.
void AddButton(std::string_view verb, DevicePort port, int index, Statement& into) {
  if (verb == "push") return AddTap(port, index, into);
  AddOne({port, verb == "hold" ? Verb::kPush : Verb::kRelease, index, 0, 0}, into);
}

// dial 1 turn 0.4.
void ReadDial(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto dial = tokens.Numbered("dial", kDials);
  if (!dial) return;
  if (!tokens.Accept("turn")) return tokens.Complain(tokens.next_column(), "expected turn");
  const auto turns = tokens.Number("a number of turns", -kMostTurns, kMostTurns);
  if (turns) AddOne({DevicePort::kDialBox, Verb::kTurn, *dial - 1, *turns, 0}, into);
}

// pointer 0.4 0.5.
void ReadPointer(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto x = tokens.Number("x, left to right", 0, 1);
  const auto y = tokens.Number("y, from above", 0, 1);
  if (x && y) AddOne({DevicePort::kPointer, Verb::kMove, 0, *x, *y}, into);
}

// press, click or release pointer; of the button that follows, or else of the first.
void ReadPointerButton(Tokenizer& tokens, std::string_view verb, Statement& into) {
  const auto button = tokens.NumberFollows() ? tokens.Numbered("pointer button", kPointerButtons) : 1;
  if (!button) return;
  if (verb == "click") return AddTap(DevicePort::kPointer, *button - 1, into);
  AddOne({DevicePort::kPointer, verb == "press" ? Verb::kPush : Verb::kRelease, *button - 1, 0, 0}, into);
}

// What is done with the pointer alone.
void ReadAtPointer(Tokenizer& tokens, std::string_view verb, Statement& into) {
  if (!tokens.Accept("pointer")) return tokens.Complain(tokens.next_column(), "expected pointer");
  if (verb != "roll") return ReadPointerButton(tokens, verb, into);
  const auto notches = tokens.Number("a number of notches", -kMostNotches, kMostNotches);
  if (notches) AddOne({DevicePort::kPointer, Verb::kRoll, 0, *notches, 0}, into);
}

// push 7, hold 7, release 7; and release pointer, which begins with the same word.
void ReadBoxButton(Tokenizer& tokens, std::string_view verb, Statement& into) {
  if (verb == "release" && tokens.Accept("pointer")) return ReadPointerButton(tokens, verb, into);
  const auto button = tokens.Numbered("button", kBoxButtons);
  if (button) AddButton(verb, DevicePort::kDialBox, *button - 1, into);
}

// left move 0.25 0.05.
void ReadMove(Tokenizer& tokens, DevicePort port, Statement& into) {
  const auto x = tokens.Number("x, left to right", -1, 1);
  const auto y = tokens.Number("y, back to forwards", -1, 1);
  if (x && y) AddOne({port, Verb::kMove, 0, *x, *y}, into);
}

// right hat up.
void ReadHat(Tokenizer& tokens, DevicePort port, Statement& into) {
  const auto token = tokens.Next("a direction of the hat");
  if (!token) return;
  const auto direction = HatNamed(token->text);
  if (direction) return AddOne({port, Verb::kHat, *direction, 0, 0}, into);
  tokens.Complain(token->column,
                  fmt::format("the hat knows no \"{}\"; it goes up, up-right, right, down-right, "
                              "down, down-left, left, up-left, centre",
                              token->text));
}

// Everything that begins with left or right.
void ReadStick(Tokenizer& tokens, std::string_view side, Statement& into) {
  const DevicePort port = side == "left" ? DevicePort::kStickLeft : DevicePort::kStickRight;
  const auto verb = tokens.Next("move, twist, slide, hat, push, hold or release");
  if (!verb) return;
  if (verb->text == "move") return ReadMove(tokens, port, into);
  if (verb->text == "hat") return ReadHat(tokens, port, into);
  if (verb->text == "twist" || verb->text == "slide") {
    const bool twist = verb->text == "twist";
    const auto value = tokens.Number(twist ? "a twist" : "a slider's position", twist ? -1 : 0, 1);
    if (value) AddOne({port, twist ? Verb::kTwist : Verb::kSlide, 0, *value, 0}, into);
    return;
  }
  if (verb->text == "push" || verb->text == "hold" || verb->text == "release") {
    const auto button = tokens.Numbered("stick button", kStickButtons);
    if (button) AddButton(verb->text, port, *button - 1, into);
    return;
  }
  tokens.Complain(verb->column,
                  fmt::format("a stick does not \"{}\"; it does move, twist, slide, hat, push, hold "
                              "and release",
                              verb->text));
}

// key space tap, key z press, key usage-57 release.
void ReadKey(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto name = tokens.Next("the name of a key");
  if (!name) return;
  const auto usage = KeyNamed(name->text);
  if (!usage) {
    return tokens.Complain(name->column,
                           fmt::format("no key \"{}\"; keys are a to z, 0 to 9, f1 to f12, space, enter, "
                                       "escape, left, right, up, down",
                                       name->text));
  }
  const auto verb = tokens.Next("tap, press or release");
  if (!verb) return;
  if (verb->text == "tap") return AddTap(DevicePort::kKeyboard, *usage, into);
  if (verb->text == "press") return AddOne({DevicePort::kKeyboard, Verb::kPush, *usage, 0, 0}, into);
  if (verb->text == "release") return AddOne({DevicePort::kKeyboard, Verb::kRelease, *usage, 0, 0}, into);
  tokens.Complain(verb->column,
                  fmt::format("a key does not \"{}\"; it does tap, press and release", verb->text));
}

// lips 0.6 1.1.
void ReadLips(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto height = tokens.Number("a height of the mouth", 0, 2);
  const auto width = tokens.Number("a width of the mouth", 0, 2);
  if (height && width) AddOne({DevicePort::kCamera, Verb::kLips, 0, *height, *width}, into);
}

// voice a 0.8, voice off.
void ReadVoice(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto vowel = tokens.Next("a vowel (a, i, u, e, o) or off");
  if (!vowel) return;
  if (vowel->text == "off") return AddOne({DevicePort::kMicrophone, Verb::kVoice, 0, 0, 0}, into);
  const auto number = kVowelLetters.find(vowel->text);
  if (vowel->text.size() != 1 || number == std::string_view::npos)
    return tokens.Complain(vowel->column,
                           fmt::format("no vowel \"{}\"; vowels are a, i, u, e, o, or off", vowel->text));
  const auto loudness = tokens.Number("a loudness", 0, 4);
  if (loudness) AddOne({DevicePort::kMicrophone, Verb::kVoice, static_cast<int>(number), *loudness, 0}, into);
}

// say "ko n ni ti wa".
void ReadSay(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto text = tokens.Next("syllables in quotes");
  if (!text) return;
  if (!CanSay(text->text))
    return tokens.Complain(text->column, "this cannot be said; syllables are such as \"ka o ri\"");
  into.say = std::string(text->text);
}

// microphone stall, microphone run; the same of the loudspeaker.
void ReadSound(Tokenizer& tokens, std::string_view thing, Statement& into) {
  const DevicePort port = thing == "microphone" ? DevicePort::kMicrophone : DevicePort::kLoudspeaker;
  if (tokens.Accept("stall")) return AddOne({port, Verb::kStall, 1, 0, 0}, into);
  if (tokens.Accept("run")) return AddOne({port, Verb::kStall, 0, 0, 0}, into);
  tokens.Complain(tokens.next_column(), "expected stall or run");
}

// lens cover, lens uncover, camera stall, camera run.
void ReadCamera(Tokenizer& tokens, std::string_view thing, Statement& into) {
  const bool lens = thing == "lens";
  const Verb verb = lens ? Verb::kCoverLens : Verb::kStall;
  if (tokens.Accept(lens ? "cover" : "stall")) return AddOne({DevicePort::kCamera, verb, 1, 0, 0}, into);
  if (tokens.Accept(lens ? "uncover" : "run")) return AddOne({DevicePort::kCamera, verb, 0, 0, 0}, into);
  tokens.Complain(tokens.next_column(), lens ? "expected cover or uncover" : "expected stall or run");
}

// plug dial-box, unplug dial-box.
void ReadCable(Tokenizer& tokens, std::string_view verb, Statement& into) {
  const auto name = tokens.Next("the name of a device");
  if (!name) return;
  const auto port = DevicePortNamed(name->text);
  if (port) return AddOne({*port, verb == "plug" ? Verb::kPlug : Verb::kUnplug, 0, 0, 0}, into);
  tokens.Complain(name->column,
                  fmt::format("no device \"{}\"; devices are dial-box, stick-left, stick-right, keyboard, "
                              "camera, screen, pointer, microphone, loudspeaker, lines",
                              name->text));
}

// line go on, line blackout off, line go tap.
void ReadLine(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto name = tokens.Next("the name of a line");
  if (!name) return;
  const auto* const known = std::ranges::find(kLineNames, name->text);
  if (known == kLineNames.end())
    return tokens.Complain(
        name->column,
        fmt::format("no line \"{}\"; lines are go, blackout, service, presence, back, panic", name->text));
  const auto line = static_cast<int>(known - kLineNames.begin());
  if (tokens.Accept("tap")) return AddTap(DevicePort::kLines, line, into);
  if (tokens.Accept("on")) return AddOne({DevicePort::kLines, Verb::kPush, line, 0, 0}, into);
  if (tokens.Accept("off")) return AddOne({DevicePort::kLines, Verb::kRelease, line, 0, 0}, into);
  tokens.Complain(tokens.next_column(), "expected on, off or tap");
}

// scene narrator.
void ReadScene(Tokenizer& tokens, std::string_view, Statement& into) {
  const auto name = tokens.Next("the name of a scene");
  if (!name) return;
  if (name->text.size() > kLongestName_bytes)
    return tokens.Complain(name->column, "a scene's name of more than 100 bytes");
  into.scene = std::string(name->text);
}

// A statement begins with one of these words, and its reader reads the rest of the line. The word is
// given to the reader, since several words share one.
struct StatementForm {
  std::string_view token;
  void (*read)(Tokenizer&, std::string_view token, Statement&);
};
// Looked through from the front: a scenario has some hundred lines.
constexpr auto kForms = std::to_array<StatementForm>({
    {"dial", ReadDial},         {"push", ReadBoxButton},  {"hold", ReadBoxButton},
    {"release", ReadBoxButton}, {"left", ReadStick},      {"right", ReadStick},
    {"key", ReadKey},           {"pointer", ReadPointer}, {"press", ReadAtPointer},
    {"click", ReadAtPointer},   {"roll", ReadAtPointer},  {"lips", ReadLips},
    {"voice", ReadVoice},       {"say", ReadSay},         {"lens", ReadCamera},
    {"line", ReadLine},         {"camera", ReadCamera},   {"microphone", ReadSound},
    {"loudspeaker", ReadSound}, {"plug", ReadCable},      {"unplug", ReadCable},
    {"scene", ReadScene},
});
constexpr std::string_view kStatementWords =
    "dial, push, hold, release, left, right, key, pointer, press, click, roll, lips, voice, say, "
    "lens, camera, microphone, loudspeaker, line, plug, unplug or scene";

}  // namespace

bool ReadStatement(Tokenizer& tokens, Statement& into) {
  const auto token = tokens.Next(kStatementWords);
  if (!token) return false;
  const auto* const form = std::ranges::find(kForms, token->text, &StatementForm::token);
  if (form == kForms.end())
    tokens.Complain(token->column,
                    fmt::format("unknown word \"{}\"; expected {}", token->text, kStatementWords));
  else
    form->read(tokens, token->text, into);  // It goes on behind the word, which was read.
  return !tokens.bad();
}

}  // namespace kaori::sim
