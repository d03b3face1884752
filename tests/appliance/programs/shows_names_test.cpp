// Names of shows in any language, from the stick to the screen.
#include "tests/appliance/programs/shows_service_fixture.h"

namespace kaori::shows {
namespace {

using std::chrono::seconds;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ShowNames : public ServiceTest {};

TEST_F(ShowNames, InJapaneseAreToldApartAndTaken) {
  PutOnStick("昼の部", &company_);
  PutOnStick("夜の部", &company_);
  plugged_ = true;
  const std::string said = Play(seconds(1));
  EXPECT_THAT(said, AllOf(HasSubstr("1. 夜の部  "), HasSubstr("2. 昼の部  "), Not(HasSubstr("??"))));
  EXPECT_THAT(Choose("夜の部"), AllOf(HasSubstr("夜の部: it is "), HasSubstr("夜の部: 入りました")));
}

TEST_F(ShowNames, OfTwoSticksAreToldApart) {
  PutOnStick("かおり", &company_);
  plugged_ = true;
  EXPECT_THAT(Play(seconds(1)), HasSubstr("> 1. かおり  "));
  plugged_ = false;
  Play(seconds(1));
  std::filesystem::remove(folder_ / "stick/かおり.kaori");
  PutOnStick("しおり", &company_);
  plugged_ = true;
  EXPECT_THAT(Play(seconds(1)), AllOf(HasSubstr("> 1. しおり  "), Not(HasSubstr("かおり"))));
}

// A line of the list has room for forty columns of a name.
TEST_F(ShowNames, ThatAreLongAreCutBetweenLetters) {
  PutOnStick("a千秋楽千秋楽千秋楽千秋楽千秋楽千秋楽千秋楽", &company_);
  plugged_ = true;
  EXPECT_THAT(Play(seconds(1)), HasSubstr("> 1. a千秋楽千秋楽千秋楽千秋楽千秋楽千秋楽...  "));
}

// The Japanese sentence stands below the English one, so that a long list does not push it off the screen.
TEST_F(ShowNames, StandBelowTheSentencesOfBothLanguages) {
  PutOnStick("夜の部", &company_);
  plugged_ = true;
  const std::string said = Play(seconds(1));
  EXPECT_THAT(said, StartsWith(Say(Message::kChoose, Language::kEnglish, "") + "\n" +
                               Say(Message::kChoose, Language::kJapanese, "") + "\n> 1. 夜の部  "));
}

}  // namespace
}  // namespace kaori::shows
