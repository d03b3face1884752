// The lips' end of the connection to a desk: commands come in, reports and small pictures go out, and nothing
// blocks. The protocol is in protocol/protocol.h; the desk's end of it is desk/lip_connection.h.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "appliance/programs/lips/paint_key.h"
#include "appliance/programs/lips/protocol/protocol.h"
#include "drivers/base/clock.h"
#include "drivers/base/shared_memory.h"
#include "drivers/base/unique_fd.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// The newest desk replaces an older one. A desk that is slow loses packets, and one that is gone or sends
// nonsense loses its connection; the lips lose nothing. Pictures are drawn only while a desk asks for them,
// 15 a second at most. Used by one thread.
class DeskConnection {
 public:
  // Listens at `path`, and removes the socket's file at the end. Errors: those of the socket.
  static Result<DeskConnection> Open(const std::string& path);
  DeskConnection(DeskConnection&&) = default;
  DeskConnection& operator=(DeskConnection&&) = delete;
  // Removes the socket's file, so that desks see at once that nobody listens.
  ~DeskConnection();

  // Returns the commands that arrived; requests for pictures and returned slots are handled here. It accepts
  // a desk that waits, too. At most 64 commands at once.
  std::vector<Command> ReceiveCommands(Time now);

  // Sends the report when it changed, and ten times a second. Without a desk it does nothing.
  void SendReport(const Report& report, Time now);

  // Sends a small picture where one is wanted and due. The planes are borrowed for the call.
  void SendPicture(const decode::Planes& planes, const PaintKey& key, Time now);

 private:
  DeskConnection(UniqueFd listener, std::string path)
      : listener_(std::move(listener)), path_(std::move(path)) {}
  // Takes the newest desk that waits, in place of the one there is.
  void Accept();
  // Handles kLook and kReturn.
  void HandlePictureCommand(const Command& command, Time now);
  // Sends a packet, with a descriptor where one is given. False: there is no desk, or it does not read.
  bool Send(const std::vector<std::uint8_t>& packet, int descriptor = -1);

  UniqueFd listener_;
  std::string path_;
  UniqueFd peer_;
  // Where small pictures are drawn; made anew for each desk.
  SharedMemory pictures_;
  std::array<bool, kPictureSlots> in_use_{};  // The desk has not given the slot back yet.
  std::uint32_t number_ = 0;
  // Until when a desk wants pictures, and when the last one and the last report were sent.
  Time wanted_until_{};
  Time picture_at_{};
  Time report_at_{};
  Report sent_;
};

}  // namespace kaori::lips
