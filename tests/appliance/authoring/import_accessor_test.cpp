#include <gmock/gmock.h>

#include "appliance/authoring/model/accessor.h"
#include "tests/appliance/authoring/import_glb.h"

namespace kaori::model {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Accessor Plain(const std::vector<std::uint8_t>& bytes, Component component, int columns, std::size_t count) {
  return {.base = {bytes, 0, component, columns, count}, .normalised = false, .sparse = {}};
}

TEST(Accessor, ReadsFloatsAsTheyAre) {
  const auto bytes = BytesOf<float>({1.5F, -2, 3, 4});
  EXPECT_THAT(ReadNumbers(Plain(bytes, Component::kFloat, 2, 2)).values, ElementsAre(1.5F, -2, 3, 4));
}

TEST(Accessor, ReadsSmallIntegersAsPartsOfOne) {
  const std::vector<std::uint8_t> bytes{127, 0, 0x81, 0x80};
  Accessor accessor = Plain(bytes, Component::kInt8, 1, 4);
  accessor.normalised = true;
  EXPECT_THAT(ReadNumbers(accessor).values, ElementsAre(1, 0, -1, -1));
  const auto words = BytesOf<std::int16_t>({32767, -32767, 0});
  accessor.base = {words, 0, Component::kInt16, 3, 1};
  EXPECT_THAT(ReadNumbers(accessor).values, ElementsAre(1, -1, 0));
  const auto unsigned_words = BytesOf<std::uint16_t>({65535, 0});
  accessor.base = {unsigned_words, 0, Component::kUint16, 2, 1};
  EXPECT_THAT(ReadNumbers(accessor).values, ElementsAre(1, 0));
}

TEST(Accessor, LeavesIntegersThatAreNotNormalised) {
  const auto bytes = BytesOf<std::int16_t>({-300, 7});
  EXPECT_THAT(ReadNumbers(Plain(bytes, Component::kInt16, 2, 1)).values, ElementsAre(-300, 7));
}

TEST(Accessor, StepsOverWhatLiesBetweenRows) {
  const auto bytes = BytesOf<float>({1, 99, 2, 99, 3});
  Accessor accessor = Plain(bytes, Component::kFloat, 1, 3);
  accessor.base.stride_bytes = 8;
  EXPECT_THAT(ReadNumbers(accessor).values, ElementsAre(1, 2, 3));
}

TEST(Accessor, ReplacesSparseRowsOfZeros) {
  const auto at = BytesOf<std::uint16_t>({1, 3});
  const auto values = BytesOf<float>({5, 6, 7, 8});
  Accessor accessor{.base = {{}, 0, Component::kFloat, 2, 4}, .normalised = false, .sparse = {}};
  accessor.sparse = Sparse{{at, 0, Component::kUint16, 1, 2}, {values, 0, Component::kFloat, 2, 2}};
  EXPECT_THAT(ReadNumbers(accessor).values, ElementsAre(0, 0, 5, 6, 0, 0, 7, 8));
}

TEST(Accessor, SaysWhyItCannotRead) {
  const auto bytes = BytesOf<float>({1, 2});
  EXPECT_THAT(ReadNumbers(Plain(bytes, Component::kFloat, 3, 1)).fault, HasSubstr("12 bytes are needed"));
  EXPECT_THAT(ReadNumbers(Plain(bytes, static_cast<Component>(1), 1, 1)).fault, HasSubstr("unknown"));
  EXPECT_THAT(ReadNumbers(Plain(bytes, Component::kFloat, 1, 0)).fault, HasSubstr("0 rows"));
  EXPECT_THAT(ReadNumbers(Plain(bytes, Component::kFloat, 1, std::size_t{1} << 60U)).fault,
              HasSubstr("rows"));
}

TEST(Accessor, RefusesASparseRowThatDoesNotExist) {
  const auto at = BytesOf<std::uint16_t>({9});
  const auto values = BytesOf<float>({5});
  Accessor accessor{.base = {{}, 0, Component::kFloat, 1, 4}, .normalised = false, .sparse = {}};
  accessor.sparse = Sparse{{at, 0, Component::kUint16, 1, 1}, {values, 0, Component::kFloat, 1, 1}};
  EXPECT_THAT(ReadNumbers(accessor).fault, HasSubstr("row 9 of 4"));
}

TEST(Accessor, ReadsCornersOfAllThreeWidths) {
  const std::vector<std::uint8_t> bytes{1, 0, 2, 0};
  EXPECT_THAT(ReadIndices({bytes, 0, Component::kUint8, 1, 4}).values, ElementsAre(1, 0, 2, 0));
  EXPECT_THAT(ReadIndices({bytes, 0, Component::kUint16, 1, 2}).values, ElementsAre(1, 2));
  EXPECT_THAT(ReadIndices({bytes, 0, Component::kUint32, 1, 1}).values, ElementsAre(0x20001));
  EXPECT_THAT(ReadIndices({bytes, 0, Component::kFloat, 1, 1}).fault, HasSubstr("unsigned"));
}

}  // namespace
}  // namespace kaori::model
