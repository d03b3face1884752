#include "appliance/core/board/valid.h"

#include <algorithm>
#include <array>

namespace kaori::board {
namespace {

// Bounds are far wider than what any device gives. They are to stop a number that would make the face vanish
// or a loop run for ever, not to judge a measurement.
constexpr std::int32_t kMaxCountsPerTurn = 1 << 20;  // The finest optical dials have a tenth of it.
constexpr float kMaxLip = 8.0F;                      // Mouth widths; no mouth opens so far.
// Of numbers without a bound of their own: what a call or a level says, frames a second, seconds until a cue.
constexpr float kMaxFigure = 1e9F;
constexpr Duration kLongestSpan = std::chrono::hours(24 * 365);
constexpr float kMostLevel_db = 100;
constexpr float kMostDelay_ms = 2000;  // The box delays by 500 ms; a sound card adds its own.
// A tenth; the crystals of sound cards differ by tens of ppm.
constexpr float kMostDrift_ppm = 1e5F;
// More than a day. A show's motions last ten minutes at most (show::kLongestMotion_s).
constexpr float kLongestMotion_s = 1e5F;
// Six digits, and the seconds of a day.
constexpr std::uint32_t kMostCode = 999'999;
constexpr float kLongestCode_s = 86'400;

// Both ends are allowed. False for NaN too: every comparison with it is.
bool Within(float value, float low, float high) {
  return value >= low && value <= high;
}

// Readers use the code of a press as an index, so each one of the log lies below `end`, those that are not
// used included.
bool HasCodes(const PressLog& log, std::uint32_t end) {
  return std::ranges::all_of(log.newest, [end](const PressLog::Press& press) { return press.code < end; });
}

bool IsPossible(const CheckedItem& item) {
  return static_cast<std::uint32_t>(item.kind) < kCheckedKindCount &&
         static_cast<std::uint32_t>(item.state) < kCheckedStateCount &&
         Within(item.low, -kMaxFigure, kMaxFigure) && Within(item.high, -kMaxFigure, kMaxFigure) &&
         item.low_first <= 1;
}

}  // namespace

bool Valid(const Surface& surface) {
  return surface.counts_per_turn > 0 && surface.counts_per_turn <= kMaxCountsPerTurn &&
         HasCodes(surface.log, static_cast<std::uint32_t>(surface.pushes.size()));
}

bool Valid(const Stick& stick) {
  return Within(stick.x, -1, 1) && Within(stick.y, -1, 1) && Within(stick.twist, -1, 1) &&
         Within(stick.slider, 0, 1) && stick.hat >= -1 && stick.hat <= 7 &&
         std::ranges::all_of(stick.centres, [](float centre) { return Within(centre, -1, 1); }) &&
         HasCodes(stick.log, static_cast<std::uint32_t>(stick.pushes.size()));
}

// A code has the usage in its lower byte and the modifiers in the next one: 16 bits.
bool Valid(const Keys& keys) {
  return HasCodes(keys.log, 0x10000);
}

bool Valid(const Lines& /*any bits are lines*/) {
  return true;
}

// Subjects are checked by who knows the show.
bool Valid(const Calls& calls) {
  return std::ranges::all_of(calls.newest, [](const Call& call) {
    return Valid(call.at) && static_cast<std::uint32_t>(call.verb) < kCallVerbCount &&
           static_cast<std::uint32_t>(call.source) < kCallSourceCount &&
           Within(call.value, -kMaxFigure, kMaxFigure);
  });
}

bool Valid(const Pointer& pointer) {
  return Within(pointer.x, 0, 1) && Within(pointer.y, 0, 1);
}

// The bounds of shut, open, narrow and wide are those that PositionOf divides by.
bool Valid(const Lips& lips) {
  return Within(lips.height, 0, kMaxLip) && Within(lips.width, 0, kMaxLip) && Within(lips.quality, 0, 1) &&
         Within(lips.rest_width, 0, 1) && Within(lips.opening, 0, kMaxLip) &&
         Within(lips.corners[0], -kMaxLip, kMaxLip) && Within(lips.corners[1], -kMaxLip, kMaxLip) &&
         Within(lips.rest_marker, 0, kMaxLip) && Within(lips.shut, 0, lips.open) &&
         Within(lips.open, 0.01F, kMaxLip) && Within(lips.narrow, 0, 1) && Within(lips.wide, 1, kMaxLip);
}

bool Valid(const Voice& voice) {
  return Within(voice.level_db, -kMostLevel_db, kMostLevel_db) && voice.speaking <= 1 &&
         Within(voice.height, 0, 1) && Within(voice.width, 0, 1) && Within(voice.quality, 0, 1);
}

bool Valid(const Sound& sound) {
  return Within(sound.delay_ms, 0, kMostDelay_ms) && Within(sound.asked_ms, 0, kMostDelay_ms) &&
         sound.automatic <= 1 && Within(sound.drift_ppm, -kMostDrift_ppm, kMostDrift_ppm);
}

// -1: none plays. How many motions there are is for who knows the show.
bool Valid(const MotionNow& motion) {
  return motion.motion >= -1 && Within(motion.at_s, 0, kLongestMotion_s);
}

// Flags are words of 0 or 1; steps are those that sections.h lists.
bool Valid(const LipsGuide& guide) {
  return guide.step <= 4 && guide.taking <= 1 && Within(guide.progress, 0, 1) && guide.seen <= 1 &&
         guide.captions <= 1;
}

// Any word can be an address, and any four bytes begin a certificate's sum.
bool Valid(const Desk& desk) {
  return desk.code <= kMostCode && Within(desk.valid_s, 0, kLongestCode_s) && desk.port <= 65535 &&
         desk.secure <= 1;
}

// Dials and buttons are looked up by whoever tells of them, who passes over those that there are not.
bool Valid(const MidiHeard& /*any bytes may have come*/) {
  return true;
}

bool Valid(const Lamps& /*any bits are lamps*/) {
  return true;
}

bool Valid(const ButtonCalls& /*any number may be a sum*/) {
  return true;
}

// Spans are not negative: readers add them up and format them.
bool Valid(const StageStatus& status) {
  const auto possible = [](Duration length) { return length >= Duration{} && length <= kLongestSpan; };
  return std::ranges::all_of(std::array{status.input_age, status.draw, status.margin, status.frame_cpu,
                                        status.lips_age, status.voice_age, status.mouth_lag},
                             possible) &&
         Valid(status.flipped_at) && Valid(status.sampled_at) && Within(status.frames_per_s, 0, kMaxFigure);
}

// Roles are indices into role_devices. Cues and devices are for who knows the show.
bool Valid(const ShowNow& show) {
  const auto possible = [](const MotionShown& one) {
    return one.motion >= -1 && one.ends <= 1 && Within(one.at_s, 0, kLongestMotion_s);
  };
  return Valid(show.act_began) && Within(show.cue_left_s, 0, kMaxFigure) && show.locked <= 1 &&
         std::ranges::all_of(show.motions, possible) &&
         static_cast<std::uint32_t>(show.lobby) < kLobbyStateCount &&
         static_cast<std::uint32_t>(show.lobby_hours) < kLobbyHoursCount &&
         std::ranges::all_of(show.levels, [](const LevelShown& level) {
           return Within(level.value, -kMaxFigure, kMaxFigure) &&
                  static_cast<std::uint32_t>(level.owner) < kLevelOwnerCount &&
                  level.role < ShowNow::kMostRoles;
         });
}

// Readers use the kind and the state as indices, of items that are not used too.
bool Valid(const LineCheck& check) {
  return check.phase <= LineCheckPhase::kEnded && check.count <= LineCheck::kMostItems &&
         std::ranges::all_of(check.items, IsPossible);
}

// Choices are for who knows the show.
bool Valid(const Learn& learn) {
  return static_cast<std::uint32_t>(learn.phase) < kLearnPhaseCount && IsPossible(learn.found) &&
         IsPossible(learn.moves_itself) && learn.inverted <= 1 && learn.instead <= 1 && learn.restless <= 1 &&
         learn.ambiguous <= 1;
}

bool Valid(const ShowsMenu& menu) {
  return menu.open <= 1;
}

// Of the bytes themselves performance::IsValid judges, when a stage takes them up.
bool Valid(const Performance& performance) {
  return performance.bytes <= Performance::kCapacityBytes;
}

// Half of the largest time: a reader may add or subtract any duration of the program without an overflow.
bool Valid(Time at) {
  return at >= Time{} && at.time_since_epoch() <= Duration::max() / 2;
}

bool Valid(SourceState source) {
  return source <= SourceState::kStale;
}

}  // namespace kaori::board
