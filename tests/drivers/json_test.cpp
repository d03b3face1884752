// JSON as it is written: what a browser reads back is what was meant, whatever a text holds.
#include "drivers/base/json.h"

#include <gtest/gtest.h>

#include <limits>

namespace kaori::json {
namespace {

TEST(Json, IsWrittenOnOneLineOrIndented) {
  const Object object{{"a", 1}, {"b", List{true, Value(), "x"}}, {"c", Object{}}, {"d", List{}}};
  EXPECT_EQ(Write(object), R"({"a":1,"b":[true,null,"x"],"c":{},"d":[]})");
  EXPECT_EQ(Write(Object{{"a", 1}, {"b", List{2, 3}}}, 2),
            "{\n  \"a\": 1,\n  \"b\": [\n    2,\n    3\n  ]\n}");
}

TEST(Json, WritesNumbersThatAreReadAsTheSame) {
  EXPECT_EQ(Write(List{0.1, 1.0, -2.5e-9, 1e20, std::uint64_t{50'701'724}}),
            "[0.1,1.0,-2.5e-09,1e+20,50701724]");
  EXPECT_EQ(Write(0.1F), "0.10000000149011612") << "a float is the double that it is";
  EXPECT_EQ(Write(std::numeric_limits<double>::infinity()), "null") << "JSON has no such number";
}

TEST(Json, EscapesWhatWouldEndAText) {
  EXPECT_EQ(Write("a\"b\\c\n\t\x01/"), R"("a\"b\\c\n\t\u0001/")");
}

TEST(Json, KeepsUtf8AndReplacesWhatIsNone) {
  EXPECT_EQ(Write("\xE9\xA6\x99\xE3\x82\x8A \xF0\x9F\x99\x82"),
            "\"\xE9\xA6\x99\xE3\x82\x8A \xF0\x9F\x99\x82\"");
  const std::string sign = "\xEF\xBF\xBD";
  EXPECT_EQ(Write("a\xFFz"), "\"a" + sign + "z\"") << "a byte that never occurs";
  EXPECT_EQ(Write("a\xE9\xA6z"), "\"a" + sign + "z\"") << "a character that is cut off";
  EXPECT_EQ(Write("\xC0\xAF"), "\"" + sign + sign + "\"") << "a longer form than needed";
  EXPECT_EQ(Write("\xED\xA0\x80"), "\"" + sign + sign + sign + "\"") << "half of a surrogate pair";
}

}  // namespace
}  // namespace kaori::json
