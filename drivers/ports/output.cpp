#include "drivers/ports/output.h"

#include <fmt/format.h>

namespace kaori::ports {
namespace {

const char* Text(ModeOrigin origin) {
  switch (origin) {
    case ModeOrigin::kSubstitute:
      return ", in place of what the card refuses";
    case ModeOrigin::kSafeGuess:
      return ", which is safe: the screen itself asks for no mode";
    case ModeOrigin::kWanted:
      break;
  }
  return "";
}

const char* Text(OutputState state) {
  switch (state) {
    case OutputState::kUnplugged:
      return ", pulled";
    case OutputState::kShowsStatus:
      return ", shows the status";
    case OutputState::kShowsMonitor:
      return ", shows the operators' monitor";
    case OutputState::kShowsPicture:
      break;
  }
  return "";
}

}  // namespace

std::string DescribeMode(const Output& output) {
  // Four digits tell 59.94 from 60.
  return fmt::format("{} x {} at {:.4g} Hz{}{}", output.width_px, output.height_px, output.rate_hz,
                     Text(output.origin), Text(output.state));
}

std::string Describe(const Output& output) {
  return output.connector + " " + DescribeMode(output);
}

}  // namespace kaori::ports
