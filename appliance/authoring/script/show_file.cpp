#include "appliance/authoring/script/show_file.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "appliance/authoring/script/backdrop_file.h"
#include "appliance/authoring/script/key_names.h"
#include "appliance/authoring/script/wave_file.h"
#include "appliance/authoring/sculpt/value.h"
#include "drivers/base/read_file.h"

namespace kaori::authoring {
namespace {

constexpr std::array<const char*, scene::kStyleCount> kShowFileStyles{"wire", "flat", "bare", "hair", "soft"};
struct Target {
  const char* name;
  show::MotionTarget target;
  bool degrees;
};
constexpr std::array<Target, 6> kTargets{{{"head_yaw", show::MotionTarget::kHeadYaw, true},
                                          {"head_pitch", show::MotionTarget::kHeadPitch, true},
                                          {"head_roll", show::MotionTarget::kHeadRoll, true},
                                          {"gaze_yaw", show::MotionTarget::kGazeYaw, true},
                                          {"gaze_pitch", show::MotionTarget::kGazePitch, true},
                                          {"lids", show::MotionTarget::kLids, false}}};

// One pass over the file; faults gather while it goes on.
class ShowFileReader {
 public:
  ShowFileReader(std::filesystem::path file, show::Show& show) : file_(std::move(file)), show_(show) {}

  std::vector<std::string> Read(const toml::table& table) {
    CheckWords("the show", table, {"name", "scene", "motion", "buttons", "keys", "channels"});
    show_.name = Value("the show", table, "name", std::string("unnamed"));
    if (const auto* scenes = Part<toml::array>(table, "scene"))
      ForEachTable(*scenes, [&](auto& t) { ReadScene(t); });
    if (show_.scenes.empty()) Fault("scenes", "there is none; the first one opens the show");
    if (const auto* motions = Part<toml::array>(table, "motion"))
      ForEachTable(*motions, [&](auto& t) { ReadMotion(t); });
    if (const auto* rows = Part<toml::array>(table, "buttons")) ReadButtons(*rows);
    if (const auto* keys = Part<toml::table>(table, "keys")) ReadKeys(*keys);
    if (const auto* channels = Part<toml::table>(table, "channels")) ReadChannels(*channels);
    return std::move(faults_);
  }

 private:
  void Fault(const std::string& item, const std::string& reason) {
    faults_.push_back(fmt::format("{}: {}: {}", file_.string(), item, reason));
  }

  // What is written wrongly would else be left out in silence.
  void CheckWords(const std::string& item, const toml::table& table,
                  std::initializer_list<std::string_view> words) {
    for (const auto& [key, node] : table)
      if (std::ranges::find(words, key.str()) == words.end())
        Fault(item, fmt::format("line {}: {}", key.source().begin.line, UnknownWord(key.str())));
  }

  static std::string UnknownWord(std::string_view word) {
    if (word == "take") return "a registered motion is now written [[motion]], not [[take]]";
    return fmt::format("nothing is called \"{}\" here", word);
  }

  // A table or an array; null where there is none.
  template <class T>
  const T* Part(const toml::table& table, std::string_view word) {
    const toml::node* node = table.get(word);
    if (node == nullptr || node->as<T>() != nullptr) return node == nullptr ? nullptr : node->as<T>();
    Fault(std::string(word),
          fmt::format(
              "line {}: {}", node->source().begin.line,
              std::is_same_v<T, toml::table> ? "a table is expected, such as [keys]" : "a list is expected"));
    return nullptr;
  }

  // A number or a text; `fallback` where it is not given.
  template <class T>
  T Value(const std::string& item, const toml::table& table, std::string_view word, T fallback) {
    const toml::node* node = table.get(word);
    if (node == nullptr) return fallback;
    if (const auto value = node->value<T>()) return *value;
    Fault(item, fmt::format("line {}: {} wants {}", node->source().begin.line, word,
                            std::is_floating_point_v<T> ? "a number" : "a text in quotes"));
    return fallback;
  }

  template <class Read>
  void ForEachTable(const toml::array& array, Read read) {
    for (const toml::node& node : array)
      if (const auto* table = node.as_table())
        read(*table);
      else
        Fault("line " + std::to_string(node.source().begin.line), "a table is expected here");
  }

