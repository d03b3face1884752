#include "appliance/core/performance/levels.h"

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/controls.h"
#include "appliance/core/performance/ease.h"

namespace kaori::performance {
namespace {

using show::Level;
using show::RoleMap;
using show::Takeover;

constexpr float kHoldLost_s = 0.25F;  // A stick that is unplugged counts for this long,
constexpr float kEaseLost_s = 1.0F;   // then eases to its middle in this time.
constexpr float kEaseFound_s = 0.3F;
constexpr float kRemoteCounts_s = 1;  // VTube Studio's time for a parameter that nobody sends any more.
constexpr float kRestReleases_s = 0.7F;
// Of a control's whole way: so far it moves before it takes a level from another owner.
constexpr float kClaims = 0.02F;

LevelNow& NowOf(State& state, Level level) {
  return state.levels[static_cast<std::size_t>(level)];
}

float SpanOf(Level level) {
  return show::InfoOf(level).high - show::InfoOf(level).low;
}

// The owner's way begins where the level stands.
void Ease(LevelNow& level, Level which, float offset, float handover_s) {
  level.offset = offset;
  level.eased_s = 0;
  level.ease_s = std::max(handover_s, kEaseOfRange_s * std::abs(offset) / SpanOf(which));
}

// What a control's movement claims, the stronger one last.
enum class Movement : std::uint8_t {
  kNone,
  kFar,  // The level: it has moved far enough.
  kMet,  // The same, and it has met the level: there is nothing to ease out.
};

// One frame of the levels.
class LevelFrame {
 public:
  LevelFrame(State& state, const board::Snapshot& board, const InputEvents& events, const show::Roles& roles,
             float dt_s)
      : state_(state), board_(board), controls_(state, board, events), roles_(roles), dt_s_(dt_s) {}

  void Move() {
    AdoptWhatWasPut();
    for (std::size_t i = 0; i < state_.sticks.size(); ++i) MovePresence(i);
    ForEachRun(state_, roles_, [this](const Run& run) { Look(run); });
    for (std::size_t i = 0; i < state_.levels.size(); ++i) MoveOn(static_cast<Level>(i));
  }

 private:
  // How much a stick counts, 0..1. One that comes back gets its full share within 0.3 s.
  void MovePresence(std::size_t stick) {
    StickNow& now = state_.sticks[stick];
    now.lost_s = board_.sticks[stick].source == board::SourceState::kLive ? 0 : now.lost_s + dt_s_;
    const bool lost = now.lost_s > kHoldLost_s;
    now.presence = Travel(now.presence, lost ? 0.0F : 1.0F, dt_s_, 1 / (lost ? kEaseLost_s : kEaseFound_s));
  }

  float PresenceOf(std::uint8_t role) const {
    const std::uint8_t device = state_.role_devices[role];
    return device < state_.sticks.size() ? SmoothStep(state_.sticks[device].presence) : 1.0F;
  }

  // Calls and the editor put the first eight where they want them.
  void AdoptWhatWasPut() {
    for (std::size_t i = 0; i < state_.knobs.size(); ++i) {
      LevelNow& level = state_.levels[i];
      if (level.value == state_.knobs[i]) continue;
      level.value = state_.knobs[i];
      level.owner = Owner::kCue;
      level.offset = level.base = 0;
      level.put = 1;
    }
  }

  // Looks at the controls of one role on one level, and lets it have that level where they claim it.
  void Look(const Run& run) {
    LevelNow& level = NowOf(state_, run.level);
    const bool owns = level.owner == Owner::kHand && level.role == run.role;
    const float sum_before = SumOf(run), said_before = Said(run);
    Movement movement = Movement::kNone;
    float turned = 0;
    for (std::size_t i = 0; i < run.maps.size(); ++i) {
      turned += controls_.TurnedBy(run, run.maps[i]);
      movement = std::max(movement, Follow(run, i, owns));
    }
    if (owns) return Keep(run, level, turned);
    if (turned != 0) return ClaimByTurning(run, level, sum_before, turned);
    if (movement == Movement::kMet) return Claim(run, level, level.value - Said(run));
    if (movement == Movement::kFar || SaysMoreThanRest(run, level))
      Claim(run, level, level.value - said_before);
  }

