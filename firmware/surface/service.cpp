#include "firmware/surface/service.h"

#include <span>

namespace kaori::surface {

// The serial number of the status is the first word of the chip's own.
wire::SurfaceStatus Service::Status(std::uint32_t double_steps) const {
  return {.firmware_major = unit_.major,
          .firmware_minor = unit_.minor,
          .serial = wire::GetU32(unit_.chip_id, 0),
          .counts_per_turn = unit_.counts_per_turn,
          .hardware = unit_.hardware,
          .state = updater_ != nullptr ? updater_->state() : wire::SurfaceState::kPlays,
          .bytes_taken = updater_ != nullptr ? updater_->bytes_taken() : 0,
          .double_steps = double_steps,
          .chip_id = unit_.chip_id,
          .stepping = unit_.stepping};
}

// Every argument is looked at before anything changes. A restart only sets a flag: the answer to this very
// command has to leave first.
bool Service::Accept(const wire::SurfaceCommand& command, Lamps& lamps) {
  if (command.length > wire::kSurfaceDataBytes) return false;
  switch (command.operation) {
    case wire::SurfaceOperation::kLampTest:
      if (command.number > 1) return false;
      tests_lamps_ = command.number == 1;
      return true;
    case wire::SurfaceOperation::kBrightness:
      if (command.number > Lamps::kBrightest) return false;
      lamps.set_brightness(command.number);
      return true;
    case wire::SurfaceOperation::kRestart:
      wants_restart_ = true;
      return true;
    default:
      return updater_ != nullptr && Update(command);
  }
}

// The updater checks the order of these; here is only who is called.
bool Service::Update(const wire::SurfaceCommand& command) {
  const auto data = std::span(command.data);
  switch (command.operation) {
    case wire::SurfaceOperation::kBegin:
      return command.length == wire::kSurfaceImageBytes &&
             updater_->Begin(wire::DecodeSurfaceImage(data.first<wire::kSurfaceImageBytes>()));
    case wire::SurfaceOperation::kData:
      return updater_->Data(command.offset, data.first(command.length));
    case wire::SurfaceOperation::kEnd:
      return updater_->End();
    case wire::SurfaceOperation::kKeep:
      updater_->Keep();
      return true;
    default:
      return false;
  }
}

}  // namespace kaori::surface
