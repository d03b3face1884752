#include "appliance/core/roles/own_buttons.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "appliance/core/roles/named.h"
#include "appliance/core/show/cue_names.h"
#include "appliance/core/toml/nearest.h"
#include "drivers/base/checksum.h"
#include "render/scene/scene.h"

namespace kaori::roles {
namespace {

using show::CallKind;
using show::CallMode;

// The words of a kind, and the names that may stand behind them, by their indices.
struct Names {
  CallKind kind;
  std::string_view word;  // With the blank that follows.
  std::vector<std::string_view> names;
};

// In the order in which learn mode offers them. The verbs of the cue list come before the numbers of its cues.
std::vector<Names> NamesOf(const Items& items) {
  const auto of = [](const auto& names) { return std::vector<std::string_view>(names.begin(), names.end()); };
  return {{CallKind::kCue, "cue ", of(show::kCueVerbNames)},
          {CallKind::kFace, "face ", of(items.faces)},
          {CallKind::kExpression, "expression ", of(items.expressions)},
          {CallKind::kBlink, "", of(show::kBlinkNames)},
          {CallKind::kMotion, "motion ", of(items.motions)},
          {CallKind::kScene, "scene ", of(items.scenes)},
          {CallKind::kStyle, "style ", of(scene::kStyleNames)},
          {CallKind::kGoTo, "cue ", of(items.cues)}};
}

// The mode that stands before a call, which is taken off the text; the usual one is not written.
CallMode ReadMode(std::string_view& text) {
  for (const CallMode mode : {CallMode::kToggle, CallMode::kMomentary}) {
    const std::string_view word = show::kCallModeNames[static_cast<std::size_t>(mode)];
    if (!text.starts_with(word) || text.size() <= word.size() || text[word.size()] != ' ') continue;
    text.remove_prefix(word.size() + 1);
    return mode;
  }
  return CallMode::kCall;
}

}  // namespace

NamedButton NameOfButton(std::uint8_t button) {
  if (button < show::kButtonCount) return {show::Device::kDialBox, button + 1};
  const int of_sticks = button - show::kButtonCount;
  return {of_sticks < show::kStickButtonCount ? show::Device::kLeftStick : show::Device::kRightStick,
          of_sticks % show::kStickButtonCount + 1};
}

std::uint8_t ButtonNamed(const NamedButton& named) {
  const int before = named.device == show::Device::kDialBox ? 0
                     : named.device == show::Device::kLeftStick
                         ? show::kButtonCount
                         : show::kButtonCount + show::kStickButtonCount;
  return static_cast<std::uint8_t>(before + named.number - 1);
}

std::optional<show::Call> CallNamed(std::string_view text, const Items& items) {
  const CallMode mode = ReadMode(text);
  for (const Names& of : NamesOf(items)) {
    if (!text.starts_with(of.word)) continue;
    const auto found = std::ranges::find(of.names, text.substr(of.word.size()));
    if (found == of.names.end()) continue;
    if (mode != CallMode::kCall && !show::Joins(of.kind)) return std::nullopt;
    return show::Call{of.kind, static_cast<std::uint16_t>(found - of.names.begin()), mode};
  }
  return std::nullopt;
}

std::string NameOf(const show::Call& call, const Items& items) {
  for (const Names& of : NamesOf(items)) {
    if (of.kind != call.kind || call.index >= of.names.size()) continue;
    const auto mode = static_cast<std::size_t>(call.mode);
    const std::string before =
        call.mode == CallMode::kCall ? std::string() : fmt::format("{} ", show::kCallModeNames[mode]);
    return fmt::format("{}{}{}", before, of.word, of.names[call.index]);
  }
  return {};
}

std::uint64_t SumOfCall(show::Call call, std::string_view show_name, const Items& items) {
  call.mode = CallMode::kCall;
  const std::string name = NameOf(call, items);
  return name.empty() ? 0 : Fnv1a(name, Fnv1a("\n", Fnv1a(show_name)));
}

std::vector<std::string> TeachableCalls(const Items& items) {
  std::vector<std::string> calls;
  for (const Names& of : NamesOf(items))
    for (const std::string_view name : of.names) calls.push_back(fmt::format("{}{}", of.word, name));
  return calls;
}

NamedButton ReadNamedButton(toml::Section& section) {
  section.AllowOnly({"device", "number", "call"});
  NamedButton named;
  if (section.Has("device"))
    if (const auto device = IndexOf(section, "device", section.Text("device"), show::kDeviceNames))
      named.device = static_cast<show::Device>(*device);
  const bool is_box = named.device == show::Device::kDialBox;
  named.number = section.WholeOr("number", 0, 1, is_box ? show::kButtonCount : show::kStickButtonCount);
  return named;
}

// A name that is not there is told of with the nearest of all that could be meant.
void ReadButton(toml::Section& section, const Items& items, std::vector<OwnButton>& buttons) {
  const NamedButton named = ReadNamedButton(section);
  const std::string text = section.Text("call");
  const auto call = CallNamed(text, items);
  if (!call && !text.empty()) {
    const std::vector<std::string> all = TeachableCalls(items);
    section.Fault("call", fmt::format("\"{}\" is no call that the show has{}", text,
                                      toml::DidYouMean(text, {all.begin(), all.end()})));
  }
  const OwnButton button{ButtonNamed(named), call.value_or(show::Call())};
  if (std::ranges::find(buttons, button.button, &OwnButton::button) != buttons.end())
    return section.Fault("number", fmt::format("button {} is given twice", named.number));
  buttons.push_back(button);
}

void Assign(const std::vector<OwnButton>& buttons, show::Show& show) {
  constexpr std::size_t kBox = show::kButtonCount;
  for (const OwnButton& own : buttons) {
    if (own.button < kBox)
      show.buttons[own.button] = show.second_buttons[own.button] = own.call;
    else
      show.stick_buttons[own.button - kBox] = own.call;
  }
}

}  // namespace kaori::roles
