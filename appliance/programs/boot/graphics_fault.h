// What is wrong with a PC's graphics, where the processor has to draw since the card does not.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::boot {

// The files of their makers that drivers of graphics cards asked for, could not have, and cannot draw without, by name,
// each once: "amdgpu/polaris10_mc.bin". `kernel_log` is the kernel's log since its start. Files of Intel's that only save
// power or play films (DMC, HuC) are left out. Pure.
std::vector<std::string> WantedFirmware(std::string_view kernel_log);

// The PCI numbers of all graphics cards, as in "1002:67df", where none of them has a driver; nothing where one has, or
// where there is no card. `devices` is /sys/bus/pci/devices.
std::vector<std::string> UndrivenCards(const std::filesystem::path& devices);

// One sentence for each fault, for the box's status.
std::vector<std::string> GraphicsFaults(const std::vector<std::string>& undriven,
                                        const std::vector<std::string>& wanted);

}  // namespace kaori::boot
