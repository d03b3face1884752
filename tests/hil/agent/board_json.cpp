#include "tests/hil/agent/board_json.h"

#include <array>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/show/level.h"

namespace kaori::agent {
namespace {

constexpr Duration kLook = std::chrono::microseconds(500);
constexpr std::size_t kMostEventText = 256 * 1024;

constexpr std::array<const char*, 3> kStates{"absent", "live", "stale"};

std::int64_t Nanoseconds(Time at) {
  return at.time_since_epoch().count();
}

std::int64_t Microseconds(Duration length) {
  return std::chrono::duration_cast<std::chrono::microseconds>(length).count();
}

// A section as it was read, and whether a program still holds it: one that died leaves a value that says it is live.
template <class T>
struct Held : board::Stamped<T> {
  bool held = false;
};

// The value first: a writer that goes between the two looks is gone.
template <class T>
Held<T> Look(const board::Board& board, int which = 0) {
  return {board.Read<T>(which), board.HasWriter<T>(which)};
}

template <class T>
std::string Head(const Held<T>& section) {
  return fmt::format(R"("source":"{}","held":{},"at_ns":{})",
                     kStates[static_cast<std::size_t>(section.source)], section.held,
                     Nanoseconds(section.at));
}

std::string StickAsJson(const Held<board::Stick>& stick) {
  const auto& value = stick.value;
  return fmt::format(R"({{{},"x":{},"y":{},"twist":{},"slider":{},"buttons":{},"port":{}}})", Head(stick),
                     value.x, value.y, value.twist, value.slider, value.buttons_down, value.port);
}

std::string SurfaceAsJson(const Held<board::Surface>& surface) {
  return fmt::format(R"({{{},"counts":[{}],"buttons":{},"pushes":[{}]}})", Head(surface),
                     fmt::join(surface.value.counts, ","), surface.value.buttons_down,
                     fmt::join(surface.value.pushes, ","));
}

std::string LinesAsJson(const Held<board::Lines>& lines) {
  return fmt::format(R"({{{},"active":{},"pushes":[{}]}})", Head(lines), lines.value.active,
                     fmt::join(lines.value.pushes, ","));
}

std::string LipsAsJson(const Held<board::Lips>& lips) {
  return fmt::format(R"({{{},"height":{},"width":{},"quality":{},"frames":{}}})", Head(lips),
                     lips.value.height, lips.value.width, lips.value.quality, lips.value.frames);
}

std::string VoiceAsJson(const Held<board::Voice>& voice) {
  return fmt::format(R"({{{},"level_db":{},"speaking":{},"height":{},"width":{},"blocks":{}}})", Head(voice),
                     voice.value.level_db, voice.value.speaking, voice.value.height, voice.value.width,
                     voice.value.blocks);
}

std::string StageAsJson(const Held<board::StageStatus>& stage) {
  const auto& value = stage.value;
  return fmt::format(
      R"({{{},"frames":{},"missed_flips":{},"frames_per_s":{},"face":{},"expression":{},"scene":{},"input_age_us":{},)"
      R"("read_ns":{},"flip_ns":{},"draw_us":{},"margin_us":{}}})",
      Head(stage), value.frames, value.missed_flips, value.frames_per_s, value.face, value.expression,
      value.scene, Microseconds(value.input_age), Nanoseconds(value.sampled_at),
      Nanoseconds(value.flipped_at), Microseconds(value.draw), Microseconds(value.margin));
}

std::string CuesAsJson(const board::Stamped<board::ShowNow>& show) {
  return fmt::format(R"({{"active":{},"standby":{},"pending":{}}})", show.value.cue_active,
                     show.value.cue_standby, show.value.cue_pending);
}

// Where the head and the gaze are, as the stage plays them now.
std::string AimAsJson(const board::ShowNow& show) {
  const auto at = [&](show::Level level) { return show.levels[static_cast<std::size_t>(level)].value; };
  return fmt::format(R"({{"head_yaw":{},"gaze_yaw":{}}})", at(show::Level::kHeadYaw),
                     at(show::Level::kGazeYaw));
}

// The code that the screen shows; -1 where it shows none.
std::int64_t DeskCode(const Held<board::Desk>& desk) {
  return desk.held && desk.source == board::SourceState::kLive ? std::int64_t{desk.value.code} : -1;
}

}  // namespace

std::string BoardAsJson(const board::Board& board, const Clock& clock) {
  const auto keys = Look<board::Keys>(board);
  const auto pointer = Look<board::Pointer>(board);
  return fmt::format(
      R"({{"now_ns":{},"surface":{},"left":{},"right":{},"keys":{{{},"down":[{}]}},"pointer":{{{},"x":{},"y":{}}},)"
      R"("lines":{},"lips":{},"voice":{},"lamps":{},"stage":{},"cues":{},"aim":{},"desk_code":{}}})",
      Nanoseconds(clock.now()), SurfaceAsJson(Look<board::Surface>(board)),
      StickAsJson(Look<board::Stick>(board)), StickAsJson(Look<board::Stick>(board, 1)), Head(keys),
      fmt::join(keys.value.down, ","), Head(pointer), pointer.value.x, pointer.value.y,
      LinesAsJson(Look<board::Lines>(board)), LipsAsJson(Look<board::Lips>(board)),
      VoiceAsJson(Look<board::Voice>(board)), board.Read<board::Lamps>().value.lit,
      StageAsJson(Look<board::StageStatus>(board)), CuesAsJson(board.Read<board::ShowNow>()),
      AimAsJson(board.Read<board::ShowNow>().value), DeskCode(Look<board::Desk>(board)));
}

std::string WatchEvents(const board::Board& board, const Clock& clock, Duration length) {
  std::string told;
  Time stick_before = board.Read<board::Stick>(0).at;
  std::int64_t flip_before = 0;
  for (const Time until = clock.now() + length; clock.now() < until && told.size() < kMostEventText;) {
    const auto stick = board.Read<board::Stick>(0);
    if (stick.at != stick_before) told += fmt::format("stick {} {}\n", Nanoseconds(stick.at), stick.value.x);
    stick_before = stick.at;
    const auto stage = board.Read<board::StageStatus>().value;
    const std::int64_t flip = Nanoseconds(stage.flipped_at);
    if (flip != flip_before) told += fmt::format("flip {} {}\n", Nanoseconds(stage.sampled_at), flip);
    flip_before = flip;
    std::this_thread::sleep_for(kLook);
  }
  return told;
}

}  // namespace kaori::agent
