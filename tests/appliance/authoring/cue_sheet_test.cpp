// The cue sheet says on paper what the list plays.
#include "appliance/authoring/pack/cue_sheet.h"

#include <gmock/gmock.h>

#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using authoring::CueSheet;
using authoring::SheetLanguage;
using ::testing::HasSubstr;
using ::testing::Not;

// Three cues: one that waits for a person, one that follows it, one that takes her away.
show::Show ShowWithCues() {
  show::Show show = SmallShow();
  show.name = "Night & Day";
  auto& cues = show.cue_list.cues;
  cues.resize(3);
  cues[0] = {
      .number = "1", .name = "Morning <b>", .act = "One", .notes = "After the \"bell\"", .pre_wait_s = 0.5F};
  cues[0].scene = show::CueCall{0, 4};
  cues[0].light = show::CueLevel{0.55F, 3};
  cues[0].next = show::CueNext::kFollow;
  cues[0].wait = {show::CuePerson::kVoiceQuiet, 1.2F, 20};
  cues[1] = {.number = "1.5", .name = "and goes on"};
  cues[1].expression = show::CueCall{0, 0};
  cues[2] = {.number = "2", .name = "Gone", .act = "Two"};
  cues[2].present = show::CueLevel{0, 0.8F};
  Track(show);
  return show;
}

TEST(CueSheetOnPaper, SaysWhatBeginsACueAndWhatItDoes) {
  const show::Show show = ShowWithCues();
  const std::string page = CueSheet(show, SheetLanguage::kEnglish);
  EXPECT_THAT(page,
              HasSubstr("<td class=\"begins\">GO, then 0.5 s; voice quiet for 1.2 s, or after 20 s</td>"));
  EXPECT_THAT(page, HasSubstr("<li>scene " + show.scenes[0].name + ", 4 s</li><li>light 55 %, 3 s</li>"));
  EXPECT_THAT(page, HasSubstr("when the cue before has ended"));
  EXPECT_THAT(page, HasSubstr("<li>expression " + show.cast.expressions[0].name + ", at once</li>"));
  EXPECT_THAT(page, HasSubstr("<li>she leaves the picture, 0.8 s</li>"));
}

TEST(CueSheetOnPaper, SaysHowATakeIsPlayedAndForWhoseLookACueWaits) {
  show::Show show = ShowWithCues();
  show.motions = {{.name = "greeting",
                   .key_usage = 0,
                   .curves = {{show::MotionTarget::kHeadYaw, 0, {{0, 0}, {1, 0.1F}, {9, 0}}}}}};
  show.gaze_targets = {{"house", {0, 0, 4}}, {"seat <12>", {0, 0, 4}}};
  show.cue_list.cues[0].motion = 0;
  show.cue_list.cues[0].use = {.layer = show::MotionLayer::kOver, .gain = 0.8F, .from_s = 2.5F};
  show.cue_list.cues[0].wait = {show::CuePerson::kGazeOn, 0.5F, 20, 1};
  const std::string page = CueSheet(show, SheetLanguage::kEnglish);
  EXPECT_THAT(page, HasSubstr("motion greeting, over, 0.8 times as large, from 2.5 s on"));
  EXPECT_THAT(page, HasSubstr("GO, then 0.5 s; her look on seat &lt;12&gt; for 0.5 s, or after 20 s"));
  EXPECT_THAT(CueSheet(show, SheetLanguage::kJapanese), HasSubstr("動き greeting、over、0.8 倍、2.5 秒から"));
}

TEST(CueSheetOnPaper, HasAHeadingForEachAct) {
  const std::string page = CueSheet(ShowWithCues(), SheetLanguage::kEnglish);
  const std::size_t one = page.find(">One</th>"), two = page.find(">Two</th>");
  ASSERT_NE(one, std::string::npos);
  ASSERT_NE(two, std::string::npos);
  EXPECT_LT(one, page.find("and goes on"));
  EXPECT_LT(page.find("and goes on"), two);
}

TEST(CueSheetOnPaper, LetsNoTextOfTheShowBecomeMarkup) {
  const std::string page = CueSheet(ShowWithCues(), SheetLanguage::kEnglish);
  EXPECT_THAT(page, HasSubstr("Night &amp; Day: Cue sheet"));
  EXPECT_THAT(page, HasSubstr("Morning &lt;b&gt;"));
  EXPECT_THAT(page, HasSubstr("After the &quot;bell&quot;"));
}

TEST(CueSheetOnPaper, IsJapaneseWhereThatIsAskedFor) {
  const std::string page = CueSheet(ShowWithCues(), SheetLanguage::kJapanese);
  EXPECT_THAT(page, HasSubstr("<html lang=\"ja\">"));
  EXPECT_THAT(page, HasSubstr("声が 1.2 秒止んだら、または 20 秒後"));
  EXPECT_THAT(page, HasSubstr("画面から消える、0.8 秒"));
  EXPECT_THAT(page, Not(HasSubstr("she leaves")));
}

TEST(CueSheetOnPaper, HasTheScenesOfAShowWithoutCues) {
  show::Show show = SmallShow();
  show.cue_list = {};
  Track(show);
  const std::string page = CueSheet(show, SheetLanguage::kEnglish);
  for (std::size_t i = 1; i < show.scenes.size(); ++i)
    EXPECT_THAT(page, HasSubstr("scene " + show.scenes[i].name));
}

}  // namespace
}  // namespace kaori::tests
