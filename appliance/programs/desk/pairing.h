// Who may use the desk: a code of six digits on the box's own screen authorises a visitor for the evening.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/programs/desk/random_bytes.h"
#include "drivers/base/clock.h"

namespace kaori::desk {

// What became of a code that was tried; kLocked: too many were wrong within the last minute.
enum class Verdict : std::uint8_t { kAccepted, kWrongCode, kLocked };

// A code is valid for five minutes and for one visitor; then there is another one. After five wrong codes
// within a minute, by any visitors, all codes are refused until that minute is over. There are four sessions
// at most, for eight hours each, in memory only; a fifth ends the oldest. Used by one thread. Borrows the
// clock.
class Pairing {
 public:
  // Tests give random bytes of their own, and so know the code.
  explicit Pairing(const Clock& clock, RandomBytes random_bytes = FillWithKernelRandom);

  // Tries a code. If it is right, `session` is set to the name of a new session, 64 hexadecimal digits; else
  // it is left as it is.
  Verdict Try(std::string_view code, std::string& session);

  // Whether this session exists and has not run out. An empty name is none.
  bool Knows(std::string_view session) const;
  // Ends it, if there is one of this name.
  void EndSession(std::string_view session);
  // Sessions that have not run out, as of the last Step.
  std::size_t sessions() const { return sessions_.size(); }

  // Shows the code again, for a visitor without a session. It is shown for two minutes, and longer where
  // nobody is authorised.
  void RequestCode();

  // Ends what has expired. Returns whether the code, or whether it is shown, changed since the last call.
  bool Step();

  // Whether the box shows the code: while there is no session, and for a while after RequestCode().
  bool shown() const;
  // The code, 0 .. 999999; people see it with leading zeros.
  std::uint32_t code() const { return code_; }
  // How much longer the code is valid.
  Duration valid() const;

 private:
  // A visitor who is authorised, until that time.
  struct Session {
    std::string name;
    Time until;
  };
  // Makes another code, whose five minutes begin now.
  void RenewCode();
  bool IsCode(std::string_view text) const;
  // A name that nobody can guess.
  std::string NewName() const;

  const Clock& clock_;
  RandomBytes random_bytes_;
  // The code, until when it is valid, and until when it is shown though there are sessions.
  std::uint32_t code_ = 0;
  Time code_until_{};
  Time shown_until_{};
  // The times of wrong codes within the last minute.
  std::vector<Time> wrong_;
  std::vector<Session> sessions_;
  // What Step has to report: a new code, or whether it is shown.
  bool changed_ = true;
  bool was_shown_ = false;
};

}  // namespace kaori::desk
