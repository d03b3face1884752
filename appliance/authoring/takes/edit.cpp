#include "appliance/authoring/takes/edit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "appliance/authoring/takes/played.h"
#include "appliance/core/performance/ease.h"

namespace kaori::authoring {
namespace {

using performance::Mix;
using performance::SmoothStep;
using show::MotionKey;
using Keys = std::vector<MotionKey>;

constexpr float kBlendStep_s = 1.0F / 60;
constexpr float kSameKey_s = 1e-3F;

// Of the keys between two of them, the one farthest from the curve through those that are kept; `to` where
// all lie near enough.
std::size_t Farthest(const Keys& keys, const Keys& through, std::size_t from, std::size_t to, float error) {
  std::size_t farthest = to;
  for (std::size_t k = from + 1; k < to; ++k) {
    const float off = std::abs(show::ValueAt(through, true, keys[k].at_s) - keys[k].value);
    if (off > error) {
      error = off;
      farthest = k;
    }
  }
  return farthest;
}

// The part of a curve that is played, in the seconds of playing; with a key at each end of it.
Keys SettledKeys(const Take& take, const Keys& keys) {
  const float length_s = PlayedLength(take);
  const float first_s = std::max(0.0F, (keys.front().at_s - take.from_s) * take.stretch);
  const float last_s = std::min(length_s, (keys.back().at_s - take.from_s) * take.stretch);
  if (last_s - first_s < kBlendStep_s) return {};
  const auto value_at = [&](float at_s) {
    const float recorded_s =
        std::clamp(take.from_s + at_s / take.stretch, keys.front().at_s, keys.back().at_s);
    return take.gain * RecordedAt(keys, recorded_s);
  };
  Keys settled{{first_s, value_at(first_s)}};
  for (const MotionKey& key : keys)
    if (const float at_s = (key.at_s - take.from_s) * take.stretch;
        at_s > first_s + kSameKey_s && at_s < last_s - kSameKey_s)
      settled.push_back({at_s, take.gain * key.value});
  settled.push_back({last_s, value_at(last_s)});
  return Rounded(std::move(settled));
}

TakeCurve* CurveLike(Take& take, const TakeCurve& wanted) {
  const auto found =
      std::ranges::find_if(take.curves, [&](const TakeCurve& curve) { return SameChannel(curve, wanted); });
  return found == take.curves.end() ? nullptr : &*found;
}

// How much of the second one is there, `at_s` after its beginning: all, but for its ends.
float ShareOf(const Take& second, float at_s, float length_s) {
  return SmoothStep(std::min(at_s, length_s - at_s) / std::min(second.ease_s, length_s / 2));
}

// What stands at the ends of a curve goes on before and behind it: nothing jumps where a patch reaches beyond
// them.
float HeldAt(const Keys& keys, float at_s) {
  return keys.empty() ? 0 : RecordedAt(keys, std::clamp(at_s, keys.front().at_s, keys.back().at_s));
}

// The patch lies in the curve from `at_s` on, and each of its ends runs into what was there.
Keys PunchedKeys(const Keys& first, const Take& second, const Keys& patch, float at_s) {
  const float begin_s = at_s + patch.front().at_s;
  const float length_s = patch.back().at_s - patch.front().at_s;
  Keys blended;
  const auto add = [&](float t) {
    const float played = HeldAt(patch, patch.front().at_s + t);
    blended.push_back({begin_s + t, Mix(HeldAt(first, begin_s + t), played, ShareOf(second, t, length_s))});
  };
  for (float t = 0; t < length_s - kSameKey_s; t += kBlendStep_s) add(t);
  add(length_s);
  Keys punched;
  std::ranges::copy_if(first, std::back_inserter(punched),
                       [=](const MotionKey& key) { return key.at_s <= begin_s - kSameKey_s; });
  std::ranges::copy(Rounded(Thinned(blended, kTakeError)), std::back_inserter(punched));
  std::ranges::copy_if(first, std::back_inserter(punched),
                       [=](const MotionKey& key) { return key.at_s >= begin_s + length_s + kSameKey_s; });
  return punched;
}

}  // namespace

std::string_view NameOf(const TakeCurve& curve) {
  const CurveName* const name = CurveNameOf(curve.target);
  return name != nullptr ? name->name : std::string_view(curve.channel);
}

bool SameChannel(const TakeCurve& a, const TakeCurve& b) {
  return a.target == b.target && a.channel == b.channel;
}

// From two keys on, each round adds the farthest of every stretch: slopes depend on the neighbours, so that
// all of them are looked at again. Ends after some tens of rounds at the latest, since each adds what is
// needed nearly everywhere.
Keys Thinned(const Keys& keys, float error) {
  if (keys.size() < 3) return keys;
  std::vector<std::size_t> kept{0, keys.size() - 1};
  for (bool added = true; added;) {
    Keys through;
    for (const std::size_t k : kept) through.push_back(keys[k]);
    std::vector<std::size_t> more{kept.front()};
    for (std::size_t i = 1; i < kept.size(); ++i) {
      if (const std::size_t far = Farthest(keys, through, kept[i - 1], kept[i], error); far != kept[i])
        more.push_back(far);
      more.push_back(kept[i]);
    }
    added = more.size() > kept.size();
    kept = std::move(more);
  }
  Keys thinned;
  for (const std::size_t k : kept) thinned.push_back(keys[k]);
  return thinned;
}

Keys Rounded(Keys keys) {
  for (MotionKey& key : keys) key = {std::round(key.at_s * 1e5F) / 1e5F, std::round(key.value * 1e4F) / 1e4F};
  return keys;
}

Take Settled(const Take& take) {
  if (take.from_s == 0 && !take.to_s && take.stretch == 1 && take.gain == 1) return take;
  Take settled = take;
  settled.from_s = 0;
  settled.to_s.reset();
  settled.stretch = settled.gain = 1;
  for (TakeCurve& curve : settled.curves) curve.keys = SettledKeys(take, curve.keys);
  std::erase_if(settled.curves, [](const TakeCurve& curve) { return curve.keys.empty(); });
  return settled;
}

Take Layered(const Take& first, const Take& second) {
  Take layered = Settled(first);
  for (const TakeCurve& curve : Settled(second).curves) {
    if (TakeCurve* const same = CurveLike(layered, curve))
      *same = curve;
    else
      layered.curves.push_back(curve);
  }
  return layered;
}

Take PunchedIn(const Take& first, const Take& second, float at_s) {
  Take punched = Settled(first);
  for (const TakeCurve& patch : Settled(second).curves) {
    TakeCurve* const same = CurveLike(punched, patch);
    if (same != nullptr)
      same->keys = PunchedKeys(same->keys, second, patch.keys, at_s);
    else
      punched.curves.push_back({patch.target, patch.channel, PunchedKeys({}, second, patch.keys, at_s)});
  }
  return punched;
}

}  // namespace kaori::authoring
