// What the show hears while somebody takes a show from the list of kaori-shows.
#include <gmock/gmock.h>

#include "appliance/core/board/caller.h"
#include "appliance/core/board/keys.h"
#include "appliance/core/board/lines.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/stage/service_modes.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint8_t kPanicButton = 6;

class StageShowsMenu : public tests::PackTest {
 protected:
  StageShowsMenu() {
    const auto panic = static_cast<std::uint16_t>(show::CueVerb::kPanic);
    show_.keys.push_back({board::key::kEscape, {show::CallKind::kCue, panic}});
    show_.buttons[kPanicButton] = {show::CallKind::kCue, panic};
    lines_.active = 1U << unsigned(board::Line::kService);
    Write();
    seen_ = performance::SeenOn(board::ReadAll(board_));
  }
  void Menu(bool open) { menu_.Write({open ? 1U : 0U}, now_, board::SourceState::kLive); }
  void Write() {
    keys_writer_.Write(keys_, now_, board::SourceState::kLive);
    surface_writer_.Write(surface_, now_, board::SourceState::kLive);
    lines_writer_.Write(lines_, now_, board::SourceState::kLive);
  }
  void Strike(std::uint8_t usage) { board::NotePress(keys_, usage, now_); }
  void Push(std::uint8_t button) { board::NotePress(surface_, button, now_); }
  void Call(show::CueVerb verb) {
    caller_.Make({.at = now_, .verb = board::CallVerb::kCue, .subject = static_cast<std::uint32_t>(verb)});
  }
  // The presses and the verbs of the calls that the show gets of a frame.
  std::vector<int> Heard() {
    Write();
    const board::Snapshot snapshot = board::ReadAll(board_);
    performance::InputEvents events = performance::ReadEvents(seen_, snapshot);
    left_ = modes_.Step({board_, snapshot, snapshot, show_, state_, nullptr, now_}, events);
    std::vector<int> heard;
    for (const auto& press : events.presses()) heard.push_back(press.code);
    for (const auto& call : events.calls()) heard.push_back(static_cast<int>(call.subject));
    return heard;
  }

  board::Board board_ = board::Board::Create((folder_ / "board").string()).value();
  board::Writer<board::Keys> keys_writer_ = board_.AcquireWriter<board::Keys>().value();
  board::Writer<board::Surface> surface_writer_ = board_.AcquireWriter<board::Surface>().value();
  board::Writer<board::Lines> lines_writer_ = board_.AcquireWriter<board::Lines>().value();
  board::Writer<board::ShowsMenu> menu_ = board_.AcquireWriter<board::ShowsMenu>().value();
  board::Writer<board::LineCheck> check_writer_ = board_.AcquireWriter<board::LineCheck>().value();
  board::Writer<board::Learn> learn_writer_ = board_.AcquireWriter<board::Learn>().value();
  board::Caller caller_ = board::Caller::Acquire(board_, board::CallWriter::kControl).value();
  show::Show show_ = tests::SmallShow();
  performance::State state_;
  performance::SeenInput seen_;
  board::Keys keys_;
  board::Surface surface_;
  board::Lines lines_;
  board::Snapshot left_;
  ServiceModes modes_{check_writer_, learn_writer_};
  Time now_ = Time{} + 1000s;
};

TEST_F(StageShowsMenu, TakesGoAndKeysAndButtonsFromTheShow) {
  Menu(true);
  Strike(board::key::k1);
  Strike(board::key::kHome);
  keys_.down[0] = 1U << board::key::k1;
  Push(3);
  surface_.counts[2] += 100;
  Call(show::CueVerb::kGo);
  EXPECT_THAT(Heard(), IsEmpty());
  EXPECT_FALSE(board::IsDown(left_.keys.value, board::key::k1));
  EXPECT_EQ(board_.Read<board::LineCheck>().value.phase, board::LineCheckPhase::kNever)
      << "Home is the list's as well";
}

TEST_F(StageShowsMenu, LeavesPanicAndBlackoutToTheShowWhateverCallsThem) {
  Menu(true);
  Call(show::CueVerb::kBlackout);
  EXPECT_THAT(Heard(), ElementsAre(static_cast<int>(show::CueVerb::kBlackout)));
  Call(show::CueVerb::kPanic);
  Strike(board::key::kEscape);
  Push(kPanicButton);
  Push(3);
  EXPECT_THAT(Heard(), ::testing::UnorderedElementsAre(board::key::kEscape, kPanicButton,
                                                       static_cast<int>(show::CueVerb::kPanic)));
  lines_.active |= 1U << unsigned(board::Line::kBlackout);
  Heard();
  EXPECT_TRUE(board::IsOn(left_.lines.value, board::Line::kBlackout));
}

TEST_F(StageShowsMenu, OfAProgramThatIsGoneTakesNothing) {
  Menu(true);
  now_ += board::kMenuSilence - 1ms;
  Strike(board::key::k1);
  EXPECT_THAT(Heard(), IsEmpty()) << "it is busy with the disk";
  now_ += 1ms;
  Strike(board::key::k1);
  EXPECT_THAT(Heard(), ElementsAre(board::key::k1));
}

TEST_F(StageShowsMenu, TakesNothingOnceTheServiceKeyIsOff) {
  Menu(true);
  lines_.active = 0;
  Strike(board::key::k1);
  EXPECT_THAT(Heard(), ElementsAre(board::key::k1));
}

TEST_F(StageShowsMenu, ThatIsShutTakesTheKeyThatOpensItAlone) {
  Strike(board::key::kPageUp);
  EXPECT_THAT(Heard(), ElementsAre(board::key::kPageUp)) << "there is no list";
  Menu(false);
  Strike(board::key::kPageUp);
  Strike(board::key::k1);
  Push(3);
  EXPECT_THAT(Heard(), ::testing::UnorderedElementsAre(board::key::k1, 3));
}

}  // namespace
}  // namespace kaori::stage
