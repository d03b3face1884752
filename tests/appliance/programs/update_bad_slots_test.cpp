// Systems that do badly, each in its own way: the one before is back after one try, and says why.
#include <gmock/gmock.h>

#include <functional>

#include "appliance/programs/update/looks.h"
#include "appliance/programs/update/trial.h"
#include "hw-sim/devices/boot_loader.h"
#include "tests/appliance/programs/update_fixture.h"

namespace kaori::update {
namespace {

using ports::Slot;
using std::chrono::seconds;
using ::testing::HasSubstr;

std::string FlatPicture(std::uint8_t grey) {
  return "P6\n30 20\n255\n" + std::string(std::size_t{30} * 20 * 3, static_cast<char>(grey));
}

std::string UnitOf(const char* state, int restarts) {
  return "Id=kaori-stage.service\nNRestarts=" + std::to_string(restarts) + "\nActiveState=" + state + "\n";
}

// What the trial sees of a system at a second of its life.
struct BadSlot {
  const char* name;
  // Whether it comes so far as to look at itself.
  bool starts = true;
  // Whether what starts comes to its own end, or somebody has to switch it off.
  bool hangs = false;
  std::string units = UnitOf("active", 0);
  std::string picture = FlatPicture(120);
  // Until it shows that.
  seconds shows_after{};
  // A part of the reason that is said.
  const char* reason = "";
};

const std::string kWanted = FlatPicture(120);

std::vector<BadSlot> BadSlots() {
  constexpr const char* kSilent = "never came so far";
  return {{.name = "its kernel panics", .starts = false, .reason = kSilent},
          {.name = "its kernel hangs", .starts = false, .hangs = true, .reason = kSilent},
          {.name = "its root has another hash", .starts = false, .reason = kSilent},
          {.name = "its first program ends", .starts = false, .reason = kSilent},
          {.name = "its stage crashes", .units = UnitOf("active", 3), .reason = "had to be started anew"},
          {.name = "its stage does not start", .units = UnitOf("activating", 0), .reason = "does not run"},
          {.name = "it is black", .picture = FlatPicture(0), .reason = "not that of the face"},
          {.name = "it shows another face", .picture = FlatPicture(160), .reason = "not that of the face"},
          {.name = "it shows no face in three minutes", .shows_after = seconds(175), .reason = "no picture"},
          {.name = "it hangs in its trial", .hangs = true, .reason = "the power went or it hung"}};
}

class BadSlotTest : public ::testing::Test {
 protected:
  // As kaori-update looks, every 5 s; without a look at the picture where the control wants it.
  static Reason FaultOf(const BadSlot& slot, seconds at, bool looks_at_picture) {
    if (auto fault = ProgramsFault(slot.units, 1, Restarts::kAreFaults); !fault.empty()) return fault;
    if (!looks_at_picture) return {};
    return PictureFault(at < slot.shows_after ? std::string() : slot.picture, {kWanted});
  }
  // Whether it stays.
  bool Try(const BadSlot& slot, bool looks_at_picture = true) {
    choice_ = sim::BootLoader();
    notes_ = SimulatedNotes();
    notes_.pending = Pending{6, Slot::kB, 0};
    BeginTry(choice_, notes_, 5);
    EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
    if (!slot.starts) return false;
    NoteStart(notes_);
    if (slot.hangs) return false;
    const Time began = ManualClock().now();
    Confirmation confirmation(began);
    auto verdict = Confirmation::Verdict::kLooking;
    for (seconds at{}; verdict == Confirmation::Verdict::kLooking; at += seconds(5))
      verdict = confirmation.Observe(FaultOf(slot, at, looks_at_picture), began + at);
    if (verdict == Confirmation::Verdict::kStays) return ConfirmTried(choice_, notes_).has_value();
    EXPECT_TRUE(GiveWay(notes_, confirmation.reason(), ""));
    return false;
  }

  sim::BootLoader choice_;
  SimulatedNotes notes_;
};

TEST_F(BadSlotTest, GivesWayAfterOneTryAndSaysWhy) {
  int kept = 0, most_tries = 0;
  for (const BadSlot& slot : BadSlots()) {
    kept += Try(slot) ? 1 : 0;
    EXPECT_EQ(choice_.SwitchOn(), Slot::kA) << slot.name;
    const Outcome found = AfterStart(choice_, notes_);
    EXPECT_EQ(found.message, Message::kGaveWay) << slot.name;
    EXPECT_THAT(found.detail, HasSubstr(slot.reason)) << slot.name;
    EXPECT_FALSE(found.japanese.empty()) << slot.name;
    ASSERT_TRUE(notes_.pending) << slot.name;
    most_tries = std::max(most_tries, static_cast<int>(notes_.pending->tries));
  }
  EXPECT_EQ(kept, 0);
  EXPECT_EQ(most_tries, 1);
  RecordProperty("bad_slots", static_cast<int>(BadSlots().size()));
  RecordProperty("bad_slots_kept", kept);
  RecordProperty("tries_to_return", most_tries);
}

TEST_F(BadSlotTest, ThatIsAGoodOneStays) {
  EXPECT_TRUE(Try({.name = "a good one", .shows_after = seconds(30)}));
  EXPECT_EQ(choice_.SwitchOn(), Slot::kB);
}

// The control: with the looks at the programs alone a black one would stay.
TEST_F(BadSlotTest, WouldStayWithoutALookAtThePicture) {
  const bool stays = Try({.name = "it is black", .picture = FlatPicture(0)}, false);
  EXPECT_TRUE(stays);
  RecordProperty("control_found", stays ? 1 : 0);
}

}  // namespace
}  // namespace kaori::update
