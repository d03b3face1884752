#include "hw-sim/monitor/stage_monitor.h"

namespace kaori::sim {
namespace {

constexpr Duration kLookPeriod = std::chrono::seconds(1);
constexpr Duration kSilence = std::chrono::seconds(2);  // A stage writes its status once a frame.

}  // namespace

std::optional<OnStage> StageMonitor::Read() {
  const Time now = clock_.now();
  if (board_) {
    const auto status = board_->Read<board::StageStatus>();
    if (status.source == board::SourceState::kLive && now - status.at < kSilence)
      return OnStage{status.value.scene, status.value.style};
  }
  if (now < look_at_) return std::nullopt;
  look_at_ = now + kLookPeriod;
  board_.reset();
  if (auto opened = board::Board::Open(path_)) board_.emplace(std::move(*opened));
  return std::nullopt;
}

}  // namespace kaori::sim
