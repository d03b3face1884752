// The author's work: what pulls do, and the way back to the bit.
#include "appliance/programs/editor/session.h"

#include <gmock/gmock.h>

#include <random>

#include "appliance/programs/editor/record.h"
#include "tests/render/default_cast.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::tests {
namespace {

using editor::Change;
using editor::Session;
using editor::Work;

class HandleSession : public ::testing::Test {
 protected:
  std::size_t Point(const char* name) const { return PointNamed(cast_, name); }
  glm::vec3 PullOf(const char* name) const { return session_.work().pulls_m[Point(name)]; }
  Work WorkOf(const char* expression) const {
    const face::Expression& e = cast_.expressions[ExpressionNamed(cast_, expression)];
    return {.pulls_m = e.displacement, .lids = e.lids, .origin = e.name};
  }

  // Some command, by chance.
  Change DoAnything(std::mt19937& random) {
    const auto point = random() % session_.points().size();
    const auto part = [&random] { return std::uniform_real_distribution<float>(-0.01F, 0.01F)(random); };
    const auto gesture = static_cast<editor::Gesture>(random() % 3);
    session_.spread = {.mirror = random() % 2 == 0, .smooth = random() % 2 == 0};
    switch (random() % 9) {
      case 0:
        return session_.Zero(point);
      case 1:
        return session_.Scale(1 + 20 * part(), gesture);
      case 2:
        return session_.ShutLids(30 * part(), gesture);
      case 3:
        return session_.Replace(WorkOf(random() % 2 == 0 ? "smile" : "surprised"));
      case 4:
        return session_.Undo();
      case 5:
        return session_.Redo();
      default:
        return session_.Pull(point, {part(), part(), part()}, gesture);
    }
  }

  face::Cast cast_ = MakeSyntheticCast({.columns = 16, .rows = 12});
  Session session_{editor::PointsOf(cast_.net)};
};

TEST_F(HandleSession, PullsTheHandleAndItsPartnerTheOtherWayRound) {
  session_.Pull(Point("MC.l"), {0.003F, -0.001F, 0.002F});
  EXPECT_EQ(PullOf("MC.l"), glm::vec3(0.003F, -0.001F, 0.002F));
  EXPECT_EQ(PullOf("MC.r"), glm::vec3(-0.003F, -0.001F, 0.002F));
  session_.spread.mirror = false;
  session_.Pull(Point("MC.r"), {0.001F, 0, 0});
  EXPECT_EQ(PullOf("MC.l"), glm::vec3(0.003F, -0.001F, 0.002F)) << "one side alone";
}

TEST_F(HandleSession, PullsTheMiddleNowhereSidewaysWhileItMirrors) {
  session_.Pull(Point("UC"), {0.003F, 0.002F, 0});
  EXPECT_EQ(PullOf("UC"), glm::vec3(0, 0.002F, 0));
  session_.spread.mirror = false;
  session_.Pull(Point("UC"), {0.003F, 0, 0});
  EXPECT_EQ(PullOf("UC"), glm::vec3(0.003F, 0.002F, 0));
}

TEST_F(HandleSession, SmoothPullsTakeNeighboursAlongTheNearerTheMore) {
  session_.spread = {.mirror = false, .smooth = true};
  session_.Pull(Point("B2.l"), {0, 0.01F, 0});
  EXPECT_FLOAT_EQ(PullOf("B2.l").y, 0.01F);
  EXPECT_GT(PullOf("C2.l").y, 0.0005F) << "the lid lies below the brow";
  EXPECT_LT(PullOf("C2.l").y, PullOf("B2.l").y);
  EXPECT_EQ(PullOf("CH"), glm::vec3(0)) << "the chin is far away";
}

TEST(HandlePoints, ASmoothPullOfOneLipLeavesTheOtherWhereItIs) {
  const face::Cast& cast = DefaultCast();
  Session session(editor::PointsOf(cast.net));
  session.spread = {.mirror = true, .smooth = true};
  const std::size_t lower = PointNamed(cast, "LC"), upper = PointNamed(cast, "UC");
  session.Pull(lower, {0, -0.01F, 0});
  EXPECT_FLOAT_EQ(session.work().pulls_m[lower].y, -0.01F);
  EXPECT_LT(session.work().pulls_m[PointNamed(cast, "LC1.l")].y, -0.004F);
  EXPECT_EQ(session.work().pulls_m[upper], glm::vec3(0))
      << "they touch, but no skin joins them: " << session.points().Apart_m(lower, upper);
}

TEST(HandlePoints, EveryHandleOfTheShowHasItsPartnerAndAWayToTheOthers) {
  const editor::Points points = editor::PointsOf(DefaultCast().net);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string& name = points.names[i];
    EXPECT_EQ(points.partners[i] >= 0, name.ends_with(".l") || name.ends_with(".r")) << name;
    for (std::size_t k = 0; k < points.size(); ++k) EXPECT_LT(points.Apart_m(i, k), 0.4F) << name;
  }
}

TEST_F(HandleSession, MirroredWorkIsTheSameOnBothSidesToTheBit) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    session_.spread = {.mirror = true, .smooth = random() % 2 == 0};
    const auto part = [&random] { return std::uniform_real_distribution<float>(-0.01F, 0.01F)(random); };
    session_.Pull(random() % session_.points().size(), {part(), part(), part()});
  }
  const editor::Points& points = session_.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 pull = session_.work().pulls_m[i];
    if (points.partners[i] < 0)
      EXPECT_EQ(pull.x, 0) << points.names[i];
    else
      EXPECT_EQ(pull * glm::vec3(-1, 1, 1),
                session_.work().pulls_m[static_cast<std::size_t>(points.partners[i])])
          << points.names[i];
  }
}