  // One control by one frame.
  Movement Follow(const Run& run, std::size_t i, bool owns) {
    const RoleMap& map = run.maps[i];
    MapNow& now = run.now[i];
    if (show::Turns(map.control)) return Movement::kNone;
    const float way = controls_.WayOf(run, map);
    const bool put = NowOf(state_, run.level).put != 0;
    now.untaken_s = put ? kLongAgo_s : std::min(kLongAgo_s, now.untaken_s + dt_s_);
    if (now.known == 0 || put) now.anchor = way;
    const bool far = std::abs(way - now.anchor) >= kClaims * (show::Springs(map.control) ? 2.0F : 1.0F);
    const Movement movement = Contribute(run, i, way, owns, far);
    now.way = way;
    now.known = controls_.IsLive(run.role) ? 1 : 0;
    return movement;
  }

  // Brings one map's contribution up to where its control stands. A control with pick-up contributes only
  // once it has met the level, one with scaling goes on from there.
  Movement Contribute(const Run& run, std::size_t i, float way, bool owns, bool far) {
    const RoleMap& map = run.maps[i];
    MapNow& now = run.now[i];
    const float to = show::LevelAt(map, way);
    if (!MeetsFirst(map)) {
      now.value = to;
      return owns || far ? Movement::kFar : Movement::kNone;
    }
    if (now.known == 0 || way == now.way) return Movement::kNone;
    const float here = owns ? now.value : NowOf(state_, run.level).value - (SumOf(run) - now.value);
    const float from = show::LevelAt(map, now.way);
    if (map.takeover == Takeover::kPickUp)
      return PickUp(map, now, here, from, to) ? Movement::kMet : Movement::kNone;
    if (!owns && !far) return Movement::kNone;
    now.value = Scaled(map, here, from, to);
    return Movement::kMet;
  }

  // What the controls of a run say, as far as their device counts.
  float Said(const Run& run) const {
    const float sum = SumOf(run), there = PresenceOf(run.role), rest = show::InfoOf(run.level).rest;
    return there < 1 && !show::Stays(run.level) ? rest + there * (sum - rest) : sum;
  }

  // A level that nobody has goes where the controls stand.
  bool SaysMoreThanRest(const Run& run, const LevelNow& level) const {
    return !show::Stays(run.level) && level.owner == Owner::kRest && (level.let_go >> run.role & 1U) == 0 &&
           std::ranges::none_of(run.maps, MeetsFirst) && Said(run) != show::InfoOf(run.level).rest;
  }

  void Claim(const Run& run, LevelNow& level, float offset) {
    Own(run, level);
    level.base = 0;
    Ease(level, run.level, offset, roles_.handover_s);
  }

  // A dial goes on from where the level is.
  void ClaimByTurning(const Run& run, LevelNow& level, float sum, float turned) {
    Own(run, level);
    level.base = level.value - sum;
    level.offset = 0;
    Keep(run, level, turned);
  }

  void Own(const Run& run, LevelNow& level) {
    if (level.owner == Owner::kHand) Anchor(level.role, run.level);
    level.owner = Owner::kHand;
    level.role = run.role;
    level.let_go = static_cast<std::uint8_t>(level.let_go & ~(1U << run.role));
    level.rest_s = 0;
  }

  // Whoever loses a level must move to have it again.
  void Anchor(std::uint8_t role, Level level) {
    ForEachRun(state_, roles_, [&](const Run& run) {
      if (run.role != role || run.level != level) return;
      for (std::size_t i = 0; i < run.maps.size(); ++i) run.now[i].anchor = controls_.WayOf(run, run.maps[i]);
    });
  }

  // The owner's dials turn on, within the ends: turned back they count at once.
  static void Keep(const Run& run, LevelNow& level, float turned) {
    if (turned == 0) return;
    const float sum = SumOf(run);
    level.base = show::Clamped(run.level, level.base + sum + turned) - sum;
    level.rest_s = 0;
  }

