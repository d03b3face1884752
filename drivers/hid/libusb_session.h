// One libusb context with its descriptors in one epoll set, and the kernel's errors in our words.
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

// A HID interface of a device that is plugged in, with a reference to the device.
struct UsbHidInterface {
  struct Unref {
    void operator()(libusb_device* device) const;
  };
  std::string port;  // As HidrawBus names it: "1-4.2", or "1-4.2:1.1".
  int number = 0;
  std::uint16_t descriptor_bytes = 0;  // Of its report descriptor; 0 where it tells none.
  std::uint8_t in_endpoint = 0;        // Interrupt endpoints; 0 where it has none.
  std::uint8_t out_endpoint = 0;
  std::uint16_t in_packet_bytes = 0;
  std::unique_ptr<libusb_device, Unref> device;
};

// Single-threaded. Events are handled in Handle(), and nowhere else.
class LibusbSession {
 public:
  static Result<std::unique_ptr<LibusbSession>> Open();
  LibusbSession(const LibusbSession&) = delete;
  LibusbSession& operator=(const LibusbSession&) = delete;
  ~LibusbSession();

  int pollable() const { return epoll_.get(); }
  libusb_context* context() const { return context_.get(); }

  // Keeps pollable() readable, whatever USB does, while `waiting`: something lies ready on our side.
  void ShowWaiting(bool waiting);

  // Runs the call-backs that are due. Does not block.
  Result<void> Handle();
  // The same, waiting up to `ms` for one to come due: for tearing down.
  void HandleFor(int ms);

  // Every HID interface with an interrupt IN endpoint. Does not block.
  Result<std::vector<UsbHidInterface>> Interfaces() const;

 private:
  struct Exit {
    void operator()(libusb_context* context) const;
  };
  LibusbSession(libusb_context* context, UniqueFd epoll, UniqueFd waiting);
  void Watch(int fd, short events);
  static void OnAdded(int fd, short events, void* self);
  static void OnRemoved(int fd, void* self);

  UniqueFd epoll_;
  UniqueFd waiting_;
  std::unique_ptr<libusb_context, Exit> context_;
};

// `code` is a libusb error: "open 1-4.2: No such device".
tl::unexpected<Error> FailUsb(int code, std::string attempt);

}  // namespace kaori::hid
