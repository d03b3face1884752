// Texts that are written into TOML files and read back.
#include "appliance/core/toml/quoted.h"

#include <gtest/gtest.h>

#include "appliance/core/toml/value.h"

namespace kaori::toml {
namespace {

TEST(QuotedTest, ComesBackAsTheSameText) {
  std::string all;
  for (char c = 1; c < 127; ++c) all += c;
  for (const std::string& text :
       {std::string(), std::string("head"), std::string("the \"old\" one"), std::string("C:\\faces\\new"),
        std::string("カオリの顔 \"怒り\""), std::string("\\u0041 \\n"),
        std::string("two\nlines\r\n\tand a tab"), std::string("\0\x1b[2J\x7f", 6),
        std::string("ends with a backslash \\"), all}) {
    const auto value = Parse("text = " + Quoted(text) + "\n", "file.toml");
    ASSERT_TRUE(value) << Quoted(text) << ": " << value.error().message();
    EXPECT_EQ(Find(*value, "text")->text, text) << Quoted(text);
  }
}

TEST(QuotedTest, IsAKeyAsWell) {
  const auto value = Parse(Quoted("brow \"up\" \\ 眉") + " = 1\n", "file.toml");
  ASSERT_TRUE(value);
  EXPECT_NE(Find(*value, "brow \"up\" \\ 眉"), nullptr);
}

}  // namespace
}  // namespace kaori::toml
