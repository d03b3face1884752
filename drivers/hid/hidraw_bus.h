// The HID devices that the kernel has, found and watched with libudev.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/hid_channel.h"

struct udev;
struct udev_device;
struct udev_monitor;

namespace kaori::hid {

class HidrawChannel;

// As ports::HidBus. A port is the USB port path, "1-4.2"; an interface after the first of one device adds its
// name, "1-4.2:1.1". A device without USB goes by its physical place (of Bluetooth the receiver: all of its
// devices share it) and by its own address where it has one, or else by its kernel name.
class HidrawBus final : public ports::HidBus {
 public:
  // Borrows `clock` for its life. Errors: those of libudev.
  static Result<std::unique_ptr<HidrawBus>> Open(const Clock& clock);

  int pollable() const override;
  Result<std::vector<std::string>> Ports() override;
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  struct Unref {
    void operator()(udev* handle) const;
    void operator()(udev_monitor* handle) const;
    void operator()(udev_device* handle) const;
  };
  struct Node {
    std::string path;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    std::string name;
  };
  explicit HidrawBus(const Clock& clock) : clock_(clock) {}
  bool DrainNotices();
  Result<void> Scan();
  void Add(udev_device* device);
  void Ask(HidrawChannel& channel);

  const Clock& clock_;
  std::unique_ptr<udev, Unref> udev_;
  std::unique_ptr<udev_monitor, Unref> monitor_;
  std::map<std::string, Node> nodes_;  // By port.
  std::set<std::pair<std::uint16_t, std::uint16_t>>
      mute_;  // Vendors and products that do not say how they stand.
  bool scanned_ = false;
};

}  // namespace kaori::hid
