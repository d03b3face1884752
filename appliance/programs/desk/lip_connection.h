// The desk's end of the connection to the lips: sends commands, receives reports, and copies pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "appliance/programs/lips/protocol/protocol.h"
#include "drivers/base/clock.h"
#include "drivers/base/shared_memory.h"
#include "drivers/base/unique_fd.h"

namespace kaori::desk {

// Used by one thread; nothing blocks. While the lips are gone it tries to connect four times a second. The
// protocol is in lips/protocol: text commands go out, reports and notes of pictures come in, and the pictures
// themselves lie in shared memory, whose descriptor comes with the first packet.
class LipConnection {
 public:
  // `path` is that of the lips' socket (lips::ServicePath); nothing is connected yet.
  explicit LipConnection(std::string path) : path_(std::move(path)) {}

  // Connects, and handles the packets that wait. Call it every 20 ms or sooner.
  void Step(Time now);

  // Whether the lips answer, from the first report of a connection on until it ends; and their newest report,
  // which is empty while they do not.
  bool live() const { return report_.has_value(); }
  const std::optional<lips::Report>& report() const { return report_; }

  // Numbers the command and sends it. Returns the number, which the report names once the command was
  // executed. Errors:
  //   no_such_device                    the lips do not answer
  //   resource_unavailable_try_again    the lips read too slowly; other errors are those of the socket
  Result<std::uint32_t> Send(lips::Command command);

  // Requests pictures for the next two seconds. Call it as long as a visitor looks at them. It sends at most
  // two requests a second, however often it is called.
  void RequestPictures(Time now);

  struct Picture {
    std::uint32_t number = 0;  // Counts the pictures; 0: none has arrived yet.
    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint8_t> rgbp;  // R, G, B and paint of each pixel, top row first.
  };
  // The newest picture, a copy of its own; it stays when the lips are gone. Valid until the next Step.
  const Picture& picture() const { return picture_; }

 private:
  // Tries to connect; not again before a quarter of a second has passed.
  void Connect(Time now);
  // Handles all packets that wait, 64 at most.
  void ReceivePackets();
  // Handles one packet; `descriptor` is what came with it. False: it breaks the protocol.
  bool Handle(std::span<const std::uint8_t> packet, UniqueFd descriptor);
  // Copies a picture out of the shared memory and gives its slot back.
  void Copy(const lips::PictureNote& note);
  // Sends a command as it is, with the number that it has.
  Result<void> SendNow(const lips::Command& command);
  // Forgets the connection and what belonged to it.
  void Disconnect();

  std::string path_;
  UniqueFd socket_;
  // The lips' memory, mapped for reading pictures; not valid before the hello.
  SharedMemory pictures_;
  std::optional<lips::Report> report_;
  Picture picture_;
  // The number of the newest command; numbers go on from the highest that the lips have answered.
  std::uint32_t number_ = 0;
  // No connection is tried before the first time, and no pictures are asked for before the second.
  Time retry_at_{};
  Time request_at_{};
};

}  // namespace kaori::desk
