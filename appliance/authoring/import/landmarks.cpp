#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "appliance/authoring/import/depth_view.h"
#include "appliance/authoring/import/head_shape.h"

namespace kaori::import {
namespace {

// This near to the plane of symmetry counts as on it: a head's middle vertices are seldom at exactly 0.
constexpr float kMiddle_m = 0.006F;
// Lips that are shut are this near at most: modelled lips seldom touch exactly.
constexpr float kLipsTouch_m = 0.004F;
constexpr float kLidsMeet_m = 0.003F;
// Less of the largest motion than this is no motion: skin far off follows by a few percent.
constexpr float kMoves = 0.08F;
// The other side of a slit moves less than this much of it. Neighbours on one lip differ by less.
constexpr float kLess = 0.6F;
// An open slit is this many times wider than a shut one, which stretched skin is not,
constexpr float kWider = 2.5F;
constexpr float kWider_m = 0.0006F;     // and this.
constexpr float kBelowLip_m = 0.010F;   // The chin begins this far below the lower lip,
constexpr float kChinReach_m = 0.060F;  // and ends here.

// Whether a motion brings the sides of the slit together (a blink) or apart (a jaw).
enum class Motion : std::uint8_t { kShuts, kOpens };

// Two vertices on either side of a slit.
struct Pair {
  Index moving;
  Index still;
};

// Finds each kind of landmark in turn; later ones need the mouth's height. Borrows the head.
class Finder {
 public:
  explicit Finder(const HeadShape& head) : head_(head), seen_(SeenFromFront(head)) {}

  // In this order, since the profile needs the mouth's height.
  std::vector<Landmark> Find() {
    FindEyes();
    FindMouth();
    FindProfile();
    FindBrows();
    FindOutline();
    return std::move(found_);
  }

 private:
  using Chosen = std::function<bool(Index)>;
  using Measure = std::function<float(Index)>;

  const glm::vec3& at(Index v) const { return head_.positions[v]; }
  void Add(std::string name, const glm::vec3& where) { found_.push_back({std::move(name), where}); }

  // Where the measure is greatest among the chosen vertices; none where none is chosen.
  std::optional<glm::vec3> Most(const Chosen& chosen, const Measure& measure) const {
    std::optional<Index> best;
    for (Index v = 0; v < head_.positions.size(); ++v)
      if (chosen(v) && (!best || measure(v) > measure(*best))) best = v;
    return best ? std::optional(at(*best)) : std::nullopt;
  }

  // Where a motion shuts (or opens) a slit: seen vertices that move, each with the seen one that moves
  // clearly less and is nearest when the slit is shut, where they are clearly farther apart when it is open.
  // Skin stretches, but not as much. Quadratic in the number of vertices; `near_m` bounds the gap of the slit
  // when it is shut.
  std::vector<Pair> Slit(const Offsets& offsets, Motion motion, float near_m) const {
    const std::vector<float> shares = Shares(offsets, head_.positions.size());
    const float when_shut = motion == Motion::kShuts ? 1.0F : 0.0F;
    const auto apart = [&](Index a, Index b, float share) {
      return glm::distance(at(a) + share * offsets[a], at(b) + share * offsets[b]);
    };
    std::vector<Pair> pairs;
    for (Index m = 0; m < shares.size(); ++m) {
      if (!seen_[m] || shares[m] < kMoves) continue;
      std::optional<Index> nearest;
      for (Index s = 0; s < shares.size(); ++s) {
        if (!seen_[s] || shares[s] > kLess * shares[m]) continue;
        if (!nearest || apart(m, s, when_shut) < apart(m, *nearest, when_shut)) nearest = s;
      }
      if (!nearest) continue;
      const float shut_m = apart(m, *nearest, when_shut);
      const bool opens = apart(m, *nearest, 1 - when_shut) > kWider * shut_m + kWider_m;
      if (shut_m < near_m && opens) pairs.push_back({m, *nearest});
    }
    return pairs;
  }

  // Lids meet when they are shut: the corners are where the slit is at its ends. A cast, and an opening found
  // by form, know their own. Fewer than four pairs are chance.
  void FindEyes() {
    for (std::size_t side = 0; side < 2; ++side) {
      if (const auto& lids = head_.lids[side]) {
        AddLids(side == 0 ? "left eye, " : "right eye, ", *lids);
        continue;
      }
      const std::vector<Pair> slit = Slit(head_.blink[side], Motion::kShuts, kLidsMeet_m);
      if (slit.size() < 4) continue;
      const std::string name = side == 0 ? "left eye, " : "right eye, ";
      // Distance from the plane of symmetry: least at the inner corner, on both sides.
      const auto out = [&](const Pair& pair) { return std::abs(at(pair.moving).x); };
      const auto [inner, outer] = std::ranges::minmax_element(slit, {}, out);
      AddMiddle(name + "inner corner", *inner);
      AddMiddle(name + "outer corner", *outer);
      const float middle = 0.5F * (out(*inner) + out(*outer));
      const auto centre =
          std::ranges::min_element(slit, {}, [&](const Pair& p) { return std::abs(out(p) - middle); });
      Add(name + "upper lid", at(centre->moving));
      Add(name + "lower lid", at(centre->still));
    }
  }

