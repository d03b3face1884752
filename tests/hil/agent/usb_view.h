// The USB devices of a machine, and whether they are authorised.
#pragma once

#include <string>

namespace kaori::agent {

// "PORT VENDOR:PRODUCT 0|1", a line each, root hubs left out; of a folder such as /sys/bus/usb/devices.
std::string UsbDevices(const std::string& folder);

}  // namespace kaori::agent
