#include "appliance/programs/surface/surface_command.h"

#include <algorithm>
#include <array>

#include "appliance/programs/surface/surface_update.h"
#include "drivers/base/number.h"

namespace kaori::surface_update {
namespace {

using wire::SurfaceOperation;

constexpr int kBrightest = 15;  // As the firmware has it (surface/lamps.h).

// 1 and 0 of two words.
Result<wire::SurfaceCommand> OneOfTwo(SurfaceOperation operation, std::string_view option,
                                      std::string_view value, std::string_view one, std::string_view zero) {
  if (value != one && value != zero)
    return FailInput("--" + std::string(option) + ": expected " + std::string(one) + " or " +
                     std::string(zero));
  return wire::SurfaceCommand{
      .operation = operation, .number = static_cast<std::uint8_t>(value == one ? 1 : 0), .data = {}};
}

// What a STALL may mean, since a surface has no words of its own.
std::string Refusal(SurfaceOperation operation) {
  if (operation == SurfaceOperation::kCalibrate)
    return " (it has no axes, was not told to begin, or one of its axes was not moved from stop to stop)";
  return " (its firmware does not know the command)";
}

}  // namespace

// The report has no id; the first byte stands for it.
Result<void> Send(ports::HidChannel& channel, const wire::SurfaceCommand& command) {
  std::array<std::uint8_t, 1 + wire::kSurfaceFeatureBytes> report{};
  std::ranges::copy(wire::Encode(command), report.begin() + 1);
  return channel.SetFeature(report);
}

// Options are those of main.cpp, without their dashes: whatever is none of the first two is the brightness.
Result<wire::SurfaceCommand> ParseCommand(std::string_view option, std::string_view value) {
  if (option == "lamp-test") return OneOfTwo(SurfaceOperation::kLampTest, option, value, "on", "off");
  if (option == "calibrate") return OneOfTwo(SurfaceOperation::kCalibrate, option, value, "begin", "end");
  const auto brightness = ParseNumber<int>(value);
  if (!brightness || *brightness < 0 || *brightness > kBrightest)
    return FailInput("--" + std::string(option) + ": expected a whole number from 0 to 15");
  return wire::SurfaceCommand{.operation = SurfaceOperation::kBrightness,
                              .number = static_cast<std::uint8_t>(*brightness),
                              .data = {}};
}

// A surface that refuses answers with a STALL, of which drivers know several names: whatever it is, the words
// say what it may be.
Result<std::string> GiveCommand(ports::HidBus& bus, const std::string& port,
                                const wire::SurfaceCommand& command) {
  auto channel = bus.Open(port);
  if (!channel) return tl::unexpected(channel.error());
  const std::uint32_t product = ProductOf((*channel)->identity());
  if (product != kDialBoxImage && product != kStickPodImage)
    return FailInput(port + ": is none of our surfaces");
  if (auto sent = Send(**channel, command); !sent)
    return Fail(sent.error().cause, sent.error().attempt + Refusal(command.operation));
  if (command.operation != SurfaceOperation::kCalibrate) return "done";
  return command.number == 1 ? "let all axes rest, move each from stop to stop, and then say --calibrate end"
                             : "the ends and centres of all axes are kept in the pod";
}

}  // namespace kaori::surface_update
