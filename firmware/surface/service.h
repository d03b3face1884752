// What every control surface does with its feature report: lamps' brightness, updates, restarting.
#pragma once

#include <cstdint>
#include <optional>

#include "firmware/surface/lamps.h"
#include "firmware/surface/updater.h"
#include "firmware/wire/surface_feature.h"

namespace kaori::surface {

// Of this one device, for its status.
struct Unit {
  std::uint16_t major = 0;
  std::uint16_t minor = 0;
  std::uint16_t counts_per_turn = 0;
  std::uint8_t hardware = 0;
  std::array<std::uint8_t, 8> chip_id{};
  wire::ChipStepping stepping = wire::ChipStepping::kUntold;
};

// One side.
class Service {
 public:
  // Borrows the updater, which may be none: a surface without flash, as in the simulator, refuses updates.
  Service(const Unit& unit, Updater* updater) : unit_(unit), updater_(updater) {}

  wire::SurfaceStatus Status(std::uint32_t double_steps) const;
  // False: refused. Calibration is the stick pod's own.
  bool Accept(const wire::SurfaceCommand& command, Lamps& lamps);

  bool tests_lamps() const { return tests_lamps_; }
  // Somebody asked for it, and the answer has to be on its way first.
  bool wants_restart() const { return wants_restart_; }

 private:
  bool Update(const wire::SurfaceCommand& command);

  const Unit unit_;
  Updater* updater_;
  bool tests_lamps_ = false;
  bool wants_restart_ = false;
};

}  // namespace kaori::surface