TEST_F(HandleSession, UndoOfAllGivesTheFirstStateToTheBitAndRedoTheLast) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    session_.Begin(WorkOf("smile"));
    const Work first = session_.work();
    for (int i = 0; i < 200; ++i) DoAnything(random);
    while (session_.Redo() != Change::kNone) {
    }
    const Work last = session_.work();
    const std::size_t steps = session_.undoable();
    std::size_t undone = 0;
    while (session_.Undo() != Change::kNone) ++undone;
    ASSERT_EQ(undone, steps);
    ASSERT_EQ(session_.work(), first) << seed;
    ASSERT_FALSE(session_.unsaved());
    while (session_.Redo() != Change::kNone) {
    }
    ASSERT_EQ(session_.work(), last) << seed;
  }
}

TEST_F(HandleSession, ChangesPlayedAgainMakeTheSameSession) {
  for (unsigned seed = 100; seed < 120; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> journal;
    const auto note = [&](Change change) {
      if (change != Change::kNone) editor::Encode({change, session_.work()}, journal);
    };
    note(session_.Begin(WorkOf("surprised")));
    for (int i = 0; i < 150; ++i) note(DoAnything(random));
    note(session_.Rename("mine", 4));
    Session again(editor::PointsOf(cast_.net));
    for (const auto& record : editor::Decode(journal).records) again.Replay(record.change, record.work);
    ASSERT_EQ(again.work(), session_.work()) << seed;
    ASSERT_EQ(again.before(), session_.before());
    ASSERT_EQ(again.undoable(), session_.undoable());
    ASSERT_EQ(again.redoable(), session_.redoable());
    ASSERT_EQ(again.unsaved(), session_.unsaved());
    while (session_.Undo() != Change::kNone) {
      ASSERT_EQ(again.Undo(), Change::kUndone);
      ASSERT_EQ(again.work(), session_.work()) << seed;
    }
  }
}

TEST_F(HandleSession, OneGestureIsOneStep) {
  for (int i = 0; i < 50; ++i) session_.Pull(Point("MC.l"), {0, 0.0001F, 0}, 7);
  EXPECT_EQ(session_.undoable(), 1U);
  session_.Pull(Point("MC.l"), {0, 0.0001F, 0}, 8);
  EXPECT_EQ(session_.undoable(), 2U);
  session_.Undo();
  session_.Undo();
  EXPECT_EQ(PullOf("MC.l"), glm::vec3(0));
  session_.Pull(Point("MC.l"), {0, 0.0001F, 0}, 8);
  session_.Undo();
  EXPECT_EQ(PullOf("MC.l"), glm::vec3(0)) << "a gesture does not reach back over what was undone";
}

TEST_F(HandleSession, AHandThatChangesNothingIsNoStep) {
  EXPECT_EQ(session_.Zero(Point("MC.l")), Change::kNone);
  EXPECT_EQ(session_.Scale(2), Change::kNone) << "of nothing";
  EXPECT_EQ(session_.ShutLids(-1), Change::kNone);
  EXPECT_EQ(session_.Pull(9999, {0.01F, 0, 0}), Change::kNone);
  EXPECT_EQ(session_.Pull(0, {NAN, 0, 0}), Change::kNone);
  EXPECT_EQ(session_.undoable(), 0U);
}

TEST_F(HandleSession, NoHandleIsPulledOffTheFace) {
  for (int i = 0; i < 100; ++i) session_.Pull(Point("MC.l"), {0.01F, -0.01F, 0.01F});
  for (int i = 0; i < 100; ++i) session_.Scale(3);
  EXPECT_EQ(PullOf("MC.l"), glm::vec3(0.05F, -0.05F, 0.05F));
  session_.ShutLids(9);
  EXPECT_EQ(session_.work().lids[0], 1);
}

TEST_F(HandleSession, BeforeIsTheExpressionAsItWasTakenIntoWork) {
  session_.Begin(WorkOf("smile"));
  session_.Pull(0, {0, 0.001F, 0});
  EXPECT_EQ(session_.before(), WorkOf("smile"));
  session_.Replace(WorkOf("surprised"));
  session_.Pull(0, {0, 0.001F, 0});
  EXPECT_EQ(session_.before(), WorkOf("surprised"));
  session_.Undo();
  session_.Undo();
  EXPECT_EQ(session_.before(), WorkOf("smile"));
}

TEST_F(HandleSession, IsSavedUntilTheNextPullAndAgainWhenThatIsUndone) {
  session_.Begin(WorkOf("smile"));
  session_.Pull(0, {0, 0.001F, 0});
  session_.Rename("mine", 2);
  EXPECT_TRUE(session_.unsaved());
  session_.Keep(session_.work());
  EXPECT_FALSE(session_.unsaved());
  session_.Pull(0, {0, 0.001F, 0});
  EXPECT_TRUE(session_.unsaved());
  session_.Undo();
  EXPECT_FALSE(session_.unsaved());
  session_.Undo();
  EXPECT_EQ(session_.work().name, "mine") << "a name is no step";
  EXPECT_TRUE(session_.unsaved());
}

TEST_F(HandleSession, RefusesWorkThatDoesNotFitTheFace) {
  EXPECT_EQ(session_.Replace({.pulls_m = std::vector<glm::vec3>(3)}), Change::kNone);
  Work broken = WorkOf("smile");
  broken.pulls_m[2].y = NAN;
  EXPECT_EQ(session_.Begin(broken), Change::kNone);
  broken = WorkOf("smile");
  broken.slot = 10;
  EXPECT_EQ(session_.Replace(broken), Change::kNone);
}

}  // namespace
}  // namespace kaori::tests
