#include "tests/drivers/hid_mock_device.h"

#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <umockdev.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace kaori::tests {
namespace {

std::string UsbDir(const std::string& usb_port) {
  return "/devices/pci0000:00/usb1/" + usb_port;
}
std::string InterfaceDir(const std::string& usb_port, int interface) {
  return fmt::format("{}/{}:1.{}", UsbDir(usb_port), usb_port, interface);
}
// The kernel numbers HID devices through; here the number is that of the node.
std::string HidDir(const std::string& usb_port, int interface, const std::string& node) {
  return fmt::format("{}/0003:1209:0001.000{}", InterfaceDir(usb_port, interface), node.back());
}

void Add(UMockdevTestbed* testbed, const std::string& device) {
  GError* error = nullptr;
  EXPECT_TRUE(umockdev_testbed_add_from_string(testbed, device.c_str(), &error)) << error->message;
}

UMockdevIoctlData* Argument(UMockdevIoctlClient* client, std::size_t bytes) {
  return umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, bytes, nullptr);
}

void Put(UMockdevIoctlData* into, std::size_t offset, std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  umockdev_ioctl_data_update(into, offset, copy.data(), static_cast<int>(copy.size()));
}

}  // namespace

bool InMockKernel() {
  std::ifstream maps("/proc/self/maps");
  const std::string loaded{std::istreambuf_iterator<char>(maps), {}};
  return loaded.find("libumockdev-preload") != loaded.npos;
}

void Unobject::operator()(void* object) const {
  g_object_unref(object);
}

MockHidraw::MockHidraw(std::vector<std::uint8_t> descriptor)
    : descriptor_(std::move(descriptor)), handler_(umockdev_ioctl_base_new()) {
  g_signal_connect(handler_.get(), "handle-ioctl", G_CALLBACK(OnIoctl), this);
  g_signal_connect(handler_.get(), "handle-read", G_CALLBACK(OnRead), this);
  g_signal_connect(handler_.get(), "handle-write", G_CALLBACK(OnWrite), this);
}

MockHidraw::~MockHidraw() {
  g_signal_handlers_disconnect_by_data(handler_.get(), this);
}

void MockHidraw::Send(std::vector<std::uint8_t> report) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(report));
}

std::vector<std::uint8_t> MockHidraw::received() const {
  const std::lock_guard lock(mutex_);
  return received_;
}

void MockHidraw::SetInitialReport(std::vector<std::uint8_t> report, int error) {
  const std::lock_guard lock(mutex_);
  initial_ = std::move(report);
  initial_error_ = error;
}

int MockHidraw::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

int MockHidraw::AnswerInput(UMockdevIoctlClient* client) {
  const std::lock_guard lock(mutex_);
  ++requests_;
  const std::size_t room = _IOC_SIZE(umockdev_ioctl_client_get_request(client));
  const std::span answer = std::span(initial_).first(std::min(room, initial_.size()));
  if (answer.empty()) {
    umockdev_ioctl_client_complete(client, -1, initial_error_ != 0 ? initial_error_ : EPIPE);
    return 1;
  }
  Put(Argument(client, room), 0, answer);
  umockdev_ioctl_client_complete(client, static_cast<long>(answer.size()), 0);
  return 1;
}

int MockHidraw::OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self) {
  auto& hidraw = *static_cast<MockHidraw*>(self);
  const auto& descriptor = hidraw.descriptor_;
  const auto request = umockdev_ioctl_client_get_request(client);
  if (_IOC_TYPE(request) == 'H' && _IOC_NR(request) == _IOC_NR(HIDIOCGINPUT(0)))
    return hidraw.AnswerInput(client);
  const std::uint32_t size = static_cast<std::uint32_t>(descriptor.size());
  const std::span size_bytes(reinterpret_cast<const std::uint8_t*>(&size), sizeof size);
  switch (request) {
    case HIDIOCGRDESCSIZE:
      Put(Argument(client, sizeof size), 0, size_bytes);
      break;
    case HIDIOCGRDESC: {
      UMockdevIoctlData* argument = Argument(client, sizeof(hidraw_report_descriptor));
      Put(argument, sizeof size, descriptor);
      break;
    }
    default:
      umockdev_ioctl_client_complete(client, -1, ENOTTY);
      return 1;
  }
  umockdev_ioctl_client_complete(client, 0, 0);
  return 1;
}

