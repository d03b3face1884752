// What well-known tools say of the devices; kept in the report.
#include <fmt/format.h>

#include "hw-sim/bench/check.h"

namespace kaori::bench {
namespace {

constexpr Duration kLongest = std::chrono::minutes(3);

struct Tool {
  const char* name;
  const char* question;
};

// evtest stays until it is ended.
constexpr std::array kTools{
    Tool{"lsusb", "tool lsusb"},
    Tool{"gpiodetect", "tool gpiodetect"},
    Tool{"gpioinfo", "tool gpioinfo"},
    Tool{"evtest (left joystick)", "tool timeout 2 evtest /dev/input/event0"},
    Tool{"v4l2-ctl", "tool v4l2-ctl -d /dev/video0 --all"},
    Tool{"v4l2-compliance", "tool v4l2-compliance -d /dev/video0"},
    Tool{"the log", "own /usr/bin/journalctl -b --no-pager -o short-monotonic -n 120"},
};

Result<void> Tools(Scene& scene) {
  int answered = 0;
  for (const Tool& tool : kTools) {
    const auto said = scene.place.witness().Ask(tool.question, kLongest);
    scene.finding.texts.emplace_back(tool.name, said ? *said : said.error().message());
    answered += said.has_value() ? 1 : 0;
  }
  scene.finding.said = fmt::format("{} outputs, {} without complaint", scene.finding.texts.size(), answered);
  return {};
}

}  // namespace

std::vector<Check> ToolChecks() {
  return {{"tools", "What evtest, v4l2-compliance, gpiodetect and others say", false, Tools}};
}

}  // namespace kaori::bench
