// What the box's own roles.toml has buttons call, those of the dial box and of the sticks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>

#include <fmt/format.h>

#include "appliance/core/roles/roles_file.h"

namespace kaori::roles {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class OwnButtonsTest : public ::testing::Test {
 protected:
  std::vector<std::string> LayOn(const std::string& text) {
    return LayOverText(text, "roles.toml", items_, roles_, besides_);
  }

  Items items_{.faces = {"kaori", "dog"}, .expressions = {"neutral", "angry", "laugh"}};
  show::Roles roles_ = show::UsualRoles();
  Besides besides_;
};

TEST_F(OwnButtonsTest, CallSomethingElseThanTheShowHas) {
  const char* const text =
      "[[button]]\nnumber = 5\ncall = \"cue go\"\n[[button]]\nnumber = 32\ncall = \"expression angry\"\n";
  ASSERT_THAT(LayOn(text), IsEmpty());
  show::Show show;
  Assign(besides_.buttons, show);
  EXPECT_EQ(show.buttons[4], (show::Call{show::CallKind::kCue, 0}));
  EXPECT_EQ(show.second_buttons[4], show.buttons[4]) << "on either sheet";
  EXPECT_EQ(show.buttons[31], (show::Call{show::CallKind::kExpression, 1}));
  const auto faults = LayOn(
      "[[button]]\nnumber = 33\ncall = \"cue gone\"\n[[button]]\nnumber = 5\ncall = \"cue go\"\n"
      "[[button]]\nnumber = 5\ncall = \"face dog\"\n");
  EXPECT_THAT(faults, ElementsAre(HasSubstr("roles.toml:2: button[1].number: is 33"),
                                  AllOf(HasSubstr("roles.toml:3: "), HasSubstr("did you mean \"cue go\"")),
                                  AllOf(HasSubstr("roles.toml:8: "), HasSubstr("button 5 is given twice"))));
  EXPECT_EQ(besides_.buttons.size(), 2U) << "as they were";
}

TEST_F(OwnButtonsTest, OfTheSticksCallWhatButtonsMayCall) {
  items_.motions = {"nod"};
  items_.scenes = {"night"};
  items_.cues = {"1", "2.10"};
  std::string text;
  const std::vector<std::string> calls{"cue panic",
                                       "motion nod",
                                       "scene night",
                                       "style flat",
                                       "blink",
                                       "wink right",
                                       "cue 2.10",
                                       "toggle expression angry",
                                       "momentary face kaori"};
  for (std::size_t n = 0; n < calls.size(); ++n)
    text +=
        fmt::format("[[button]]\ndevice = \"right stick\"\nnumber = {}\ncall = \"{}\"\n", n + 1, calls[n]);
  text += "[[button]]\ndevice = \"left stick\"\nnumber = 1\ncall = \"cue go\"\n";
  ASSERT_THAT(LayOn(text), IsEmpty());
  show::Show show;
  Assign(besides_.buttons, show);
  const std::span right = std::span(show.stick_buttons).subspan(show::kStickButtonCount);
  using show::CallKind, show::CallMode;
  EXPECT_EQ(right[0], (show::Call{CallKind::kCue, 4}));
  EXPECT_EQ(right[1], (show::Call{CallKind::kMotion, 0}));
  EXPECT_EQ(right[2], (show::Call{CallKind::kScene, 0}));
  EXPECT_EQ(right[3], (show::Call{CallKind::kStyle, 1}));
  EXPECT_EQ(right[4], (show::Call{CallKind::kBlink, 0}));
  EXPECT_EQ(right[5], (show::Call{CallKind::kBlink, 2}));
  EXPECT_EQ(right[6], (show::Call{CallKind::kGoTo, 1}));
  EXPECT_EQ(right[7], (show::Call{CallKind::kExpression, 1, CallMode::kToggle}));
  EXPECT_EQ(right[8], (show::Call{CallKind::kFace, 0, CallMode::kMomentary}));
  EXPECT_EQ(show.stick_buttons[0], (show::Call{CallKind::kCue, 0}));
  EXPECT_EQ(show.buttons[0], show::Call()) << "those of the dial box stay as they were";
  for (std::size_t n = 0; n < calls.size(); ++n) EXPECT_EQ(NameOf(right[n], items_), calls[n]);
  EXPECT_THAT(LayOn("[[button]]\ndevice = \"left stick\"\nnumber = 17\ncall = \"toggle cue go\"\n"),
              ElementsAre(HasSubstr("roles.toml:3: button[1].number: is 17"),
                          HasSubstr("\"toggle cue go\" is no call that the show has")));
}

}  // namespace
}  // namespace kaori::roles
