// Configurations of USB devices that hide a storage interface from readers other than the kernel, as udev's builtin usb_id
// (systemd 252), which takes each of them for a mouse or a sound card alone.
#pragma once

#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// A mouse, a descriptor of two bytes, at which such a reader stops, and storage.
UsbBytes StorageBehindAShortDescriptor();

// A sound interface with 80 settings, each of another subclass, which fill such a reader's list, and storage.
UsbBytes StorageBehindManySettings();

// A mouse, and storage without endpoints as the last nine bytes, which such a reader does not look at.
UsbBytes StorageAtTheVeryEnd();

}  // namespace kaori::sim
