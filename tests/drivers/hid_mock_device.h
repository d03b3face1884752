// A fake kernel for tests: sysfs, udev and hidraw nodes that answer, by umockdev.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

// NOLINTBEGIN(bugprone-reserved-identifier): the library's own names.
typedef struct _UMockdevTestbed UMockdevTestbed;
typedef struct _UMockdevIoctlBase UMockdevIoctlBase;
typedef struct _UMockdevIoctlClient UMockdevIoctlClient;
// NOLINTEND(bugprone-reserved-identifier)

namespace kaori::tests {

// False where the preloaded library is missing.
bool InMockKernel();

struct Unobject {
  void operator()(void* object) const;
};

// A hidraw node's other side. Its call-backs run in umockdev's thread.
class MockHidraw {
 public:
  explicit MockHidraw(std::vector<std::uint8_t> descriptor);
  ~MockHidraw();
  MockHidraw(const MockHidraw&) = delete;
  MockHidraw& operator=(const MockHidraw&) = delete;

  void Send(std::vector<std::uint8_t> report);
  // Its answer to a request for its input report, in the kernel's form; empty: it stalls. Or the error of the kernel.
  void SetInitialReport(std::vector<std::uint8_t> report, int error = 0);
  int requests() const;
  std::vector<std::uint8_t> received() const;
  UMockdevIoctlBase* handler() const { return handler_.get(); }

 private:
  static int OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self);
  int AnswerInput(UMockdevIoctlClient* client);
  static int OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self);
  static int OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, void* self);

  std::vector<std::uint8_t> descriptor_;
  mutable std::mutex mutex_;
  std::vector<std::vector<std::uint8_t>> waiting_;
  std::vector<std::uint8_t> received_;
  std::vector<std::uint8_t> initial_;
  int initial_error_ = 0;
  int requests_ = 0;
  std::unique_ptr<UMockdevIoctlBase, Unobject> handler_;
};

// Plugs and pulls. A port is a USB port path ("1-4.2") and an interface number.
class MockKernel {
 public:
  MockKernel();

  void Plug(const std::string& usb_port, int interface, const std::string& node, const MockHidraw& device);
  // A device of Bluetooth: `address` is its own, the receiver is always the same.
  void Pair(const std::string& address, const std::string& node);
  // Pulls the whole USB device; the node goes last.
  void Unplug(const std::string& usb_port, int interface, const std::string& node);
  UMockdevTestbed* testbed() const { return testbed_.get(); }

 private:
  std::unique_ptr<UMockdevTestbed, Unobject> testbed_;
};

}  // namespace kaori::tests
