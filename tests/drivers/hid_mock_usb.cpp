#include "tests/drivers/hid_mock_usb.h"

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace kaori::tests {
namespace {

constexpr const char* kNode = "/dev/bus/usb/001/002";
constexpr std::uint32_t kCanDisconnectAndClaim = 0x20;  // A capability of usbfs that its header leaves out.
constexpr const char* kDeviceDir = "/devices/pci0000:00/usb1/1-4";

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint8_t kNameIndex = 2;

Bytes DeviceDescriptor(bool has_name) {
  const std::uint8_t name = has_name ? kNameIndex : 0;
  return {18, 1, 0, 2, 0, 0, 0, 64, 0x09, 0x12, 0x01, 0x00, 0, 1, 0, name, 0, 1};
}

Bytes ConfigDescriptor(std::size_t report_bytes, bool has_out) {
  Bytes config = {9, 2, 0, 0, 1, 1, 0, 0x80, 50};
  const auto append = [&](const Bytes& more) {
    for (const std::uint8_t byte : more) config.push_back(byte);
  };
  append({9, 4, 0, 0, static_cast<std::uint8_t>(has_out ? 2 : 1), 3, 0, 0, 0});
  append({9, 0x21, 0x11, 1, 0, 1, 0x22, static_cast<std::uint8_t>(report_bytes), 0});
  append({7, 5, 0x81, 3, 64, 0, 1});
  if (has_out) append({7, 5, 0x01, 3, 64, 0, 1});
  config[2] = static_cast<std::uint8_t>(config.size());
  return config;
}

Bytes NameDescriptor(const std::string& name) {
  Bytes bytes = {static_cast<std::uint8_t>(2 + 2 * name.size()), 0x03};
  for (const char letter : name) {
    bytes.push_back(static_cast<std::uint8_t>(letter));
    bytes.push_back(0);
  }
  return bytes;
}

std::string UsbDevice(const char* dir, int number, const Bytes& descriptors) {
  return fmt::format(
      "P: {}\nN: bus/usb/001/{:03}\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: "
      "DEVNAME=/dev/bus/usb/001/{:03}\n"
      "E: BUSNUM=001\nE: DEVNUM={:03}\nA: busnum=1\\n\nA: devnum={}\\n\nA: speed=480\\n\n"
      "A: bConfigurationValue=1\\n\nH: descriptors={:02X}\n\n",
      dir, number, number, number, number, fmt::join(descriptors, ""));
}

void MockUsbAdd(UMockdevTestbed* testbed, const std::string& device) {
  GError* error = nullptr;
  EXPECT_TRUE(umockdev_testbed_add_from_string(testbed, device.c_str(), &error)) << error->message;
}

usbdevfs_urb& Fields(UMockdevIoctlData* urb) {
  return *reinterpret_cast<usbdevfs_urb*>(urb->data);
}

}  // namespace

MockUsb::MockUsb(Options options) : options_(std::move(options)), handler_(umockdev_ioctl_base_new()) {
  g_signal_connect(handler_.get(), "handle-ioctl", G_CALLBACK(OnIoctl), this);
}

MockUsb::~MockUsb() {
  g_signal_handlers_disconnect_by_data(handler_.get(), this);
}

void MockUsb::Plug(MockKernel& kernel) {
  Bytes descriptors = DeviceDescriptor(!options_.name.empty());
  for (const std::uint8_t byte : ConfigDescriptor(options_.descriptor.size(), options_.has_out_endpoint))
    descriptors.push_back(byte);
  MockUsbAdd(kernel.testbed(), UsbDevice(kDeviceDir, 2, descriptors));
  GError* error = nullptr;
  EXPECT_TRUE(umockdev_testbed_attach_ioctl(kernel.testbed(), kNode, handler_.get(), &error))
      << error->message;
  umockdev_testbed_uevent(kernel.testbed(), (std::string("/sys") + kDeviceDir).c_str(), "add");
}

void MockUsb::Unplug(MockKernel& kernel) {
  const std::string path = std::string("/sys") + kDeviceDir;
  umockdev_testbed_uevent(kernel.testbed(), path.c_str(), "remove");
  umockdev_testbed_detach_ioctl(kernel.testbed(), kNode, nullptr);
  umockdev_testbed_remove_device(kernel.testbed(), path.c_str());
}

bool MockUsb::Send(const Bytes& report) {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return false;
  Complete(waiting_.front(), 0, report, 0);
  waiting_.pop_front();
  return true;
}

void MockUsb::Vanish() {
  const std::lock_guard lock(mutex_);
  vanished_ = true;
  for (const Urb& urb : waiting_) Complete(urb, -ESHUTDOWN, {}, 0);
  waiting_.clear();
}

Bytes MockUsb::received() const {
  const std::lock_guard lock(mutex_);
  return received_;
}

std::size_t MockUsb::waiting() const {
  const std::lock_guard lock(mutex_);
  return waiting_.size();
}

int MockUsb::OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self) {
  auto& usb = *static_cast<MockUsb*>(self);
  const std::lock_guard lock(usb.mutex_);
  usb.Answer(client);
  return 1;
}

