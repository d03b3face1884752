// A show in the middle of an evening, as the operators' monitor sees it.
#pragma once

#include <string>

#include "appliance/programs/monitor/page.h"
#include "appliance/programs/monitor/view.h"

namespace kaori::monitor {

// Whole at the beginning: a test changes what it is about.
struct MonitorEvening {
  MonitorEvening() {
    show.name = "evening";
    show.cast.faces.resize(2);
    show.cast.faces[0].name = "poster";
    show.cast.faces[1].name = "narrator";
    show.cast.expressions.resize(2);
    show.cast.expressions[1].name = "smile";
    show.scenes.resize(1);
    show.scenes[0].name = "stage";
    show.motions.resize(1);
    show.motions[0].name = "bow";
    show.motions[0].curves = {{.keys = {{0, 0}, {4, 0}}}};
    show.cue_list.cues = {{.number = "1", .name = "House open", .act = "Prologue"},
                          {.number = "2", .name = "House lights down", .notes = "On the bell."},
                          {.number = "3", .name = "He comes", .act = "One", .notes = "After her last word."}};
    show_now.source = lips.source = lines.source = board::SourceState::kLive;
    show_now.value.cue_active = 1;
    show_now.value.cue_standby = 2;
    show_now.value.act_began = now - std::chrono::seconds(754);
    show_now.value.role_devices = {2, 0, 1};
    lips.at = now;
    lips.value.quality = 1;
    lips.value.height = 0.5F;
    state.expressions.to = 1;
  }

  View Now() const {
    return Describe({.show = show,
                     .state = state,
                     .show_now = show_now,
                     .lips = lips,
                     .lines = lines,
                     .status = status,
                     .time_of_day = time_of_day,
                     .now = now});
  }

  show::Show show;
  performance::State state;
  Time now = Time{} + std::chrono::hours(3);
  board::Stamped<board::ShowNow> show_now;
  board::Stamped<board::Lips> lips;
  board::Stamped<board::Lines> lines;
  std::vector<status::Line> status;
  std::string time_of_day = "19:43:10";
};

// The piece whose text begins so; null where there is none.
inline const Piece* PieceWith(const Page& page, const std::string& text) {
  for (const Cell& cell : page.cells)
    for (const Piece& piece : cell.pieces)
      if (piece.size_px > 0 && piece.text.starts_with(text)) return &piece;
  return nullptr;
}

}  // namespace kaori::monitor
