// The settings of the box at the box: those of a file on a stick, but for the name of a box that has one, and single ones that
// are chosen from a list. Whatever is taken is checked as a whole and shown as what it would change; once somebody agrees it is written, and counts from the
// next start of the box on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/programs/shows/installation.h"
#include "appliance/programs/shows/menu.h"

namespace kaori::shows {

struct SettingsPlaces {
  // Of the box: /var/lib/kaori. Below it lie settings/box.toml, and as settings/box.before.toml the one before the last change
  // that was made here. The last one without a mistake is kept besides by kaori-boot, at each start.
  std::filesystem::path data;
  // Of the tz database.
  std::filesystem::path zones = "/usr/share/zoneinfo";
  // Which outputs the stage drives (status/screens_file.h); they can be chosen by their names.
  std::filesystem::path screens;
};

// One thread. Blocks for the disk and for a stick.
class BoxSettings {
 public:
  explicit BoxSettings(SettingsPlaces places) : places_(std::move(places)) {}

  // The line by which the list of settings is opened.
  static Choosable Opening();
  // The settings that have few values, each with what it is now; the settings before the last change, where there are such; and
  // first of all the line that leaves everything as it is.
  std::vector<Choosable> Settings() const;
  // What the setting of this name can be: kValue each.
  std::vector<Choosable> Values(const std::string& name) const;

  // Reads what was taken, kSettingsFile, kSettingsBefore or kValue, and compares it. kAskChange, kNothingDiffers, or a refusal;
  // kRestoreWaits where a restore would undo the change at the next start: that comes first.
  Progress Begin(const Choosable& taken);
  // The same of a text that somebody brought in another way; `name` is what the settings are called.
  Progress BeginText(std::string name, const std::string& text);
  // The text of box.toml as it is now; empty where there is none.
  std::string Text() const { return Now(); }
  // Of what was taken last: stands before what is said.
  const std::string& name() const { return name_; }

  // Something waits for an answer; the list is then that of the answers, with the differences below it.
  bool asks() const { return wanted_.has_value(); }
  static std::vector<Choosable> Answers();
  std::vector<std::string> Differences() const;
  // Ends the question: kSettingsWait, kLeft, or a refusal.
  Progress Answer(bool yes);

 private:
  std::filesystem::path File() const;
  std::filesystem::path Before() const;
  // The text of box.toml; empty where there is none.
  std::string Now() const;
  Result<std::string> TextOf(const Choosable& taken) const;
  // Settings of a stick with the box's own name in place of theirs, where it has one: several boxes are set up from one stick.
  std::string KeepName(const std::string& text) const;
  std::vector<std::string> Screens() const;
  Result<void> Write(const std::string& text) const;

  SettingsPlaces places_;
  std::string name_;
  // The whole text that would be written.
  std::optional<std::string> wanted_;
};

}  // namespace kaori::shows
