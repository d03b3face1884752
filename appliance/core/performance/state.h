// What the performance remembers from frame to frame. Plain bytes: the stage keeps it on the board, so that a
// stage that was killed goes on in the middle of a fade.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include <glm/vec2.hpp>

#include "appliance/core/performance/fading.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/kept.h"
#include "appliance/core/performance/knobs.h"
#include "appliance/core/performance/layers.h"
#include "appliance/core/performance/level_state.h"
#include "appliance/core/performance/life_state.h"
#include "appliance/core/performance/lobby_state.h"
#include "appliance/core/performance/mixture.h"
#include "appliance/core/show/show.h"
#include "drivers/base/clock.h"
#include "render/scene/scene.h"

namespace kaori::performance {

// How a stick stands, besides its values: one that was unplugged holds for a moment and then eases to
// neutral.
struct StickNow {
  float presence = 1;  // 1: what it says counts; eases to 0 when the device is lost.
  float lost_s = 0;    // For how long it has been gone.
};

// A registered motion that is playing. Its curves end where they begin, so that nothing jumps at either end; where it
// begins or ends in its middle, its share comes and goes.
struct Playing {
  std::int32_t motion = -1;  // Of the show's motions; -1: nothing.
  float at_s = 0;            // From its beginning.
  float gain = 1;            // Its share, 0..1.
  float size = 1;            // How many times as large it plays (show::MotionUse).
  std::uint32_t number = 0;  // Of the call, counted (State::motions_called): tells which of two is younger.
  show::MotionLayer layer = show::MotionLayer::kAdd;
  std::uint8_t ends = 0;  // 1: its share goes to 0, and it plays no more then.
};
inline constexpr int kVoices = 2 * show::kMostTakes;  // As many may play, and as many fade out.

// All that the box plays by itself in waves begins anew after so long, on a whole number of each: a float
// that counted on for days could not hold the step of a frame.
inline constexpr float kLifePeriod_s = 1000;

inline constexpr float kNoLook_rad = 4;  // Farther off than any look can be: there is none.

// Where the cue list stands. Indices are into the show's cues.
struct CueRun {
  enum class Phase : std::uint32_t {
    kIdle,     // Nothing waits; GO plays the cue that stands by.
    kFollow,   // `pending` begins when the active cue has ended,
    kPreWait,  // is on its pre-wait,
    kPerson,   // or waits for a person.
  };
  std::int32_t active = -1;   // The cue that was played last; -1: none was.
  std::int32_t standby = 0;   // What GO plays next; the number of cues: the list is over.
  std::int32_t pending = -1;  // The cue of the chain that comes by itself; -1: none.
  Phase phase = Phase::kIdle;
  float left_s = 0;  // Of the phase: until `pending` begins, or until its wait for a person gives up.
  float held_s = 0;  // For how long the person has done what the cue waits for.
  float look_off_rad = kNoLook_rad;  // How far her eyes were from whom the cue waits for, in the last frame.
  std::uint32_t paused = 0;          // 1: waits, fades and motions stand still.
  std::uint32_t panicking = 0;       // 1: the panic scene is on its way; a second call is at once.
  std::uint32_t played = 0;          // GOs that were played, counted,
  std::uint32_t refused = 0;         // and those that the guard or the end of the list refused; both wrap.
  float since_refused_s = 10;        // Since the last one of them.
};

// A swinging tip of hair: angle and speed, sideways and forwards.
struct Sway {
  glm::vec2 angle_rad{};
  glm::vec2 speed_rad_s{};
  glm::vec2 head_rad{};  // The head at the last frame.
};

// What hangs at one side of the head; the lower joint's head_rad is not used.
struct Chain {
  Sway upper, lower;
};

inline constexpr float kLongAgo_s = 10;  // Where counts of seconds stop,
// and that of the last GO, which is compared with GOs from before a long pause of the stage.
inline constexpr float kLongSinceGo_s = 3600;

// All of it; angles are as in render/scene/scene.h. Counts of seconds stop at 10, but for
// StickNow::lost_s and go_quiet_s.
// Fields are ordered by nothing but the reader's eye; padding between them is not looked at.
struct State {
  static constexpr std::uint32_t kLayout = 21;  // Raise it when a field changes: see board::Hold.
  Time last{};                                  // When the last frame was to be presented.
  float age_s = 0;                              // Of the performance, from 0 to kLifePeriod_s and again.
  // The board's counters at the last frame. ReadEvents alone changes it.
  SeenInput seen;
  Mixture faces, expressions, styles;  // Indices into the cast, and scene::Style.
  Mixture backdrops;                   // Of scenes, by their numbers.
  std::array<Kept, kMostKept> kept{};  // What people keep beside faces and expressions that were called.
  std::uint16_t sheet = 0;    // Of the buttons, as it was called; one that is held down lies over it.
  Fading exposure;            // Of the scene: 1 is as it was lit, 0 is black.
  Fading cue_light, present;  // As cues set them, 0..1.
  CueRun cue_run;
  // Calls on the board that named what the show has not, and those that came faster than the frames; both
  // wrap.
  std::uint32_t calls_refused = 0, calls_lost = 0;
  // The lock (lock.h), what it has refused, and how often it was denied; the counts wrap.
  std::uint16_t locked = 0;             // 1: it is on.
  std::uint16_t locked_out_button = 0;  // That was refused last,
  float since_locked_out_s = 10;        // and for how long that is past.
  std::uint32_t locked_out = 0, locks_denied = 0;
  // Where the first eight levels (show::Level) stand, and the same smoothed, which is what the face shows.
  // They begin as a box should that nobody has touched: all of the call, 0.6 s of fade, a mouth at rest, some
  // life, full light.
  std::array<float, kKnobCount> knobs{1, 1, 1, 0.6F, 0, 0.5F, 0.6F, 1};
  std::array<float, kKnobCount> shown{1, 1, 1, 0.6F, 0, 0.5F, 0.6F, 1};  // Knobs, smoothed.
  // Who has each level; the value of the first eight is that of `knobs` too, which others may put elsewhere.
  std::array<LevelNow, show::kLevelCount> levels = RestingLevels();
  std::array<MapNow, show::kMostRoleMaps> maps{};  // In the order of the show's roles and of their maps.
  std::array<std::uint8_t, show::kMostRoles> role_devices{};  // A show::Device, kNoDevice or kNoRole.
  // Left, right, as on the board.
  std::array<StickNow, 2> sticks;
  std::array<float, 2> blink_s{10, 10};  // Since a blink began: the character's left, right.
  std::array<float, 2> lids_held{};
  std::array<Playing, kVoices> voices;
  std::uint32_t motions_called = 0;  // Wraps.
  LayersNow layers;                  // How takes that lie under or over operator input have the levels.
  // What the face does by itself, and how its hair swings.
  Life life;
  std::array<Sway, scene::kHairPartCount> sway;  // By scene::HairPart.
  std::array<Chain, 2> chains;                   // At the character's left, right.
  // Head, gaze and brows as the sticks have them, eased; idle motion and registered motions come on top and
  // are no state.
  scene::Head head;
  scene::Gaze gaze;
  float brow = 0;  // -1 frown .. 1 raised.
  float mouth_open = 0;
  float mouth_wide = 0.5F;
  float mouth_drive = 0;  // 0: the expression's mouth .. 1: the dial's, the lips' or the voice's.
  float mouth_said = 0;   // The same of its opening, which does not wait.
  float mouth_quiet_s = 10;
  float mouth_voice = 0;                // 0: the lips have the mouth .. 1: the voice has it.
  float lips_lost_s = 10;               // Since the lips were seen well.
  float blackout = 0;                   // 0 lit .. 1 black, on its way.
  float go_quiet_s = kLongSinceGo_s;    // Since the last GO was called.
  float jump_quiet_s = kLongSinceGo_s;  // Since somebody called a cue by its number,
  std::int32_t jumped_to = -1;          // and which one; -1: nobody has.
  std::uint16_t black_called = 0;       // 1: black by a call; the switch blacks out besides.
  std::uint16_t black_wanted = 0;       // 1: the switch is on, or was when it was lost.
  std::uint16_t black_scene = 0;        // The scene at the last look at that switch.
  // The scene that was entered last.
  std::uint16_t scene = 0;
  LobbyNow lobby;
};
static_assert(std::is_trivially_copyable_v<State>);

// All that fades, of a State or a const one: between called items, and levels.
auto MixturesOf(auto& state) {
  return std::array{&state.faces, &state.expressions, &state.styles, &state.backdrops};
}
auto FadingsOf(auto& state) {
  return std::array{&state.exposure, &state.cue_light, &state.present};
}

// Whether the show may go on with a state that was found on the board or on the disk: every number is finite
// and in range, and everything that it calls exists in the show. Every field is checked, since the bytes may
// come from another version of the program or from a disk that lies. Pure.
bool IsValid(const State& state, const show::Show& show);

}  // namespace kaori::performance