  template <class Items>
  std::uint16_t Named(const std::string& item, const char* kind, const Items& items,
                      const std::string& name) {
    const auto it = std::ranges::find_if(items, [&](const auto& one) { return one.name == name; });
    if (it != items.end()) return static_cast<std::uint16_t>(it - items.begin());
    Fault(item, fmt::format("there is no {} \"{}\"", kind, name));
    return 0;
  }

  std::uint16_t Style(const std::string& item, const std::string& name) {
    const auto it = std::ranges::find(kShowFileStyles, name);
    if (it != kShowFileStyles.end()) return static_cast<std::uint16_t>(it - kShowFileStyles.begin());
    Fault(item, fmt::format("there is no style \"{}\"; styles are wire, flat, bare, hair, soft", name));
    return 0;
  }

  // Of two things on one key, or of one name, an operator would never see the second.
  void CheckOnce(const std::string& item, const char* what, const std::string& name,
                 std::vector<std::string>& before) {
    if (std::ranges::find(before, name) != before.end())
      Fault(item, fmt::format("{} \"{}\" is given twice", what, name));
    before.push_back(name);
  }

  std::uint16_t Key(const std::string& item, const toml::table& table) {
    if (!table.contains("key")) return 0;
    return KeyNamed(item, Value(item, table, "key", std::string()));
  }

  std::uint16_t KeyNamed(const std::string& item, const std::string& name) {
    CheckOnce(item, "the key", name, keys_);
    if (const auto usage = KeyUsage(name)) return *usage;
    Fault(item, fmt::format("there is no key \"{}\"; keys are a to z, 0 to 9, f1 to f12", name));
    return 0;
  }

  void ReadScene(const toml::table& table) {
    show::StageScene scene;
    scene.name = Value("a scene", table, "name", std::string("unnamed"));
    const std::string item = fmt::format("scene \"{}\"", scene.name);
    CheckWords(item, table, {"name", "key", "face", "expression", "style", "light", "fade_s", "backdrop"});
    if (table.contains("name")) CheckOnce(item, "the name", scene.name, scenes_);
    scene.key_usage = Key(item, table);
    scene.face = Named(item, "face", show_.cast.faces, Value(item, table, "face", std::string()));
    scene.expression = Named(item, "expression", show_.cast.expressions,
                             Value(item, table, "expression", std::string("neutral")));
    scene.style = static_cast<scene::Style>(Style(item, Value(item, table, "style", std::string("soft"))));
    scene.exposure = Value(item, table, "light", 1.0F);
    scene.fade_s = Value(item, table, "fade_s", 0.8F);
    auto reading = ReadBackdrop(table.get("backdrop"), file_.parent_path(), show_.cast.textures);
    for (const std::string& reason : reading.faults) Fault(item, reason);
    scene.backdrop = reading.backdrop;
    show_.scenes.push_back(std::move(scene));
  }

  std::vector<show::MotionKey> Curve(const std::string& item, const toml::array& pairs, float unit) {
    std::vector<show::MotionKey> keys;
    for (const toml::node& node : pairs) {
      const auto* pair = node.as_array();
      const auto at_s = pair != nullptr && pair->size() == 2 ? (*pair)[0].value<float>() : std::nullopt;
      const auto value = at_s ? (*pair)[1].value<float>() : std::nullopt;
      if (value)
        keys.push_back({*at_s, *value * unit});
      else
        Fault(item, fmt::format("line {}: a pair [second, value] is expected", node.source().begin.line));
    }
    return keys;
  }

  void ReadMotion(const toml::table& table) {
    show::Motion motion;
    motion.name = Value("a motion", table, "name", std::string("unnamed"));
    const std::string item = fmt::format("motion \"{}\"", motion.name);
    motion.key_usage = Key(item, table);
    for (const auto& [key, node] : table) {
      if (const auto* pairs = node.as_array())
        motion.curves.push_back(TargetCurve(item, std::string(key.str()), *pairs));
      else if (key.str() == "sound")
        ReadSound(item, node, motion.sound);
      else if (key.str() != "name" && key.str() != "key")
        Fault(item, fmt::format("line {}: {} wants a list of pairs [second, value]", key.source().begin.line,
                                key.str()));
    }
    if (motion.curves.empty() && motion.sound.samples.empty()) Fault(item, "it moves nothing");
    show_.motions.push_back(std::move(motion));
  }

