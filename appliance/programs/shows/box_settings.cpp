#include "appliance/programs/shows/box_settings.h"

#include <algorithm>
#include <array>
#include <utility>

#include "appliance/core/restore/plan.h"
#include "appliance/programs/boot/profile.h"
#include "appliance/programs/shows/settings_check.h"
#include "appliance/programs/shows/settings_line.h"
#include "appliance/programs/shows/settings_text.h"
#include "appliance/programs/status/screens_file.h"
#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/utf8.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNone = "none";
constexpr std::size_t kMostSettingLines = 10;  // Lines that a small screen has beside the list.
constexpr std::size_t kLongestSettingLine = 90;

// A setting with few values, by its name in box.toml, and as people read it.
struct Listed {
  const char* name;
  const char* words;
};
constexpr std::array<Listed, 3> kListed{{{"profile", "profile"},
                                         {"status_screen", "screen that shows the status"},
                                         {"monitor_screen", "operators' monitor"}}};

Choosable Line(Choosable::Kind kind, std::string name, std::string remark = {}, std::string id = {}) {
  return {.kind = kind,
          .offer = {.file = {}, .name = std::move(name)},
          .remark = std::move(remark),
          .id = std::move(id)};
}

Choosable Leave() {
  return Line(Choosable::Kind::kNo, "leave the settings as they are");
}

// What the box goes by: its own file, or where that has a mistake what stands for it.
std::string ValueOf(const boot::Profile& profile, std::string_view name) {
  if (name == "profile") return profile.name;
  const std::string& screen = name == "status_screen" ? profile.status_screen : profile.monitor_screen;
  return screen.empty() ? kNone : screen;
}

}  // namespace

// The reader of process 1 wants it there.
fs::path BoxSettings::File() const {
  return places_.data / "settings/box.toml";
}

// Beside it, so that whoever has the disk in another computer finds it; no program of the box but this one reads it.
fs::path BoxSettings::Before() const {
  return places_.data / "settings/box.before.toml";
}

// A file that cannot be read is shown as one in which everything is new.
std::string BoxSettings::Now() const {
  return ReadFile(File(), {.most_bytes = kMostSettings_bytes}).value_or("");
}

// As the stage found them: a screen that is plugged in later has to be named in a file.
std::vector<std::string> BoxSettings::Screens() const {
  std::vector<std::string> names;
  for (const auto& output : status::ParseScreens(ReadFile(places_.screens).value_or("")))
    names.push_back(output.connector);
  return names;
}

Choosable BoxSettings::Opening() {
  return Line(Choosable::Kind::kSettings, "settings of this box");
}

// Leaving comes first, since GO takes the first line: whoever pushes it once too often changes nothing.
std::vector<Choosable> BoxSettings::Settings() const {
  const auto profile = boot::ReadProfile(Now());
  std::vector<Choosable> lines{Leave()};
  for (const auto& [name, words] : kListed)
    lines.push_back(Line(Choosable::Kind::kSetting, words, ValueOf(profile, name), name));
  if (IsThere(Before()))
    lines.push_back(Line(Choosable::Kind::kSettingsBefore, "back to the settings before the last change"));
  return lines;
}

// The value of now is among them, so that the list shows where the box stands. More screens than the list has numbers do not
// happen: a card has six sockets at most.
std::vector<Choosable> BoxSettings::Values(const std::string& name) const {
  std::vector<std::string> values;
  if (name == "profile") {
    values.assign(boot::kProfileNames.begin(), boot::kProfileNames.end());
  } else {
    values = Screens();
    values.insert(values.begin(), kNone);
  }
  const std::string now = ValueOf(boot::ReadProfile(Now()), name);
  std::vector<Choosable> lines{Leave()};
  for (const std::string& value : values)
    if (lines.size() < kMostChoices)
      lines.push_back(Line(Choosable::Kind::kValue, value, value == now ? "as it is" : "", name));
  return lines;
}

Result<std::string> BoxSettings::TextOf(const Choosable& taken) const {
  if (taken.kind == Choosable::Kind::kValue)
    return WithSetting(Now(), taken.id, taken.offer.name == kNone ? "" : taken.offer.name);
  const bool is_before = taken.kind == Choosable::Kind::kSettingsBefore;
  const auto text = ReadFile(is_before ? Before() : taken.offer.file, {.most_bytes = kMostSettings_bytes});
  return text && !is_before ? KeepName(*text) : text;
}

// Only a name that the box was given counts. A text with a mistake stays as it is, since the mistake is named by its line.
std::string BoxSettings::KeepName(const std::string& text) const {
  const std::string now = Now();
  const bool stays = boot::ReadProfile(now).box_name.empty() || !FaultOfSettings(text, places_.zones).empty();
  return stays ? text : WithLineOf(text, now, "name");
}

// A text that cannot be read because of what it is has a mistake; all else is the stick's, or the disk's.
Progress BoxSettings::Begin(const Choosable& taken) {
  wanted_.reset();
  name_ = taken.kind == Choosable::Kind::kValue ? taken.id : taken.offer.name;
  const auto text = TextOf(taken);
  if (!text && text.error().kind == ErrorKind::kInput)
    return {Message::kFaultySettings, text.error().message()};
  if (!text)
    return {taken.kind == Choosable::Kind::kSettingsFile ? Message::kPulled : Message::kDiskFault,
            text.error().message()};
  return BeginText(name_, *text);
}

Progress BoxSettings::BeginText(std::string name, const std::string& text) {
  wanted_.reset();
  name_ = std::move(name);
  if (IsThere(places_.data / restore::kNext / restore::kPlan)) return {Message::kRestoreWaits};
  if (auto fault = FaultOfSettings(text, places_.zones); !fault.empty())
    return {Message::kFaultySettings, std::move(fault)};
  if (SettingsDifferences(Now(), text).empty()) return {Message::kNothingDiffers};
  wanted_ = text;
  return {Message::kAskChange};
}

// No comes first, as in the list of settings.
std::vector<Choosable> BoxSettings::Answers() {
  return {Leave(), Line(Choosable::Kind::kYes, "yes, change them")};
}

std::vector<std::string> BoxSettings::Differences() const {
  if (!asks()) return {};
  auto lines = SettingsDifferences(Now(), *wanted_);
  const std::size_t all = lines.size();
  lines.resize(std::min(all, kMostSettingLines));
  for (std::string& line : lines) line = utf8::Printable(line, kLongestSettingLine);
  if (all > lines.size()) lines.push_back("and " + std::to_string(all - lines.size()) + " more");
  return lines;
}

// The old ones first: where the power goes between the two nothing has changed yet.
Result<void> BoxSettings::Write(const std::string& text) const {
  if (IsThere(File()))
    if (auto ok = WriteWholeFile(Before(), {AsBytes(Now())}); !ok) return ok;
  return WriteWholeFile(File(), {AsBytes(text)});
}

Progress BoxSettings::Answer(bool yes) {
  const auto text = std::exchange(wanted_, std::nullopt);
  if (!yes || !text) return {Message::kLeft};
  const auto written = Write(*text);
  if (written) return {Message::kSettingsWait};
  return {DiskMessageOf(written.error()), written.error().message()};
}

}  // namespace kaori::shows
