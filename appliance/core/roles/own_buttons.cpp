#include "appliance/core/roles/own_buttons.h"

#include <algorithm>

#include <fmt/format.h>

#include "appliance/core/show/cue_names.h"
#include "appliance/core/toml/nearest.h"

namespace kaori::roles {
namespace {

constexpr std::string_view kFaceCall = "face ", kExpressionCall = "expression ", kCueCall = "cue ";

// The call whose name stands behind `kind`, among names in the order of their indices.
template <class Names>
std::optional<show::Call> CallAmong(show::CallKind kind, const Names& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return show::Call{kind, static_cast<std::uint16_t>(found - names.begin())};
}

template <class Names>
std::string NameAmong(std::string_view kind, const Names& names, std::size_t index) {
  return index < names.size() ? fmt::format("{}{}", kind, names[index]) : std::string();
}

}  // namespace

std::optional<show::Call> CallNamed(std::string_view text, const Items& items) {
  if (text.starts_with(kFaceCall))
    return CallAmong(show::CallKind::kFace, items.faces, text.substr(kFaceCall.size()));
  if (text.starts_with(kExpressionCall))
    return CallAmong(show::CallKind::kExpression, items.expressions, text.substr(kExpressionCall.size()));
  if (text.starts_with(kCueCall))
    return CallAmong(show::CallKind::kCue, show::kCueVerbNames, text.substr(kCueCall.size()));
  return std::nullopt;
}

std::string NameOf(const show::Call& call, const Items& items) {
  if (call.kind == show::CallKind::kFace) return NameAmong(kFaceCall, items.faces, call.index);
  if (call.kind == show::CallKind::kExpression)
    return NameAmong(kExpressionCall, items.expressions, call.index);
  if (call.kind == show::CallKind::kCue) return NameAmong(kCueCall, show::kCueVerbNames, call.index);
  return {};
}

// A name that is not there is told of with the nearest of all that could be meant.
void ReadButton(toml::Section& section, const Items& items, std::vector<OwnButton>& buttons) {
  section.AllowOnly({"number", "call"});
  const int number = section.WholeOr("number", 0, 1, show::kButtonCount);
  const std::string text = section.Text("call");
  const auto call = CallNamed(text, items);
  if (!call && !text.empty()) {
    std::vector<std::string> all;
    for (std::uint16_t i = 0; i < items.faces.size(); ++i)
      all.push_back(NameOf({show::CallKind::kFace, i}, items));
    for (std::uint16_t i = 0; i < items.expressions.size(); ++i)
      all.push_back(NameOf({show::CallKind::kExpression, i}, items));
    for (std::uint16_t i = 0; i < show::kCueVerbCount; ++i)
      all.push_back(NameOf({show::CallKind::kCue, i}, items));
    section.Fault("call",
                  fmt::format("\"{}\" is no \"face ...\", \"expression ...\" or \"cue ...\" of the show{}",
                              text, toml::DidYouMean(text, {all.begin(), all.end()})));
  }
  const OwnButton button{static_cast<std::uint8_t>(number - 1), call.value_or(show::Call())};
  if (std::ranges::find(buttons, button.button, &OwnButton::button) != buttons.end())
    return section.Fault("number", fmt::format("button {} is given twice", number));
  buttons.push_back(button);
}

void Assign(const std::vector<OwnButton>& buttons, show::Show& show) {
  for (const OwnButton& own : buttons) show.buttons[own.button] = show.second_buttons[own.button] = own.call;
}

}  // namespace kaori::roles
