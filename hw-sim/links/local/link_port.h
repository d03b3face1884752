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

// What all kinds of devices share: the listening socket, one driver at a time, and its packets. A kind
// adds its hello, its packets and what is due. One thread; nothing blocks. What a driver does wrong
// ends its connection, never the simulator.
class LinkPort {
 public:
  LinkPort(const LinkPort&) = delete;
  LinkPort& operator=(const LinkPort&) = delete;
  virtual ~LinkPort() = default;

  // Makes the socket, which is what a driver sees as a device that was plugged in; does nothing where it
  // is plugged already. Errors: those of ListenForPackets.
  Result<void> Plug();
  // Hangs up and removes the socket.
  void Unplug();
  // A driver finds the socket.
  bool plugged() const { return listener_.valid(); }
  // A driver has the device open.
  bool connected() const { return peer_.valid(); }

  // Accepts, receives, and sends what is due. A driver that talks without end is stopped after some
  // hundred packets and goes on with the next call.
  void Pump(Time now);

  // When Pump has something to send, though the socket is silent. Nothing while
  // it waits for a packet or a driver.
  virtual std::optional<Time> next_due() const = 0;

 protected:
  // `path` is that of the socket. `epoll` is a descriptor that gets the sockets, and
  // outlives the port. Unplugged at first.
  LinkPort(std::string path, int epoll) : path_(std::move(path)), epoll_(epoll) {}

  // -1 while nobody is connected.
  int peer() const { return peer_.get(); }
  const std::string& path() const { return path_; }
  // Ends the connection; the driver may come again.
  void HangUp();
  // Sends now; a peer that is gone is let go of. False: the packet did not leave.
  bool Send(std::span<const std::uint8_t> packet, int descriptor = -1);

  // A driver came: sends the hello. False: that failed, and the connection ends.
  virtual bool Greet() = 0;
  // A packet of the driver; the bytes are borrowed for the call.
  virtual void Handle(std::span<const std::uint8_t> packet) = 0;
  // Sends what is due at `now`. Called while a driver is connected.
  virtual void SendDue(Time now) = 0;
  // The driver has gone, or was replaced by a newer one.
  virtual void PeerLeft() {}
  // The cable was put in or pulled.
  virtual void PowerChanged() {}

 private:
  // Lets the newest driver in; a driver before it is hung up on.
  void Accept();
  // Reads the driver's packets, some hundred at most.
  void Receive();
  // Adds a descriptor to the epoll set; its number is all that the set knows of it.
  void Join(int fd);

  std::string path_;
  int epoll_;
  UniqueFd listener_;
  // The driver that has the device; one at a time.
  UniqueFd peer_;
};

}  // namespace kaori::sim
