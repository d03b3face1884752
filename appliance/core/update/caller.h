// How kaori-shows, which reads sticks, and kaori-update, which writes the other slot, talk: packets over a Unix socket,
// so that whoever mounts a foreign stick can write no disk, and whoever writes the disk mounts nothing.
//
// A request is one word, with the update's open file beside it where it is about one:
//   "look"     what is it, and may it be taken?     one answer
//   "install"  brings it in                         answers as it goes on; the last is no kReading and no kWriting
//   "waits"    which update waits, or why none      one answer
//   "restart"  tries what waits, or else the        one answer; at kRestarts the machine restarts
//              system before
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "appliance/core/update/messages.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::update {

// Where kaori-update listens; the service manager starts it when somebody calls.
inline constexpr const char* kSocket = "/run/kaori-update-socket";

inline constexpr std::string_view kLook = "look", kInstall = "install", kIsWaiting = "waits",
                                  kRestart = "restart";
inline constexpr std::size_t kLongestPacket_bytes = 1024;

// What kaori-shows makes of it: a line on the screen in two languages, and one in the log.
//
// One answer.
struct Answer {
  Message message = Message::kNothingWaits;
  std::uint32_t version = 0;
  // Of the work, in thousandths.
  std::uint32_t done = 0;
  // A reason, or what is new in it; one line of English.
  std::string detail{};
  friend bool operator==(const Answer&, const Answer&) = default;
  bool is_last() const { return message != Message::kReading && message != Message::kWriting; }
};

// As "9 12 0 why", and back; nothing for another text. A detail that is too long is cut. Pure.
std::string Format(const Answer& answer);
std::optional<Answer> ParseAnswer(std::string_view packet);

// A connection to kaori-update. One thread; nothing blocks but Ask's connecting. The connection's end ends what it
// asked for.
class Caller {
 public:
  // Sends one request. `file` is borrowed; -1: none. Errors: those of ConnectToPeer and SendPacket.
  static Result<Caller> Ask(const std::string& socket, std::string_view request, int file = -1);

  // The newest answer. Errors: resource_unavailable_try_again (there is none yet), no_such_device (kaori-update
  // has ended), bad_message.
  Result<Answer> Read();

 private:
  explicit Caller(UniqueFd connection) : connection_(std::move(connection)) {}
  UniqueFd connection_;
};

}  // namespace kaori::update
