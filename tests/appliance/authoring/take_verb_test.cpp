// kaori-atelier take: what it writes, what it says, and that nothing is lost where it refuses.
#include <gmock/gmock.h>

#include "appliance/authoring/pack/verbs.h"
#include "appliance/authoring/takes/take_file.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using authoring::LoadTake;
using ::testing::HasSubstr;

class VerbTake : public PackTest {
 protected:
  VerbTake() {
    std::ofstream(folder_ / "show.toml") << "name = \"small\"\n";
    std::filesystem::create_directories(folder_ / "takes");
    std::ofstream(folder_ / "takes/wave.toml")
        << "key = \"3\"\n[curves]\nhead_yaw = [[0, 3], [2, 20], [4, -4]]\nhead_pitch = [[0, 1], [4, 2]]\n";
    std::ofstream(folder_ / "takes/pass.toml") << "[curves]\nhead_yaw = [[0, 9], [1, 9]]\n";
  }

  // What it said, on either stream, behind its exit status.
  std::string Run(std::vector<std::string> words, std::map<std::string, std::string> options = {}) const {
    for (std::string& word : words)
      if (word == "FOLDER") word = folder_.string();
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int status = authoring::VerbOfTakes().run({std::move(words), std::move(options)});
    const std::string said = ::testing::internal::GetCapturedStdout();
    return std::to_string(status) + " " + said + ::testing::internal::GetCapturedStderr();
  }
  std::string TextOf(const char* take) const {
    std::ifstream in(authoring::FileOfTake(folder_, take));
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(VerbTake, ChangesHowATakeIsPlayedAndKeepsTheRecording) {
  EXPECT_THAT(Run({"trim", "FOLDER", "wave", "0.5", "3"}), HasSubstr("from 0.50 to 3.00 s"));
  EXPECT_THAT(Run({"stretch", "FOLDER", "wave", "2"}), HasSubstr("2.00 times as long"));
  EXPECT_THAT(Run({"gain", "FOLDER", "wave", "0.5"}), HasSubstr("0.50 times as large"));
  EXPECT_THAT(Run({"ease", "FOLDER", "wave", "0.4"}), ::testing::StartsWith("0 "));
  EXPECT_THAT(Run({"loop", "FOLDER", "wave", "1"}), HasSubstr("a loop of 4.00 s"));
  EXPECT_THAT(Run({"put", "FOLDER", "wave", "under"}), HasSubstr("; under operator input"));
  EXPECT_THAT(Run({"put", "FOLDER", "wave", "below"}), HasSubstr("below: is none of add, under, over"));
  const auto take = LoadTake(folder_, "wave");
  ASSERT_TRUE(take) << take.error().message();
  EXPECT_TRUE(take->loop);
  EXPECT_EQ(take->layer, show::MotionLayer::kUnder);
  EXPECT_EQ(take->ease_s, 0.4F);
  EXPECT_EQ(take->key, "3");
  ASSERT_EQ(take->curves.size(), 2U);
  EXPECT_EQ(take->curves[1].keys[1].value, 20) << "head_yaw, behind head_pitch";
  EXPECT_THAT(Run({"trim", "FOLDER", "wave", "0", "end"}), ::testing::StartsWith("0 "));
  EXPECT_THAT(Run({"loop", "FOLDER", "wave", "off"}), ::testing::Not(HasSubstr("loop")));
  EXPECT_FALSE(LoadTake(folder_, "wave")->to_s);
}

TEST_F(VerbTake, MakesANewTakeOfTwoAndKeepsBoth) {
  const std::string wave = TextOf("wave"), pass = TextOf("pass");
  EXPECT_THAT(Run({"layer", "FOLDER", "both", "wave", "pass"}), HasSubstr("4.00 s of head_pitch, head_yaw"));
  EXPECT_THAT(Run({"punch", "FOLDER", "mended", "wave", "pass", "2"}),
              HasSubstr("4.00 s of head_pitch, head_yaw"));
  EXPECT_EQ(TextOf("wave"), wave);
  EXPECT_EQ(TextOf("pass"), pass);
  EXPECT_EQ(LoadTake(folder_, "both")->key, "") << "one key plays one take";
  EXPECT_THAT(Run({"layer", "FOLDER", "both", "wave", "pass"}),
              HasSubstr("both.toml: it is there; --replace"));
  EXPECT_THAT(Run({"layer", "FOLDER", "both", "both", "pass"}, {{"--replace", ""}}),
              ::testing::StartsWith("0 "));
  EXPECT_THAT(
      Run({"list", "FOLDER"}),
      ::testing::AllOf(HasSubstr("both: 4.00 s"), HasSubstr("mended: 4.00 s"), HasSubstr("wave: 4.00 s")));
}

TEST_F(VerbTake, RefusesWhatMakesNoSenseInOneLineAndLeavesTheFile) {
  const std::string before = TextOf("wave");
  EXPECT_THAT(Run({"dance", "FOLDER"}),
              ::testing::AllOf(::testing::StartsWith("2 "), HasSubstr("there is no such action")));
  EXPECT_THAT(Run({"trim", "FOLDER", "wave", "1"}),
              ::testing::AllOf(::testing::StartsWith("2 "), HasSubstr("take trim FOLDER NAME FROM TO|end")));
  EXPECT_THAT(Run({"trim", "FOLDER", "wave", "1", "2"}, {{"--mouth", ""}}),
              HasSubstr("take trim: it has no option --mouth"));
  EXPECT_THAT(Run({"trim", "FOLDER", "wave", "1", "9"}),
              ::testing::AllOf(::testing::StartsWith("1 "),
                               HasSubstr("to_s: is 9 s, and the take was recorded for 4 s")));
  EXPECT_THAT(Run({"stretch", "FOLDER", "wave", "5"}), HasSubstr("5: a number from 0.25 to 4 is expected"));
  EXPECT_THAT(Run({"stretch", "FOLDER", "wvae", "2"}), HasSubstr("wvae.toml: No such file"));
  EXPECT_THAT(Run({"layer", "FOLDER", "none", "wave", "pass"}), HasSubstr("is not \"none\""));
  EXPECT_THAT(Run({"layer", "FOLDER", "../x", "wave", "pass"}), HasSubstr("letters, digits, spaces"));
  EXPECT_THAT(Run({"punch", "FOLDER", "x", "wave", "pass", "7"}),
              HasSubstr("7: a number from 0 to 4 is expected"));
  EXPECT_THAT(Run({"list", "/nowhere"}), HasSubstr("it is no folder of a show: it has no show.toml"));
  EXPECT_EQ(TextOf("wave"), before);
}

}  // namespace
}  // namespace kaori::tests
