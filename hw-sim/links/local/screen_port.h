// The screen on the local link: shows what was presented at the next vertical blank.
#pragma once

#include "drivers/base/shared_memory.h"
#include "firmware/wire/link_packets.h"
#include "hw-sim/devices/screen.h"
#include "hw-sim/links/local/link_port.h"

namespace kaori::sim {

// As LinkPort, for a driver of ports::Scanout. A picture that is presented twice before a vertical blank
// is shown once, the newer one. One thread.
class ScreenPort final : public LinkPort {
 public:
  // One that is shown, one that is drawn.
  static constexpr std::uint32_t kSlots = 2;

  // Borrows the screen.
  ScreenPort(std::string path, int epoll, Screen& screen)
      : LinkPort(std::move(path), epoll), screen_(screen) {}

  std::optional<Time> next_due() const override;

 protected:
  bool Greet() override;
  void Handle(std::span<const std::uint8_t> packet) override;
  void SendDue(Time now) override;
  void PeerLeft() override { waiting_.reset(); }
  void PowerChanged() override;

 private:
  // Shows the slot, and tells the driver so.
  void Flip(const wire::ScreenPresent& present, Time at);

  Screen& screen_;
  ScreenMode greeted_;                          // The mode that the driver was told.
  SharedMemory drawn_;                          // The memory that it was given.
  SharedMemory shown_;                          // An earlier driver's, while its last picture still stands.
  std::optional<wire::ScreenPresent> waiting_;  // For the next vertical blank.
  std::int64_t last_blank_ = -1;                // The last vertical blank that Pump has seen.
};

}  // namespace kaori::sim
