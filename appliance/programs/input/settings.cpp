#include "appliance/programs/input/settings.h"


#include <fmt/format.h>

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include "drivers/base/read_file.h"

namespace kaori::input {
namespace {

constexpr int kMostStickButtons = 32;
constexpr float kMostCounts = 1e6F;  // Of a mouse, from edge to edge.

// Collects the first complaint; every reader after it does nothing.
class Reading {
 public:
  Reading(std::string path, toml::table& file) : path_(std::move(path)), file_(file) {}

  void Number(std::string_view table, std::string_view key, float& into, float low, float high) {
    const auto value = Value<double>(table, key);
    if (!value) return;
    if (!(*value >= low && *value <= high))  // TOML knows nan.
      return Complain(table, key, fmt::format("is not between {} and {}", low, high));
    into = static_cast<float>(*value);
  }

  void Whole(std::string_view table, std::string_view key, int& into, int low, int high) {
    const auto value = Value<std::int64_t>(table, key);
    if (!value) return;
    if (*value < low || *value > high)
      return Complain(table, key, fmt::format("is not between {} and {}", low, high));
    into = static_cast<int>(*value);
  }

  void Text(std::string_view table, std::string_view key, std::string& into) {
    if (auto value = Value<std::string>(table, key)) into = std::move(*value);
  }

  void Switch(std::string_view table, std::string_view key, bool& into) {
    if (const auto value = Value<bool>(table, key)) into = *value;
  }

  // What nobody asked for is a typing error: better said now than wondered about during a show.
  void RefuseTheRest() { RefuseIn(file_, ""); }

  const std::string& complaint() const { return complaint_; }

 private:
  static std::string Path(std::string_view table, std::string_view key) {
    return fmt::format("{}.{}", table, key);
  }

  template <class T>
  std::optional<T> Value(std::string_view table, std::string_view key) {
    const auto node = file_.at_path(Path(table, key));
    if (!node) return std::nullopt;
    const auto value = node.value<T>();
    where_ = node.node()->source();
    if (!value) Complain(table, key, "is of the wrong kind");
    if (toml::table* owner = file_.at_path(table).as_table()) owner->erase(key);
    return value;
  }

  void RefuseIn(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      where_ = node.source();
      const std::string name = prefix + std::string(key.str());
      if (const toml::table* inner = node.as_table())
        RefuseIn(*inner, name + ".");
      else
        Complain(prefix.empty() ? "" : prefix.substr(0, prefix.size() - 1), key.str(), "does not exist");
    }
  }

  void Complain(std::string_view table, std::string_view key, std::string_view what) {
    if (!complaint_.empty()) return;
    complaint_ = fmt::format("{}, line {}, column {}: {}.{} {}", path_, where_.begin.line,
                             where_.begin.column, table, key, what);
  }

  std::string path_;
  toml::table& file_;
  toml::source_region where_;
  std::string complaint_;
};

void ReadStick(Reading& reading, std::size_t which, InputSettings& settings) {
  const std::string table = which == 0 ? "stick.left" : "stick.right";
  decode::StickSettings& stick = settings.sticks[which];
  reading.Text(table, "port", settings.stick_ports[which]);
  reading.Whole(table, "centre_button", settings.centre_buttons[which], 0, kMostStickButtons);
  reading.Number(table, "dead_zone", stick.dead_zone, 0, 0.9F);
  reading.Number(table, "reach", stick.reach, 0.1F, 1);
  reading.Number(table, "curve", stick.curve, 0, 1);
  reading.Switch(table, "slider_reversed", stick.slider_reversed);
}

}  // namespace

Result<InputSettings> ReadSettings(const std::string& path) {
  const auto text = ReadFile(path, {.most_levels = kMostLevels});
  if (!text) return tl::unexpected(text.error());
  toml::parse_result parsed = toml::parse(*text, path);
  if (!parsed) {
    const auto at = parsed.error().source().begin;
    return FailInput(
        fmt::format("{}, line {}, column {}: {}", path, at.line, at.column, parsed.error().description()));
  }
  InputSettings settings;
  Reading reading(path, parsed.table());
  reading.Whole("dials", "counts_per_turn", settings.counts_per_turn, 1, 1 << 20);
  reading.Text("dials", "port", settings.dial_box_port);
  reading.Text("keyboard", "port", settings.keyboard_port);
  reading.Text("pointer", "port", settings.pointer_port);
  reading.Number("pointer", "counts_across", settings.pointer.counts_across, 1, kMostCounts);
  reading.Number("pointer", "counts_down", settings.pointer.counts_down, 1, kMostCounts);
  for (std::size_t which = 0; which < settings.sticks.size(); ++which) ReadStick(reading, which, settings);
  reading.RefuseTheRest();
  if (!reading.complaint().empty()) return FailInput(reading.complaint());
  return settings;
}

}  // namespace kaori::input
