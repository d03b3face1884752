#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

// Emulation on a busy machine is slow; on a quiet one a box plays after half a minute.
constexpr Duration kLongestBoot = std::chrono::minutes(8);
constexpr Duration kStrategyLongestFind = std::chrono::minutes(3);
// The first is drawn before the stage's loop runs: some more say that it does.
constexpr std::uint32_t kFirstFrames = 3;

}  // namespace

// A box with this setup that still runs is kept: a start takes half a minute at least.
Result<void> PlayStrategy::Play(const Setup& setup) {
  // Setups are compared as a whole: a box with any other field is another box.
  if (plays_ && target_.machine().setup() == setup && target_.machine().runs()) return {};
  Off();
  target_.machine().SetUp(setup);
  if (auto ok = SwitchOn(); !ok) return ok;
  plays_ = true;
  return {};
}

// The agent first: its socket ends with the machine.
void PlayStrategy::Off() {
  target_.agent().Lose();
  target_.machine().Off();
  plays_ = false;
}

// After a check. A box that does not play by itself again is switched off, so that
// the next check starts a fresh one.
void PlayStrategy::Recover(std::int64_t input_since_ns) {
  if (!plays_) return;
  auto ok = AwaitFrames();
  if (ok && target_.machine().setup().plugged) ok = AwaitInputDevices(input_since_ns);
  if (!ok) Off();
}

// The steps are those of a start on a stage: cables, power, the first face, the devices.
Result<void> PlayStrategy::SwitchOn() {
  const Time began = target_.clock().now();
  const bool plugged = target_.machine().setup().plugged;
  // Devices are plugged in before power comes, as on a stage.
  if (auto ok = plugged ? target_.PlugAll() : target_.PullAll(); !ok) return ok;
  if (auto ok = target_.machine().On(); !ok) return ok;
  if (auto ok = target_.agent().Find(kLongestBoot); !ok) return ok;
  if (auto ok = AwaitFrames(); !ok) return ok;
  // Until the first face: finding the devices goes on behind it.
  boot_s_ = Seconds(target_.clock().now() - began);
  return plugged ? AwaitInputDevices(0) : Result<void>{};
}

// Errors: timed_out, with what the board said of the sticks at the last look.
Result<void> PlayStrategy::AwaitFrames() {
  const auto plays = [](const BoardView& board) {
    return board.stage.live && board.stage.frames >= kFirstFrames;
  };
  if (auto ok = target_.UntilBoard(plays, kLongestBoot, "wait for the first face"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

// After a restart of the input program the board keeps its old values: only what was heard since then counts.
Result<void> PlayStrategy::AwaitInputDevices(std::int64_t since_ns) {
  const bool keys = target_.machine().setup().keyboards;
  const auto found = [&](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && (board.keys_live || !keys) &&
           board.pointer_live && board.input_at_ns >= since_ns;
  };
  if (auto ok = target_.UntilBoard(found, kStrategyLongestFind, "wait for the input devices"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

}  // namespace kaori::hil
