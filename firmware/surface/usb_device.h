// A USB device with one HID interface, as a machine without registers: chapter 9 of USB 2.0, and HID 1.11.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "firmware/surface/hid_function.h"
#include "firmware/surface/usb_descriptors.h"
#include "firmware/surface/usb_port.h"

namespace kaori::surface {

// A controller's driver tells it what the bus did; it answers by way of the port. Whatever comes, in whatever
// order and length, ends in an answer, a STALL, or the wait for a SETUP. One side.
class UsbDevice {
 public:
  // Borrows both.
  UsbDevice(const UsbIdentity& identity, HidFunction& function, UsbPort& port)
      : identity_(identity), function_(function), port_(port) {}

  // The bus was reset: address 0, no configuration.
  void HandleReset();
  void HandleSuspend();
  void HandleResume();
  void HandleSetup(std::span<const std::uint8_t, 8> packet);
  // The host fetched the packet of endpoint 0; or sent one.
  void HandleControlSent();
  void HandleControlReceived(std::span<const std::uint8_t> packet);
  // The host sent a report to the OUT endpoint.
  void HandleOutput(std::span<const std::uint8_t> packet) { function_.Accept(ReportKind::kOutput, packet); }
  // To be called often: sends a report where one is due and the host has fetched the one before.
  void Poll();

  bool configured() const { return configuration_ != 0; }

 private:
  // The stages of a control transfer, as the device sees them.
  enum class Stage : std::uint8_t { kSetup, kDataIn, kDataOut, kStatusIn, kStatusOut };
  // The eight bytes of a SETUP (USB 2.0, 9.3).
  struct Setup {
    std::uint8_t type = 0;
    std::uint8_t request = 0;
    std::uint16_t value = 0;
    std::uint16_t index = 0;
    std::uint16_t length = 0;
  };

  // Data towards the host: sets answer_. False: there is no such request.
  bool Answer();
  bool AnswerDevice();
  bool AnswerInterface();
  bool AnswerEndpoint();
  bool AnswerDescriptor();
  // Requests without data, or whose data came. False: refused.
  bool Do();
  bool DoForEndpoint();
  bool SetConfiguration(std::uint16_t value);

  bool AnswerBytes(std::initializer_list<std::uint8_t> bytes);
  void SendNext();
  void Finish(bool accepted);
  void TellHost();
  bool is_endpoint(std::uint16_t index) const;
  bool& halt(std::uint16_t index) { return index == kInputEndpoint ? input_halted_ : output_halted_; }

  const UsbIdentity identity_;
  HidFunction& function_;
  UsbPort& port_;

  Stage stage_ = Stage::kSetup;
  Setup setup_;
  std::array<std::uint8_t, kPacketBytes> buffer_{};  // Of what is made, or what comes.
  static_assert(kMostDescriptorBytes <= kPacketBytes);
  std::size_t received_ = 0;
  std::span<const std::uint8_t> answer_;  // What is still to be sent.
  bool ends_short_ = false;       // An empty packet ends the data, for nothing shorter than 64 bytes does.
  std::uint8_t new_address_ = 0;  // From the status stage on; 0: none.

  std::uint8_t configuration_ = 0;
  bool suspended_ = false;
  bool input_halted_ = false;
  bool output_halted_ = false;
};

}  // namespace kaori::surface
