#include "tests/hil/agent/simulated_dials.h"

#include <fcntl.h>
#include <sys/mount.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"

namespace kaori::agent {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConfig = "/sys/kernel/config";
constexpr const char* kChip = "/sys/kernel/config/gpio-sim/kaori";
// A program that requests the lines with pull-ups, as encoders want them, sets the simulated levels high too.

// Attributes take their value in one write.
Result<void> Put(const fs::path& file, std::string_view text) {
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!fd.valid()) return FailErrno("open " + file.string());
  if (::write(fd.get(), text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    return FailErrno("write " + file.string());
  return {};
}

Result<std::string> Line(const fs::path& file) {
  return ReadFile(file).map([](const std::string& text) { return text.substr(0, text.find('\n')); });
}

}  // namespace

// A chip that was made before is used again: its name stays.
Result<SimulatedDials> SimulatedDials::Make() {
  std::error_code error;
  if (!fs::exists(fs::path(kConfig) / "gpio-sim", error) &&
      ::mount("configfs", kConfig, "configfs", 0, nullptr) != 0 && errno != EBUSY)
    return FailErrno(std::string("mount configfs on ") + kConfig);
  const fs::path bank = fs::path(kChip) / "bank";
  if (!fs::exists(bank, error)) {
    fs::create_directory(kChip, error);
    if (!error) fs::create_directory(bank, error);
    if (error) return Fail(static_cast<std::errc>(error.value()), "make a chip of gpio-sim");
    if (auto ok = Put(bank / "num_lines", std::to_string(2 * kDials)); !ok) return tl::unexpected(ok.error());
    if (auto ok = Put(fs::path(kChip) / "live", "1"); !ok) return tl::unexpected(ok.error());
  }
  const auto device = Line(fs::path(kChip) / "dev_name"), chip = Line(bank / "chip_name");
  if (!device) return tl::unexpected(device.error());
  if (!chip) return tl::unexpected(chip.error());
  const fs::path lines = fs::path("/sys/devices/platform") / *device / *chip;
  for (int line = 0; line < 2 * kDials; ++line)
    if (auto ok = Put(lines / fmt::format("sim_gpio{}", line) / "pull", "pull-up"); !ok)
      return tl::unexpected(ok.error());
  return SimulatedDials(*chip, lines);
}

Result<void> SimulatedDials::Step(int dial, int direction) {
  const sim::QuadratureEdge edge = phases_[static_cast<std::size_t>(dial)].Step(direction);
  return Put(lines_ / fmt::format("sim_gpio{}", 2 * dial + edge.line) / "pull",
             edge.is_high ? "pull-up" : "pull-down");
}

Result<void> SimulatedDials::Turn(std::array<int, kDials> edges, int pause_us) {
  while (std::ranges::any_of(edges, [](int left) { return left != 0; }))
    for (int dial = 0; dial < kDials; ++dial) {
      int& left = edges[static_cast<std::size_t>(dial)];
      if (left == 0) continue;
      const int direction = left > 0 ? 1 : -1;
      if (auto ok = Step(dial, direction); !ok) return ok;
      left -= direction;
      ::usleep(static_cast<useconds_t>(pause_us));
    }
  return {};
}

}  // namespace kaori::agent
