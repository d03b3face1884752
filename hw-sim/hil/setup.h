// What a check wants of its target: another kernel, other graphics, other settings on its data partition.
#pragma once

#include <string>

namespace kaori::hil {

// The graphics card of the machine. kVirtio: pictures are drawn by the box's processor. kVirgl: a virtio card
// whose GLES is drawn on the bench, in a window under Xvfb. kVga: as a PC's firmware finds it. kNone: no
// card.
enum class Graphics { kVirtio, kVirgl, kVga, kNone };

// Where the image's disk is attached: each bus has a driver of its own in the
// kernel, and another name for the disk. kUsb: without firmware the kernel is told
// to let in what is on USB, as an image for USB has it.
enum class DiskBus { kVirtio, kSata, kNvme, kUsb, kSd };

// All that differs between the boxes of two checks. Checks with equal setups share a box that plays.
struct Setup {
  bool plugged = true;    // The simulated devices are plugged in before power comes.
  bool sound = true;      // It has sound cards.
  bool keyboards = true;  // The profile authorises them.
  // The in-guest agent and the simulated devices are there. Without it the image runs alone, and the serial
  // line is the log of kernel and systemd, a file that QemuDriver::console reads.
  bool agent = true;
  bool firmware = false;         // UEFI starts the disk by itself; otherwise QEMU loads the image's kernel.
  bool watchdog_resets = false;  // The chip set's watchdog resets the machine, as on a PC.
  bool keeps_disk = false;       // What the machine writes to its disk is kept.
  bool bench_kernel = false;     // The box's own settings, and simulated hardware besides.
  bool stock = false;  // A processor with every instruction that QEMU emulates, and 2 GiB of memory.
  // The machine's time is that of its instructions, a nanosecond each, whatever else this computer does
  // meanwhile. It has one processor: of two, QEMU lets one run until the next timer of any, and a busy one
  // would leave the other next to nothing.
  bool counts_instructions = false;
  // Without a card the machine is for those who want its log.
  Graphics graphics = Graphics::kVirtio;
  DiskBus disk_bus = DiskBus::kVirtio;
  bool other_stick = false;  // A USB stick with nothing on it is plugged in before power comes.
  bool tells_size = true;    // The screen has an EDID, as good ones have.
  int screens =
      0;  // Outputs whose screens can be plugged in and unplugged; 0: one output, whose screen stays.
  int width_px = 0;  // Of the screen; 0: as for the other checks.
  int height_px = 0;
  std::string image{};      // Another folder with bzImage and cmdline; empty: the bench's.
  std::string initramfs{};  // Empty: none.
  std::string disk{};       // Another disk; empty: the image's.
  // What a firmware with Secure Boot keeps, a file that it writes; empty: a firmware without, which keeps nothing.
  std::string variables{};
  std::string settings{};       // box.toml; empty: as the image has it.
  std::string last_settings{};  // That which was good before; empty: none.
  friend bool operator==(const Setup&, const Setup&) = default;
};

}  // namespace kaori::hil
