#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

// Emulation on a busy machine is slow; on a quiet one a box plays after half a minute.
constexpr Duration kLongestBoot = std::chrono::minutes(8);
constexpr Duration kStrategyLongestFind = std::chrono::minutes(3);
constexpr std::uint32_t kFirstFrames = 3;

}  // namespace

Result<void> PlayStrategy::Play(const Setup& setup) {
  if (plays_ && place_.machine().setup() == setup && place_.machine().runs()) return {};
  Off();
  place_.machine().SetUp(setup);
  if (auto ok = SwitchOn(); !ok) return ok;
  plays_ = true;
  return {};
}

void PlayStrategy::Off() {
  place_.witness().Lose();
  place_.machine().Off();
  plays_ = false;
}

Result<void> PlayStrategy::SwitchOn() {
  const Time began = place_.clock().now();
  const bool plugged = place_.machine().setup().plugged;
  if (auto ok = plugged ? place_.PlugAll() : place_.PullAll(); !ok) return ok;
  if (auto ok = place_.machine().On(); !ok) return ok;
  if (auto ok = place_.witness().Find(kLongestBoot); !ok) return ok;
  if (auto ok = AwaitFrames(); !ok) return ok;
  boot_s_ = Seconds(place_.clock().now() - began);
  return plugged ? AwaitHands() : Result<void>{};
}

Result<void> PlayStrategy::AwaitFrames() {
  const auto plays = [](const BoardView& board) {
    return board.stage.live && board.stage.frames >= kFirstFrames;
  };
  if (auto ok = place_.UntilBoard(plays, kLongestBoot, "wait for the first face"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

Result<void> PlayStrategy::AwaitHands() {
  const bool keys = place_.machine().setup().keyboards;
  const auto found = [&](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && (board.keys_live || !keys) &&
           board.pointer_live;
  };
  if (auto ok = place_.UntilBoard(found, kStrategyLongestFind, "wait for the hands' devices"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

}  // namespace kaori::hil
