// A rig, a console and a toy stage in one program: what the browser test plays on, without the appliance.
// Usage: console-harness FOLDER [PORT]     prints the page's address, then what the drivers decode.

#include <cstdio>
#include <cstdlib>

#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "hw-sim/console/console.h"
#include "hw-sim/links/local/rig.h"
#include "tests/hw-sim/console_toy_stage.h"

namespace kaori::console {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(4);

Labels HarnessLabels() {
  Labels labels;
  for (std::size_t dial = 0; const char* text : {"Amount", "Speed", "Idle life", "Light"})
    labels.dials[dial++].text = text;
  labels.buttons[0] = {"Kaori", "face"};
  labels.buttons[1] = {"Dog", "face"};
  labels.buttons[8] = {"Smile", "expression"};
  labels.buttons[24] = {"Wireframe", "style"};
  labels.sticks = {{{"Head", "Tilt", "Lean in"}, {"Gaze and brows"}}};
  labels.sticks[1].buttons[11] = {"Laugh", "motion"};
  labels.keys = {{0x2C, "Blink", "blink"}, {0x1E, "Nod", "motion"},      {0x3A, "Poster", "scene"},
                 {0x15, "Hair", "style"},  {0x14, "Wireframe", "style"}, {0x1A, "Flat", "style"}};
  labels.scenes = {"Studio", "Poster"};
  labels.styles = {"Wireframe", "Flat"};
  return labels;
}

Result<void> Play(const std::string& folder, std::uint16_t port) {
  SteadyClock clock;
  auto loop = EventLoop::Open();
  if (!loop) return tl::unexpected(loop.error());
  auto rig = sim::Rig::Open({.folder = folder, .wakes_by_timer = true}, clock);
  if (!rig) return tl::unexpected(rig.error());
  auto console =
      Console::Open({.port = port,
                     .labels = HarnessLabels(),
                     .on_stage =
                         [] {
                           return json::Object{{"scene", 1},       {"style", 0},     {"cue", 0},
                                               {"standby", 1},     {"pending", -1},  {"left_s", 0},
                                               {"paused", false},  {"black", false}, {"panicking", false},
                                               {"waiting", false}, {"refused", 0}};
                         }},
                    **rig, *loop);
  if (!console) return tl::unexpected(console.error());
  auto stage = ToyStage::Open(folder);
  if (!stage) return tl::unexpected(stage.error());
  std::puts((*console)->address().c_str());
  std::fflush(stdout);
  if (auto ok = loop->Watch((*rig)->pollable(), [&] { (*rig)->Pump(); }); !ok) return ok;
  if (auto ok = loop->Every(kStep, [&] { (*stage)->Step(); }); !ok) return ok;
  return loop->Run();
}

}  // namespace
}  // namespace kaori::console

int main(int count, char** words) {
  kaori::SetLogName("console-harness");
  if (count < 2) {
    kaori::LogError("usage: console-harness FOLDER [PORT]");
    return EXIT_FAILURE;
  }
  const auto port = static_cast<std::uint16_t>(count > 2 ? std::atoi(words[2]) : 0);
  if (auto played = kaori::console::Play(words[1], port); !played) {
    kaori::LogError("{}", played.error().message());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
