// A USB socket of a virtual machine, with one simulated device before it and a cable that can be pulled.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hw-sim/devices/usb_device.h"
#include "hw-sim/links/usbredir/redir_wire.h"

namespace kaori::sim {

// Announces the device to the machine, and answers what its kernel asks. The machine listens and
// this end calls, as QEMU's usb-redir device wants it; a machine that goes away is called again
// until it is back. One thread; nothing blocks.
class UsbredirPort final : private RedirRequests {
 public:
  // `path` is the socket at which the machine listens; `epoll` gets the connection, and outlives the
  // port. Borrows the device, which must outlive the port or be replaced by Hold.
  UsbredirPort(std::string path, int epoll, UsbDevice& device)
      : path_(std::move(path)), epoll_(epoll), device_(&device) {}

  // The cable. Doing it twice is doing it once. The machine is told with the next
  // Pump, and of a pulled cable at once.
  void Plug();
  void Unplug();
  // The cable is in, whether or not a machine is there.
  bool plugged() const { return plugged_; }

  bool connected() const { return wire_ != nullptr; }  // A machine is there.
  bool configured() const { return configured_; }      // It has enumerated the device.
  // A program in the machine listens to an interrupt endpoint: its HID driver has opened the device.
  bool listened() const { return !listened_to_.empty(); }

  // Another device at the end of the cable, which must be out.
  void Hold(UsbDevice& device) { device_ = &device; }

  // Calls, reads, answers, and sends what is due.
  void Pump(Time now);
  // When Pump has something to send, or calls again; nothing while it only waits for the machine.
  std::optional<Time> next_due(Time now) const;

 private:
  // Connects to the machine; what fails is tried again after kCallAgain.
  void Call(Time now);
  // The machine is gone, or broke the protocol.
  void HangUp();
  // Says that a device was plugged in.
  void Announce();
  // What the machine was doing with the device is over.
  void Forget();
  // Gives interrupt endpoints what is due, and fills requests that wait.
  void SendDue(Time now);
  // Answers the oldest request for data. False: the device has none.
  bool FillFirst(Time now);
  // Watches the socket for room while the wire has something to write.
  void WatchForRoom();

  void Greeted() override;
  void SetConfiguration(std::uint64_t id, std::uint8_t number) override;
  void GetConfiguration(std::uint64_t id) override;
  void SetAlternate(std::uint64_t id, std::uint8_t interface, std::uint8_t number) override;
  void GetAlternate(std::uint64_t id, std::uint8_t interface) override;
  void Control(std::uint64_t id, const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  void Listen(std::uint64_t id, std::uint8_t endpoint, bool begins) override;
  void InterruptOut(std::uint64_t id, std::uint8_t endpoint, std::span<const std::uint8_t> data) override;
  void Bulk(const RedirBulk& request, std::span<const std::uint8_t> data) override;
  void Isochronous(std::uint64_t id, std::uint8_t endpoint) override {
    wire_->IsochronousStatus(id, endpoint);
  }
  void Cancel(std::uint64_t id) override;

  std::string path_;
  int epoll_;
  // What is at the end of the cable now.
  UsbDevice* device_;
  // Null while no machine is there.
  std::unique_ptr<RedirWire> wire_;
  Time call_at_{};                         // When the machine is called again.
  bool plugged_ = false;                   // The cable is in.
  bool greeted_ = false;                   // The machine said hello.
  bool announced_ = false;                 // It was told of the device.
  bool configured_ = false;                // It chose the configuration.
  bool waits_for_room_ = false;            // The epoll set wakes for room in the socket.
  std::vector<std::uint8_t> listened_to_;  // Interrupt endpoints.
  std::deque<RedirBulk> bulk_in_;          // Requests that wait for data, in their order.
};

}  // namespace kaori::sim
