// What is said to whoever installs a show, in English and Japanese: one table, in words of the theatre.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kaori::shows {

// How an installation ended, or how far it is. Each has a row in the table.
enum class Message : std::uint8_t {
  kPlugIn,        // The stick was taken out before anything was taken.
  kNoShow,        // There is no show on the stick.
  kShut,          // The list is shut: how it is opened.
  kChoose,        // Several are there, or one: which one is to be taken?
  kCopying,       // On the way.
  kTrying,        // Checked; its scenes are drawn once.
  kInstalled,     // It is on the box and chosen; the stage has not begun it yet.
  kPlays,         // The stage plays it.
  kAlreadyThere,  // It is what is chosen, and whole.
  kKeyTaken,      // A public key was kept: shows that it signed will play.
  kWriting,       // The support file is on its way to the stick.
  kWritten,       // It is there.
  kNotAShow,      // Another kind of file.
  kDamaged,       // Its checksum or its signature does not fit.
  kCutOff,        // Its end is missing.
  kUnsigned,
  kForeign,  // Signed, by a key that the box does not trust.
  kNoKeys,   // The box trusts nobody.
  kTooLarge,
  kNewerFormat,
  kOlderFormat,
  kFull,             // The data partition has no room.
  kPulled,           // The stick was pulled, or cannot be read.
  kUnreadable,       // A stick of another file system.
  kDiskFault,        // The box's own disk cannot be written.
  kUnplayable,       // It is whole and trusted, and does not play.
  kKeyOff,           // The service key was turned back on the way.
  kStickFull,        // The stick has no room for the support file.
  kStickUnwritable,  // It cannot be written, or does not hold what was written.
  kSupportPulled,    // It was pulled while the support file was written.
};
inline constexpr std::size_t kMessageCount = 30;

enum class Language : std::uint8_t { kEnglish, kJapanese };

// One row of the table, without the show's name. UTF-8; at most 90 columns, where a Japanese letter has two.
std::string_view Words(Message message, Language language);

// Whether nothing was installed and somebody has to do something about it.
bool IsRefusal(Message message);

// "NAME: WORDS", and "(DETAIL)" behind it where there is one. Pure.
std::string Say(Message message, Language language, std::string_view name, std::string_view detail = {});

}  // namespace kaori::shows
