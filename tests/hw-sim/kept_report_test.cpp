// A run of the bench that was cut goes on where it was, and never takes over what was found of something else.
#include "hw-sim/hil/kept_report.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/image_files.h"

namespace kaori::hil {
namespace {

class KeptReport : public ::testing::Test {
 protected:
  KeptReport() : folder_(::testing::TempDir() + "kept-report-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~KeptReport() override { std::filesystem::remove_all(folder_); }
  std::string folder_;
};

// One has passed, one failed, one was skipped.
Report OneOfThree() {
  Report report;
  report.checks.push_back({"face",
                           "The face is on the screen",
                           {.said = "92 % lit",
                            .pictures = {{"face-0.png", "The first face"}},
                            .figures = {{"lit", 0.92}},
                            .took_s = 1.5}});
  report.checks.push_back({"replugs", "Roles stay", {.verdict = Verdict::kFailed, .said = "a swap"}});
  report.checks.push_back({"sound", "Sound", {.verdict = Verdict::kSkipped, .said = "no card"}});
  return report;
}

TEST_F(KeptReport, GivesWhatHasPassedInThisVeryTrialAlone) {
  ASSERT_TRUE(KeepReport(OneOfThree(), {}, "image ab12", folder_));
  const auto passes = KeptPasses("image ab12", folder_);
  ASSERT_EQ(passes.size(), 1U) << "what failed or was skipped is tried again";
  EXPECT_EQ(passes[0].name, "face");
  EXPECT_EQ(passes[0].finding.said, "92 % lit");
  EXPECT_EQ(passes[0].finding.figures.at("lit"), 0.92);
  EXPECT_EQ(passes[0].finding.pictures.at(0).file, "face-0.png");
  EXPECT_TRUE(KeptPasses("image cd34", folder_).empty());
}

TEST_F(KeptReport, GivesTheRoundsThatHavePassedOfACheckOfWhichALaterOneHasNot) {
  Report report;
  report.checks.push_back(
      {"held", "The picture stays", {.verdict = Verdict::kFailed, .said = "dark", .rounds = 4}});
  const ReportedCheck passed{
      "held",
      "The picture stays",
      {.said = "3 pictures", .counts = {{"deaths", 39}}, .control = "; wrong", .rounds = 3}};
  ASSERT_TRUE(KeepReport(report, {passed}, "image ab12", folder_));
  const auto passes = KeptPasses("image ab12", folder_);
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_EQ(passes[0].finding.rounds, 3);
  EXPECT_EQ(passes[0].finding.counts.at("deaths"), 39);
  EXPECT_EQ(passes[0].finding.control, "; wrong");
  EXPECT_THAT(ReadFile(folder_ + "/report.json").value(), ::testing::HasSubstr("\"passed\": false"))
      << "no update is made of it";
}

TEST_F(KeptReport, KeepsWhatARunThatGoesOnHasNotComeTo) {
  ASSERT_TRUE(KeepReport(OneOfThree(), {}, "image ab12", folder_));
  Report later;
  later.checks.push_back({"replugs", "Roles stay", {.said = "no swap"}});
  ASSERT_TRUE(KeepReport(later, KeptPasses("image ab12", folder_), "image ab12", folder_));
  const auto passes = KeptPasses("image ab12", folder_);
  ASSERT_EQ(passes.size(), 2U);
  EXPECT_EQ(passes[0].name, "replugs");
  EXPECT_EQ(passes[1].name, "face");
}

// rootfs/image/tested.py reads it.
TEST_F(KeptReport, SaysOfWhichFilesAnUpdateMayBeMade) {
  using ::testing::HasSubstr;
  Report report = OneOfThree();
  report.files = {{"root.erofs", "ab12"}};
  report.wanted = 7;
  ASSERT_TRUE(KeepReport(report, {}, "image ab12", folder_));
  const std::string text = ReadFile(folder_ + "/report.json").value();
  EXPECT_THAT(text, HasSubstr("\"files\": {\n    \"root.erofs\": \"ab12\"\n  }"));
  EXPECT_THAT(text, HasSubstr("\"wanted\": 7"));
  EXPECT_THAT(text, HasSubstr("\"skipped\": true"));
}

TEST_F(KeptReport, KnowsAnImageByTheFilesOfAnUpdateThatAreThere) {
  std::ofstream(folder_ + "/root.erofs") << "abc";
  std::ofstream(folder_ + "/kaori.disk") << "a disk";
  const auto hashes = UpdateFileHashes(folder_, folder_ + "/log");
  ASSERT_EQ(hashes.size(), 1U);
  // FIPS 180-2, appendix B.1.
  EXPECT_EQ(hashes.at("root.erofs"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST_F(KeptReport, IsNothingWhereItIsNoReport) {
  EXPECT_TRUE(KeptPasses("", folder_).empty());
  for (const char* text :
       {"", "seven", "[]", R"({"trial": ""})", R"({"trial": "", "checks": [{"passed": true}]})"}) {
    std::ofstream(folder_ + "/report.json") << text;
    EXPECT_TRUE(KeptPasses("", folder_).empty()) << text;
  }
}

}  // namespace
}  // namespace kaori::hil
