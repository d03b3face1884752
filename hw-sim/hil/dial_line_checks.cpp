// Dials that are not on USB: the serial boxes of 1993 behind an adapter, and encoders on GPIO lines.
#include <array>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/devices/usb_serial.h"
#include "hw-sim/hil/dial_scene.h"
#include "hw-sim/hil/held_device.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;
using Kind = sim::SerialDialBox::Kind;

constexpr const char* kAdapter = "pointer";  // The socket at which the adapter takes the pointer's place.

// "/dev/serial/by-path/...", which udev of the box makes: the name that its settings are to have.
Result<std::string> SerialLine(Scene& scene) {
  std::string line;
  const auto named = [&] {
    std::istringstream links(
        AskOfDials(scene, "own /usr/bin/udevadm info --query=symlink --name=/dev/ttyUSB0").value_or(""));
    for (std::string link; links >> link;)
      if (link.starts_with("serial/by-path/")) line = "/dev/" + link;
    return !line.empty();
  };
  if (!scene.target.Await(named, kLongestDial, "see the adapter"))
    return FailInput("no adapter was seen by the box");
  return line;
}

// A box tells where its dials stand by their first turns, which move nothing: each is turned until it moves.
Result<void> WakeDials(Scene& scene, sim::SerialDialBox& box) {
  for (const int dial : {0, 7}) {
    const auto n = static_cast<std::size_t>(dial);
    const auto before = scene.target.Board();
    if (!before) return tl::unexpected(before.error());
    Time again{};
    const auto moved = [&](const BoardView& now) {
      const Time at = scene.target.clock().now();
      if (at >= again) box.Turn(dial, 1), again = at + seconds(2);
      return now.surface_live && now.counts[n] != before->counts[n];
    };
    if (auto ok = WantBoard(scene, moved, "a turn of the serial box"); !ok) return tl::unexpected(ok.error());
  }
  return {};
}

// Half a turn and a whole one, both ways and back, since the last dial is the light's; and the last but one button. The box
// without buttons and lamps, the DLS80, is turned alone.
Result<void> TurnAndPush(Scene& scene, sim::SerialDialBox& box, Kind kind) {
  const auto before = scene.SettledBoard();
  if (!before) return tl::unexpected(before.error());
  box.Turn(0, 128);
  box.Turn(7, -256);
  box.Push(30);
  const bool has_buttons = kind != Kind::kDls80;
  const auto turned = [&](const BoardView& now) {
    return now.counts[0] - before->counts[0] == 128 && now.counts[7] - before->counts[7] == -256 &&
           (!has_buttons || now.pushes[30] == before->pushes[30] + 1);
  };
  const auto seen = WantBoard(scene, turned, "what was turned and pushed, to the last count,");
  box.Release(30);
  if (!seen) return tl::unexpected(seen.error());
  const auto lit = [&] {
    return box.lamps() == scene.target.Board().map([](const auto& now) { return now.lamps; });
  };
  if (has_buttons && !scene.target.Await(lit, kLongestDial, "see the lamps"))
    return FailInput("the lamps of the box are not those of the board");
  box.Turn(0, -128);
  box.Turn(7, 256);
  const auto back = [&](const BoardView& now) { return now.counts == before->counts; };
  return WantBoard(scene, back, "what was turned back").map([](const BoardView&) {});
}

