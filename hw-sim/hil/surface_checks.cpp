// Surfaces that people own, by their twins: each is plugged in, and what a hand does there is on the board.
#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "hw-sim/devices/owned_device.h"
#include "hw-sim/devices/stream_deck.h"
#include "hw-sim/devices/usb_midi.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/held_device.h"

namespace kaori::hil {
namespace {

using sim::OwnedKind;
using std::chrono::seconds;

// For machines that have little of a processor.
constexpr Duration kLongestFindSurface = seconds(120), kLongestSeen = seconds(60);
// A hand tries again so often until the box has found what it plays on.
constexpr Duration kTryAgain = seconds(2);
constexpr int kBoardTurn = 256;
// All pictures that are due have come after this; a key that is not on is darker by this.
constexpr Duration kPicturesCome = seconds(10);
constexpr double kDimmer = 0.7;

using Seen = std::function<bool(const BoardView& before, const BoardView& now)>;

// One thing that is done to a surface, and what is to be seen of it.
struct SurfaceAction {
  const char* name;
  std::function<void()> act;
  Seen seen;
};

// What the board saw since `before` of one dial, as the maps of appliance/shows/kaori/surfaces have it. Division may keep
// one count for the next turn.
Seen Turned(std::size_t dial, int counts) {
  return [=](const BoardView& before, const BoardView& now) {
    return std::abs(now.counts[dial] - before.counts[dial] - counts) <= 1;
  };
}
Seen Pushed(std::size_t button) {
  return [=](const BoardView& before, const BoardView& now) {
    return now.pushes[button] == before.pushes[button] + 1;
  };
}
Seen LeftStick(std::function<bool(const StickView&)> stands) {
  return [stands = std::move(stands)](const BoardView&, const BoardView& now) {
    return now.left.live && stands(now.left);
  };
}

// A device that is plugged in, a first movement that is repeated until the box has seen any, and then what is counted.
struct Played {
  std::string name;
  std::string socket;
  sim::UsbDevice& device;
  SurfaceAction wake;
  std::vector<SurfaceAction> actions;
  // Of what else it shows; empty: nothing.
  std::function<Result<void>()> shows{};
};

Result<void> NotSeen(const Played& played, const char* what) {
  return FailInput(fmt::format("{}: {} was not seen", played.name, what));
}

// Errors: invalid_argument, which names device and action; those of the board.
Result<void> Play(Scene& scene, Played played) {
  const HeldDevice held(scene, played.socket, played.device);
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  Time again{};
  const auto woke = [&] {
    const Time now = scene.target.clock().now();
    if (now >= again) played.wake.act(), again = now + kTryAgain;
    const auto board = scene.target.Board();
    return board && played.wake.seen(*before, *board);
  };
  if (!scene.target.Await(woke, kLongestFindSurface, played.name)) return NotSeen(played, played.wake.name);
  for (const SurfaceAction& action : played.actions) {
    const auto stands = scene.SettledBoard();
    if (!stands) return tl::unexpected(stands.error());
    action.act();
    const auto seen = [&](const BoardView& now) { return action.seen(*stands, now); };
    if (!scene.target.UntilBoard(seen, kLongestSeen, played.name)) return NotSeen(played, action.name);
  }
  scene.finding.said += (scene.finding.said.empty() ? "" : ", ") + played.name;
  return played.shows ? played.shows() : Result<void>{};
}

// For a first movement, of which nobody knows how much arrives: the device may still be asked who it is.
Seen AnyTurn(std::size_t dial) {
  return
      [=](const BoardView& before, const BoardView& now) { return now.counts[dial] != before.counts[dial]; };
}

// Linux makes no reports of it: the box's program reads it by libusb, beside hidraw.
Result<void> PlayPowerMate(Scene& scene) {
  sim::OwnedDevice knob(OwnedKind::kPowerMate);
  sim::UsbHid usb(knob);
  const auto turn = [&](int clicks) { return [&knob, clicks] { knob.Turn(clicks); }; };
  const auto push = [&] { knob.Push(0), knob.Release(0); };
  return Play(scene, {"PowerMate",
                      "pointer",
                      usb,
                      {"a turn", turn(3), AnyTurn(2)},
                      {{"a turn back", turn(-94), Turned(2, -kBoardTurn)}, {"a push", push, Pushed(10)}}});
}

// Ten clicks of its jog wheel are a turn, and its counter of eight bits wraps on the way.
Result<void> PlayShuttle(Scene& scene) {
  sim::OwnedDevice shuttle(OwnedKind::kShuttlePro);
  sim::UsbHid usb(shuttle);
  const auto turn = [&](int clicks) { return [&shuttle, clicks] { shuttle.Turn(clicks); }; };
  const auto push = [&] { shuttle.Push(12), shuttle.Release(12); };
  return Play(scene, {"ShuttlePRO v2",
                      "pointer",
                      usb,
                      {"a turn", turn(2), AnyTurn(2)},
                      {{"a turn back", turn(-10), Turned(2, -kBoardTurn)}, {"a push", push, Pushed(12)}}});
}

// Its first value after a plug turns nothing, since where it stood is not known.
Result<void> PlayXTouch(Scene& scene) {
  sim::MidiTwin touch(sim::MidiTwin::Kind::kXTouchMini);
  sim::UsbMidi usb(touch);
  const auto turn = [&](int steps) { return [&touch, steps] { touch.Turn(3, steps); }; };
  const auto push = [&] { touch.Push(15, true), touch.Push(15, false); };
  return Play(scene, {"X-Touch Mini",
                      "pointer",
                      usb,
                      {"a turn", turn(2), AnyTurn(3)},
                      {{"a turn to the end", turn(127), AnyTurn(3)},
                       {"a turn back", turn(-127), Turned(3, -kBoardTurn)},
                       {"a push", push, Pushed(15)}}});
}

// Before it was put into its native mode it tells no turns.
Result<void> PlayTwister(Scene& scene) {
  sim::MidiTwin twister(sim::MidiTwin::Kind::kTwister);
  sim::UsbMidi usb(twister);
  const auto turn = [&](int steps) { return [&twister, steps] { twister.Turn(5, steps); }; };
  const auto push = [&] { twister.Push(14, true), twister.Push(14, false); };
  return Play(scene, {"Midi Fighter Twister",
                      "pointer",
                      usb,
                      {"a turn", turn(1), AnyTurn(5)},
                      {{"a turn back", turn(-96), Turned(5, -kBoardTurn)}, {"a push", push, Pushed(14)}}});
}

// At the socket of the left pod, since a stick's role belongs to the port. Forwards is positive on the board.
Result<void> PlayStick(Scene& scene, OwnedKind kind, const char* name) {
  sim::OwnedDevice stick(kind);
  sim::UsbHid usb(stick);
  // Each try another place: the same one is no report of a device that tells changes alone.
  const auto wake = [&] { stick.Move(0, -0.9F), stick.Move(0, -1); };
  return Play(scene, {name,
                      "stick-left",
                      usb,
                      {"a move", wake, LeftStick([](const StickView& left) { return left.y < -0.9; })},
                      {{"a move to the left", [&] { stick.Move(-1, 0); },
                        LeftStick([](const StickView& left) { return left.x < -0.9 && left.y > -0.1; })},
                       {"rest", [&] { stick.Move(0, 0); },
                        LeftStick([](const StickView& left) { return left.x == 0 && left.y == 0; })}}});
}

// Until no picture has come for kPicturesCome: a machine that lacks time sends a key's bright one long after its first.
void AwaitPictures(Scene& scene, const sim::StreamDeck& deck) {
  constexpr int kMostWaits = 12;
  for (int n = 0, before = -1; n < kMostWaits && deck.pictures() != before; ++n) {
    before = deck.pictures();
    scene.target.For(kPicturesCome);
  }
}

// Every key shows a picture; the one that is on a bright one, until another is.
Result<void> WantPictures(Scene& scene, sim::StreamDeck& deck, int lit, const char* name) {
  const auto all = [&] {
    for (int key = 0; key < deck.keys(); ++key)
      if (!deck.picture(key)) return false;
    return true;
  };
  const bool shown = scene.target.Until(all, kLongestSeen);
  scene.finding.said += fmt::format(" ({} pictures)", deck.pictures());
  if (!shown) return FailInput(fmt::format("{}: a key shows no picture", name));
  AwaitPictures(scene, deck);
  const double bright = deck.picture(lit)->brightness();
  deck.Push(0);
  deck.Release(0);
  if (!scene.target.Until([&] { return deck.picture(lit)->brightness() < kDimmer * bright; }, kLongestSeen))
    return FailInput(fmt::format("{}: the key of what is on no more stays bright", name));
  if (deck.wrong_pages() + deck.wrong_pictures() == 0) return {};
  return FailInput(fmt::format("{}: {} pages and {} pictures that it was sent make no sense", name,
                               deck.wrong_pages(), deck.wrong_pictures()));
}

// Keys call what the buttons of the same numbers do: the first ten call faces.
Result<void> PlayDeck(Scene& scene, sim::StreamDeck::Kind kind, const char* name) {
  constexpr int kKey = 5;
  sim::StreamDeck deck(kind);
  sim::UsbHid usb(deck);
  const auto push = [&deck](int key) { return [&deck, key] { deck.Push(key), deck.Release(key); }; };
  const auto any = [](const BoardView& before, const BoardView& now) {
    return now.pushes[0] != before.pushes[0];
  };
  const auto face = [](const BoardView& before, const BoardView& now) {
    return Pushed(kKey)(before, now) && now.stage.face != before.stage.face && (now.lamps >> kKey & 1U) != 0;
  };
  return Play(
      scene,
      {name, "pointer", usb, {"a push", push(0), any}, {{"a push that calls a face", push(kKey), face}}, [&] {
         return WantPictures(scene, deck, kKey, name);
       }});
}

// One after the other: the box has room for four further surfaces, and each is to be seen alone. What has played is
// counted for out/firmware.json.
Result<void> Surfaces(Scene& scene) {
  for (const auto& part : std::initializer_list<std::function<Result<void>(Scene&)>>{
           PlayPowerMate, PlayShuttle, PlayXTouch, PlayTwister,
           [](Scene& s) { return PlayStick(s, OwnedKind::kExtreme3dPro, "Extreme 3D Pro"); },
           [](Scene& s) { return PlayStick(s, OwnedKind::kAttack3, "Attack 3"); },
           [](Scene& s) { return PlayStick(s, OwnedKind::kT16000m, "T.16000M"); },
           [](Scene& s) { return PlayStick(s, OwnedKind::kDragonRise, "DragonRise stick"); },
           [](Scene& s) { return PlayDeck(s, sim::StreamDeck::Kind::kMk2, "Stream Deck MK.2"); },
           [](Scene& s) { return PlayDeck(s, sim::StreamDeck::Kind::kXl, "Stream Deck XL"); },
           [](Scene& s) { return PlayDeck(s, sim::StreamDeck::Kind::kMini, "Stream Deck Mini"); }}) {
    if (auto ok = part(scene); !ok) return ok;
    scene.finding.figures["surfaces_played"] += 1;
  }
  return scene.WantNoRestart();
}

}  // namespace

std::vector<Check> SurfaceChecks() {
  return {{"surfaces",
           "Surfaces that people own play, each by the kernel's own driver, and decks show their faces",
           false,
           Surfaces,
           {},
           "kaori-input.service"}};
}

}  // namespace kaori::hil
