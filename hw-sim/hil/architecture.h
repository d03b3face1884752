// The processors that images are built for, and what a virtual machine of each is in QEMU's words.
#pragma once

#include <optional>
#include <string_view>

namespace kaori::hil {

// kAmd64: a PC of Intel's or AMD's. kArm64: a machine of 64-bit ARM. The same two are rows of rootfs/image/architectures.py.
enum class Architecture { kAmd64, kArm64 };

// What differs between machines of two architectures; all views are of constants, which live as long as the program.
struct Platform {
  // Debian's name of the processor, which --arch and the image's builder take too.
  std::string_view name;
  // QEMU's program.
  std::string_view qemu;
  // q35 is a PC with PCI Express and ICH9. virt describes itself to a kernel that QEMU loads by a device tree, and to
  // firmware by ACPI.
  std::string_view machine;
  // An old processor: with a newer one's instructions emulation is many times slower.
  std::string_view processor;
  // The kernel's file in the image's folder.
  std::string_view kernel;
  // UEFI, of Debian's packages ovmf and qemu-efi-aarch64.
  std::string_view firmware;
  // Linux's name of the first serial line.
  std::string_view serial;
};

// Pure.
const Platform& PlatformOf(Architecture architecture);

// By Debian's name; nothing where there is no such one. Pure.
std::optional<Architecture> ParseArchitecture(std::string_view name);

}  // namespace kaori::hil
