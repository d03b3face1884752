// UTF-8: letters, columns, and foreign names as they are shown.
#include "drivers/base/utf8.h"

#include <gtest/gtest.h>

#include <tuple>

namespace kaori::utf8 {
namespace {

TEST(Utf8, DecodesLettersOfOneToFourBytes) {
  for (const auto& [text, code, bytes] :
       {std::tuple{"A", U'A', 1U}, {"é", U'é', 2U}, {"香", U'香', 3U}, {"\U0001F600", U'\U0001F600', 4U}}) {
    EXPECT_EQ(FirstLetter(text).code, code);
    EXPECT_EQ(FirstLetter(text).bytes, bytes);
  }
}

TEST(Utf8, RefusesWhatIsNoLetter) {
  for (const char* text : {"\x80", "\xC3", "\xC3(", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80",
                           "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xFF"}) {
    EXPECT_EQ(FirstLetter(text).code, U'\uFFFD');
    EXPECT_EQ(FirstLetter(text).bytes, 1U);
  }
}

TEST(Utf8, CountsTwoColumnsForAJapaneseLetter) {
  EXPECT_EQ(Columns(""), 0U);
  EXPECT_EQ(Columns("Kaori é"), 7U);
  EXPECT_EQ(Columns("香・（ー"), 8U);
  EXPECT_EQ(Columns("ｶｵﾘ"), 3U) << "narrow kana";
  EXPECT_EQ(Columns("香\xFF"), 3U);
}

TEST(PrintableText, KeepsLettersOfAllKinds) {
  for (const char* name : {"evening 1", "かおり 夜の部", "ｶｵﾘ", "Müller – Ærø", "Θέατρο", "𠮷野"})
    EXPECT_EQ(Printable(name, 40), name);
}

TEST(PrintableText, HasAQuestionMarkForWhatIsNoLetter) {
  EXPECT_EQ(Printable("a\nb\x1B[31m\x7F", 40), "a?b?[31m?");
  EXPECT_EQ(Printable("\xC2\x9B"
                      "31m",
                      40),
            "?31m")
      << "C1, which some terminals obey";
  EXPECT_EQ(Printable("香\x82\xA9\xE9", 40), "香???") << "as of a stick whose names are Shift-JIS";
}

// A name that turns the order of writing around, or hides a letter, could pass for another one.
TEST(PrintableText, ShowsMarksThatNobodySees) {
  EXPECT_EQ(Printable("eve\u200Bning\u202E", 40), "eve?ning?");
  EXPECT_EQ(Printable("\uFEFFa\u2028", 40), "?a?");
}

TEST(PrintableText, IsCutBetweenLettersByItsColumns) {
  EXPECT_EQ(Printable("evening", 7), "evening");
  EXPECT_EQ(Printable("evening 2", 7), "even...");
  EXPECT_EQ(Printable("かおりかおり", 12), "かおりかおり");
  EXPECT_EQ(Printable("かおりかおり", 11), "かおりか...");
  EXPECT_EQ(Printable("かおりかおり", 10), "かおり...") << "half a letter is none";
  EXPECT_EQ(Printable("かおり", 3), "...");
  EXPECT_EQ(Printable("\x80\x80\x80\x80", 4), "????");
  for (std::size_t most = 3; most < 14; ++most) EXPECT_LE(Columns(Printable("aかbおcりdか", most)), most);
}

}  // namespace
}  // namespace kaori::utf8
