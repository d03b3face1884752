#include "appliance/programs/input/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/toml/value.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::input {
namespace {

constexpr int kMostStickButtons = 32;
constexpr float kMostCounts = 1e6F;  // Of a mouse, from edge to edge.

// Collects the first complaint; every reader after it does nothing.
class Reading {
 public:
  Reading(std::string path, const toml::Value& file) : path_(std::move(path)), file_(file) {}

  // Each reads one key of a table such as "stick.left" into `into`, which keeps its value where the key is
  // missing. Both ends of a range are allowed. Kinds are those of TOML: a whole number is written without
  // quotes.
  void Number(std::string_view table, std::string_view key, float& into, float low, float high) {
    const toml::Value* value = Find(table, key, toml::Value::Kind::kNumber);
    if (value == nullptr) return;
    if (!(value->number >= low && value->number <= high))
      return Complain(*value, table, key, fmt::format("is not between {} and {}", low, high));
    into = static_cast<float>(value->number);
  }

  // The file's reader has one kind for all numbers, so that a fraction is told from a whole number here.
  void Whole(std::string_view table, std::string_view key, int& into, int low, int high) {
    const toml::Value* value = Find(table, key, toml::Value::Kind::kNumber);
    if (value == nullptr) return;
    if (value->number != std::floor(value->number))
      return Complain(*value, table, key, "is of the wrong kind");
    if (value->number < low || value->number > high)
      return Complain(*value, table, key, fmt::format("is not between {} and {}", low, high));
    into = static_cast<int>(value->number);
  }

  void Text(std::string_view table, std::string_view key, std::string& into) {
    if (const toml::Value* value = Find(table, key, toml::Value::Kind::kText)) into = value->text;
  }

  void Switch(std::string_view table, std::string_view key, bool& into) {
    if (const toml::Value* value = Find(table, key, toml::Value::Kind::kSwitch)) into = value->on;
  }

  // What nobody asked for is a typing error: better said now than wondered about during a show.
  void RefuseTheRest() { RefuseIn(file_, ""); }

  const std::string& complaint() const { return complaint_; }

 private:
  // The value of `key` in a table such as "stick.left"; null where there is none, or one of another kind.
  // Notes that the key was asked for, which RefuseTheRest needs.
  const toml::Value* Find(std::string_view table, std::string_view key, toml::Value::Kind kind) {
    const toml::Value* owner = &file_;
    for (std::string_view rest = table; owner != nullptr && !rest.empty();) {
      const auto dot = std::min(rest.find('.'), rest.size());
      owner = toml::Find(*owner, rest.substr(0, dot));
      rest.remove_prefix(std::min(dot + 1, rest.size()));
    }
    const toml::Value* value = owner == nullptr ? nullptr : toml::Find(*owner, key);
    if (value == nullptr) return nullptr;
    asked_for_.push_back(value);
    if (value->kind == kind) return value;
    Complain(*value, table, key, "is of the wrong kind");
    return nullptr;
  }

  // Values are compared by address: the tree stays as it was read, and so each value is one key of the file.
  void RefuseIn(const toml::Value& table, const std::string& prefix) {
    for (const auto& [key, value] : table.table) {
      if (value.kind == toml::Value::Kind::kTable)
        RefuseIn(value, prefix + key + ".");
      else if (std::ranges::find(asked_for_, &value) == asked_for_.end())
        Complain(value, prefix.empty() ? "" : prefix.substr(0, prefix.size() - 1), key, "does not exist");
    }
  }

  // As compilers name a place, so that an editor can jump there.
  void Complain(const toml::Value& at, std::string_view table, std::string_view key, std::string_view what) {
    if (complaint_.empty())
      complaint_ = fmt::format("{}:{}:{}: {}.{} {}", path_, at.line, at.column, table, key, what);
  }

  std::string path_;
  const toml::Value& file_;
  std::vector<const toml::Value*> asked_for_;
  std::string complaint_;
};

// Each key has bounds of its own; a reach below the dead zone is put right by decode::Shape.
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

Result<InputSettings> Interpret(const std::string& path, const toml::Value& file) {
  InputSettings settings;
  Reading reading(path, file);
  reading.Whole("dials", "counts_per_turn", settings.counts_per_turn, 1, kMostCountsOfATurn);
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

}  // namespace

// The file is read once, when the program starts.
Result<InputSettings> ReadSettings(const std::string& path) {
  return toml::ReadToml(path).and_then([&](const toml::Value& file) { return Interpret(path, file); });
}

Result<InputSettings> ParseBoxSettings(const std::string& text, const std::string& path) {
  auto file = toml::Parse(text, path);
  if (!file) return tl::unexpected(file.error());
  constexpr std::array<std::string_view, 4> kOurs{"dials", "keyboard", "pointer", "stick"};
  std::erase_if(file->table,
                [&](const auto& item) { return std::ranges::find(kOurs, item.first) == kOurs.end(); });
  return Interpret(path, *file);
}

// A good file is copied only where it differs from the copy: no start without a change writes anything.
BoxSettings ReadBoxSettings(const std::string& file, const std::string& last_good) {
  const auto text = ReadFile(file);
  if (!text && text.error().cause == std::errc::no_such_file_or_directory) return {};
  const auto settings =
      text ? ParseBoxSettings(*text, file) : Result<InputSettings>(tl::unexpected(text.error()));
  const auto before = ReadFile(last_good);
  if (settings) {
    // Where this fails the box only has no last good settings next time.
    if (!before || *before != *text) static_cast<void>(WriteWholeFile(last_good, {AsBytes(*text)}));
    return {*settings, {}};
  }
  if (before)
    if (const auto kept = ParseBoxSettings(*before, last_good))
      return {*kept, settings.error().message() + "; the last good settings count"};
  return {InputSettings{}, settings.error().message() + "; the usual settings count"};
}

}  // namespace kaori::input
