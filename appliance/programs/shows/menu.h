// What whoever stands before the box sees and does: the list of what is on the stick, which one is marked,
// and the one that was taken. Presses come from the board; nothing is drawn here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/sections.h"
#include "appliance/programs/shows/messages.h"
#include "appliance/programs/shows/stick.h"
#include "drivers/base/clock.h"

namespace kaori::shows {

// One thing that can be taken: a show, a key of somebody's whose shows the box shall play, a show that is on
// the box already, a support file or a backup, which go the other way, a backup that is brought, what a restore
// took away, the list of settings, one of them, a value of it, settings of a file, those before the last change, an
// update of the box, the restart that tries one, the two answers to what a restore and other settings ask, and those to
// whether a key is trusted.
struct Choosable {
  enum class Kind : std::uint8_t {
    kShow,
    kKey,
    kBack,
    kSupport,
    kBackup,
    kRestore,
    kPutBack,
    kSettings,
    kSetting,
    kValue,
    kSettingsFile,
    kSettingsBefore,
    kUpdate,
    kRestart,
    kYes,
    kNo,
    kTrust,
    kDistrust
  } kind = Kind::kShow;
  Offer offer;
  // "48 MB", a key's fingerprint, or what an update says of itself.
  std::string remark;
  // Of a key: what is taken is what was shown, whatever the stick says later.
  show::PublicKey key{};
  // Of a show that is on the box: as in store::Choice. Of a setting, and of a value: the setting's name. Of an answer for a key: the
  // name of its file.
  std::string id{};
};

// Pure but for what it remembers. One thread.
//
// The list is open or shut. It opens when a stick comes, and by the key Page Up; it shuts by Page Up, and
// when nobody has pressed anything for kNobodyChooses: a box that was left with its service key on must play
// the show. While it is open every press is its own, and the show hears PANIC and BLACKOUT alone
// (programs/stage/service_modes.h).
class Menu {
 public:
  static constexpr Duration kNobodyChooses = std::chrono::minutes(2);

  // What can be taken from now on; the first is marked. Presses from before count no more. `left_out` more lie
  // on the stick, which have no number. `notes` stand below, and cannot be taken.
  void Offer(std::vector<Choosable> choices, std::size_t left_out = 0, std::vector<std::string> notes = {});

  // A list without anything in it stays shut.
  void Open(Time now);
  void Shut() { open_until_.reset(); }
  bool IsOpen(Time now) const { return open_until_ && now < *open_until_; }
  bool empty() const { return choices_.empty(); }

  // For a screen elsewhere, which shows the list whether or not it is open here. The number is another one after each Offer.
  std::uint32_t number() const { return number_; }
  // Each with its kind, name and remark.
  std::vector<std::string> Labels() const;
  const std::vector<std::string>& notes() const { return notes_; }
  std::size_t left_out() const { return left_out_; }
  // What stands in this line, from 0, of the list of this number; nothing where that list is gone.
  std::optional<Choosable> LineOf(std::uint32_t number, std::size_t line) const;

  // What can be taken stays; presses from before count no more.
  void ForgetPresses();

  // Looks at the board: a press of a key or button takes the line of its number, the key 0 the tenth; arrow keys move the mark; GO and
  // Enter take the marked one; Page Up opens the list and shuts it. The result is taken now; nothing where
  // nobody took anything.
  std::optional<Choosable> Read(const board::Stamped<board::Keys>& keys,
                                const board::Stamped<board::Surface>& surface,
                                const board::Stamped<board::Lines>& lines, Time now);

  // The lines for a screen, in one language: the message, and below it what can be chosen, or, where the list
  // is shut, how it is opened.
  std::vector<std::string> Lines(Message message, Language language, const std::string& name,
                                 const std::string& detail, bool open) const;

 private:
  // The number, from 0, of what presses took; nothing where they took nothing or only moved the mark.
  std::optional<std::size_t> ReadKeys(const std::vector<std::uint32_t>& codes, Time now);
  std::optional<std::size_t> ReadButtons(const std::vector<std::uint32_t>& codes) const;

  std::vector<Choosable> choices_;
  std::uint32_t number_ = 0;
  std::size_t left_out_ = 0;
  std::vector<std::string> notes_;
  std::size_t marked_ = 0;
  std::optional<Time> open_until_;
  // Counters as they stood at the last look; nothing before the first.
  std::optional<std::uint32_t> keys_seen_, buttons_seen_, go_seen_;
};

}  // namespace kaori::shows
