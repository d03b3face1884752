// One HID device through libusb, with interrupt transfers that are always submitted: no call waits for it.
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

// As ports::HidChannel. Up to kReads reports that nobody reads stay in their transfers, and the
// device keeps the rest: none is lost on our side. Write says resource_unavailable_try_again
// while kWrites reports are submitted. Stamps are taken in the call-back, that is when Read or
// Write runs: they are late by as much as the loop. One thread.
class LibusbChannel final : public ports::HidChannel {
 public:
  // At 1000 reports/s, USB's most at full speed, eight reports outlast a loop that is busy for 8 ms.
  static constexpr std::size_t kReads = 8;
  // Lamps and a display line at once; whoever writes faster than the device reads is told so.
  static constexpr std::size_t kWrites = 4;

  // Opens the HID interface at `port` in a libusb session of its own, and claims
  // it from the kernel's driver. Blocks while the device sends its descriptors,
  // 250 ms at most for each. `clock` must outlive the channel. Errors:
  //   no_such_device           no HID interface is plugged in there
  //   permission_denied        the device's node may not be opened
  //   device_or_resource_busy  another program has claimed the interface
  //   io_error                 the device does not send its descriptors
  static Result<std::unique_ptr<LibusbChannel>> Open(const std::string& port, const Clock& clock);
  LibusbChannel(const LibusbChannel&) = delete;
  LibusbChannel& operator=(const LibusbChannel&) = delete;
  // Cancels the transfers, and blocks up to 100 ms until they have ended.
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
  // kSubmitted: libusb owns the bytes; kCompleted: they are a report that Read has not given yet.
  struct Transfer {
    enum class State { kIdle, kSubmitted, kCompleted };
    // Whose call-backs these are.
    LibusbChannel* channel = nullptr;
    // libusb's structure; it lives as long as the channel, and is used again for each report.
    std::unique_ptr<libusb_transfer, FreeTransfer> handle;
    // For a control transfer the eight bytes of its setup come first.
    std::vector<std::uint8_t> bytes;
    State state = State::kIdle;
    // When its call-back ran.
    Time at{};
    std::uint64_t order = 0;  // Of arrival.
  };
  // Opens nothing yet.
  LibusbChannel(std::unique_ptr<LibusbSession> session, UsbHidInterface interface, const Clock& clock);
  // The steps of Open, in this order. Each leaves the channel in a state that the destructor can end.
  Result<void> Claim();
  // Reads the ids, the name and the report descriptor from the device;
  // blocks as Open says. The name may stay empty.
  Result<void> ReadIdentity();
  // The string descriptor of this index in English, as ASCII; empty where the device does not send it.
  std::string ReadName(std::uint8_t index);
  // Allocates all transfers and submits those for reading: nothing is allocated afterwards.
  Result<void> Prepare();
  // Gives a transfer to libusb. Errors: those of libusb; the transfer is idle then.
  Result<void> Submit(Transfer& transfer);
  // Has the transfer wait for the next input report. Errors: those of Submit.
  Result<void> AwaitInput(Transfer& transfer);
  // Fills an idle transfer with an output report; `report` is copied.
  // Allocates where it is longer than those before.
  void FillWrite(Transfer& transfer, std::span<const std::uint8_t> report);
  // The transfer whose report arrived first; null: none has one.
  Transfer* Oldest();
  // A transfer belongs to libusb: its memory must stay.
  bool any_submitted() const;
  tl::unexpected<Error> Gone() const;
  // libusb's call-back, with the Transfer as its user data; it leads
  // to HandleDone of the transfer's channel.
  static void OnDone(libusb_transfer* done);
  // Notes how a transfer ended; runs inside Handle and HandleFor only.
  void HandleDone(Transfer& transfer);

  // This channel's alone, so that its descriptor tells of this device.
  std::unique_ptr<LibusbSession> session_;
  // Holds a reference to the device, so that its port and number stay known.
  UsbHidInterface interface_;
  const Clock& clock_;
  // Read once, when it was opened.
  ports::HidIdentity identity_;
  // Several are submitted at a time, so that no report waits for the program.
  std::array<Transfer, kReads> reads_;
  std::array<Transfer, kWrites> writes_;
  // Closes before the transfers are freed: then libusb has let them go.
  std::unique_ptr<libusb_device_handle, Close> handle_;
  // Counts completed reports, so that they are given in their order.
  std::uint64_t arrivals_ = 0;
  // The interface is ours, and must be given back.
  bool claimed_ = false;
  // The destructor runs: call-backs only end their transfers.
  bool closing_ = false;
  // The device was unplugged; what arrived before is still given.
  bool gone_ = false;
  // A transfer failed: told once, by the next Read that has no report. The next try may succeed.
  bool broken_ = false;
};

}  // namespace kaori::hid
