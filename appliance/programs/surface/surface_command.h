// Single commands to a control surface, as a technician gives them: lamp test, brightness, calibration.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/base/result.h"
#include "drivers/ports/hid_channel.h"
#include "firmware/wire/surface_feature.h"

namespace kaori::surface_update {

// Writes one feature report. Errors: those of HidChannel::SetFeature; what the surface refuses is io_error or
// broken_pipe, by the driver.
Result<void> Send(ports::HidChannel& channel, const wire::SurfaceCommand& command);

// Of an option of kaori-surface and its value: "lamp-test" on or off, "brightness" 0 to 15, "calibrate" begin or end.
// Errors: invalid_argument, which says what is expected.
Result<wire::SurfaceCommand> ParseCommand(std::string_view option, std::string_view value);

// Gives the command to the surface at that port, and returns what the person is to be told. Errors: those of
// HidBus::Open and Send, in words; invalid_argument, where the device is none of our surfaces.
Result<std::string> GiveCommand(ports::HidBus& bus, const std::string& port,
                                const wire::SurfaceCommand& command);

}  // namespace kaori::surface_update