  // A file beside this one.
  void ReadSound(const std::string& item, const toml::node& node, show::Sound& into) {
    const auto name = node.value<std::string>();
    if (!name) return Fault(item, "sound wants the name of a WAV file");
    auto sound = ReadWave(file_.parent_path() / *name);
    if (!sound) return Fault(item, sound.error().message());
    into = std::move(*sound);
  }

  show::MotionCurve TargetCurve(const std::string& item, const std::string& name, const toml::array& pairs) {
    const auto it = std::ranges::find_if(kTargets, [&](const Target& t) { return name == t.name; });
    if (it == kTargets.end())
      return {show::MotionTarget::kChannel, Named(item, "target or channel", show_.cast.expressions, name),
              Curve(item, pairs, 1)};
    return {it->target, 0, Curve(item, pairs, it->degrees ? std::numbers::pi_v<float> / 180 : 1.0F)};
  }

  void ReadButtons(const toml::array& rows) {
    std::size_t number = 0;
    for (const toml::node& row : rows) {
      const auto* buttons = row.as_array();
      if (buttons == nullptr) {
        Fault("buttons", fmt::format("line {}: a row [...] is expected", row.source().begin.line));
        continue;
      }
      for (const toml::node& button : *buttons) {
        const show::Call call = ReadCall(fmt::format("button {}", number + 1), button);
        if (number < show_.buttons.size()) show_.buttons[number] = call;
        ++number;
      }
    }
    if (number != show_.buttons.size())
      Fault("buttons", fmt::format("{} are given; the box has {}", number, show_.buttons.size()));
  }

  void ReadKeys(const toml::table& keys) {
    for (const auto& [key, node] : keys) {
      const std::string name(key.str());
      const std::string item = "key " + name;
      show_.keys.push_back({KeyNamed(item, name), ReadCall(item, node)});
    }
  }

  show::Call ReadCall(const std::string& item, const toml::node& node) {
    if (!node.is_string())
      Fault(item, fmt::format("line {}: a text in quotes is expected", node.source().begin.line));
    const std::string text = node.value_or(std::string());
    if (text.empty()) return {};
    const auto space = text.find(' ');
    const std::string kind = text.substr(0, space);
    const std::string name = space == std::string::npos ? "" : text.substr(space + 1);
    if (kind == "face") return {show::CallKind::kFace, Named(item, "face", show_.cast.faces, name)};
    if (kind == "expression")
      return {show::CallKind::kExpression, Named(item, "expression", show_.cast.expressions, name)};
    if (kind == "style") return {show::CallKind::kStyle, Style(item, name)};
    if (kind == "scene") return {show::CallKind::kScene, Named(item, "scene", show_.scenes, name)};
    Fault(item, fmt::format("\"{}\" is none of face, expression, style, scene", kind));
    return {};
  }

  int Channel(const toml::node_view<const toml::node>& node, const std::string& role) {
    const auto name = node.value<std::string>();
    return name ? Named("channel " + role, "expression", show_.cast.expressions, *name) : -1;
  }

  void ReadChannels(const toml::table& table) {
    CheckWords("channels", table,
               {"brow_up_left", "brow_up_right", "brow_frown", "lids_up", "lids_down", "mouth"});
    show::Channels& channels = show_.channels;
    channels.brow_up = {Channel(table["brow_up_left"], "brow_up_left"),
                        Channel(table["brow_up_right"], "brow_up_right")};
    channels.brow_frown = Channel(table["brow_frown"], "brow_frown");
    channels.lids_up = Channel(table["lids_up"], "lids_up");
    channels.lids_down = Channel(table["lids_down"], "lids_down");
    for (std::size_t i = 0; i < channels.mouth.size(); ++i)
      channels.mouth[i] = Channel(table["mouth"][i], "mouth");
  }

  std::filesystem::path file_;
  show::Show& show_;
  std::vector<std::string> faults_;
  std::vector<std::string> keys_;    // That call something.
  std::vector<std::string> scenes_;  // Their names.
};

}  // namespace

std::vector<std::string> ReadShowFile(const std::filesystem::path& file, show::Show& show) {
  const auto text = ReadFile(file, {.most_levels = kMostLevels});
  if (!text) return {text.error().message()};
  const toml::parse_result parsed = toml::parse(*text, file.string());
  if (!parsed) {
    const auto& at = parsed.error().source().begin;
    return {fmt::format("{}:{}:{}: {}", file.string(), at.line, at.column, parsed.error().description())};
  }
  return ShowFileReader(file, show).Read(parsed.table());
}

}  // namespace kaori::authoring
