// HID devices that the simulator plugs into a link folder.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::hid {

// A port is listed once its device has said hello, so pollable() also wakes for that. The folder is made
// where it is missing, and watched anew after it vanished.
class LocalHidBus final : public ports::HidBus {
 public:
  // Errors: those of making and watching the folder.
  static Result<std::unique_ptr<ports::HidBus>> Watch(const std::string& folder);

  int pollable() const override { return epoll_.get(); }
  Result<std::vector<std::string>> Ports() override;

  // Hands the greeted connection over; the port stays listed until it is unplugged. A second Open of a port
  // calls its device again: device_or_resource_busy until it has answered (pollable() wakes then).
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  // kBusy: too many call it; the next Open calls again.
  enum class State { kCalling, kBusy, kGreeted, kOpened, kRefused };
  struct Line {
    State state = State::kCalling;
    UniqueFd socket;
    ports::HidIdentity identity;
  };

  LocalHidBus(std::string folder, UniqueFd epoll) : folder_(std::move(folder)), epoll_(std::move(epoll)) {}
  Result<void> WatchFolder();
  Result<void> DrainNotices();
  void LookAt(const std::string& port);
  void Call(const std::string& port);
  void Answer(const std::string& port, Line& line);
  std::string PathOf(const std::string& port) const;

  std::string folder_;
  UniqueFd epoll_;
  UniqueFd watch_;         // inotify on the folder.
  bool watching_ = false;  // The folder was there when it was last looked for.
  std::map<std::string, Line> lines_;
};

}  // namespace kaori::hid
