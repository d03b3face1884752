// What well-known tools say of the devices; kept in the report.
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/kernel_fault.h"

namespace kaori::hil {
namespace {

// v4l2-compliance tries everything that a camera can be asked for.
constexpr Duration kToolLongest = std::chrono::minutes(3);

constexpr std::size_t kMostAnswer_bytes = std::size_t{64} * 1024;  // Of the agent, which cuts what is longer.

// A question to the agent whose answer is kept under this name.
struct Tool {
  const char* name;
  const char* question;
};

constexpr std::array kTools{
    Tool{"lsusb", "tool lsusb"},
    Tool{"gpiodetect", "tool gpiodetect"},
    Tool{"gpioinfo", "tool gpioinfo"},
    Tool{"v4l2-ctl", "tool v4l2-ctl -d /dev/video0 --all"},
    Tool{"kaori-lips releases the camera", "own /usr/bin/systemctl stop kaori-lips.service"},
    Tool{"v4l2-compliance", "tool v4l2-compliance -d /dev/video0"},
    Tool{"kaori-lips opens it again", "own /usr/bin/systemctl start kaori-lips.service"},
    Tool{"input devices", "read /proc/bus/input/devices"},
    Tool{"the kernel's log", "own /usr/bin/journalctl -k --no-pager -o short-monotonic -n 200"},
    Tool{"the stage's log", "own /usr/bin/journalctl -b --no-pager -o short-monotonic -n 60 -u kaori-stage"},
    Tool{"the input program's log",
         "own /usr/bin/journalctl -b --no-pager -o short-monotonic -n 60 -u kaori-input"},
    Tool{"the lips' log", "own /usr/bin/journalctl -b --no-pager -o short-monotonic -n 60 -u kaori-lips"},
};

// "/dev/input/event3" of the device that the kernel lists by that name; empty where there is none.
std::string EventFile(const std::string& devices, const std::string& name) {
  const std::size_t device = devices.find(name);
  const std::size_t event = device == std::string::npos ? device : devices.find("event", device);
  if (event == std::string::npos) return {};
  return "/dev/input/" + devices.substr(event, devices.find_first_of(" \n", event) - event);
}

// evtest stays until it is ended; meanwhile both sticks move: which of them the kernel lists first is chance.
void Evtest(Scene& scene) {
  const auto listed = scene.target.agent().Ask("read /proc/bus/input/devices", kToolLongest);
  const std::string file = listed ? EventFile(*listed, "stick pod") : "";
  if (file.empty()) return;
  sim::InputDevices& devices = scene.target.rig().devices();
  float x = 0;
  scene.target.SetInput([&](Time) {
    x = x > 0.9F ? -0.9F : x + 0.01F;
    devices.left_stick.Move(x, 0);
    devices.right_stick.Move(x, 0);
  });
  const auto said =
      scene.target.agent().Ask("tool timeout -s INT --preserve-status 3 evtest " + file, kToolLongest);
  scene.target.SetInput({});
  devices.left_stick.Move(0, 0);
  devices.right_stick.Move(0, 0);
  scene.finding.texts.emplace_back("evtest", said ? *said : said.error().message());
}

// Their words are in the report; a tool that ends with an error counts as one that complains.
Result<void> Tools(Scene& scene) {
  int answered = 0;
  Evtest(scene);
  for (const Tool& tool : kTools) {
    const auto said = scene.target.agent().Ask(tool.question, kToolLongest);
    scene.finding.texts.emplace_back(tool.name, said ? *said : said.error().message());
    answered += said.has_value() ? 1 : 0;
    // The others may lack here and there; without a camera this list says nothing.
    if (!said && std::string_view(tool.name) == "v4l2-ctl") return FailInput("v4l2-ctl sees no camera");
  }
  scene.finding.said = fmt::format("{} outputs, {} without complaint", scene.finding.texts.size(), answered);
  return {};
}

// The first line of a kernel's log that tells of a fault of the kernel itself; empty where there is none.
std::string KernelFault(const std::string& log) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (TellsOfKernelFault(line)) return line;
  return {};
}

// The input program ends and starts once, so that drivers let go of all devices while these are plugged in.
// Faults are looked for among warnings and what is worse: an answer holds 64 KiB, and each plug adds to the
// rest of the log.
Result<void> KernelWithoutFault(Scene& scene) {
  const auto ask = [&](const char* question) { return scene.target.agent().Ask(question, kToolLongest); };
  if (auto ok = ask("own /usr/bin/systemctl restart kaori-input.service"); !ok)
    return tl::unexpected(ok.error());
  const auto log = ask("own /usr/bin/journalctl -k -b --no-pager -o cat");
  if (!log) return tl::unexpected(log.error());
  if (log->find("Linux version") == std::string::npos)
    return FailInput("the kernel's log does not reach back to its start");
  const auto warnings = ask("own /usr/bin/journalctl -k -b -p warning --no-pager -o cat");
  if (!warnings) return tl::unexpected(warnings.error());
  if (warnings->size() >= kMostAnswer_bytes) return FailInput("the kernel warns more than can be read here");
  if (const std::string fault = KernelFault(*warnings); !fault.empty())
    return FailInput("the kernel says: " + fault);
  scene.finding.said = fmt::format("{} bytes of warnings without a fault", warnings->size());
  return {};
}

// A fault that is planted in the log is found. It stays there: whoever else reads the log knows it.
Result<void> PlantedFault(Scene& scene) {
  const auto planted =
      scene.target.agent().Ask(fmt::format("write /dev/kmsg {}", kPlantedFault), kToolLongest);
  if (!planted) return tl::unexpected(planted.error());
  return WantFoundWrong(KernelWithoutFault(scene), "a fault in the kernel's log is not seen");
}

}  // namespace

std::vector<Check> ToolChecks() {
  return {{.name = "tools",
           .sentence = "What evtest, v4l2-compliance, gpiodetect and others say",
           .run = Tools,
           .fails_without = "camera",
           .ends_programs = true},
          {.name = "kernel",
           .sentence = "The kernel tells of no fault of its own",
           .chosen = true,
           .run = KernelWithoutFault,
           .control = PlantedFault,
           .ends_programs = true}};
}

}  // namespace kaori::hil
