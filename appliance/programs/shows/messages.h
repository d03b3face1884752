// What is said to whoever installs a show, in English and Japanese: one table, in words of the theatre.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/base/result.h"

namespace kaori::shows {

// How an installation ended, or how far it is. Each has a row in the table.
enum class Message : std::uint8_t {
  // The stick was taken out before anything was taken.
  kPlugIn,
  // There is no show on the stick.
  kNoShow,
  // The list is shut: how it is opened.
  kShut,
  // Several are there, or one: which one is to be taken?
  kChoose,
  // On the way.
  kCopying,
  // Checked; its scenes are drawn once.
  kTrying,
  // It is on the box and chosen; the stage has not begun it yet.
  kInstalled,
  // The stage plays it.
  kPlays,
  // It is what is chosen, and whole.
  kAlreadyThere,
  // Shows that a public key signed would play: is that wanted?
  kAskKey,
  // The key was kept: they will.
  kKeyTaken,
  // The support file is on its way to the stick.
  kWriting,
  // It is there.
  kWritten,
  // A backup is on its way to the stick.
  kBackingUp,
  // It is there.
  kBackedUp,
  // It is made, and can be fetched from the desk.
  kBackupForDesk,
  // A backup is being copied from the stick and checked.
  kReadingBackup,
  // What a restore or other settings would change is listed: is that wanted?
  kAskChange,
  kNothingDiffers,
  // It is done at the next start.
  kRestoreWaits,
  // It was done at once.
  kRestored,
  // What the last restore took away comes back at the next start.
  kUndoWaits,
  // Somebody did not want it.
  kLeft,
  // The settings of the box are listed, or what one of them may be.
  kChooseSetting,
  kChooseValue,
  // They are written, and count from the next start on.
  kSettingsWait,
  // Another kind of file.
  kNotAShow,
  // Its checksum or its signature does not fit.
  kDamaged,
  // Its end is missing.
  kCutOff,
  kUnsigned,
  // Signed, by a key that the box does not trust.
  kForeign,
  // The box trusts nobody.
  kNoKeys,
  kTooLarge,
  kNewerFormat,
  kOlderFormat,
  // The data partition has no room.
  kFull,
  // The stick was pulled, or cannot be read.
  kPulled,
  // A stick of another file system.
  kUnreadable,
  // The box's own disk cannot be written.
  kDiskFault,
  // It is whole and trusted, and does not play.
  kUnplayable,
  // The service key was turned back on the way.
  kKeyOff,
  // The stick has no room for what is written onto it.
  kStickFull,
  // It cannot be written, or does not hold what was written.
  kStickUnwritable,
  // It was pulled while a file was written onto it.
  kSupportPulled,
  // Another kind of file.
  kNotABackup,
  kNewerBackup,
  // A name of it leads out of the folders of a box.
  kOutside,
  // The box's files changed while they were copied.
  kChanged,
  // A settings file that the box would not start with as it is meant.
  kFaultySettings,
};
inline constexpr std::size_t kMessageCount = 49;

enum class Language : std::uint8_t { kEnglish, kJapanese };

// One row of the table, without the show's name. UTF-8; at most 90 columns, where a Japanese letter has two.
std::string_view Words(Message message, Language language);

// Whether nothing was installed and somebody has to do something about it.
bool IsRefusal(Message message);

// What it is called that the box's own disk took no file: a full one is for the person to mend, anything else is for whoever looks
// after the box. Pure.
Message DiskMessageOf(const Error& error);

// "NAME: WORDS", and "(DETAIL)" behind it where there is one. Pure.
std::string Say(Message message, Language language, std::string_view name, std::string_view detail = {});

}  // namespace kaori::shows