// The adapter is pulled: the box says so once, and goes on when it is back; nothing jumps.
Result<void> PullAndPlug(Scene& scene, HeldDevice& adapter) {
  const auto before = scene.SettledBoard();
  if (!before) return tl::unexpected(before.error());
  adapter.Pull();
  if (auto ok = WantBoard(
          scene, [](const BoardView& now) { return !now.surface_live; }, "the loss");
      !ok)
    return tl::unexpected(ok.error());
  adapter.Plug();
  const auto back = [&](const BoardView& now) { return now.surface_live && now.counts == before->counts; };
  if (auto ok = WantBoard(scene, back, "the box again, where its dials were,"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

// Nothing else is read meanwhile, so that nothing else can keep the surface live.
Result<void> PlaySerialBox(Scene& scene, Kind kind, const char* name, int baud) {
  sim::SerialDialBox box(kind);
  box.set_baud(baud);
  sim::UsbSerial usb(box);
  HeldDevice adapter(scene, kAdapter, usb);
  const auto line = SerialLine(scene);
  if (!line) return tl::unexpected(line.error());
  StartedInput input(scene, fmt::format("--serial {}={}", *line, name));
  auto played = [&]() -> Result<void> {
    if (auto ok = WakeDials(scene, box); !ok) return ok;
    if (auto ok = TurnAndPush(scene, box, kind); !ok) return ok;
    return PullAndPlug(scene, adapter);
  }();
  scene.finding.texts.emplace_back(fmt::format("kaori-input, {}", name), input.End());
  return played;
}

constexpr std::array kBoxes{std::pair{Kind::kSgi, "sgi"},
                            std::pair{Kind::kSpectragraphics, "spectragraphics"},
                            std::pair{Kind::kDls80, "dls80"}};

// Each with an adapter of its own, so that each is found anew by the name of the socket.
Result<void> SerialBoxes(Scene& scene) {
  for (const auto& [kind, name] : kBoxes) {
    if (auto ok = PlaySerialBox(scene, kind, name, sim::SerialDialBox::kBaud); !ok)
      return FailInput(fmt::format("{}: {}", name, ok.error().message()));
    scene.finding.figures["serial_boxes_played"] += 1;
  }
  scene.finding.said =
      "three boxes behind an FTDI adapter: dials to the last count, buttons, lamps; pulled and plugged";
  return scene.WantNoRestart();
}

// The control: a box that speaks at another speed.
Result<void> AnotherSpeedIsSeen(Scene& scene) {
  return WantFoundWrong(PlaySerialBox(scene, Kind::kSgi, "sgi", 19200), "a box of another speed passes");
}

// Numbers of edges, four a cycle: fast and slow, both ways, and a dial that stands.
constexpr std::array<int, 8> kEdges{256, -256, 64, -64, 1, -1, 512, 0};
// Of the machine's own time, which is that of its instructions: a kernel whose processor is taken away for a while, as by
// neighbours on this computer, merges two edges of a line into one that never was.
constexpr int kPause_us = 2000;

// `crossed`: A and B of each dial change places, as by a wrong wire.
Result<void> PlayGpioDials(Scene& scene, bool crossed) {
  const auto chip = AskOfDials(scene, "dials make");
  if (!chip) return tl::unexpected(chip.error());
  std::string lines, edges;
  for (int dial = 0; dial < 8; ++dial) {
    lines += fmt::format("{}{},{}", dial == 0 ? "" : ",", 2 * dial + (crossed ? 1 : 0),
                         2 * dial + (crossed ? 0 : 1));
    edges += fmt::format("{}{}", dial == 0 ? "" : ",", kEdges[static_cast<std::size_t>(dial)]);
  }
  StartedInput input(scene, fmt::format("--dials {}:{}", *chip, lines));
  const auto live = WantBoard(
      scene, [](const BoardView& now) { return now.surface_live; }, "the dials");
  if (!live) return tl::unexpected(live.error());
  const auto before = scene.SettledBoard();
  if (!before) return tl::unexpected(before.error());
  if (auto ok = AskOfDials(scene, fmt::format("dials turn {} {}", kPause_us, edges)); !ok)
    return tl::unexpected(ok.error());
  const auto turned = [&](const BoardView& now) {
    for (std::size_t n = 0; n < kEdges.size(); ++n)
      if (now.counts[n] - before->counts[n] != kEdges[n]) return false;
    return true;
  };
  const auto seen = WantBoard(scene, turned, "every edge");
  const std::string said = input.End();
  scene.finding.texts.emplace_back("kaori-input", said);
  if (!seen) return tl::unexpected(seen.error());
  scene.finding.figures["gpio_edges"] = 1154;
  // A gap is told of, and moves nothing: with one the counts could not be right.
  scene.finding.said =
      fmt::format("1154 edges of eight dials on {}, each counted once and its own way", *chip);
  return {};
}

Result<void> GpioDials(Scene& scene) {
  if (!AskOfDials(scene, "dials make")) return scene.Skip("this kernel has no gpio-sim");
  return PlayGpioDials(scene, false);
}

// The control: every dial turns the other way, as one whose A and B were soldered wrongly.
Result<void> CrossedLinesAreSeen(Scene& scene) {
  return WantFoundWrong(PlayGpioDials(scene, true), "dials whose lines are crossed pass");
}

}  // namespace

std::vector<Check> SerialBoxChecks() {
  return {{.name = "serial-boxes",
           .sentence = "The dial boxes of 1993 play behind a serial adapter",
           .run = SerialBoxes,
           .control = AnotherSpeedIsSeen,
           .ends_programs = true}};
}

std::vector<Check> DialLineChecks() {
  return {{.name = "gpio-dials",
           .sentence = "Dials on GPIO lines are counted edge by edge",
           .run = GpioDials,
           .setup = CountedSetup(),
           .control = CrossedLinesAreSeen,
           .ends_programs = true}};
}

}  // namespace kaori::hil
