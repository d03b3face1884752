// One HID device through libusb, with interrupt transfers always under way: nothing waits for the device.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/hid/libusb_session.h"
#include "drivers/ports/hid_channel.h"

struct libusb_transfer;

namespace kaori::hid {

// As ports::HidChannel. Reports that nobody reads stay in their transfers, and the device keeps the rest:
// none is lost on our side. Write says resource_unavailable_try_again while kWrites reports are still on
// their way.
class LibusbChannel final : public ports::HidChannel {
 public:
  static constexpr std::size_t kReads = 8;
  static constexpr std::size_t kWrites = 4;

  // In a session of its own. Borrows `clock` for its life. Errors: no_such_device, permission_denied,
  // device_or_resource_busy, io_error (the device does not tell its descriptors).
  static Result<std::unique_ptr<LibusbChannel>> Open(const std::string& port, const Clock& clock);
  LibusbChannel(const LibusbChannel&) = delete;
  LibusbChannel& operator=(const LibusbChannel&) = delete;
  // Waits up to 100 ms for the transfers to end.
  ~LibusbChannel() override;

  int pollable() const override { return session_->pollable(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override;
  Result<void> Write(std::span<const std::uint8_t> report) override;

 private:
  struct Close {
    void operator()(libusb_device_handle* handle) const;
  };
  struct FreeTransfer {
    void operator()(libusb_transfer* transfer) const;
  };
  // What a transfer carries; `state` says who has it.
  struct Flight {
    enum class State { kIdle, kUnderWay, kArrived };
    LibusbChannel* channel = nullptr;
    std::unique_ptr<libusb_transfer, FreeTransfer> transfer;
    std::vector<std::uint8_t> bytes;
    State state = State::kIdle;
    Time at{};
    std::uint64_t order = 0;  // Of arrival.
  };
  LibusbChannel(std::unique_ptr<LibusbSession> session, UsbHidInterface interface, const Clock& clock);
  Result<void> Claim();
  Result<void> ReadIdentity();
  std::string ReadName(std::uint8_t index);
  Result<void> Prepare();
  Result<void> Submit(Flight& flight);
  Result<void> AwaitInput(Flight& flight);
  void FillWrite(Flight& flight, std::span<const std::uint8_t> report);
  Flight* Oldest();
  bool any_under_way() const;
  tl::unexpected<Error> Gone() const;
  static void OnDone(libusb_transfer* transfer);
  void Landed(Flight& flight);

  std::unique_ptr<LibusbSession> session_;
  UsbHidInterface interface_;
  const Clock& clock_;
  ports::HidIdentity identity_;
  std::array<Flight, kReads> reads_;
  std::array<Flight, kWrites> writes_;
  std::unique_ptr<libusb_device_handle, Close> handle_;  // Closes first: transfers that did not end let go.
  std::uint64_t arrivals_ = 0;
  bool claimed_ = false;
  bool closing_ = false;
  bool gone_ = false;
  bool broken_ = false;  // A transfer failed: told once, by the next Read or Write.
};

}  // namespace kaori::hid
