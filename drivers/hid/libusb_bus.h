// The HID devices on USB, found and watched with libusb.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/hid/libusb_session.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::hid {

// As ports::HidBus, with the port names of HidrawBus, so that a profile serves both. Open blocks while
// the device sends its descriptors, 250 ms at most for each, and claims the interface from the
// kernel's driver; the channel's end gives it back. One thread.
class LibusbBus final : public ports::HidBus {
 public:
  // Every device is listed, hidraw's access rights or not; Open needs those of
  // /dev/bus/usb. `clock` stamps reports. It must outlive the bus and its channels.
  // Errors: not_supported (libusb has no hot-plug), io_error.
  // `which` is what it lists: every HID device, or those alone that the kernel's own driver leaves to others
  // (HID_QUIRK_IGNORE of hid-quirks.c), so that the bus may stand beside a HidrawBus.
  enum class Which : std::uint8_t { kAll, kIgnoredByKernel };
  static Result<std::unique_ptr<LibusbBus>> Open(const Clock& clock, Which which = Which::kAll);
  ~LibusbBus() override;

  int pollable() const override { return session_->pollable(); }
  Result<std::vector<std::string>> Ports() override;
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) override;

 private:
  LibusbBus(std::unique_ptr<LibusbSession> session, const Clock& clock, Which which);

  // For hot-plug and listings alone: every channel has a session
  // of its own, so that its descriptor wakes for it alone.
  std::unique_ptr<LibusbSession> session_;
  const Clock& clock_;
  Which which_;
  // The registered call-back of libusb; 0: none.
  int hot_plug_ = 0;
};

}  // namespace kaori::hid
