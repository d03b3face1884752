#include "hw-sim/monitor/stage_monitor.h"

#include <cmath>

namespace kaori::sim {
namespace {

constexpr Duration kLookPeriod = std::chrono::seconds(1);
// A stage writes its status once a frame, so two seconds are no pause of one that lives.
constexpr Duration kSilence = std::chrono::seconds(2);

}  // namespace

std::optional<board::StageStatus> StageMonitor::Status() {
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

json::Value StageMonitor::Read() {
  const auto now = Status();
  if (!now) return {};
  const auto is = [&](board::CueState state) { return (now->cue_state & state) != 0; };
  return json::Object{{"scene", now->scene},
                      {"style", now->style},
                      {"cue", now->cue_active},
                      {"standby", now->cue_standby},
                      {"pending", now->cue_pending},
                      // Tenths, as people read them: a state that looks the same is the same text.
                      {"left_s", std::ceil(static_cast<double>(now->cue_left_s) * 10) / 10},
                      {"paused", is(board::kCuesPaused)},
                      {"panicking", is(board::kCuesPanicking)},
                      {"black", is(board::kCuesBlack)},
                      {"waiting", is(board::kCuesWaiting)},
                      {"refused", now->gos_refused}};
}

}  // namespace kaori::sim
