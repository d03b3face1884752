// Dials on simulated GPIO lines of the kernel (gpio-sim): encoders that a hand in the guest turns.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "drivers/base/result.h"
#include "hw-sim/devices/quadrature_phase.h"

namespace kaori::agent {

// One chip of 16 lines: A and B of the first dial, A and B of the second, and so on. The chip stays when this
// goes. For a process that may mount.
class SimulatedDials {
 public:
  static constexpr int kDials = 8;

  // All lines are high, as pull-ups leave them. Makes the chip by configfs, which is mounted where it is not yet. `name` is the chip's, such as "gpiochip1".
  // Errors: those of the files; no_such_file_or_directory where the kernel has no gpio-sim.
  static Result<SimulatedDials> Make();

  const std::string& name() const { return name_; }

  // Moves each dial by its own number of edges, clockwise where that is positive: the first edge of each, then the
  // second of each, as those of an operator do who turns several at once, with `pause_us` after each edge. Errors: those of the files.
  Result<void> Turn(std::array<int, kDials> edges, int pause_us);

 private:
  SimulatedDials(std::string name, std::filesystem::path lines)
      : name_(std::move(name)), lines_(std::move(lines)) {}
  // Moves one dial by one edge.
  Result<void> Step(int dial, int direction);

  std::string name_;
  std::filesystem::path lines_;  // With a folder for each line, whose file `pull` is its level.
  std::array<sim::QuadraturePhase, kDials> phases_{};
};

}  // namespace kaori::agent
