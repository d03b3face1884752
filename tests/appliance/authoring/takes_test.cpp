// Takes: how they are played, layered and punched in.
#include <gtest/gtest.h>

#include <iterator>

#include "appliance/authoring/takes/edit.h"
#include "appliance/authoring/takes/played.h"
#include "tests/appliance/authoring/takes_played.h"

namespace kaori::authoring {
namespace {

using show::MotionKey;
using show::MotionTarget;

constexpr float kDegree_rad = 0.0174533F;

float At(const TakeKeys& keys, float at_s) {
  return show::ValueAt(keys, true, at_s);
}

TEST(Take, IsPlayedAsItWasRecordedAndBeginsAndEndsAtRest) {
  const Take take = WaveOf(6);
  const TakeKeys keys = PlayedKeys(take, take.curves[0]);
  EXPECT_EQ(keys.front().at_s, 0);
  EXPECT_EQ(keys.front().value, 0);
  EXPECT_NEAR(keys.back().at_s, 6, 1e-3F);
  EXPECT_EQ(keys.back().value, 0);
  for (float at_s = take.ease_s + 0.05F; at_s < 5.95F - take.ease_s; at_s += 0.007F)
    ASSERT_NEAR(At(keys, at_s), StickWave(at_s) * kDegree_rad, 2e-4F) << at_s;
  float most = 0;
  for (float at_s = 0; at_s < 0.5F; at_s += kTakeFrame_s)
    most = std::max(most, std::abs(At(keys, at_s + kTakeFrame_s) - At(keys, at_s)));
  EXPECT_LT(most, 0.03F) << "radians a frame, while it begins";
}

TEST(Take, ThatIsStretchedKeepsItsEndsAtRestAndItsShape) {
  Take take = WaveOf(6);
  take.stretch = 2.5F;
  const TakeKeys keys = PlayedKeys(take, take.curves[0]);
  EXPECT_EQ(keys.front().value, 0);
  EXPECT_EQ(keys.back().value, 0);
  EXPECT_NEAR(keys.back().at_s, 15, 1e-3F);
  for (float at_s = 1; at_s < 14; at_s += 0.013F)
    ASSERT_NEAR(At(keys, at_s), StickWave(at_s / 2.5F) * kDegree_rad, 2e-4F) << at_s;
  // A cubic through the points of the recording: frames that lie between them go on at an even pace.
  float uneven = 0;
  for (float at_s = 2; at_s < 13; at_s += kTakeFrame_s)
    uneven = std::max(uneven, std::abs(At(keys, at_s + 2 * kTakeFrame_s) - 2 * At(keys, at_s + kTakeFrame_s) +
                                       At(keys, at_s)));
  EXPECT_LT(uneven, 5e-4F);
}

TEST(Take, ThatIsTrimmedPlaysThatPartAlone) {
  Take take = WaveOf(6);
  take.from_s = 1.234F;
  take.to_s = 4.5F;
  take.gain = 0.5F;
  const TakeKeys keys = PlayedKeys(take, take.curves[0]);
  EXPECT_EQ(keys.front().value, 0);
  EXPECT_EQ(keys.back().value, 0);
  EXPECT_NEAR(keys.back().at_s, 3.266F, 1e-3F);
  for (float at_s = 0.3F; at_s < 2.9F; at_s += 0.013F)
    ASSERT_NEAR(At(keys, at_s), 0.5F * StickWave(at_s + 1.234F) * kDegree_rad, 2e-4F) << at_s;
  EXPECT_TRUE(SameKeys(take.curves[0].keys, WaveOf(6).curves[0].keys)) << "the recording is whole";
}

// Played as the box does it: from the end of the loop it goes on at its beginning.
TEST(Take, ThatLoopsJumpsNeitherInItsPlaceNorInItsSpeed) {
  for (const float stretch : {1.0F, 1.7F, 0.4F})
    for (const float blend_s : {0.5F, 0.1F, 9.0F}) {
      Take take = WaveOf(4.3F);
      take.loop = true;
      take.stretch = stretch;
      take.blend_s = blend_s;
      const TakeLoop loop = LoopOf(take);
      const TakeKeys keys = PlayedKeys(take, take.curves[0]);
      const auto played = [&](float at_s) {
        const float period_s = loop.to_s - loop.from_s;
        return At(keys, at_s < loop.to_s ? at_s : loop.from_s + std::fmod(at_s - loop.from_s, period_s));
      };
      const auto step = [&](float at_s) { return played(at_s + kTakeFrame_s) - played(at_s); };
      EXPECT_EQ(keys.front().value, 0);
      ASSERT_GT(keys.back().at_s, loop.to_s);
      EXPECT_NEAR(At(keys, loop.from_s), At(keys, loop.to_s), 1e-5F);
      // The recording goes 52 degrees a second at most, and its two ends lie 34 degrees apart at most: so fast is a blend.
      const float blended_s = PlayedLength(take) - (loop.to_s - loop.from_s);
      const float fastest = (52 / stretch + 1.5F * 34 / blended_s) * kDegree_rad * kTakeFrame_s;
      for (float at_s = loop.from_s; at_s < 2 * loop.to_s; at_s += kTakeFrame_s / 3) {
        ASSERT_LE(std::abs(step(at_s)), fastest) << at_s << ' ' << stretch << ' ' << blend_s;
      }
      float most = 0, most_change = 0;  // Anywhere but at the seam.
      for (float at_s = loop.from_s + 3 * kTakeFrame_s; at_s < loop.to_s - 4 * kTakeFrame_s;
           at_s += kTakeFrame_s / 3) {
        most = std::max(most, std::abs(step(at_s)));
        most_change = std::max(most_change, std::abs(step(at_s + kTakeFrame_s) - step(at_s)));
      }
      for (float at_s = loop.to_s - 3 * kTakeFrame_s; at_s < loop.to_s + 3 * kTakeFrame_s;
           at_s += kTakeFrame_s / 3) {
        EXPECT_LE(std::abs(step(at_s)), 2 * most) << stretch << ' ' << blend_s;
        EXPECT_LE(std::abs(step(at_s + kTakeFrame_s) - step(at_s)), most_change + 1e-4F)
            << stretch << ' ' << blend_s;
      }
    }
}

TEST(Take, ThatLoopsPlaysItsMiddleAsItWasRecorded) {
  Take take = WaveOf(5);
  take.loop = true;
  const TakeLoop loop = LoopOf(take);
  EXPECT_NEAR(loop.to_s - loop.from_s, 4.5F, 1e-3F);
  const TakeKeys keys = PlayedKeys(take, take.curves[0]);
  for (float at_s = take.blend_s; at_s < 4.5F; at_s += 0.01F)
    ASSERT_NEAR(At(keys, at_s), StickWave(at_s) * kDegree_rad, 2e-4F) << at_s;
}

TEST(Take, ThatIsLayeredKeepsTheOtherChannelsToTheBit) {
  Take first = WaveOf(6);
  first.curves.push_back(CurveOf(MotionTarget::kHeadPitch, 6));
  first.curves.push_back({MotionTarget::kChannel, "brow_up_left", CurveOf(MotionTarget::kHeadYaw, 6).keys});
  first.loop = true;
  const Take second{
      .name = "pass",
      .curves = {CurveOf(MotionTarget::kHeadPitch, 3, [](float s) { return 3 * std::cos(s); }),
                 {MotionTarget::kChannel, "brow_frown", CurveOf(MotionTarget::kHeadYaw, 3).keys}}};
  const Take layered = Layered(first, second);
  ASSERT_EQ(layered.curves.size(), 4U);
  EXPECT_TRUE(SameKeys(layered.curves[0].keys, first.curves[0].keys));
  EXPECT_TRUE(SameKeys(layered.curves[2].keys, first.curves[2].keys));
  EXPECT_TRUE(SameKeys(layered.curves[1].keys, second.curves[0].keys)) << "the second pass has this one";
  EXPECT_EQ(layered.curves[3].channel, "brow_frown");
  EXPECT_TRUE(layered.loop);
  // The shorter pass ends at rest, though the take goes on.
  Take once = layered;
  once.loop = false;
  const TakeKeys pitch = PlayedKeys(once, once.curves[1]);
  EXPECT_EQ(pitch.back().value, 0);
  EXPECT_NEAR(pitch.back().at_s, 3, 1e-3F);
}

TEST(Take, ThatIsPunchedInKeepsAllButThatStretchToTheBit) {
  Take first = WaveOf(8);
  first.curves.push_back(CurveOf(MotionTarget::kHeadPitch, 8));
  const Take second{.name = "patch",
                    .curves = {CurveOf(MotionTarget::kHeadYaw, 2, [](float s) { return 20 - 8 * s; })}};
  const Take punched = PunchedIn(first, second, 3);
  ASSERT_EQ(punched.curves.size(), 2U);
  EXPECT_TRUE(SameKeys(punched.curves[1].keys, first.curves[1].keys));
  const auto outside = [](const TakeKeys& keys) {
    TakeKeys kept;
    std::ranges::copy_if(keys, std::back_inserter(kept),
                         [](const MotionKey& key) { return key.at_s < 2.99F || key.at_s > 5.01F; });
    return kept;
  };
  EXPECT_TRUE(SameKeys(outside(punched.curves[0].keys), outside(first.curves[0].keys)));
  const TakeKeys& keys = punched.curves[0].keys;
  for (float at_s = 3.3F; at_s < 4.7F; at_s += 0.01F) ASSERT_NEAR(At(keys, at_s), 20 - 8 * (at_s - 3), 0.01F);
  float most = 0;
  for (float at_s = 2.5F; at_s < 5.5F; at_s += kTakeFrame_s)
    most = std::max(most, std::abs(At(keys, at_s + kTakeFrame_s) - At(keys, at_s)));
  EXPECT_LT(most, 2.5F) << "degrees a frame: 13 degrees are blended in a quarter of a second";
}

TEST(Take, ThatIsThinnedStaysWhereItWas) {
  const TakeKeys keys = CurveOf(MotionTarget::kHeadYaw, 6).keys;
  const TakeKeys thinned = Thinned(keys, kTakeError);
  EXPECT_LT(thinned.size(), keys.size() * 2 / 3);
  for (const MotionKey& key : keys) {
    ASSERT_NEAR(RecordedAt(thinned, key.at_s), key.value, kTakeError * 1.001F);
  }
}

}  // namespace
}  // namespace kaori::authoring
