#include "appliance/atelier/script/labels.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace kaori::atelier {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint16_t kSpace = 0x2C, kZ = 0x1D, kX = 0x1B;  // HID usage page 7.

// What the performance makes of each dial; a test holds the two together.
struct Dial {
  const char* text;
  const char* unit;
  double low, high, per_turn, start;
  const char* called_by;  // A call of this group comes whole and puts the dial to 1; a scene does so too.
};
const std::array<Dial, 8> kDials{{
    {"Face", "%", 0, 1, 1, 1, "face"},
    {"Expression", "%", 0, 1, 1, 1, "expression"},
    {"Strength", "%", 0, 1.4, 1, 1, nullptr},
    {"Fade time", "s", 0, 4, 2, 0.6, nullptr},
    {"Mouth", "%", 0, 1, 1, 0, nullptr},
    {"Mouth width", "%", 0, 1, 1, 0.5, nullptr},
    {"Life", "%", 0, 1, 1, 0.6, nullptr},
    {"Light", "%", 0, 1.2, 1, 1, nullptr},
}};

constexpr std::array<const char*, scene::kStyleCount> kStyles{"Wireframe", "Flat", "No hair", "Hair",
                                                              "Soft light"};

Json DialsJson() {
  Json dials = Json::array();
  for (const Dial& dial : kDials)
    dials.push_back(
        {{"text", dial.text},
         {"unit", dial.unit},
         {"low", dial.low},
         {"high", dial.high},
         {"per_turn", dial.per_turn},
         {"start", dial.start},
         {"filled_by", dial.called_by == nullptr ? Json::array() : Json{dial.called_by, "scene"}}});
  return dials;
}

Json ButtonJson(const show::Call& call, const show::Show& show) {
  const auto labelled = [](const std::string& text, const char* group) {
    return Json{{"text", text}, {"group", group}};
  };
  switch (call.kind) {
    case show::CallKind::kFace:
      return labelled(Readable(show.cast.faces[call.index].name), "face");
    case show::CallKind::kExpression:
      return labelled(Readable(show.cast.expressions[call.index].name), "expression");
    case show::CallKind::kStyle:
      return labelled(kStyles[call.index], "style");
    case show::CallKind::kScene:
      return labelled(Readable(show.scenes[call.index].name), "scene");
    case show::CallKind::kNothing:
      break;
  }
  return labelled("", "");
}

Json SticksJson() {
  return Json::array({{{"text", "Head"}, {"twist", "Tilt"}, {"slide", "Lean in"}},
                      {{"text", "Gaze and brows"}, {"twist", "Brows"}, {"slide", "Brows up"}}});
}

// In the order in which hands find them: blinks, registered motions, scenes.
Json KeysJson(const show::Show& show) {
  Json keys = Json::array();
  const auto add = [&keys](std::uint16_t usage, const std::string& text, const char* group) {
    if (usage != 0) keys.push_back({{"usage", usage}, {"text", text}, {"group", group}});
  };
  add(kSpace, "Blink", "blink");
  add(kZ, "Wink left", "blink");  // As the audience sees her.
  add(kX, "Wink right", "blink");
  for (const show::Take& take : show.takes) add(take.key_usage, Readable(take.name), "take");
  for (const show::StageScene& scene : show.scenes) add(scene.key_usage, Readable(scene.name), "scene");
  return keys;
}

}  // namespace

std::string Readable(std::string name) {
  std::ranges::replace(name, '_', ' ');
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

std::string LabelsJson(const show::Show& show) {
  Json buttons = Json::array();
  for (const show::Call& call : show.buttons) buttons.push_back(ButtonJson(call, show));
  const Json labels{{"show", show.name},
                    {"dials", DialsJson()},
                    {"buttons", buttons},
                    {"sticks", SticksJson()},
                    {"keys", KeysJson(show)}};
  // A name that is not UTF-8 is shown with replacement signs.
  return labels.dump(1, ' ', false, nlohmann::detail::error_handler_t::replace) + '\n';
}

}  // namespace kaori::atelier