  void AddLids(const std::string& name, const LidMarks& lids) {
    Add(name + "inner corner", lids.inner);
    Add(name + "outer corner", lids.outer);
    Add(name + "upper lid", lids.upper);
    Add(name + "lower lid", lids.lower);
  }

  void AddMiddle(std::string name, const Pair& pair) {
    Add(std::move(name), 0.5F * (at(pair.moving) + at(pair.still)));
  }

  // Lips touch at rest; the lower one goes down with the jaw.
  void FindMouth() {
    std::vector<Pair> slit = Slit(head_.jaw, Motion::kOpens, kLipsTouch_m);
    if (slit.size() < 4) return;
    const auto across = [&](const Pair& pair) { return at(pair.moving).x; };
    const auto [right, left] = std::ranges::minmax_element(slit, {}, across);
    AddMiddle("left mouth corner", *left);
    AddMiddle("right mouth corner", *right);
    const auto middle =
        std::ranges::min_element(slit, {}, [&](const Pair& pair) { return std::abs(across(pair)); });
    Add("lower lip", at(middle->moving));
    Add("upper lip", at(middle->still));
    lip_y_ = at(middle->moving).y;
  }

  // On the plane of symmetry, from the front: the nose's tip is what stands out most between eyes and lips,
  // the chin the same below the lips, "chin, below" the lowest that goes with the jaw, the nose's root what
  // lies at the eyes' height. Without a mouth there is no telling nose from chin.
  void FindProfile() {
    const float eyes_y = 0.5F * (head_.eyes[0].centre.y + head_.eyes[1].centre.y);
    const auto front = [&](Index v) { return seen_[v] && std::abs(at(v).x) < kMiddle_m; };
    const auto forwards = [&](Index v) { return at(v).z; };
    if (!lip_y_) return;
    const float lip_y = *lip_y_;
    const auto nose =
        Most([&](Index v) { return front(v) && at(v).y < eyes_y && at(v).y > lip_y; }, forwards);
    const auto chin = Most(
        [&](Index v) { return front(v) && at(v).y < lip_y - kBelowLip_m && at(v).y > lip_y - kChinReach_m; },
        forwards);
    const std::vector<float> jaw = Shares(head_.jaw, head_.positions.size());
    const auto jaw_end =
        Most([&](Index v) { return front(v) && jaw[v] > 0.5F; }, [&](Index v) { return -at(v).y; });
    if (nose) Add("nose tip", *nose);
    if (chin) Add("chin", *chin);
    if (jaw_end) Add("chin, below", *jaw_end);
    const auto root = Most([&](Index v) { return front(v) && at(v).y > lip_y; },
                           [&](Index v) { return -std::abs(at(v).y - eyes_y); });
    if (root) Add("nose root", *root);
  }

  // The vertex nearest to where the brow's motion is strongest; weights are squared, so that the forehead
  // that follows says little.
  void FindBrows() {
    for (std::size_t side = 0; side < 2; ++side) {
      const Offsets& up = head_.brow_up[side];
      glm::vec3 sum{};
      float weight = 0;
      for (Index v = 0; v < up.size(); ++v) {
        const bool here = seen_[v] && (side == 0) == (at(v).x > 0);
        const float w = here ? glm::dot(up[v], up[v]) : 0;
        sum += w * at(v);
        weight += w;
      }
      if (!(weight > 0)) continue;
      const glm::vec3 mean = sum / weight;
      const auto brow =
          Most([&](Index v) { return seen_[v]; }, [&](Index v) { return -glm::distance(at(v), mean); });
      Add(side == 0 ? "left brow" : "right brow", *brow);
    }
  }

  // Ears are what lies farthest to the sides between eyes and mouth. Crown and back lie near the plane of
  // symmetry. Without a mouth, 6 cm below the eyes stand for the lips' height.
  void FindOutline() {
    const float eyes_y = 0.5F * (head_.eyes[0].centre.y + head_.eyes[1].centre.y);
    const float low = lip_y_.value_or(eyes_y - 0.06F);
    const auto beside = [&](Index v) { return at(v).y < eyes_y + 0.02F && at(v).y > low; };
    const auto level = [&](Index v) { return std::abs(at(v).x) < 0.01F && at(v).y > low; };
    if (const auto ear = Most(beside, [&](Index v) { return at(v).x; })) Add("left ear", *ear);
    if (const auto ear = Most(beside, [&](Index v) { return -at(v).x; })) Add("right ear", *ear);
    if (const auto crown = Most(level, [&](Index v) { return at(v).y; })) Add("crown", *crown);
    if (const auto back = Most(level, [&](Index v) { return -at(v).z; })) Add("back", *back);
  }

  const HeadShape& head_;
  std::vector<bool> seen_;
  std::optional<float> lip_y_;
  std::vector<Landmark> found_;
};

}  // namespace

std::vector<Landmark> FindLandmarks(const HeadShape& head) {
  return Finder(head).Find();
}

}  // namespace kaori::import
