// The dial and button box on an RP2040.
#include <atomic>
#include <cstdint>

#include "firmware/board/rp2040/chip.h"
#include "firmware/board/rp2040/pins.h"
#include "firmware/board/rp2040/registers.h"
#include "firmware/board/rp2040/rom_flash.h"
#include "firmware/board/rp2040/shift_registers.h"
#include "firmware/board/rp2040/start.h"
#include "firmware/board/rp2040/usb_controller.h"
#include "firmware/surface/dial_box.h"
#include "firmware/surface/slots.h"
#include "firmware/surface/updater.h"
#include "firmware/surface/usb_device.h"
#include "firmware/surface/version.h"

namespace kaori::rp2040 {
namespace {

constexpr std::uint32_t kLooksInATick = surface::DialBox::kLooksPerSecond / surface::DialBox::kTicksPerSecond;
constexpr std::uint8_t kHardwareRp2040 = 1;
constexpr std::uint32_t kWatchdogMs = 100;
// The answer to the command that asks for a restart is fetched within that.
constexpr std::uint32_t kLooksToRestart = surface::DialBox::kLooksPerSecond / 20;
constexpr std::uint32_t kProduct = std::uint32_t{wire::kDialBoxVendor} << 16 | wire::kDialBoxProduct;

// What the timer's interrupt and the rest of the program share. The interrupt alone writes the number of looks.
std::atomic<surface::DialBox*> looked_at{nullptr};
std::atomic<std::uint32_t> looks{0};

surface::DialLines ReadDials() {
  return static_cast<surface::DialLines>(At(kPinsIn) >> kFirstDialPin);
}

void StartLooking(surface::DialBox& box) {
  looked_at.store(&box, std::memory_order_release);
  At(kSysTickReload) = kClockHz / surface::DialBox::kLooksPerSecond - 1;
  At(kSysTickValue) = 0;
  At(kSysTickControl) = 7;  // The processor's clock, with an interrupt.
}

[[noreturn]] void Run(surface::DialBox& box, surface::UsbDevice& device, UsbController& usb) {
  std::uint32_t ticked_at = 0, restart_at = 0, lamps = 0;
  for (;;) {
    asm volatile("wfi" ::: "memory");
    const std::uint32_t now = looks.load(std::memory_order_relaxed);
    usb.Service(device);
    device.Poll();
    if (now - ticked_at < kLooksInATick) continue;
    // After an operation of the flash, which takes many ticks, there is one.
    ticked_at = now;
    lamps = box.Tick(ShiftRegisters::Exchange(lamps));
    // Here the looks have moved, and USB and the reports had their turn: whichever stands still, the watchdog bites.
    Watch(kWatchdogMs);
    if (!box.wants_restart()) restart_at = now + kLooksToRestart;
    if (static_cast<std::int32_t>(now - restart_at) > 0) Restart();
  }
}

}  // namespace

void Look() {
  looked_at.load(std::memory_order_acquire)->Look(ReadDials());
  looks.store(looks.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

void Main() {
  Watch(kWatchdogMs);
  StartClocks();
  SetUp(kDialBoxPins);
  ShiftRegisters::Start();

  RomFlash flash;
  const auto chip_id = flash.UniqueId();
  surface::Updater updater(flash, {.slot = static_cast<surface::Slot>(ToldSlot()),
                                   .product = kProduct,
                                   .oldest_version = surface::kOldestVersion});
  surface::DialBox box({.major = surface::kVersionMajor,
                        .minor = surface::kVersionMinor,
                        .counts_per_turn = wire::kDialCountsPerTurn,
                        .hardware = kHardwareRp2040,
                        .chip_id = chip_id},
                       &updater);
  UsbController usb;
  surface::UsbDevice device({.vendor = wire::kDialBoxVendor,
                             .product = wire::kDialBoxProduct,
                             .release_bcd = surface::kVersionMajor << 8 | surface::kVersionMinor,
                             .name = "Kaori dial and button box",
                             .report_descriptor = wire::kDialBoxDescriptor,
                             .takes_output = true,
                             .chip_id = chip_id},
                            box, usb);
  usb.Start();
  StartLooking(box);
  Run(box, device, usb);
}

}  // namespace kaori::rp2040