  // What the owner wants, without what is left of the hand-over.
  float WantedOf(Level which) {
    LevelNow& level = NowOf(state_, which);
    const float rest = show::InfoOf(which).rest;
    if (level.owner == Owner::kRemote)
      return Mix(level.remote, rest, state_.layers[static_cast<std::size_t>(which)].covers);
    if (level.owner != Owner::kHand) return show::Stays(which) ? level.value : rest;
    float said = level.base;
    bool silent = true;
    ForEachRun(state_, roles_, [&](const Run& run) {
      if (run.role != level.role || run.level != which) return;
      said += Said(run);
      for (std::size_t i = 0; i < run.maps.size(); ++i)
        silent = silent && show::Springs(run.maps[i].control) && run.now[i].way == 0;
    });
    const float wanted = show::Clamped(which, said);
    const bool nothing = show::Stays(which) ? silent : wanted == rest;
    level.rest_s = nothing ? std::min(kLongAgo_s, level.rest_s + dt_s_) : 0;
    return wanted;
  }

  static float Left(const LevelNow& level) {
    return level.ease_s > 0 ? level.offset * (1 - SmoothStep(level.eased_s / level.ease_s)) : 0;
  }

  void MoveOn(Level which) {
    LevelNow& level = NowOf(state_, which);
    EndClaims(which, level);
    const float wanted = WantedOf(which);
    level.eased_s += dt_s_;
    if (level.offset == 0 || level.eased_s >= level.ease_s) level.offset = level.ease_s = level.eased_s = 0;
    level.value = show::Clamped(which, wanted + Left(level));
    level.put = 0;
    if (show::Stays(which)) state_.knobs[static_cast<std::size_t>(which)] = level.value;
  }

  void EndClaims(Level which, LevelNow& level) {
    level.remote_left_s = std::max(0.0F, level.remote_left_s - dt_s_);
    const bool silent = level.owner == Owner::kRemote && level.remote_left_s <= 0;
    const bool rests = level.owner == Owner::kHand && level.rest_s >= kRestReleases_s;
    if (!silent && !rests) return;
    level.owner = level.remote_left_s > 0 ? Owner::kRemote : Owner::kRest;
    level.base = 0;
    Ease(level, which, level.value - WantedOf(which), roles_.handover_s);
  }

  State& state_;
  const board::Snapshot& board_;
  Controls controls_;
  const show::Roles& roles_;
  float dt_s_;
};

}  // namespace

void RestLevels(State& state) {
  state.maps = {};
  for (std::size_t i = 0; i < state.levels.size(); ++i) {
    const bool stays = show::Stays(static_cast<Level>(i));
    state.levels[i] = {.value = stays ? state.knobs[i] : show::kLevels[i].rest};
  }
}

void BeginLevels(State& state, const show::Roles& roles) {
  RestLevels(state);
  state.role_devices.fill(kNoRole);
  for (std::size_t i = 0; i < roles.roles.size(); ++i)
    state.role_devices[i] = static_cast<std::uint8_t>(roles.roles[i].device);
}

void MoveLevels(State& state, const board::Snapshot& board, const InputEvents& events,
                const show::Roles& roles, float dt_s) {
  LevelFrame(state, board, events, roles, dt_s).Move();
}

void SetRemotely(State& state, const show::Roles& roles, Level which, float value) {
  LevelNow& level = NowOf(state, which);
  level.remote = show::Clamped(which, value);
  level.remote_left_s = kRemoteCounts_s;
  if (level.owner >= Owner::kRemote) return;
  level.owner = Owner::kRemote;
  Ease(level, which, level.value - level.remote, roles.handover_s);
}

void LetGo(State& state, const show::Roles& roles, Level which) {
  LevelNow& level = NowOf(state, which);
  const float value = level.value;
  level = {.value = value, .let_go = 0xFF, .put = 1};
  if (!show::Stays(which)) Ease(level, which, value - show::InfoOf(which).rest, roles.handover_s);
}

bool LoadRole(State& state, const show::Roles& roles, std::uint32_t role, std::uint32_t device) {
  if (role >= roles.roles.size() || device > kNoDevice) return false;
  for (std::size_t i = 0; i < state.levels.size(); ++i)
    if (LevelNow& level = state.levels[i]; level.owner == Owner::kHand && level.role == role)
      LetGo(state, roles, static_cast<Level>(i));
  for (LevelNow& level : state.levels) level.let_go |= static_cast<std::uint8_t>(1U << role);
  ForEachRun(state, roles, [role](const Run& run) {
    if (run.role == role)
      for (MapNow& now : run.now) now = {};
  });
  state.role_devices[role] = static_cast<std::uint8_t>(device);
  return true;
}

}  // namespace kaori::performance
