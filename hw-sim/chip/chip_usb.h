// The shipped firmware in an emulated chip, as a USB device: hw-sim/chip/serve.mjs at the other end of a socket.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// A dial and button box, or a stick pod, whose every answer is its chip's: nothing is known of it here but what it says of itself. Its chip
// keeps the time of the wall, or is slower. Answer waits for the chip, ten seconds at most, and the caller's other devices
// stand still meanwhile: some milliseconds on a quiet machine. A chip that is gone stalls and is silent. One thread.
class ChipUsb final : public UsbDevice {
 public:
  // Connects to the emulator that listens at `path`, and asks the chip who it is: blocks for that. Errors: those of
  // ConnectToStream; protocol_error (it does not say who it is).
  static Result<std::unique_ptr<ChipUsb>> Connect(const std::string& path);

  // The operator's side; nothing waits, and the chip does it when it comes to it, in the order of the calls. Dials 0 to 7,
  // clockwise is positive, `edges_per_s` of its four edges a count; buttons 0 to 31, held until they are released.
  void Turn(int dial, std::int32_t counts, std::uint32_t edges_per_s = 1000);
  void Push(int button);
  void Release(int button);
  // An axis of a pod, 0 to 3: to the right, towards the operator, clockwise, the slider upwards. A code of its converter, 0 to 4095.
  // It stays there until it is moved again; where it rests is 2047, as a potentiometer's middle.
  void Move(int axis, std::uint16_t code);
  // Bit n: lamp n is lit, as its shift registers put it out. As of the last report or answer.
  std::uint32_t lamps() const { return lamps_; }
  // How often its watchdog started it.
  std::uint32_t restarts() const { return restarts_; }
  // The emulator is at the other end.
  bool is_there() const { return socket_.valid(); }

  // The cable's side.
  const UsbDescriptors& descriptors() const override { return descriptors_; }
  bool answers_standard() const override { return true; }
  std::optional<UsbBytes> Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) override;
  void HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) override;
  std::optional<UsbBytes> NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) override;
  std::optional<Time> next_due(Time now) const override;
  void HostCame(std::uint8_t endpoint) override;
  void HostLeft(std::uint8_t endpoint) override;
  void PowerCycle() override;

 private:
  explicit ChipUsb(UniqueFd socket) : socket_(std::move(socket)) {}
  // Fills descriptors_ from what the chip answers: vendor, product, release, texts, the whole configuration. Errors:
  // protocol_error.
  Result<void> AskWhoItIs();
  // A descriptor by its kind and index; empty where the chip has none.
  UsbBytes Descriptor(std::uint8_t kind, std::uint8_t index, std::uint16_t length);
  // A string descriptor's text; letters beyond ASCII are cut to their low byte.
  std::string Text(std::uint8_t index);
  // One frame. A socket that does not take it whole counts as an emulator that has gone.
  void Send(char kind, std::span<const std::uint8_t> bytes);
  // Reads what has come, and takes whole frames out of it.
  void Read();
  // Of one frame, by the kinds that serve.mjs lists; one of another kind is passed over.
  void Accept(char kind, std::span<const std::uint8_t> bytes);

  UniqueFd socket_;  // None once the emulator is gone.
  UsbDescriptors descriptors_;
  UsbBytes come_;                                // Of frames that are not whole yet.
  std::deque<std::optional<UsbBytes>> answers_;  // Nothing: it stalled.
  std::deque<UsbBytes> reports_;
  std::uint32_t lamps_ = 0;
  std::uint32_t restarts_ = 0;
  Time polled_{};
};

}  // namespace kaori::sim