int MockHidraw::OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self) {
  auto& hidraw = *static_cast<MockHidraw*>(self);
  const std::lock_guard lock(hidraw.mutex_);
  if (hidraw.waiting_.empty()) {
    umockdev_ioctl_client_complete(client, -1, EAGAIN);
    return 1;
  }
  const std::vector<std::uint8_t> report = hidraw.waiting_.front();
  hidraw.waiting_.erase(hidraw.waiting_.begin());
  Put(umockdev_ioctl_client_get_arg(client), 0, report);
  umockdev_ioctl_client_complete(client, static_cast<long>(report.size()), 0);
  return 1;
}

int MockHidraw::OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self) {
  auto& hidraw = *static_cast<MockHidraw*>(self);
  const UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
  const std::lock_guard lock(hidraw.mutex_);
  hidraw.received_.assign(data->data, data->data + data->data_len);
  umockdev_ioctl_client_complete(client, data->data_len, 0);
  return 1;
}

MockKernel::MockKernel() : testbed_(umockdev_testbed_new()) {
  // The root hub, with what libusb reads of it; its configuration tells of no interface.
  Add(testbed_.get(),
      "P: /devices/pci0000:00/usb1\nN: bus/usb/001/001\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n"
      "E: DEVNAME=/dev/bus/usb/001/001\nE: BUSNUM=001\nE: DEVNUM=001\nA: busnum=1\\n\nA: devnum=1\\n\n"
      "A: speed=480\\n\nA: bConfigurationValue=1\\n\n"
      "H: descriptors=12010002090001406B1D0200060503020101090209000001008000\n\n");
}

void MockKernel::Plug(const std::string& usb_port, int interface, const std::string& node,
                      const MockHidraw& device) {
  const std::string hid = HidDir(usb_port, interface, node);
  if (interface == 0)
    Add(testbed_.get(), fmt::format("P: {}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n\n", UsbDir(usb_port)));
  Add(testbed_.get(), fmt::format("P: {}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n"
                                  "A: bInterfaceNumber={:02x}\\n\n\n",
                                  InterfaceDir(usb_port, interface), interface));
  Add(testbed_.get(), fmt::format("P: {}\nE: SUBSYSTEM=hid\nE: HID_ID=0003:00001209:00000001\n"
                                  "E: HID_NAME=Dial Box\n\n",
                                  hid));
  Add(testbed_.get(), fmt::format("P: {}/hidraw/{}\nN: {}\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/{}\n\n", hid,
                                  node, node, node));
  GError* error = nullptr;
  EXPECT_TRUE(
      umockdev_testbed_attach_ioctl(testbed_.get(), ("/dev/" + node).c_str(), device.handler(), &error))
      << error->message;
  umockdev_testbed_uevent(testbed_.get(), ("/sys" + hid + "/hidraw/" + node).c_str(), "add");
}

void MockKernel::Pair(const std::string& address, const std::string& node) {
  const std::string hid = "/devices/virtual/misc/uhid/0005:1209:0001." + node;
  Add(testbed_.get(), fmt::format("P: {}\nE: SUBSYSTEM=hid\nE: HID_ID=0005:00001209:00000001\n"
                                  "E: HID_PHYS=00:1a:7d:da:71:13\nE: HID_UNIQ={}\n\n",
                                  hid, address));
  Add(testbed_.get(), fmt::format("P: {}/hidraw/{}\nN: {}\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/{}\n\n", hid,
                                  node, node, node));
}

void MockKernel::Unplug(const std::string& usb_port, int interface, const std::string& node) {
  const std::string path = "/sys" + HidDir(usb_port, interface, node) + "/hidraw/" + node;
  umockdev_testbed_uevent(testbed_.get(), path.c_str(), "remove");
  umockdev_testbed_detach_ioctl(testbed_.get(), ("/dev/" + node).c_str(), nullptr);
  // Children first: the testbed forgets the bus links of what goes with its parent.
  const std::string hid = HidDir(usb_port, interface, node);
  for (const std::string& device :
       {fmt::format("{}/hidraw/{}", hid, node), hid, InterfaceDir(usb_port, interface), UsbDir(usb_port)})
    umockdev_testbed_remove_device(testbed_.get(), fmt::format("/sys{}", device).c_str());
}

}  // namespace kaori::tests
