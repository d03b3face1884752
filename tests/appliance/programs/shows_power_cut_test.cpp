// The power goes at each step of an installation: what is found afterwards is the show before or the new one, whole.
#include <gmock/gmock.h>

#include "tests/appliance/programs/shows_simulated_folder.h"

namespace kaori::shows {
namespace {

class PowerCut : public InstallationTest {
 protected:
  PowerCut() { EXPECT_EQ(Install(folder_, first_).message, Message::kInstalled); }

  // What is wrong with a folder after a cut; empty: nothing.
  std::string Fault(SimulatedFolder after, bool acknowledged) const {
    const auto choice = ReadChoice(after);
    const bool is_new = choice.current == IdOf(second_);
    if (!is_new && choice.current != IdOf(first_)) return "another show is chosen: " + choice.current;
    if (acknowledged && !is_new) return "the show that was said to be installed is lost";
    if (after.Content(store::PackName(choice.current)) != (is_new ? second_ : first_))
      return "the chosen show is torn";
    if (is_new && after.Content(store::PackName(choice.previous)) != first_) return "the show before is lost";
    const auto again = Install(after, second_).message;
    if (again != (is_new ? Message::kAlreadyThere : Message::kInstalled))
      return "it cannot be installed again";
    return ReadChoice(after).current == IdOf(second_) ? "" : "the second try changed nothing";
  }

  // Looks at each folder that a cut at any step can leave. Gives the faults; `states` counts.
  std::vector<std::string> FaultsOfAllCuts(int& states) const {
    std::vector<std::string> faults;
    bool cut = true;
    for (int step = 0; cut; ++step) {
      SimulatedFolder folder = folder_;
      folder.steps_left = step;
      const bool acknowledged = Install(folder, second_).message == Message::kInstalled;
      cut = !acknowledged;
      for (std::size_t changes = 0; changes <= folder.pending(); ++changes)
        for (const Torn torn : {Torn::kEmpty, Torn::kHalf, Torn::kWhole, Torn::kZeros}) {
          ++states;
          if (auto fault = Fault(folder.AfterCut(changes, torn), acknowledged); !fault.empty())
            faults.push_back(
                fmt::format("step {}, {} changes, torn {}: {}", step, changes, int(torn), fault));
        }
    }
    return faults;
  }

  SimulatedFolder folder_;
};

TEST_F(PowerCut, LeavesTheShowBeforeOrTheNewOneWhole) {
  int states = 0;
  EXPECT_THAT(FaultsOfAllCuts(states), ::testing::IsEmpty());
  EXPECT_GE(states, 60);
}

TEST_F(PowerCut, WouldSpoilAShowWhoseNamesAreNotKept) {
  folder_.forgets_names = true;
  int states = 0;
  EXPECT_THAT(FaultsOfAllCuts(states), ::testing::Not(::testing::IsEmpty()));
}

TEST_F(PowerCut, WouldSpoilAShowWhoseContentIsNotKept) {
  folder_.forgets_content = true;
  int states = 0;
  EXPECT_THAT(FaultsOfAllCuts(states), ::testing::Not(::testing::IsEmpty()));
}

// Packs without a choice are those of a folder whose choice the disk has lost, and are told of as such.
TEST_F(PowerCut, OfTheFirstInstallationLeavesNoPackWithoutAChoice) {
  int packs = 0;
  bool cut = true;
  for (int step = 0; cut; ++step) {
    SimulatedFolder folder;
    folder.steps_left = step;
    cut = Install(folder, first_).message != Message::kInstalled;
    for (std::size_t changes = 0; changes <= folder.pending(); ++changes)
      for (const Torn torn : {Torn::kEmpty, Torn::kHalf, Torn::kWhole, Torn::kZeros}) {
        const SimulatedFolder after = folder.AfterCut(changes, torn);
        const bool has_pack = after.BytesOf(store::PackName(IdOf(first_))) > 0;
        packs += has_pack ? 1 : 0;
        EXPECT_TRUE(!has_pack || HasChoice(after)) << "step " << step << ", " << changes << " changes";
      }
  }
  EXPECT_GE(packs, 4);
}

// A disk that fails for good, at each step.
TEST_F(PowerCut, IsNoWorseThanADiskThatCannotBeWritten) {
  SimulatedFolder folder = folder_;
  folder.fault = std::errc::io_error;
  EXPECT_EQ(Install(folder, second_).message, Message::kDiskFault);
  EXPECT_EQ(ReadChoice(folder).current, IdOf(first_));
}

}  // namespace
}  // namespace kaori::shows
