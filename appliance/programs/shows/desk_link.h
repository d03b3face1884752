// The connection of kaori-shows to kaori-desk: what a paired visitor asks for comes in, the state goes out (protocol/protocol.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "appliance/programs/shows/protocol/protocol.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::shows {

// One thread; nothing blocks. One desk is heard at a time: a new connection takes the place of the one before, since a desk that
// was started again has no use for its old one.
class DeskLink {
 public:
  // Listens at `path`, which the group of this program may use too; whoever calls and is not the user `desk` is hung up on.
  // Errors: those of ListenForPackets.
  static Result<DeskLink> Open(const std::string& path, std::uint32_t desk);

  // The next request; nothing where none waits. A desk that sends anything else is hung up on.
  std::optional<Request> Hear();
  // A desk is there, to be told the state.
  bool connected() const { return desk_.valid(); }
  // Sends the state where it is not the one that the desk has. What it cannot take now is sent by a later call. One that is
  // longer than a packet is not sent.
  void Tell(const std::string& state);
  // Hands the desk a backup of this name. Errors: those of SendPacket.
  Result<void> Give(const std::string& name, UniqueFd backup);
  // The name of the one that the desk of now got last; empty where it has none.
  const std::string& given() const { return given_; }

 private:
  DeskLink(UniqueFd listener, std::uint32_t user) : listener_(std::move(listener)), user_(user) {}
  // The newest connection that waits, if its program is the desk's.
  void Accept();
  void HangUp();

  UniqueFd listener_;
  std::uint32_t user_;
  UniqueFd desk_;
  // What the desk of now has; empty where it has nothing yet.
  std::string told_, given_;
};

}  // namespace kaori::shows
