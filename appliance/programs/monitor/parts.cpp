#include "appliance/programs/monitor/parts.h"

#include <algorithm>
#include <utility>

#include "appliance/programs/monitor/palette.h"

namespace kaori::monitor {
namespace {

// Number and name beside each other, notes below them.
Cell CueCell(const CueWords& cue, const Pen& pen, const Box& box, int number_px, int name_px) {
  Cell cell{box, kPanel, {}};
  Box rest = Inset(box, pen.unit / 2);
  const bool has_notes = !cue.notes.empty() && rest.height > number_px * 12 / 10 + pen.unit;
  Box notes = CutBottom(rest, has_notes ? rest.height - number_px * 13 / 10 : 0);
  if (!cue.number.empty()) {
    Box number = CutLeft(rest, pen.WidthOf(cue.number, number_px) + pen.unit / 2);
    number.height = std::min(number.height, number_px * 13 / 10);
    cell.pieces.push_back({number, kAmber, cue.number, number_px});
  }
  // A name that is too long for one large line has two smaller ones.
  const bool is_long = pen.WidthOf(cue.name, name_px) > rest.width;
  Box name = rest;
  name.height = std::min(name.height, number_px * 13 / 10);
  if (is_long) AddLines(cue.name, pen, name, name_px * 7 / 10, kText, cell);
  if (!is_long) cell.pieces.push_back({name, kText, cue.name, name_px});
  if (has_notes) AddLines(cue.notes, pen, notes, pen.normal(), kQuiet, cell);
  return cell;
}

}  // namespace

void AddCues(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  const int u = pen.unit, label = u * 8 / 5;
  Box active = CutBottom(box, box.height * 2 / 5);
  CutBottom(box, u / 2);
  cells.push_back(LabelCell("STAND BY", view.go, pen, CutTop(box, label)));
  const bool none = view.standby.number.empty() && view.standby.name.empty();
  const CueWords nothing{{}, view.go.words == "no cue list" ? "This show has no cues" : "The list is over", {}};
  cells.push_back(CueCell(none ? nothing : view.standby, pen, box, pen.huge(), u * 9 / 5));
  cells.push_back(LabelCell("ON", {view.comes, kAmber}, pen, CutTop(active, label)));
  const bool before = view.active.number.empty() && view.active.name.empty();
  cells.push_back(CueCell(before ? CueWords{{}, "No cue was called yet", {}} : view.active, pen, active,
                          u * 9 / 5, pen.large()));
}

Box AddLips(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  const int u = pen.unit;
  cells.push_back(LabelCell("LIPS", {}, pen, CutTop(box, u * 8 / 5)));
  const Box words = CutBottom(box, u * 8 / 5);
  Cell state{words, kPanel, {}};
  Box line = words;
  CutLeft(line, u / 2);
  state.pieces.push_back({line, view.lips.colour, view.lips.words, pen.normal()});
  cells.push_back(std::move(state));
  const Level voice{{}, {}, view.speaks ? kByVoice : kQuiet, view.voice, 0};
  const Box sound = CutBottom(box, u);
  Cell loud = BarCell(voice, pen, {sound.left + u / 2, sound.top, std::max(0, sound.width - u), sound.height});
  loud.box = sound;
  cells.push_back(std::move(loud));
  const Box side = CutRight(box, u * 3 / 2);
  Cell open{side, kPanel, {}};
  Box bar{side.left + u / 2, side.top, u / 2, side.height};
  open.pieces.push_back({bar, kGroove});
  open.pieces.push_back({CutBottom(bar, static_cast<int>(view.open * static_cast<float>(bar.height))), kByLips});
  cells.push_back(std::move(open));
  cells.push_back({CutLeft(box, u / 2), kPanel, {}});
  return box;
}

void AddPlaying(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  const int u = pen.unit, pitch = u * 7 / 4;
  cells.push_back(LabelCell("ON STAGE", {}, pen, CutTop(box, u * 8 / 5)));
  for (std::size_t i = 0; box.height >= pitch; ++i) {
    Cell cell{CutTop(box, pitch), kPanel, {}};
    Box row = cell.box;
    CutLeft(row, u / 2);
    CutRight(row, u / 2);
    if (i < view.playing.size()) {
      const Playing& playing = view.playing[i];
      Box under = CutBottom(row, std::max(1, u / 5));
      cell.pieces.push_back({CutLeft(row, u * 11 / 2), kQuiet, playing.what, pen.normal()});
      cell.pieces.push_back({row, playing.colour, playing.words, u * 6 / 5});
      CutLeft(under, u * 11 / 2);
      if (playing.share < 1) {
        cell.pieces.push_back({under, kGroove});
        under.width = static_cast<int>(playing.share * static_cast<float>(under.width));
        cell.pieces.push_back({under, playing.colour});
      }
    }
    cells.push_back(std::move(cell));
  }
  cells.push_back({box, kPanel, {}});
}

}  // namespace kaori::monitor
