// A box that starts from a USB disk: which devices on USB belong to that disk, and that all others are cut off again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kaori::boot {

// The names of the USB devices on the way to the disk from which the box started, from the bus on, as in "usb2", "2-1",
// "2-1.4"; none where it is not on USB. `blocks` is /sys/class/block.
std::vector<std::string> UsbMedium(const std::filesystem::path& blocks);

// Such a box's kernel authorises every device by itself, or it would not find its root (usbcore.authorized_default=1, as
// `./box image --medium usb` has it on the command line). From now on each bus authorises none, and what came before and
// is not on the way to the disk is cut off: udev decides about it, as about whatever comes later. Gives the names of what
// was cut off. Where the buses authorise nothing in any case this does nothing. `devices` is /sys/bus/usb/devices; blocks until
// their drivers have let go. What cannot be written is passed over.
std::vector<std::string> DeauthoriseOthers(const std::filesystem::path& devices,
                                           const std::vector<std::string>& medium);

}  // namespace kaori::boot
