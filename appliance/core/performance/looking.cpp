#include "appliance/core/performance/looking.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/saccade.h"

namespace kaori::performance {
namespace {

constexpr float kApart_s = 0.2F;  // Between the beginnings of two saccades.
// Bursts of looking at somebody, and what lies between them: 60 % of a talk (dual eye tracking of talks).
constexpr float kBurst_s = 2.2F, kAway_s = kBurst_s * 0.4F / 0.6F;
constexpr float kShortestBurst_s = 0.6F, kLongestBurst_s = 3, kShortestAway_s = 0.4F, kLongestAway_s = 3.5F;
constexpr float kGlanceStays_s = 0.5F, kSpread = 0.5F, kBurstSpread = 0.35F;
constexpr float kNoGlance = 0.04F;                 // Amounts below this are none.
constexpr float kSeen_rad = 0.1F * show::kDegree;  // Smaller movements are none.
// Directions of glances in eighths of a turn from her left by up, and how many of a hundred go there (Eyes
// Alive).
constexpr std::array<float, 8> kEighths{15.54F, 6.46F, 17.69F, 7.44F, 16.80F, 7.89F, 20.38F, 7.80F};
// A glance that cannot be seen is none; wide ones look at nobody's seat. Up and down the lids are in the way.
constexpr float kLeastGlance_rad = 3 * show::kDegree, kWidest_rad = 14 * show::kDegree,
                kSteepest_rad = 7 * show::kDegree;
// How far eyes turn in the head without strain, and how far at all.
constexpr glm::vec2 kReach_rad{20 * show::kDegree, 14 * show::kDegree},
    kEnd_rad{26 * show::kDegree, 18 * show::kDegree};
constexpr glm::vec2 kComesBack_rad{15 * show::kDegree, 10 * show::kDegree},
    kOffAhead_rad{10 * show::kDegree, 8 * show::kDegree};
// How long she strains after somebody who was named; of herself she lets go at once.
constexpr float kStrains_s = 1.2F, kLetsGo_s = 0.05F;
// The head follows beyond 12 degrees, 40 ms later, half of the way; and so far that the eyes come to 18
// degrees.
constexpr float kHeadFrom_rad = 12 * show::kDegree, kHeadLate_s = 0.04F, kHeadShare = 0.5F;
constexpr float kEyesKeep_rad = 18 * show::kDegree;
constexpr float kTurns = 0.5F;  // With a smaller amount the head stays, and the eyes are alone.
constexpr float kFarthest_m = 300;
// A spring stick keeps its level for 0.7 s after it has come to rest (levels.h); she does not wait much
// longer.
constexpr float kHandOver_s = 0.25F, kHandHolds_s = 0.05F, kHeadTaken_s = 0.6F;

// Yaw and pitch, each by its own bound.
bool Within(glm::vec2 angles, glm::vec2 most) {
  return std::abs(angles.x) <= most.x && std::abs(angles.y) <= most.y;
}

// How far the head has followed the eyes, in radians: yaw and pitch.
glm::vec2 HeadNow(const GazeLife& life) {
  return glm::mix(life.head_from_rad, life.head_to_rad, WayDone(life.head_since_s, life.head_length_s));
}

// Where the look is on its way between two points: by angle in the stage, and by nearness, as eyes converge.
glm::vec3 PointNow(const GazeLife& life, glm::vec3 from_m) {
  const float t = WayDone(life.since_s, life.length_s);
  if (t >= 1) return life.to_m;
  const glm::vec3 a = life.from_m - from_m, b = life.to_m - from_m;
  const float near = Mix(1 / std::max(glm::length(a), 0.1F), 1 / std::max(glm::length(b), 0.1F), t);
  return from_m + DirectionOf(glm::mix(AnglesOf(a), AnglesOf(b), t)) / std::max(near, 1 / kFarthest_m);
}

// One frame of the look, with the head as it is when the frame begins.
class Looker {
 public:
  Looker(GazeLife& life, std::int32_t target, const LookInput& input)
      : life_(life), input_(input), named_(target >= 0), pose_(Pose()) {}

  // What operators, cues and the head have changed since the last frame. Seen at its beginning.
  void MindChanges(std::int32_t target, float dt_s) {
    if (life_.share <= 0) return WakeUp(target);
    if (life_.since_s < kApart_s) return;
    if (target != life_.target) {
      life_.target = target;
      life_.ahead = 0;
      return Burst(0);
    }
    MindReach(dt_s);
  }

  // What has begun is carried to its end, and nothing else: the eyes are not hers now.
  void Rest(float dt_s) {
    TurnHead({});
    Count(dt_s);
  }

