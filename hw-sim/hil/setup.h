// What a check wants of its target: another kernel, other graphics, other settings on its data partition.
#pragma once

#include <string>

namespace kaori::hil {

// The graphics card of the machine. kVirtio: pictures are drawn by the box's processor, which is emulated, and has no time left for
// anything else. kVirgl: a virtio card whose GLES is drawn on the bench, in a window under Xvfb. kUsual: the one of these two
// that QemuOptions name. kVga: as a PC's firmware finds it. kNone: no card.
enum class Graphics { kUsual, kVirtio, kVirgl, kVga, kNone };

// Where the image's disk is attached: each bus has a driver of its own in the
// kernel, and another name for the disk. kUsb: without firmware the kernel is told
// to authorise what is on USB, as an image for USB has it.
enum class DiskBus { kVirtio, kSata, kNvme, kUsb, kSd };

// All that differs between the boxes of two checks. Checks with equal setups share a box that plays.
struct Setup {
  // The simulated devices are plugged in before power comes.
  bool plugged = true;
  // It has sound cards.
  bool sound = true;
  // One on USB instead, which only plays.
  bool usb_sound = false;
  // The profile authorises them.
  bool keyboards = true;
  // The in-guest agent and the simulated devices are there. Without it the image runs alone, and the serial
  // line is the log of kernel and systemd, a file that QemuDriver::console reads.
  bool agent = true;
  // UEFI starts the disk by itself; otherwise QEMU loads the image's kernel.
  bool firmware = false;
  // The chip set's watchdog resets the machine, as on a PC.
  bool watchdog_resets = false;
  // What the machine writes to its disk is kept.
  bool keeps_disk = false;
  // The box's own settings, and simulated hardware besides.
  bool bench_kernel = false;
  // A processor with every instruction that QEMU emulates, and 2 GiB of memory.
  bool stock = false;
  // The machine's time is that of its instructions, a nanosecond each, whatever else this computer does
  // meanwhile. It has one processor: of two, QEMU lets one run until the next timer of any, and a busy one
  // would leave the other next to nothing.
  bool counts_instructions = false;
  // Without a card the machine is for those who want its log.
  Graphics graphics = Graphics::kUsual;
  DiskBus disk_bus = DiskBus::kVirtio;
  // A USB stick with nothing on it is plugged in before power comes.
  bool other_stick = false;
  // The screen has an EDID, as good ones have.
  bool tells_size = true;
  int screens =
      // Outputs whose screens can be plugged in and unplugged; 0: one output, whose screen stays.
      0;
  // Of the screen; 0: as for the other checks.
  int width_px = 0;
  int height_px = 0;
  // Another folder with bzImage and cmdline; empty: the bench's.
  std::string image{};
  // Empty: none.
  std::string initramfs{};
  // Another disk; empty: the image's.
  std::string disk{};
  // What the firmware keeps, a file that it writes; empty: a firmware that keeps nothing.
  std::string variables{};
  // The firmware has Secure Boot; it wants `variables`.
  bool secure_boot = false;
  // Where QEMU notes each write to the disk, for WriteLog; empty: nowhere. The disk then has a cache that the machine
  // flushes, as real ones have.
  std::string write_log{};
  // The same of `variables`.
  std::string variables_log{};
  // A wired network card, by which this computer reaches the box's port 8443 at this one; 0: no card.
  int desk_port = 0;
  // box.toml; empty: as the image has it.
  std::string settings{};
  // That which was good before; empty: none.
  std::string last_settings{};
  friend bool operator==(const Setup&, const Setup&) = default;
};

// A machine whose time is that of its instructions, with the bench's kernel, no device and no screen but that kernel's own:
// neighbours on this computer change nothing but how long a check takes.
inline Setup CountedSetup() {
  return {.plugged = false,
          .sound = false,
          .bench_kernel = true,
          .counts_instructions = true,
          .graphics = Graphics::kNone};
}

}  // namespace kaori::hil
