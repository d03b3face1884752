// The stick pod on an RP2040.
#include <cstdint>

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/converter.h"
#include "firmware/board/rp2040/pins.h"
#include "firmware/board/rp2040/program.h"
#include "firmware/board/rp2040/rom_flash.h"
#include "firmware/board/rp2040/shift_registers.h"
#include "firmware/board/rp2040/start.h"
#include "firmware/board/rp2040/stepping.h"
#include "firmware/board/rp2040/usb_controller.h"
#include "firmware/surface/slots.h"
#include "firmware/surface/stick_pod.h"
#include "firmware/surface/updater.h"
#include "firmware/surface/usb_device.h"
#include "firmware/surface/version.h"

namespace kaori::rp2040 {
namespace {

// Whose images the updater accepts: vendor id * 65536 + product id.
constexpr std::uint32_t kProduct = std::uint32_t{wire::kStickPodVendor} << 16 | wire::kStickPodProduct;

// Codes of 12 bits, in the order of the converter's channels, which is that of StickPod's axes. Read one
// after the other within a tick: the first is some tens of microseconds older than the last.
surface::StickPod::Codes ReadAxes() {
  surface::StickPod::Codes codes;
  for (unsigned channel = 0; channel < codes.size(); ++channel) codes[channel] = Converter::Read(channel);
  return codes;
}

// Of the 32 bits that come, the first 16 are of its two registers.
std::uint32_t ReadSwitches() {
  return ShiftRegisters::Exchange(0) >> 16;
}

}  // namespace

// In the timer's interrupt. A pod has no line that must be seen so often; the count alone paces the loop.
void Look() {
  CountLook();
}

// As the dial box's: the watchdog first, the USB connection only when everything is there that answers the
// host. The pod also borrows the flash, where it keeps the ends of its axes.
void Main() {
  Watch(kWatchdogMs);
  StartClocks();
  SetUp(kStickPodPins);
  ShiftRegisters::Start();
  Converter::Start();

  RomFlash flash;
  const auto chip_id = flash.UniqueId();
  const surface::Unit unit{.major = surface::kVersionMajor,
                           .minor = surface::kVersionMinor,
                           .hardware = kHardwareRp2040,
                           .chip_id = chip_id,
                           .stepping = ReadStepping()};
  const surface::UsbIdentity identity{.vendor = wire::kStickPodVendor,
                                      .product = wire::kStickPodProduct,
                                      .release_bcd = surface::kVersionMajor << 8 | surface::kVersionMinor,
                                      .name = "Kaori stick pod",
                                      .report_descriptor = wire::kStickPodDescriptor,
                                      .chip_id = chip_id};
  // As the dial box does; a pod's converter is never asked then.
  if (!IsFit(unit.stepping)) Refuse(identity, unit);
  surface::Updater updater(flash, {.slot = static_cast<surface::Slot>(ToldSlot()),
                                   .product = kProduct,
                                   .oldest_version = surface::kOldestVersion});
  surface::StickPod pod(unit, &updater, &flash);
  UsbController usb;
  surface::UsbDevice device(identity, pod, usb);
  usb.Start();
  StartLooking();
  Run(pod, device, usb, [&] { pod.Tick(ReadSwitches(), ReadAxes()); });
}

}  // namespace kaori::rp2040
