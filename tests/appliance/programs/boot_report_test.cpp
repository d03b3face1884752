// What kaori-boot reports: one record of the kernel's log in both languages.
#include "appliance/programs/boot/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace kaori::boot {
namespace {

TEST(BootReport, SaysWhatIsWrongInEnglishAndJapanese) {
  EXPECT_EQ(RecordOf({"this PC forgot the time", Trouble::kClock}),
            "<4>kaori-boot: this PC forgot the time / "
            "このPCは時刻を忘れていました。ファームウェアの設定で時計をUTCに合わせてください\n");
  EXPECT_EQ(RecordOf({"it is odd"}), "<4>kaori-boot: it is odd\n");
}

// A record of the kernel's log has 976 bytes beside its head.
TEST(BootReport, HasOtherWordsForEachTroubleThatFitIntoARecord) {
  std::set<std::string_view> words;
  for (std::size_t n = 1; n < kTroubles; ++n) {
    const auto text = InJapanese(static_cast<Trouble>(n));
    EXPECT_TRUE(words.insert(text).second) << text;
    EXPECT_TRUE(std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) > 0x7F; })) << n;
    EXPECT_LT(text.size(), 300U) << n;
  }
  EXPECT_EQ(InJapanese(Trouble::kOther), "");
}

TEST(BootReport, KeepsItsLinesForTheStatusAndJapaneseOnesOnce) {
  const std::string japanese(InJapanese(Trouble::kSettings));
  Report("one", Trouble::kSettings);
  Report("two");
  Report("three", Trouble::kSettings);
  EXPECT_EQ(Reported(), "one\n" + japanese + "\ntwo\nthree\n");
}

// kaori-data takes those lines away when it has mended the partition, and knows them by how they begin.
TEST(BootReport, BeginsWhatItSaysOfThePartitionAsItsMenderKnowsIt) {
  EXPECT_THAT(std::string(InJapanese(Trouble::kData)), ::testing::StartsWith("データの領域"));
}

}  // namespace
}  // namespace kaori::boot
