// lobby.toml beside a show: what it says is what the box plays, and all that is wrong is said at once.
#include <gmock/gmock.h>

#include "appliance/authoring/script/show_file.h"
#include "tests/appliance/authoring/checked_folder.h"

namespace kaori::tests {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The show's names of faces and expressions are not asked for: no cast has to be made.
class LobbyFileTest : public CheckedFolder {
 protected:
  std::vector<std::string> Read(const std::string& text) {
    std::ofstream(show_ / "lobby.toml") << text;
    read_ = {};
    return authoring::ReadShowFile(show_ / "show.toml", read_, {.faces = false, .expressions = false});
  }

  show::Show read_;
};

TEST_F(LobbyFileTest, SaysWhatTheBoxPlays) {
  EXPECT_THAT(Read(R"(cue = "40"
by_itself = true
visitor = "seat 12"
sleep_s = 45
stuck_s = 600
sleep_light = 0.1
[[greeting]]
motion = "nod"
language = "ja"
[[greeting]]
motion = "bow"
[[goodbye]]
motion = "bow"
[hours]
monday = "17:00-23:30"
sunday = ["10:00-12:00", "18:00-01:30"]
)"),
              IsEmpty());
  ASSERT_TRUE(read_.lobby);
  const show::Lobby& lobby = *read_.lobby;
  EXPECT_EQ(read_.cue_list.cues[lobby.cue].number, "40");
  EXPECT_TRUE(lobby.by_itself);
  EXPECT_EQ(read_.gaze_targets[static_cast<std::size_t>(lobby.visitor)].name, "seat 12");
  EXPECT_FLOAT_EQ(lobby.sleep_s, 45);
  EXPECT_FLOAT_EQ(lobby.stuck_s, 600);
  EXPECT_FLOAT_EQ(lobby.sleep_light, 0.1F);
  EXPECT_FLOAT_EQ(lobby.stay_s, 20) << "what is not named stays as it is";
  ASSERT_EQ(lobby.greetings.size(), 2U);
  EXPECT_EQ(lobby.greetings[0].language, "ja");
  EXPECT_EQ(read_.motions[static_cast<std::size_t>(lobby.greetings[1].motion)].name, "bow");
  EXPECT_THAT(lobby.stays, IsEmpty());
  ASSERT_EQ(lobby.goodbyes.size(), 1U);
  ASSERT_EQ(lobby.hours.size(), 3U);
  EXPECT_EQ(lobby.hours[0].from, 17 * 60);
  EXPECT_EQ(lobby.hours[0].to, 23 * 60 + 30);
  EXPECT_EQ(lobby.hours[2].to, show::kWeekMinutes + 90) << "it goes on into Monday";
}

TEST_F(LobbyFileTest, WithoutOneAShowHasNoLobby) {
  std::filesystem::remove(show_ / "lobby.toml");
  EXPECT_THAT(authoring::ReadShowFile(show_ / "show.toml", read_, {.faces = false, .expressions = false}),
              IsEmpty());
  EXPECT_FALSE(read_.lobby);
}

TEST_F(LobbyFileTest, AllThatIsWrongIsSaidAtOnceWithFileAndLine) {
  EXPECT_THAT(Read(R"(cue = "41"
visitor = "camra"
sleep_s = 0
sleep = 3
by_itself = "yes"
[[greeting]]
take = "helo"
language = "Japanese!"
[[goodbye]]
language = "en"
[hours]
monday = "17-23"
tuesday = ["25:00-26:00"]
funday = "10:00-12:00"
)"),
              ::testing::UnorderedElementsAre(
                  ContainsRegex("lobby.toml:1: cue: there is no cue \"41\" in cues.toml"),
                  ContainsRegex("lobby.toml:2: visitor: there is no gaze target \"camra\"; did you mean "
                                "\"camera\"[?]"),
                  ContainsRegex("lobby.toml:3: sleep_s: is 0"),
                  ContainsRegex("lobby.toml:4: sleep: is not known here; did you mean \"sleep_s\"[?]"),
                  ContainsRegex("lobby.toml:5: by_itself: must be true or false"),
                  ContainsRegex("lobby.toml:7: greeting.*take: there is no take \"helo\""),
                  ContainsRegex("lobby.toml:8: greeting.*language: \"Japanese!\" is no tag"),
                  ContainsRegex("lobby.toml:9: goodbye.*motion: is missing"),
                  ContainsRegex("lobby.toml:12: hours.monday: \"17-23\" is no time such as"),
                  ContainsRegex("lobby.toml:13: hours.tuesday: \"25:00-26:00\" is no time"),
                  ContainsRegex("lobby.toml:14: hours.funday: is not known here")));
}

TEST_F(LobbyFileTest, ALobbyGreetsAndOpensOnSomeDay) {
  EXPECT_THAT(Read("cue = \"40\"\n[hours]\nmonday = []\n"),
              ElementsAre(ContainsRegex("greeting: there is none"), ContainsRegex("hours: names no time")));
}

}  // namespace
}  // namespace kaori::tests