  // Moves all clocks on, and lets fixations begin when they are due.
  void Run(float dt_s) {
    for (float left_s = dt_s;;) {
      const float step_s = std::min(left_s, std::max(0.0F, life_.to_next_s));
      Count(step_s);
      life_.to_next_s -= step_s;
      life_.left_s = std::max(0.0F, life_.left_s - step_s);
      left_s -= step_s;
      if (life_.to_next_s > 0) return;
      NextFixation(left_s);
    }
  }

  Look Now() const {
    const HeadPose pose = Pose();
    const glm::vec3 point_m = PointNow(life_, pose.middle_m());
    Look look = begun_;
    look.head_rad = HeadNow(life_) * SmoothStep(life_.head_share);
    for (std::size_t eye = 0; eye < 2; ++eye) {
      const glm::vec2 angles =
          glm::clamp(pose.EyeTo(eye, point_m), -kEnd_rad, kEnd_rad) * SmoothStep(life_.share);
      look.eyes[eye] = {angles.x, angles.y};
    }
    return look;
  }

 private:
  // The head as operators and motions hold it, with what it follows of the gaze.
  HeadPose Pose() const {
    scene::Head head = input_.head;
    const glm::vec2 follows = HeadNow(life_) * SmoothStep(life_.head_share);
    head.yaw_rad += follows.x;
    head.pitch_rad += follows.y;
    return {head, input_.eyes_m, input_.pivot_m};
  }

  // Whom she looks at when nothing draws her away: straight ahead, the one who is named, or the house.
  glm::vec3 Base() const {
    if (life_.ahead != 0) return pose_.Ahead(glm::length(input_.house_m));
    return named_ ? input_.target_m : input_.house_m;
  }

  // Clocks stop at kLongSince_s: an evening long they would lose their fractions.
  void Count(float dt_s) {
    for (float* clock : {&life_.since_s, &life_.head_since_s}) *clock = std::min(kLongSince_s, *clock + dt_s);
  }

  // From where the hand or nothing has left the eyes: straight ahead.
  void WakeUp(std::int32_t target) {
    life_.share = 1;
    life_.target = target;
    life_.ahead = 0;
    life_.beyond_s = 0;
    life_.from_m = life_.to_m = pose_.Ahead(glm::length(input_.house_m));
    Burst(0);
  }

  // Looks at whom she looks at, and stays.
  void Burst(float ago_s) {
    life_.away = 0;
    life_.left_s =
        std::clamp(LogNormal(life_.random, kBurst_s, kBurstSpread), kShortestBurst_s, kLongestBurst_s);
    life_.to_next_s = life_.left_s;
    LookAt(Base(), ago_s);
  }

  // Whether the head goes where the eyes go.
  bool HeadIsHers() const { return life_.head_hand_off_s >= kHandHolds_s && input_.turn > kTurns; }

  // A head that a hand turns far away takes the eyes along; when it comes back they come back first.
  void MindReach(float dt_s) {
    const glm::vec2 to_base = pose_.MiddleTo(named_ ? input_.target_m : input_.house_m);
    if (life_.ahead == 0) {
      const bool strains = !HeadIsHers() && !Within(to_base, kReach_rad);
      life_.beyond_s = strains ? std::min(kLongSince_s, life_.beyond_s + dt_s) : 0.0F;
      if (life_.beyond_s <= (named_ ? kStrains_s : kLetsGo_s)) return;
      life_.ahead = 1;
      return Burst(0);
    }
    life_.beyond_s = 0;
    if (HeadIsHers() || Within(to_base, kComesBack_rad)) {
      life_.ahead = 0;
      return Burst(0);
    }
    if (!Within(pose_.MiddleTo(life_.to_m), life_.away != 0 ? kReach_rad : kOffAhead_rad)) Burst(0);
  }

  // When looking at somebody is over she glances about for a while, then looks back. Fixations too short to
  // be followed by another one are lengthened to the end of their stretch.
  void NextFixation(float ago_s) {
    const bool over = life_.left_s <= kApart_s;
    if (over && (life_.away != 0 || input_.glance < kNoGlance)) return Burst(ago_s);
    if (over) {
      const float usual_s = kAway_s * std::min(1.0F, input_.glance);
      life_.left_s = std::clamp(LogNormal(life_.random, usual_s, kSpread), kShortestAway_s, kLongestAway_s);
      life_.away = 1;
    }
    const float stays_s = kApart_s + LogNormal(life_.random, kGlanceStays_s, kSpread);
    life_.to_next_s = stays_s + kApart_s < life_.left_s ? stays_s : life_.left_s;
    LookAt(Beside(), ago_s);
  }

