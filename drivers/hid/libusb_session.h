// One libusb context with its descriptors in one epoll set, and libusb's errors as std::errc.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

struct libusb_context;
struct libusb_device;
struct libusb_device_handle;

namespace kaori::hid {

// A HID interface of a device that is plugged in, with a reference to the device. A
// snapshot: the device may be gone when it is opened.
struct UsbHidInterface {
  struct Unref {
    void operator()(libusb_device* device) const;
  };
  std::string port;  // As HidrawBus names it: "1-4.2", or "1-4.2:1.1".
  // bInterfaceNumber, which requests to the interface name.
  int number = 0;
  std::uint16_t descriptor_bytes = 0;  // Of its report descriptor; 0 where it tells none.
  std::uint8_t in_endpoint = 0;        // Interrupt endpoints; 0 where it has none.
  std::uint8_t out_endpoint = 0;
  // wMaxPacketSize of the IN endpoint, without the bits for extra transactions.
  std::uint16_t in_packet_bytes = 0;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  // A reference: the device's structure stays until it is let go of.
  std::unique_ptr<libusb_device, Unref> device;
};

// One context for each bus and each channel, so that a descriptor becomes readable for its own device
// alone. One thread. libusb's call-backs run in Handle and HandleFor only.
class LibusbSession {
 public:
  // Lists nothing and opens no device. Errors: io_error and those of epoll_create1(2) and eventfd(2).
  static Result<std::unique_ptr<LibusbSession>> Open();
  LibusbSession(const LibusbSession&) = delete;
  LibusbSession& operator=(const LibusbSession&) = delete;
  ~LibusbSession();

  // Readable while libusb has something to handle, or SetReadable(true) counts. Level-triggered.
  int pollable() const { return epoll_.get(); }
  // Borrowed, for libusb's own calls; no events are handled but by this object.
  libusb_context* context() const { return context_.get(); }

  // While true, pollable() is readable whatever USB does: a completed report waits to be read.
  void SetReadable(bool readable);

  // Runs the call-backs that are due: ended transfers, and hot-plug.
  // Does not block. Errors: those of FailUsb.
  Result<void> Handle();
  // As Handle, but blocks up to `ms` until one is due: for closing.
  void HandleFor(int ms);

  // Every HID interface that has an interrupt IN endpoint, of all devices, in libusb's order. Reads what
  // the kernel has cached and does not talk to a device. Does not block. Errors: io_error.
  Result<std::vector<UsbHidInterface>> Interfaces() const;

 private:
  struct Exit {
    void operator()(libusb_context* context) const;
  };
  LibusbSession(libusb_context* context, UniqueFd epoll, UniqueFd waiting);
  // libusb tells which of its descriptors are to be watched; these keep the epoll set the same.
  void Watch(int fd, short events);
  // libusb's notices of its own descriptors; `self` is the session.
  static void OnAdded(int fd, short events, void* self);
  static void OnRemoved(int fd, void* self);

  // Declared before the context, which must end first.
  UniqueFd epoll_;
  // Readable by hand: see SetReadable.
  UniqueFd readable_;
  // Ends first, since it closes the descriptors that epoll_ watches.
  std::unique_ptr<libusb_context, Exit> context_;
};

// `code` is a negative libusb error code; the message is as "open 1-4.2: No such
// device". LIBUSB_ERROR_NOT_FOUND counts as no_such_device: a device whose interface is
// gone is being unplugged. What is not named here is io_error.
tl::unexpected<Error> FailUsb(int code, std::string attempt);

}  // namespace kaori::hid
