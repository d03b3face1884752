#include "hw-sim/bench/strategy.h"

namespace kaori::bench {
namespace {

// Emulation on a busy machine is slow; on a quiet one a box plays after half a minute.
constexpr Duration kLongestBoot = std::chrono::minutes(5);
constexpr Duration kLongestFind = std::chrono::minutes(1);
constexpr std::uint32_t kFirstFrames = 3;

}  // namespace

Result<void> PlayStrategy::Transition(BoxState wanted) {
  if (wanted == state_ && (wanted == BoxState::kOff || place_.machine().runs())) return {};
  place_.witness().Lose();
  place_.machine().Off();
  state_ = BoxState::kOff;
  if (wanted == BoxState::kOff) return {};
  if (auto ok = SwitchOn(); !ok) return ok;
  state_ = BoxState::kPlaying;
  return {};
}

Result<void> PlayStrategy::SwitchOn() {
  const Time began = place_.clock().now();
  if (auto ok = place_.PlugAll(); !ok) return ok;
  if (auto ok = place_.machine().On(); !ok) return ok;
  if (auto ok = place_.witness().Find(kLongestBoot); !ok) return ok;
  const auto plays = [](const BoardView& board) {
    return board.stage.live && board.stage.frames >= kFirstFrames;
  };
  if (auto ok = place_.UntilBoard(plays, kLongestBoot, "wait for the first face"); !ok)
    return tl::unexpected(ok.error());
  boot_s_ = Seconds(place_.clock().now() - began);
  const auto found = [](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && board.keys_live && board.pointer_live;
  };
  if (auto ok = place_.UntilBoard(found, kLongestFind, "wait for the hands' devices"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

}  // namespace kaori::bench
