// HID devices that the simulator plugs into a link folder.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::hid {

// As ports::HidBus, over a link folder (firmware/wire/link.h). A port is listed once its device has
// sent its hello; pollable() is readable for that too. The folder is made where it is missing, and
// watched anew after it vanished. No call blocks. One thread.
class LocalHidBus final : public ports::HidBus {
 public:
  // Watches the folder and connects to what is there. Errors: those of
  // epoll_create1(2), inotify_init1(2) and inotify_add_watch(2).
  static Result<std::unique_ptr<ports::HidBus>> Watch(const std::string& folder);

  int pollable() const override { return epoll_.get(); }
  Result<std::vector<std::string>> Ports() override;

  // Moves the connection into the channel; the port stays listed until it is unplugged.
  // A second Open of a port connects again, and says device_or_resource_busy until the
  // device has sent its hello (pollable() is readable then).
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  // kBusy: its queue of connections is full; the next Open connects again. kConnecting: no
  // hello yet. kReady: it has come, and Open may have the connection. kOpened: a channel has
  // it. kRefused: nobody listens, or what was said is no hello.
  enum class State { kConnecting, kBusy, kReady, kOpened, kRefused };
  // A connection to the device at a port, until its channel gets it.
  struct Connection {
    State state = State::kConnecting;
    // Becomes the channel's with Open.
    UniqueFd socket;
    // Of the hello; valid in kReady.
    ports::HidIdentity identity;
  };

  LocalHidBus(std::string folder, UniqueFd epoll) : folder_(std::move(folder)), epoll_(std::move(epoll)) {}
  // Makes and watches the folder, and connects to every device in it. Errors: those of
  // inotify_init1(2) and inotify_add_watch(2).
  Result<void> WatchFolder();
  // Applies the folder's pending notices. Errors: those of watching it anew.
  Result<void> DrainNotices();
  // Drops what is known of a port, and connects anew where its socket exists.
  void Refresh(const std::string& port);
  // Connects to the port's socket; the hello is awaited without blocking.
  void Connect(const std::string& port);
  // Reads the hello where it has come, and settles the connection's state by it.
  void ReceiveHello(const std::string& port, Connection& connection);
  // The socket of a port: "<folder>/hid.<port>".
  std::string PathOf(const std::string& port) const;

  // Where simulators make their sockets.
  std::string folder_;
  // Of the watch and all connections that wait for a hello.
  UniqueFd epoll_;
  UniqueFd watch_;         // inotify on the folder.
  bool watching_ = false;  // The folder was there when it was last looked for.
  // By port.
  std::map<std::string, Connection> connections_;
};

}  // namespace kaori::hid
