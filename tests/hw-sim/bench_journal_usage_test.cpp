// What the bench reads of journalctl's words on the journal's size.
#include <gtest/gtest.h>

#include "hw-sim/hil/journal_usage.h"

namespace kaori::hil {
namespace {

std::string Words(const std::string& size) {
  return "Archived and active journals take up " + size + " in the file system.\n";
}

TEST(JournalUsage, IsInMillionsOfBytesWhateverItsUnitIs) {
  EXPECT_DOUBLE_EQ(JournalIn_mb(Words("8.0M")).value(), 8 * 1.048576);
  EXPECT_DOUBLE_EQ(JournalIn_mb(Words("512.0K")).value(), 0.524288);
  EXPECT_DOUBLE_EQ(JournalIn_mb(Words("1.5G")).value(), 1536 * 1.048576);
  EXPECT_DOUBLE_EQ(JournalIn_mb(Words("0B")).value(), 0);
}

TEST(JournalUsage, ThatCannotBeReadIsAnErrorThatTellsTheWords) {
  for (const char* words :
       {"", "No journal files were found.", "journals take up ", "journals take up 8.0 in"}) {
    const auto read = JournalIn_mb(words);
    ASSERT_FALSE(read) << words;
    EXPECT_EQ(read.error().kind, ErrorKind::kInput);
    EXPECT_NE(read.error().message().find(words), std::string::npos);
  }
}

}  // namespace
}  // namespace kaori::hil
