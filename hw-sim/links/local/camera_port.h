// The lip camera on the local link: frames in shared memory, one for each period.
#pragma once

#include <array>

#include "drivers/base/shared_memory.h"
#include "firmware/wire/link_packets.h"
#include "hw-sim/devices/lip_camera.h"
#include "hw-sim/links/local/link_port.h"

namespace kaori::sim {

// When frames are exposed: the camera's crystal is the clock itself.
struct CameraTiming {
  Time start{};  // Frame n is read out at start + n * period.
  // From frame to frame.
  Duration period{};
};

// As LinkPort. The driver borrows a slot with each frame and gives it back; while it holds all of them,
// frames go by, as at a real camera whose buffers are all with the program. One thread.
class CameraPort final : public LinkPort {
 public:
  // One that the driver looks at, one that waits, one being drawn, one to spare.
  static constexpr std::size_t kSlots = 4;

  // Borrows the camera. `path` and `epoll` are LinkPort's; the camera counts frames from
  // timing.start, whether a driver is there or not.
  CameraPort(std::string path, int epoll, LipCamera& camera, CameraTiming timing)
      : LinkPort(std::move(path), epoll), camera_(camera), timing_(timing) {}

  std::optional<Time> next_due() const override;

 protected:
  bool Greet() override;
  void Handle(std::span<const std::uint8_t> packet) override;
  void SendDue(Time now) override;

 private:
  // Draws a frame into the slot and announces it; a spoilt one goes out as LipCamera says.
  void SendFrame(std::int64_t number, std::size_t slot);
  // The packet of a frame that lies in the slot.
  wire::CameraFrameNote Describe(std::int64_t number, std::size_t slot, std::size_t bytes) const;

  LipCamera& camera_;
  // Of the camera's crystal.
  CameraTiming timing_;
  std::int64_t last_ = -1;           // The newest frame that was read out, sent or not.
  SharedMemory memory_;              // Of all slots; new for each driver.
  std::array<bool, kSlots> lent_{};  // The driver looks at slot n.
};

}  // namespace kaori::sim
