// A USB device of a made-up kernel: usbfs requests in, as libusb makes them, by umockdev.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tests/drivers/hid_mock_device.h"

// NOLINTNEXTLINE(bugprone-reserved-identifier): the library's own name.
typedef struct _UMockdevIoctlData UMockdevIoctlData;

namespace kaori::tests {

// A HID device on port "1-4" with one interface. Its call-backs run in umockdev's thread.
class MockUsb {
 public:
  struct Options {
    std::vector<std::uint8_t> descriptor;  // The report descriptor.
    bool has_out_endpoint = true;
    std::string name{};  // ASCII.
  };
  explicit MockUsb(Options options);
  ~MockUsb();
  MockUsb(const MockUsb&) = delete;
  MockUsb& operator=(const MockUsb&) = delete;

  void Plug(MockKernel& kernel);
  void Unplug(MockKernel& kernel);

  // Fills the oldest waiting transfer; false when none waits: the device would keep the report.
  bool Send(const std::vector<std::uint8_t>& report);
  // From now on every transfer ends with "no such device".
  void Vanish();
  std::vector<std::uint8_t> received() const;  // By interrupt or, with its 8 bytes of setup, by control.
  std::size_t waiting() const;                 // IN transfers under way.

 private:
  struct Urb {
    UMockdevIoctlData* urb = nullptr;
    UMockdevIoctlData* buffer = nullptr;
  };
  static int OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self);
  void Answer(UMockdevIoctlClient* client);
  void Submit(UMockdevIoctlClient* client);
  void Reap(UMockdevIoctlClient* client);
  void Discard(UMockdevIoctlClient* client);
  void AnswerControl(const Urb& urb);
  void Complete(const Urb& urb, int status, const std::vector<std::uint8_t>& bytes, std::size_t offset);

  Options options_;
  mutable std::mutex mutex_;
  std::deque<Urb> waiting_;
  std::deque<Urb> done_;
  std::vector<std::uint8_t> received_;
  bool vanished_ = false;
  std::unique_ptr<UMockdevIoctlBase, Unobject> handler_;
};

}  // namespace kaori::tests
