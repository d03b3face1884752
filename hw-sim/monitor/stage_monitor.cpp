#include "hw-sim/monitor/stage_monitor.h"

namespace kaori::sim {
namespace {

constexpr Duration kLookPeriod = std::chrono::seconds(1);
// A stage writes its status once a frame, so two seconds are no pause of one that lives.
constexpr Duration kSilence = std::chrono::seconds(2);

}  // namespace

std::optional<board::StageStatus> StageMonitor::Read() {
  const Time now = clock_.now();
  if (board_) {
    const auto status = board_->Read<board::StageStatus>();
    if (status.source == board::SourceState::kLive && now - status.at < kSilence) return status.value;
  }
  // Looked for anew, since a stage that was started again may have made another file.
  if (now < look_at_) return std::nullopt;
  look_at_ = now + kLookPeriod;
  board_.reset();
  if (auto opened = board::Board::Open(path_)) board_.emplace(std::move(*opened));
  return std::nullopt;
}

}  // namespace kaori::sim