void MockUsb::Answer(UMockdevIoctlClient* client) {
  switch (umockdev_ioctl_client_get_request(client)) {
    case USBDEVFS_SUBMITURB:
      return Submit(client);
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
      return Reap(client);
    case USBDEVFS_DISCARDURB:
      return Discard(client);
    case USBDEVFS_GET_CAPABILITIES: {
      UMockdevIoctlData* data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                            sizeof(std::uint32_t), nullptr);
      *reinterpret_cast<std::uint32_t*>(data->data) = kCanDisconnectAndClaim;
      return umockdev_ioctl_client_complete(client, 0, 0);
    }
    case USBDEVFS_DISCONNECT_CLAIM:
    case USBDEVFS_CLAIMINTERFACE:
    case USBDEVFS_RELEASEINTERFACE:
      return umockdev_ioctl_client_complete(client, 0, 0);
    default:
      return umockdev_ioctl_client_complete(client, -1, ENOTTY);
  }
}

void MockUsb::Submit(UMockdevIoctlClient* client) {
  if (vanished_) return umockdev_ioctl_client_complete(client, -1, ENODEV);
  Urb urb;
  urb.urb =
      umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(usbdevfs_urb), nullptr);
  usbdevfs_urb& fields = Fields(urb.urb);
  urb.buffer = umockdev_ioctl_data_resolve(urb.urb, offsetof(usbdevfs_urb, buffer),
                                           static_cast<std::size_t>(fields.buffer_length), nullptr);
  umockdev_ioctl_data_ref(urb.urb);
  if (fields.type == USBDEVFS_URB_TYPE_CONTROL) {
    AnswerControl(urb);
  } else if ((fields.endpoint & 0x80) != 0) {
    waiting_.push_back(urb);
  } else {
    received_.assign(urb.buffer->data, urb.buffer->data + fields.buffer_length);
    fields.status = 0;
    fields.actual_length = fields.buffer_length;
    done_.push_back(urb);
  }
  umockdev_ioctl_client_complete(client, 0, 0);
}

void MockUsb::AnswerControl(const Urb& urb) {
  constexpr std::size_t kSetup = 8;
  const std::uint8_t* setup = urb.buffer->data;
  if (setup[0] == 0x81 && setup[1] == 6 && setup[3] == 0x22)
    return Complete(urb, 0, options_.descriptor, kSetup);
  if (setup[0] == 0x80 && setup[1] == 6 && setup[2] == kNameIndex && setup[3] == 0x03)
    return Complete(urb, 0, NameDescriptor(options_.name), kSetup);
  if (setup[0] != 0x21) return Complete(urb, -EPIPE, {}, 0);  // A stall.
  received_.assign(setup, setup + Fields(urb.urb).buffer_length);
  Complete(urb, 0, {}, 0);
  Fields(urb.urb).actual_length = Fields(urb.urb).buffer_length - static_cast<int>(kSetup);
}

void MockUsb::Complete(const Urb& urb, int status, const Bytes& bytes, std::size_t offset) {
  usbdevfs_urb& fields = Fields(urb.urb);
  const auto room = static_cast<std::size_t>(fields.buffer_length) - offset;
  const std::size_t length = bytes.empty() ? 0 : std::min(bytes.size(), room);
  std::copy_n(bytes.begin(), length, urb.buffer->data + offset);
  fields.status = status;
  fields.actual_length = static_cast<int>(length);
  done_.push_back(urb);
}

void MockUsb::Reap(UMockdevIoctlClient* client) {
  if (done_.empty()) return umockdev_ioctl_client_complete(client, -1, vanished_ ? ENODEV : EAGAIN);
  UMockdevIoctlData* into =
      umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(void*), nullptr);
  umockdev_ioctl_data_set_ptr(into, 0, done_.front().urb);
  done_.pop_front();
  umockdev_ioctl_client_complete(client, 0, 0);
}

void MockUsb::Discard(UMockdevIoctlClient* client) {
  const auto address = *reinterpret_cast<gulong*>(umockdev_ioctl_client_get_arg(client)->data);
  const auto it =
      std::ranges::find_if(waiting_, [&](const Urb& urb) { return urb.urb->client_addr == address; });
  if (it == waiting_.end()) return umockdev_ioctl_client_complete(client, -1, EINVAL);
  Complete(*it, -ENOENT, {}, 0);
  waiting_.erase(it);
  umockdev_ioctl_client_complete(client, 0, 0);
}

}  // namespace kaori::tests
