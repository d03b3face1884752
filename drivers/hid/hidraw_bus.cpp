#include "drivers/hid/hidraw_bus.h"

#include <fcntl.h>
#include <libudev.h>
#include <poll.h>

#include <charconv>
#include <optional>
#include <string_view>

#include "drivers/base/long_call.h"
#include "drivers/base/open_cause.h"
#include "drivers/decode/recognise.h"
#include "drivers/hid/hidraw_channel.h"

namespace kaori::hid {
namespace {

// The kernel's class of nodes that give reports without interpreting them (Documentation/hid/hidraw.rst).
constexpr const char* kSubsystem = "hidraw";
// bInterfaceNumber of a device's first interface: it is named by the device's port alone.
constexpr std::string_view kFirstInterface = "00";

struct EnumerateUnref {
  void operator()(udev_enumerate* handle) const { udev_enumerate_unref(handle); }
};

// libudev returns null for what a device does not have.
std::string_view Text(const char* text) {
  return text != nullptr ? text : std::string_view{};
}

// The middle and last numbers of HID_ID, "0003:00001209:00000001":
// bus, vendor, product. 0 where there are none.
std::uint16_t HexAt(std::string_view id, std::size_t at) {
  std::uint32_t value = 0;
  if (id.size() >= at + 8) std::from_chars(id.data() + at, id.data() + at + 8, value, 16);
  return static_cast<std::uint16_t>(value);
}

// Borrows from `device`; null without a USB interface above it.
std::optional<std::string> UsbPort(udev_device* device) {
  // A hidraw node is a child of the HID device, and that one of a USB
  // interface; the device is above the interface.
  udev_device* interface = udev_device_get_parent_with_subsystem_devtype(device, "usb", "usb_interface");
  udev_device* usb = udev_device_get_parent_with_subsystem_devtype(device, "usb", "usb_device");
  if (interface == nullptr || usb == nullptr) return std::nullopt;
  const auto number = Text(udev_device_get_sysattr_value(interface, "bInterfaceNumber"));
  return std::string(Text(udev_device_get_sysname(number == kFirstInterface ? usb : interface)));
}

// The name of the port, as the header says.
std::string PortOf(udev_device* device, udev_device* hid) {
  if (const auto usb = UsbPort(device)) return *usb;
  const auto phys = Text(udev_device_get_property_value(hid, "HID_PHYS"));
  const auto uniq = Text(udev_device_get_property_value(hid, "HID_UNIQ"));
  if (phys.empty()) return std::string(uniq.empty() ? Text(udev_device_get_sysname(hid)) : uniq);
  return std::string(phys) + (uniq.empty() ? "" : "/") + std::string(uniq);
}

}  // namespace

void HidrawBus::Unref::operator()(udev* handle) const {
  udev_unref(handle);
}
void HidrawBus::Unref::operator()(udev_monitor* handle) const {
  udev_monitor_unref(handle);
}
void HidrawBus::Unref::operator()(udev_device* handle) const {
  udev_device_unref(handle);
}

Result<std::unique_ptr<HidrawBus>> HidrawBus::Open(const Clock& clock) {
  std::unique_ptr<HidrawBus> bus(new HidrawBus(clock));
  bus->udev_.reset(udev_new());
  if (!bus->udev_) return FailErrno("open udev");
  // "udev" are the notices that udevd sends on after its rules ran:
  // only then has the node its access rights.
  bus->monitor_.reset(udev_monitor_new_from_netlink(bus->udev_.get(), "udev"));
  if (!bus->monitor_) return FailErrno("watch udev");
  if (udev_monitor_filter_add_match_subsystem_devtype(bus->monitor_.get(), kSubsystem, nullptr) < 0 ||
      udev_monitor_enable_receiving(bus->monitor_.get()) < 0)
    return FailErrno("watch udev for hidraw devices");
  return bus;
}

int HidrawBus::pollable() const {
  return udev_monitor_get_fd(monitor_.get());
}

Result<std::vector<std::string>> HidrawBus::Ports() {
  // Devices are listed anew only after a notice: a listing reads several files of sysfs for each device.
  if (DrainNotices() || !scanned_) {
    if (auto ok = Scan(); !ok) return tl::unexpected(ok.error());
  }
  std::vector<std::string> ports;
  for (const auto& [port, node] : nodes_) ports.push_back(port);
  return ports;
}

// Many notices at once may overrun the socket: then it is readable, but gives no device.
bool HidrawBus::DrainNotices() {
  pollfd notices{.fd = pollable(), .events = POLLIN, .revents = 0};
  const bool any = ::poll(&notices, 1, 0) > 0;
  // The monitor's socket does not block, so null ends the loop;
  // receiving also gives a broken notice as null.
  while (const std::unique_ptr<udev_device, Unref> device{udev_monitor_receive_device(monitor_.get())}) {
  }
  return any;
}

// Lists all devices instead of applying notices one by one, so that lost notices do no harm. On a busy machine the files of
// sysfs that are read for it take a second, while the kernel makes a device.
Result<void> HidrawBus::Scan() {
  ExpectLongCall();
  const std::unique_ptr<udev_enumerate, EnumerateUnref> found(udev_enumerate_new(udev_.get()));
  if (!found || udev_enumerate_add_match_subsystem(found.get(), kSubsystem) < 0 ||
      udev_enumerate_scan_devices(found.get()) < 0)
    return FailErrno("list hidraw devices");
  nodes_.clear();
  udev_list_entry* entry = nullptr;
  udev_list_entry_foreach(entry, udev_enumerate_get_list_entry(found.get())) {
    const std::unique_ptr<udev_device, Unref> device(
        udev_device_new_from_syspath(udev_.get(), udev_list_entry_get_name(entry)));
    if (device) Add(device.get());  // Null: pulled meanwhile.
  }
  scanned_ = true;
  return {};
}

// Ids and name are the HID device's, of which the node is a child.
void HidrawBus::Add(udev_device* device) {
  udev_device* hid = udev_device_get_parent_with_subsystem_devtype(device, "hid", nullptr);
  const auto path = Text(udev_device_get_devnode(device));
  // The device was pulled while it was read.
  if (hid == nullptr || path.empty()) return;
  const auto id = Text(udev_device_get_property_value(hid, "HID_ID"));
  nodes_[PortOf(device, hid)] =
      Node{.path = std::string(path),
           .vendor = HexAt(id, 5),
           .product = HexAt(id, 14),
           .name = std::string(Text(udev_device_get_property_value(hid, "HID_NAME")))};
}

// A device that is pulled between its notice and the opening gives no_such_device, as one that was never
// there. Its state is asked for at once, since a switch that stands sends no report.
Result<std::unique_ptr<ports::HidChannel>> HidrawBus::Open(const std::string& port) {
  const auto it = nodes_.find(port);
  if (it == nodes_.end()) return Fail(std::errc::no_such_device, "open " + port);
  const Node& node = it->second;
  // Reading and writing: a lamp's report goes through the same node.
  UniqueFd fd(::open(node.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (!fd.valid()) return Fail(CauseOfOpen(errno), "open " + node.path + " at " + port);
  auto descriptor = ReadHidrawDescriptor(fd.get());
  if (!descriptor) return Fail(std::errc::no_such_device, descriptor.error().attempt + " at " + port);
  auto channel = std::make_unique<HidrawChannel>(std::move(fd),
                                                 ports::HidIdentity{.port = port,
                                                                    .vendor = node.vendor,
                                                                    .product = node.product,
                                                                    .name = node.name,
                                                                    .descriptor = std::move(*descriptor)},
                                                 clock_);
  RequestInitialReports(*channel);
  return channel;
}

// A device that does not answer blocks the loop for 5 s: no other one of its kind is asked again.
void HidrawBus::RequestInitialReports(HidrawChannel& channel) {
  const ports::HidIdentity& identity = channel.identity();
  const auto layout = decode::LayoutOf(identity);
  const std::pair kind(identity.vendor, identity.product);
  if (!layout || silent_kinds_.contains(kind)) return;
  // The opening may have taken its time already: whoever watches is told of this call anew.
  ExpectLongCall();
  const auto asked = channel.RequestInitialReports(decode::InitialReportsOf(*layout));
  if (!asked && asked.error().cause == std::errc::timed_out) silent_kinds_.insert(kind);
}

}  // namespace kaori::hid
