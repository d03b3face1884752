#include "appliance/programs/monitor/parts.h"

#include <algorithm>
#include <utility>

#include "appliance/programs/monitor/palette.h"

namespace kaori::monitor {
namespace {

// Number and name beside each other, notes below them. A name that is too long for one large line has two
// smaller ones.
Cell CueCell(const CueWords& cue, const Pen& pen, const Box& box, int number_px, int name_px) {
  Cell cell{box, kPanel, {}};
  Box rest = Inset(box, pen.unit / 2);
  Box head = CutTop(rest, number_px * 13 / 10);
  if (!cue.number.empty()) {
    const Box number = CutLeft(head, pen.WidthOf(cue.number, number_px) + pen.unit / 2);
    cell.pieces.push_back({number, kAmber, cue.number, number_px});
  }
  const bool is_long = pen.WidthOf(cue.name, name_px) > head.width;
  AddLines({cue.name, is_long ? std::min(name_px * 3 / 4, head.height * 10 / 26) : name_px, kText, true}, pen,
           head, cell);
  if (!cue.notes.empty() && rest.height >= pen.unit)
    AddLines({cue.notes, pen.normal(), kSoft}, pen, rest, cell);
  return cell;
}

}  // namespace

void AddCues(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  const int u = pen.unit, label = u * 8 / 5;
  Box active = CutBottom(box, box.height * 38 / 100);
  CutBottom(box, u / 2);
  Cell head = LabelCell("STAND BY", {}, pen, CutTop(box, u * 2));
  Box line = head.box;
  CutRight(line, u / 2);
  AddBadge(view.go, pen, line, head);
  cells.push_back(std::move(head));
  const bool none = view.standby.number.empty() && view.standby.name.empty();
  const CueWords nothing{
      {}, view.go.words == "no cue list" ? "This show has no cues" : "The list is over", {}};
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
  Cell loud =
      BarCell(voice, pen, {sound.left + u / 2, sound.top, std::max(0, sound.width - u), sound.height});
  loud.box = sound;
  cells.push_back(std::move(loud));
  const Box side = CutRight(box, u * 3 / 2);
  Cell open{side, kPanel, {}};
  Box bar{side.left + u / 2, side.top, u / 2, side.height};
  open.pieces.push_back({bar, kGroove});
  open.pieces.push_back(
      {CutBottom(bar, static_cast<int>(view.open * static_cast<float>(bar.height))), kByLips});
  cells.push_back(std::move(open));
  cells.push_back({CutLeft(box, u / 2), kPanel, {}});
  return box;
}

void AddPlaying(const View& view, const Pen& pen, Box box, std::vector<Cell>& cells) {
  const int u = pen.unit, pitch = u * 7 / 4, label = u * 6;
  cells.push_back(LabelCell("ON STAGE", {}, pen, CutTop(box, u * 8 / 5)));
  for (std::size_t i = 0; box.height >= pitch; ++i) {
    Cell cell{CutTop(box, pitch), kPanel, {}};
    Box row = cell.box;
    CutLeft(row, u / 2);
    CutRight(row, u / 2);
    if (i < view.playing.size()) {
      const Playing& playing = view.playing[i];
      Box under = CutBottom(row, std::max(1, u / 5));
      cell.pieces.push_back({CutLeft(row, label), kQuiet, playing.what, pen.normal()});
      cell.pieces.push_back({row, playing.colour, playing.words, u * 6 / 5});
      CutLeft(under, label);
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
