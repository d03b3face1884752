// A copy of the root's show beside the shows of sticks.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/shows/copy.h"
#include "tests/appliance/programs/shows_simulated_folder.h"

namespace kaori::shows {
namespace {

class CopyTest : public InstallationTest {
 protected:
  // The root's show is signed by nobody.
  const Bytes root_ = PackOf("of the root", nullptr), next_ = PackOf("of the next root", nullptr);
  SimulatedFolder folder_;

  static Result<Copied> Keep(SimulatedFolder& folder, const Bytes& root) {
    SimulatedSource source(root);
    Bytes there = folder.Content(store::kCopyName);
    there.resize(std::min(there.size(), show::kPackHeader_bytes));
    return KeepCopy(folder, source, there);
  }
};

TEST_F(CopyTest, IsMadeOnceForEachRoot) {
  EXPECT_EQ(Keep(folder_, root_), Copied::kMade);
  EXPECT_EQ(folder_.Content(store::kCopyName), root_);
  EXPECT_EQ(folder_.pending(), 0U) << "its name is on the disk";
  folder_.fault = std::errc::io_error;
  EXPECT_EQ(Keep(folder_, root_), Copied::kIsThere) << "nothing is written";
  folder_.fault.reset();
  EXPECT_EQ(Keep(folder_, next_), Copied::kMade);
  EXPECT_EQ(folder_.Content(store::kCopyName), next_);
}

TEST_F(CopyTest, OfARootThatReadsWronglyIsNotKept) {
  Bytes spoilt = root_;
  spoilt.back() ^= 1U;
  EXPECT_FALSE(Keep(folder_, spoilt));
  SimulatedSource failing(root_, 5000);
  EXPECT_FALSE(KeepCopy(folder_, failing, {}));
  EXPECT_THAT(folder_.Names().value(), ::testing::IsEmpty());
}

TEST_F(CopyTest, OfAFileThatIsNoPackIsRefusedByItsName) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / ("keeps-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::ofstream(folder / "given.kaori") << "no pack at all";
  const auto kept = KeepCopyOf(folder / "given.kaori", folder, {});
  std::filesystem::remove_all(folder);
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.error().message(), (folder / "given.kaori").string() + " is no show pack");
}

TEST_F(CopyTest, IsNotMadeWhereThereIsNoRoom) {
  folder_.capacity_bytes = root_.size() + Installation::kReserve_bytes - 1;
  EXPECT_EQ(Keep(folder_, root_), Copied::kNoRoom);
  EXPECT_THAT(folder_.Names().value(), ::testing::IsEmpty());
}

TEST_F(CopyTest, GivesWayToTheNextOneAndToShowsThatNeedItsRoom) {
  folder_.capacity_bytes = root_.size() + Installation::kReserve_bytes + 5000;
  EXPECT_EQ(Keep(folder_, root_), Copied::kMade);
  EXPECT_EQ(Keep(folder_, next_), Copied::kMade);
  EXPECT_EQ(folder_.Content(store::kCopyName), next_);
  EXPECT_EQ(Install(folder_, first_).message, Message::kInstalled);
  EXPECT_EQ(folder_.BytesOf(store::kCopyName), 0U);
}

TEST_F(CopyTest, IsNotMadeWhileAShowComesFromAStick) {
  ASSERT_TRUE((*folder_.Begin(store::kIncomingName))->Append(first_));
  EXPECT_EQ(Keep(folder_, root_), Copied::kGaveWay);
  EXPECT_THAT(folder_.Names().value(), ::testing::ElementsAre(store::kIncomingName));
}

TEST_F(CopyTest, RestsWhileTheFaceNeedsTheBoxAndGivesWayThenToo) {
  SimulatedSource source(root_), again(root_);
  int asked = 0;
  EXPECT_EQ(KeepCopy(folder_, source, {}, [&] { return ++asked > 2; }), Copied::kMade);
  EXPECT_GT(asked, 2);
  SimulatedFolder other;
  const auto comes = [&] { return (*other.Begin(store::kIncomingName))->Append(first_), false; };
  EXPECT_EQ(KeepCopy(other, again, {}, comes), Copied::kGaveWay);
}

TEST_F(CopyTest, ThatIsBeingMadeLeavesItsRoomToAShowOfAStick) {
  folder_.capacity_bytes = root_.size() + Installation::kReserve_bytes + 5000;
  ASSERT_TRUE((*folder_.Begin(store::kUnfinishedCopyName))->Append(root_));
  EXPECT_EQ(Install(folder_, first_).message, Message::kInstalled);
  EXPECT_EQ(folder_.BytesOf(store::kUnfinishedCopyName), 0U);
}

TEST_F(CopyTest, IsTheOldOneTheNewOneOrNoneWhereverThePowerGoes) {
  EXPECT_EQ(Keep(folder_, root_), Copied::kMade);
  int cuts = 0;
  for (bool is_through = false; !is_through; ++cuts) {
    SimulatedFolder cut = folder_;
    cut.steps_left = cuts;
    is_through = Keep(cut, next_).has_value();
    for (std::size_t changes = 0; changes <= cut.pending(); ++changes)
      for (const Torn torn : {Torn::kEmpty, Torn::kHalf, Torn::kWhole, Torn::kZeros}) {
        SimulatedFolder after = cut.AfterCut(changes, torn);
        const Bytes copy = after.Content(store::kCopyName);
        EXPECT_TRUE(copy == root_ || copy == next_) << cuts;
        EXPECT_TRUE(Keep(after, next_)) << cuts;
        EXPECT_EQ(after.Content(store::kCopyName), next_);
      }
  }
  EXPECT_GE(cuts, 6);
}

}  // namespace
}  // namespace kaori::shows
