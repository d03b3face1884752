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

// As ports::HidBus. A port is the USB port path, "1-4.2"; a device's second interface and
// those after it add the interface's name, "1-4.2:1.1". A device without USB is named by its
// HID_PHYS and its HID_UNIQ (of Bluetooth these are the receiver, which all of its devices
// share, and the device's address), or else by its kernel name.
// Open blocks while a joystick is asked for its position: about 1 ms, and 5 s once for
// each kind of device that does not answer. One thread.
class HidrawBus final : public ports::HidBus {
 public:
  // Subscribes to udev's notices; nothing is listed before Ports. `clock` stamps reports.
  // It must outlive the bus and its channels. Errors: those of libudev:
  // too_many_files_open, and whatever netlink(7) refuses.
  static Result<std::unique_ptr<HidrawBus>> Open(const Clock& clock);

  int pollable() const override;
  Result<std::vector<std::string>> Ports() override;
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  // libudev counts references; each pointer here owns one.
  struct Unref {
    void operator()(udev* handle) const;
    void operator()(udev_monitor* handle) const;
    void operator()(udev_device* handle) const;
  };
  // A device as udev tells it, before its node is opened.
  struct Node {
    // Of the node: "/dev/hidraw3".
    std::string path;
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    // The device's own name, for people; may be empty.
    std::string name;
  };
  explicit HidrawBus(const Clock& clock) : clock_(clock) {}
  // Reads every notice; true where there was one. What they say does not matter.
  bool DrainNotices();
  // Makes `nodes_` anew: some files of sysfs are read for each device. Errors: those of libudev.
  Result<void> Scan();
  // Adds a hidraw device to `nodes_`; borrows it. A device that vanished meanwhile is left out.
  void Add(udev_device* device);
  // Has a joystick tell where it stands (initial_reports.h). Fails silently: the first report then tells.
  void RequestInitialReports(HidrawChannel& channel);

  // Stamps the reports of every channel that this bus opens.
  const Clock& clock_;
  // Owns one reference; the monitor has one of its own.
  std::unique_ptr<udev, Unref> udev_;
  // Hears of hidraw nodes that come and go.
  std::unique_ptr<udev_monitor, Unref> monitor_;
  std::map<std::string, Node> nodes_;  // By port.
  // Vendors and products that answered no request for initial reports.
  std::set<std::pair<std::uint16_t, std::uint16_t>> silent_kinds_;
  // False until the first Ports: devices that were plugged in before have no notice.
  bool scanned_ = false;
};

}  // namespace kaori::hid
