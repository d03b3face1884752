#include "drivers/hid/libusb_bus.h"

#include <libusb.h>

#include <algorithm>
#include <utility>

#include "drivers/hid/libusb_channel.h"

namespace kaori::hid {
namespace {

// Ports() lists the devices anew each time: the event only makes pollable() readable.
int OnHotPlug(libusb_context*, libusb_device*, libusb_hotplug_event, void*) {
  return 0;
}

// Griffin's PowerMate and SoundKnob. Linux has a driver of its own for them, which makes events of them and
// no reports.
bool IsIgnoredByKernel(const UsbHidInterface& interface) {
  constexpr std::uint16_t kGriffin = 0x077D;
  return interface.vendor == kGriffin && (interface.product == 0x0410 || interface.product == 0x04AA);
}

}  // namespace

Result<std::unique_ptr<LibusbBus>> LibusbBus::Open(const Clock& clock, Which which) {
  auto session = LibusbSession::Open();
  if (!session) return tl::unexpected(session.error());
  if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) == 0)
    return Fail(std::errc::not_supported, "watch USB for hot-plug");
  std::unique_ptr<LibusbBus> bus(new LibusbBus(std::move(*session), clock, which));
  // The call-back itself does nothing: what counts is that an event makes the session's descriptor readable.
  const int code = libusb_hotplug_register_callback(
      bus->session_->context(), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT, 0,
      LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY, OnHotPlug, nullptr,
      &bus->hot_plug_);
  if (code != 0) return FailUsb(code, "watch USB for hot-plug");
  return bus;
}

LibusbBus::LibusbBus(std::unique_ptr<LibusbSession> session, const Clock& clock, Which which)
    : session_(std::move(session)), clock_(clock), which_(which) {}

LibusbBus::~LibusbBus() {
  if (hot_plug_ != 0) libusb_hotplug_deregister_callback(session_->context(), hot_plug_);
}

Result<std::vector<std::string>> LibusbBus::Ports() {
  // Events are handled first, so that the list is no older than the call.
  if (auto ok = session_->Handle(); !ok) return tl::unexpected(ok.error());
  const auto interfaces = session_->Interfaces();
  if (!interfaces) return tl::unexpected(interfaces.error());
  std::vector<std::string> ports;
  for (const UsbHidInterface& interface : *interfaces)
    if (which_ == Which::kAll || IsIgnoredByKernel(interface)) ports.push_back(interface.port);
  std::ranges::sort(ports);
  return ports;
}

Result<std::unique_ptr<ports::HidChannel>> LibusbBus::Open(const std::string& port) {
  return LibusbChannel::Open(port, clock_);
}

}  // namespace kaori::hid
