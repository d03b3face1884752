#include "hw-sim/hil/board_view.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace kaori::hil {
namespace {

using Json = nlohmann::json;

// A section is live while its writer is there and its device delivers. A program that ended leaves the word for which its last
// value stood, so the section must be held as well. The word is one of the names that the agent has for board::SourceState.
bool Live(const Json& section) {
  return section.at("source") == "live" && section.at("held") == true;
}

// A stick's section; "left" and "right" have the same fields.
StickView Stick(const Json& section) {
  return {Live(section), section.at("x"), section.at("y"), section.at("port")};
}

// Names of fields are those of the agent's answer; each of them must be there, or the library throws.
StageView Stage(const Json& section) {
  return {.live = Live(section),
          .frames = section.at("frames"),
          .missed_flips = section.at("missed_flips"),
          .frames_per_s = section.at("frames_per_s"),
          .face = section.at("face"),
          .expression = section.at("expression"),
          .scene = section.at("scene"),
          .read_ns = section.at("read_ns")};
}

// The sections of the devices that the puppeteer holds. The names are those that
// `board` of the in-guest agent prints.
// A section that no device has written yet has its defaults, and is not live.
void ParseInput(const Json& board, BoardView& view) {
  const Json& surface = board.at("surface");
  view.surface_live = Live(surface);
  view.counts = surface.at("counts");
  view.buttons = surface.at("buttons");
  view.pushes = surface.at("pushes");
  view.left = Stick(board.at("left"));
  view.right = Stick(board.at("right"));
  view.keys_live = Live(board.at("keys"));
  view.keys_down = board.at("keys").at("down");
  view.pointer_live = Live(board.at("pointer"));
  view.pointer_x = board.at("pointer").at("x");
  view.pointer_y = board.at("pointer").at("y");
  view.input_at_ns = view.newest_input_ns = surface.at("at_ns");
  for (const char* section : {"left", "right", "keys", "pointer"}) {
    const std::int64_t at_ns = board.at(section).at("at_ns");
    if (at_ns != 0) view.input_at_ns = std::min(view.input_at_ns, at_ns);  // 0: there never was one.
    view.newest_input_ns = std::max(view.newest_input_ns, at_ns);
  }
}

// The sections of the other devices, and what stands beside all sections.
void ParseRest(const Json& board, BoardView& view) {
  view.now_ns = board.at("now_ns");
  view.lines_live = Live(board.at("lines"));
  view.lines_active = board.at("lines").at("active");
  const Json& lips = board.at("lips");
  view.lips_live = Live(lips);
  view.lips_at_ns = lips.at("at_ns");
  view.lips_frames = lips.at("frames");
  view.lips_height = lips.at("height");
  view.lips_quality = lips.at("quality");
  const Json& voice = board.at("voice");
  view.voice_live = Live(voice);
  view.voice_speaking = voice.at("speaking") == 1;
  view.voice_level_db = voice.at("level_db");
  view.voice_height = voice.at("height");
  view.voice_blocks = voice.at("blocks");
  view.lamps = board.at("lamps");
  view.stage = Stage(board.at("stage"));
  view.cue_active = board.at("cues").at("active");
  view.cue_pending = board.at("cues").at("pending");
  view.cue_standby = board.at("cues").at("standby");
  view.head_yaw_rad = board.at("aim").at("head_yaw");
  view.gaze_yaw_rad = board.at("aim").at("gaze_yaw");
  view.desk_code = board.at("desk_code");
}

}  // namespace

// The library throws where a field is missing or of another kind: that ends here.
Result<BoardView> ReadBoardView(const std::string& text) {
  BoardView view;
  try {
    const Json board = Json::parse(text);
    ParseInput(board, view);
    ParseRest(board, view);
  } catch (const Json::exception& fault) {
    return Fail(std::errc::invalid_argument, std::string("the agent's board: ") + fault.what());
  }
  return view;
}

}  // namespace kaori::hil