  // A point beside whom she looks at, as far away. To the other side where the eyes would leave their reach.
  glm::vec3 Beside() {
    const glm::vec3 way = Base() - pose_.middle_m();
    const float amplitude = GlanceAmplitude_rad(Uniform(life_.random)) * input_.glance;
    const float eighth = Eighth(100 * Uniform(life_.random)) * 0.7853982F;
    glm::vec2 off{std::cos(eighth), std::sin(eighth)};
    const glm::vec2 most{kWidest_rad, kSteepest_rad};
    off =
        glm::clamp(off * std::max(amplitude, kLeastGlance_rad * std::min(1.0F, input_.glance)), -most, most);
    const glm::vec2 in_head = pose_.MiddleTo(Base());
    for (int axis = 0; axis < 2; ++axis)
      if (std::abs(in_head[axis] + off[axis]) > kReach_rad[axis]) off[axis] = -off[axis];
    return pose_.middle_m() + DirectionOf(AnglesOf(way) + off) * glm::length(way);
  }

  // The direction that this part of all glances, 0 to 100, falls to.
  static float Eighth(float percent) {
    std::size_t n = 0;
    while (n + 1 < kEighths.size() && percent >= kEighths[n]) percent -= kEighths[n++];
    return static_cast<float>(n);
  }

  // Begins a saccade now, which is ago_s before the end of the frame, from where the eyes are.
  void LookAt(glm::vec3 point_m, float ago_s) {
    const glm::vec3 from_m = pose_.middle_m();
    const glm::vec3 now_m = PointNow(life_, from_m);
    const float cosine = glm::dot(glm::normalize(now_m - from_m), glm::normalize(point_m - from_m));
    const float moved_rad = std::acos(std::clamp(cosine, -1.0F, 1.0F));
    life_.to_m = point_m;
    if (moved_rad > kSeen_rad) {
      life_.from_m = now_m;
      life_.since_s = 0;
      life_.length_s = SaccadeLength_s(moved_rad);
      begun_.moved_rad = moved_rad;
      begun_.ago_s = ago_s;
    }
    if (moved_rad > kHeadFrom_rad || life_.away == 0) TurnHead(AnglesOf(point_m - from_m));
  }

  // The head follows to its share of the way to `goal`, from where it is.
  void TurnHead(glm::vec2 goal) {
    const float far = glm::length(goal);
    const bool follows = far > kHeadFrom_rad && life_.ahead == 0;
    const float share = follows ? std::max(kHeadShare, 1 - kEyesKeep_rad / far) : 0.0F;
    const glm::vec2 to_rad = goal * share * std::min(1.0F, input_.turn);
    if (glm::length(to_rad - life_.head_to_rad) <= (follows ? show::kDegree : 0.0F)) return;
    life_.head_from_rad = HeadNow(life_);
    life_.head_to_rad = to_rad;
    life_.head_since_s = -kHeadLate_s;
    life_.head_length_s = HeadTurnLength_s(glm::length(to_rad - life_.head_from_rad));
  }

  GazeLife& life_;
  const LookInput& input_;
  bool named_;
  HeadPose pose_;
  Look begun_;
};

// Seconds since a hand let go, and the share that is her own: lost within kHandOver_s.
void HandOver(float& off_s, float& share, bool hand, float back_per_s, float dt_s) {
  off_s = hand ? 0 : std::min(kLongSince_s, off_s + dt_s);
  const bool own = off_s >= kHandHolds_s;
  share = Travel(share, own ? 1.0F : 0.0F, dt_s, own ? back_per_s : 1 / kHandOver_s);
}

}  // namespace

// Eyes and head are given up and taken up each for itself: a hand may have one of them and leave her the
// other.
Look LookAround(GazeLife& life, std::int32_t target, const LookInput& input, float dt_s) {
  HandOver(life.head_hand_off_s, life.head_share, input.hand_on_head, 1 / kHeadTaken_s, dt_s);
  life.hand_off_s = input.hand_on_eyes ? 0 : std::min(kLongSince_s, life.hand_off_s + dt_s);
  const bool looks = (target >= 0 || input.glance >= kNoGlance) && life.hand_off_s >= kHandHolds_s;
  Looker looker(life, target, input);
  if (!looks) {
    life.share = Travel(life.share, 0, dt_s, 1 / kHandOver_s);
    looker.Rest(dt_s);
    return looker.Now();
  }
  looker.MindChanges(target, dt_s);
  life.share = Travel(life.share, 1, dt_s, 1 / kHandOver_s);
  looker.Run(dt_s);
  return looker.Now();
}

}  // namespace kaori::performance
