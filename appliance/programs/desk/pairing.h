// Who may use the desk: a code of six digits on the box's own screen lets a visitor in for the evening.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/programs/desk/chance.h"
#include "drivers/base/clock.h"

namespace kaori::desk {

enum class Verdict : std::uint8_t { kIn, kWrong, kWait };

// A code lasts five minutes and lets one visitor in; then there is another one. Five wrong tries within a
// minute, from whoever, and nobody is heard until the minute is over. Four sessions live at a time, for eight
// hours each, in memory only. Borrows the clock.
class Pairing {
 public:
  explicit Pairing(const Clock& clock, Chance chance = FillByChance);

  // Gives the new session's name in `session` where the code is right.
  Verdict Try(std::string_view code, std::string& session);

  bool Knows(std::string_view session) const;
  void Leave(std::string_view session);
  std::size_t sessions() const { return sessions_.size(); }

  // A visitor without a session came: the code is shown again.
  void Ask();

  // Forgets what is over. True: something about the code changed.
  bool Step();

  // Shown while nobody is paired, and for a while when somebody asks.
  bool shown() const;
  std::uint32_t code() const { return code_; }  // 0 .. 999999.
  Duration valid() const;                       // From now on.

 private:
  struct Session {
    std::string name;
    Time until;
  };
  void RenewCode();
  bool IsCode(std::string_view text) const;
  std::string NewName() const;

  const Clock& clock_;
  Chance chance_;
  std::uint32_t code_ = 0;
  Time code_until_{};
  Time shown_until_{};
  std::vector<Time> wrong_;  // Of the last minute.
  std::vector<Session> sessions_;
  bool changed_ = true;
  bool was_shown_ = false;
};

}  // namespace kaori::desk
