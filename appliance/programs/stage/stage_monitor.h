// The stage's operators' monitor: shows on a screen beside the show's what the operators watch behind the
// stage. Drawn by processor in small portions, beside the frames.
#pragma once

#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/board/lip_picture.h"
#include "appliance/core/performance/state.h"
#include "appliance/programs/monitor/sheet.h"
#include "appliance/programs/stage/stage_status_display.h"
#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "drivers/ports/side_display.h"

namespace kaori::stage {

// "19:43:10" in local time; empty before 2025, where the box's clock has lost its battery.
std::string TimeOfDay(std::time_t now);

// One thread, that of the stage. All that it is given must outlive it. It draws pictures about 15 times a
// second and text ten times; after each portion it rests 40 times as long as that took, so that it has no
// more than a fortieth of one processor.
class StageMonitor {
 public:
  // `time_of_day` gives the wall clock's time, and must not wait.
  StageMonitor(const board::Board& board, const Clock& clock, Studio& studio,
               const StageStatusDisplay& status, std::function<std::time_t()> time_of_day);

  // What a step needs of the stage. `next_frame`: when it begins its next frame, where that is known.
  struct StageNow {
    const performance::State& state;
    std::optional<Time> next_frame{};
  };
  // To be called every kPeriod, with the monitor's display; null while there is none, or while the status has
  // it. Leaves a frame alone that is about to begin. While there is a display the lips' picture is asked for.
  // A display that fails is logged once and left alone for a minute.
  void Step(ports::SideDisplay* display, const StageNow& stage);

  static constexpr Duration kPeriod = std::chrono::milliseconds(20);

 private:
  // No display: what was drawn and asked for is forgotten.
  void Close();
  // A blank sheet of the display's size; false, with a line in the log, where there is no memory.
  bool Open(const ports::SideDisplay& display);
  // Draws what is due into the sheet, and notes its areas.
  void DrawDue(const StageNow& stage);
  void DrawPictures();
  Result<void> Show(ports::SideDisplay& display);
  monitor::View ViewOf(const performance::State& state) const;

  const board::Board& board_;
  const Clock& clock_;
  Studio& studio_;
  const StageStatusDisplay& status_;
  std::function<std::time_t()> time_of_day_;
  std::optional<monitor::Sheet> sheet_;
  std::optional<board::LipPictureReader> lips_;
  SmallImage programme_;
  std::vector<ports::DisplayArea> areas_;  // That were drawn and not shown yet.
  bool owed_ = false;                      // The display has areas that it has not shown.
  Time next_step_{}, next_text_{}, next_lips_{}, silent_until_{};
  Time lips_shown_{};  // When the picture of the lips that is shown was exposed; Time{}: none is.
  int left_alone_ = 0;
};

}  // namespace kaori::stage
