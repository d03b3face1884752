// The stage's status display: shows on a screen beside the show's how the box does, and leaves a file for
// others that says what screens there are. It is the same text as kaori-status prints, drawn by processor in
// small portions.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/status/facts.h"
#include "appliance/programs/status/sheet.h"
#include "drivers/base/background_writer.h"
#include "drivers/base/clock.h"
#include "drivers/ports/scanout.h"

namespace kaori::stage {

// One thread. The board and the clock must outlive it.
class StageStatusDisplay {
 public:
  StageStatusDisplay(const board::Board& board, const Clock& clock, status::Places places);

  // To be called every kPeriod, with the screen that shows the show; null while there is none. Draws lines
  // that changed, for a small part of a frame's usual time, and one at least: so no frame is late for it. A
  // display that fails is logged once and left alone for a minute. A box that has the operators' monitor and
  // no status display shows the status there while its service key is on.
  void Step(ports::Scanout* screen);

  // Whether it has the operators' monitor since the last Step.
  bool on_monitor() const { return on_monitor_; }

  static constexpr Duration kPeriod = std::chrono::milliseconds(100);

  // The status as it is now.
  std::vector<status::Line> Lines() const;

  // What the show's own screen says to whoever services the box, where there is no other one: the stick's
  // shows. Of the last time that files were looked at, by Step.
  const std::vector<std::string>& notice() const { return notice_; }

 private:
  // Where the status is shown now; null: nowhere.
  ports::SideDisplay* DisplayOf(ports::Scanout* screen);
  // Writes the file of screens where they changed.
  void LookAtScreens(ports::Scanout* screen);
  // Draws and shows some rows. Errors: device_or_resource_busy (later), and those of the display.
  Result<void> ShowNext(ports::SideDisplay& display);
  // A blank sheet of the display's size; all of its rows are to be shown. Errors: not_enough_memory.
  Result<status::Sheet::Rows> DrawAnew(const ports::SideDisplay& display);
  status::Sheet::Rows DrawChanged();
  // Reads the facts' files anew, once a second.
  void LookAtFacts();
  const board::Board& board_;
  const Clock& clock_;
  status::Places places_;
  // As they were read last, and when; Time{}: they are to be read anew.
  status::Facts facts_;
  Time facts_read_{};
  std::vector<std::string> notice_;
  std::optional<std::vector<ports::Output>> screens_;  // As they were written last.
  std::optional<status::Sheet> sheet_;
  bool owed_ = false;  // The display has rows that it has not shown.
  bool on_monitor_ = false;
  Time silent_until_{};
  std::mutex text_mutex_;
  std::string screens_text_;  // For the thread that writes it, so that no frame waits for a disk.
  BackgroundWriter writer_;   // Last: it uses all the others.
};

}  // namespace kaori::stage
