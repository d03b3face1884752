// The simulator's screen: frames in shared memory, flips by packets.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/shared_memory.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/scanout.h"
#include "drivers/scanout/local_monitor.h"
#include "firmware/wire/link_packets.h"

namespace kaori::scanout {

// As ports::Scanout, over the local link (firmware/wire/link.h): the simulator is the display, and its
// clock gives the vertical blanks. Slots go round in order; one frame is under way at a time. One thread.
class LocalScreen final : public ports::Scanout {
 public:
  // Connects to the socket "<folder>/screen.<port>". Until the screen has answered, Acquire says
  // resource_unavailable_try_again; pollable() is readable once it has, and the next call reads the answer.
  // Errors: no_such_device (nobody listens), permission_denied.
  static Result<std::unique_ptr<ports::Scanout>> Open(const std::string& folder,
                                                      const std::string& port = "screen");

  // Owns the connected socket; the hello is read by the first call that needs it. In `folder` the operators'
  // monitor is looked for; empty: there is none.
  explicit LocalScreen(UniqueFd socket, std::string folder = "")
      : socket_(std::move(socket)), folder_(std::move(folder)) {}

  int pollable() const override { return socket_.get(); }
  Result<ports::PixelBuffer> Acquire() override;
  Result<void> Present(std::uint64_t frame) override;
  Result<ports::Flip> ReadFlip() override;
  // Null while nobody shows one; looked for at each call.
  ports::SideDisplay* monitor_display() override;
  // One output named "simulator", once the screen has answered and as long as it is there.
  std::vector<ports::Output> outputs() const override;

 private:
  // Reads the hello, and maps the memory that came with it. Errors: as Receive.
  Result<void> ReadHello();
  // The next packet's length. Errors: resource_unavailable_try_again (there is none), no_such_device.
  Result<std::size_t> Receive(std::span<std::uint8_t> into, UniqueFd* descriptor);
  // Of one slot: R, G, B, X without padding.
  std::size_t picture_bytes() const { return std::size_t{hello_.width_px} * hello_.height_px * 4; }

  UniqueFd socket_;
  std::string folder_;
  std::unique_ptr<LocalMonitor> monitor_;
  // Zeroes until the screen has answered.
  wire::ScreenHello hello_;
  // All slots, one behind another.
  SharedMemory memory_;
  std::uint32_t next_slot_ = 0;  // The slot to draw into: never the one that is shown.
  // Acquire gave the slot away, and Present has not yet come.
  bool acquired_ = false;
  std::optional<std::uint64_t> presented_;  // Waits for its flip.
  // The simulator hung up: every later call fails.
  bool gone_ = false;
};

}  // namespace kaori::scanout
