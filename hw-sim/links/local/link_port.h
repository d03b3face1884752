// A socket of the link folder with one simulated device behind it: keeps the newest driver, and lets it go.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::sim {

// One thread; nothing blocks. What a driver does wrong ends its connection, never the simulator.
class LinkPort {
 public:
  LinkPort(const LinkPort&) = delete;
  LinkPort& operator=(const LinkPort&) = delete;
  virtual ~LinkPort() = default;

  // Errors: those of the socket.
  Result<void> Plug();
  void Unplug();
  bool plugged() const { return listener_.valid(); }
  bool connected() const { return peer_.valid(); }

  // Accepts, receives, and sends what is due.
  void Pump(Time now);

  // When Pump has something to send, though the socket is silent.
  virtual std::optional<Time> next_due() const = 0;

 protected:
  // `epoll` gets the sockets, and outlives the port.
  LinkPort(std::string path, int epoll) : path_(std::move(path)), epoll_(epoll) {}

  int peer() const { return peer_.get(); }
  const std::string& path() const { return path_; }
  void HangUp();
  // Sends now; a peer that is gone is let go of. False: the packet did not leave.
  bool Send(std::span<const std::uint8_t> packet, int descriptor = -1);

  virtual bool Greet() = 0;  // A driver came: says hello. False: no use.
  virtual void Handle(std::span<const std::uint8_t> packet) = 0;
  virtual void SendDue(Time now) = 0;
  virtual void PeerLeft() {}
  virtual void PowerChanged() {}

 private:
  void Accept();
  void Receive();
  void Join(int fd);

  std::string path_;
  int epoll_;
  UniqueFd listener_;
  UniqueFd peer_;
};

}  // namespace kaori::sim
