#include <utility>

#include "appliance/programs/stage/stage.h"

namespace kaori::stage {

// All or none, as InputWriters.
Result<StageWriters> StageWriters::Acquire(const board::Board& board) {
  auto performance = board.AcquireWriter<board::Performance>();
  if (!performance) return tl::unexpected(performance.error());
  auto lamps = board.AcquireWriter<board::Lamps>();
  if (!lamps) return tl::unexpected(lamps.error());
  auto status = board.AcquireWriter<board::StageStatus>();
  if (!status) return tl::unexpected(status.error());
  auto motion_now = board.AcquireWriter<board::MotionNow>();
  if (!motion_now) return tl::unexpected(motion_now.error());
  auto show_now = board.AcquireWriter<board::ShowNow>();
  if (!show_now) return tl::unexpected(show_now.error());
  auto line_check = board.AcquireWriter<board::LineCheck>();
  if (!line_check) return tl::unexpected(line_check.error());
  auto learn = board.AcquireWriter<board::Learn>();
  if (!learn) return tl::unexpected(learn.error());
  auto button_calls = board.AcquireWriter<board::ButtonCalls>();
  if (!button_calls) return tl::unexpected(button_calls.error());
  return StageWriters{std::move(*performance), std::move(*lamps),       std::move(*status),
                      std::move(*show_now),    std::move(*motion_now),  std::move(*line_check),
                      std::move(*learn),       std::move(*button_calls)};
}

}  // namespace kaori::stage
