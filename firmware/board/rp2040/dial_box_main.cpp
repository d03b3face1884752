// The dial and button box on an RP2040.
#include <atomic>
#include <cstdint>

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/pins.h"
#include "firmware/board/rp2040/program.h"
#include "firmware/board/rp2040/registers.h"
#include "firmware/board/rp2040/rom_flash.h"
#include "firmware/board/rp2040/shift_registers.h"
#include "firmware/board/rp2040/start.h"
#include "firmware/board/rp2040/stepping.h"
#include "firmware/board/rp2040/usb_controller.h"
#include "firmware/surface/dial_box.h"
#include "firmware/surface/slots.h"
#include "firmware/surface/updater.h"
#include "firmware/surface/usb_device.h"
#include "firmware/surface/version.h"

namespace kaori::rp2040 {
namespace {

// Whose images the updater accepts, in the form that the image's own head has: vendor id * 65536 + product
// id.
constexpr std::uint32_t kProduct = std::uint32_t{wire::kDialBoxVendor} << 16 | wire::kDialBoxProduct;
static_assert(surface::DialBox::kLooksPerSecond == kLooksPerSecond);

// Set before the timer runs; null on a chip that is refused, where nobody looks at the dials.
std::atomic<surface::DialBox*> looked_at{nullptr};

surface::DialLines ReadDials() {
  return static_cast<surface::DialLines>(At(kPinsIn) >> kFirstDialPin);
}

}  // namespace

// In the timer's interrupt, 40 000 times a second.
void Look() {
  if (auto* const box = looked_at.load(std::memory_order_acquire)) box->Look(ReadDials());
  CountLook();
}

// The watchdog runs before anything that could wait for ever. The device connects to USB only when all is
// built that answers the host, and the box is named to the interrupt before the timer calls Look. All objects
// live on this stack for good, since Run does not return.
void Main() {
  Watch(kWatchdogMs);
  StartClocks();
  SetUp(kDialBoxPins);
  ShiftRegisters::Start();

  RomFlash flash;
  const auto chip_id = flash.UniqueId();
  const surface::Unit unit{.major = surface::kVersionMajor,
                           .minor = surface::kVersionMinor,
                           .counts_per_turn = wire::kDialCountsPerTurn,
                           .hardware = kHardwareRp2040,
                           .chip_id = chip_id,
                           .stepping = ReadStepping()};
  const surface::UsbIdentity identity{.vendor = wire::kDialBoxVendor,
                                      .product = wire::kDialBoxProduct,
                                      .release_bcd = surface::kVersionMajor << 8 | surface::kVersionMinor,
                                      .name = "Kaori dial and button box",
                                      .report_descriptor = wire::kDialBoxDescriptor,
                                      .takes_output = true,
                                      .chip_id = chip_id};
  // Before anything of the box is made: what refuses borrows none of it.
  if (!IsFit(unit.stepping)) Refuse(identity, unit);
  surface::Updater updater(flash, {.slot = static_cast<surface::Slot>(ToldSlot()),
                                   .product = kProduct,
                                   .oldest_version = surface::kOldestVersion});
  surface::DialBox box(unit, &updater);
  UsbController usb;
  surface::UsbDevice device(identity, box, usb);
  usb.Start();
  looked_at.store(&box, std::memory_order_release);
  StartLooking();
  std::uint32_t lamps = 0;
  Run(box, device, usb, [&] { lamps = box.Tick(ShiftRegisters::Exchange(lamps)); });
}

}  // namespace kaori::rp2040
