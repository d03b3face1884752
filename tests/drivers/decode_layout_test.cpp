#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/decode/recognise.h"
#include "drivers/decode/report_values.h"
#include "drivers/decode/usages.h"
#include "firmware/wire/dial_box.h"
#include "firmware/wire/keyboard.h"
#include "firmware/wire/stick_pod.h"
#include "firmware/wire/surface_feature.h"
#include "tests/drivers/hid_devices.h"

namespace kaori::decode {
namespace {

using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

// A joystick's frame around `inside`, so that a test shows only what it is about.
Bytes Within(const Bytes& inside) {
  Bytes all;
  all.reserve(inside.size() + 7);
  for (const std::uint8_t byte : std::to_array<std::uint8_t>({0x05, 0x01, 0x09, 0x04, 0xA1, 0x01}))
    all.push_back(byte);
  for (const std::uint8_t byte : inside) all.push_back(byte);
  all.push_back(0xC0);
  return all;
}

std::string Refusal(const Bytes& descriptor) {
  const auto layout = ReadReportLayout(descriptor);
  return layout ? "it was accepted" : layout.error().attempt;
}

TEST(ReportLayout, ReadsTheDialBox) {
  const auto layout = ReadReportLayout(wire::kDialBoxDescriptor);
  ASSERT_TRUE(layout) << layout.error().message();
  EXPECT_EQ(layout->Find(ReportKind::kInput, 0)->bytes(), wire::kDialBoxReportBytes);
  EXPECT_EQ(layout->Find(ReportKind::kOutput, 0)->bytes(), wire::kDialBoxLampBytes);
  EXPECT_EQ(layout->Find(ReportKind::kFeature, 0)->bytes(), wire::kSurfaceFeatureBytes);
  EXPECT_EQ(FindInputs(*layout, kUsageDial, 100).size(), wire::kDials);
  EXPECT_FALSE(layout->numbered(ReportKind::kInput));
}

TEST(ReportLayout, TellsDevicesByTheirUsages) {
  const auto kind = [](std::span<const std::uint8_t> descriptor) {
    return Recognise(*ReadReportLayout(descriptor));
  };
  EXPECT_EQ(kind(wire::kDialBoxDescriptor), DeviceKind::kDialBox);
  EXPECT_EQ(kind(wire::kStickPodDescriptor), DeviceKind::kJoystick);
  EXPECT_EQ(kind(wire::kRefusalDescriptor), DeviceKind::kOther) << "a surface that refuses to play";
  EXPECT_EQ(kind(wire::kKeyboardDescriptor), DeviceKind::kKeyboard);
  EXPECT_EQ(kind(tests::kExtreme3dPro), DeviceKind::kJoystick);
  EXPECT_EQ(kind(tests::kAttack3), DeviceKind::kJoystick);
  EXPECT_EQ(kind(tests::kT16000m), DeviceKind::kJoystick);
}

TEST(ReportLayout, DoesNotMistakeAMouseForAJoystick) {
  const Bytes mouse = {0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x30, 0x09, 0x31, 0x15,
                       0x81, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x02, 0x81, 0x06, 0xC0};
  EXPECT_EQ(Recognise(*ReadReportLayout(mouse)), DeviceKind::kPointer);
}

TEST(ReportLayout, ReadsSignedUnalignedFieldsAcrossBytes) {
  // 3 bits of padding, then a signed field of 11 bits and an unsigned one of 32.
  const Bytes descriptor = Within({0x75, 0x03, 0x95, 0x01, 0x81, 0x01, 0x09, 0x30, 0x16, 0x00, 0xFC, 0x26,
                                   0xFF, 0x03, 0x75, 0x0B, 0x81, 0x02, 0x09, 0x31, 0x15, 0x00, 0x27, 0xFF,
                                   0xFF, 0xFF, 0xFF, 0x75, 0x20, 0x81, 0x02, 0x75, 0x02, 0x81, 0x01});
  const auto layout = ReadReportLayout(descriptor);
  ASSERT_TRUE(layout) << layout.error().message();
  ASSERT_EQ(layout->fields.size(), 2u);
  EXPECT_EQ(layout->fields[1].logical_max, 0xFFFFFFFFll);
  // -1024 in bits 3..13, 0xFFFFFFFE in bits 14..45.
  const Bytes report = {0x00, 0xA0, 0xFF, 0xFF, 0xFF, 0x3F};
  EXPECT_EQ(Extract(layout->fields[0], 0, report), -1024);
  EXPECT_EQ(Extract(layout->fields[1], 0, report), 0xFFFFFFFEll);
}

TEST(ReportLayout, ReadsAMaximumOfFFAs255BesideAnUnsignedMinimum) {
  const auto layout =
      ReadReportLayout(Within({0x09, 0x30, 0x15, 0x00, 0x25, 0xFF, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02}));
  ASSERT_TRUE(layout) << layout.error().message();
  EXPECT_EQ(layout->fields[0].logical_max, 255);
  EXPECT_EQ(Extract(layout->fields[0], 0, Bytes{0xFE}), 254);
}

TEST(ReportLayout, PushAndPopKeepTheGlobalItems) {
  const auto layout = ReadReportLayout(tests::kExtreme3dPro);
  ASSERT_TRUE(layout) << layout.error().message();
  const auto slider = FindInputs(*layout, kUsageSlider, 1);
  ASSERT_EQ(slider.size(), 1u);
  EXPECT_EQ(layout->fields[slider[0].field].bits, 8u);
  EXPECT_EQ(layout->fields[slider[0].field].logical_max, 255);
  EXPECT_EQ(layout->Find(ReportKind::kInput, 0)->bytes(), 7u);
}

TEST(ReportLayout, CompletesShortUsagesWithThePageThatHoldsAtTheMainItem) {
  // Usage X first, then the page changes to Button: Linux uses the last page, and so do we.
  const auto layout = ReadReportLayout(
      Within({0x09, 0x01, 0x05, 0x09, 0x15, 0x00, 0x25, 0x01, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02}));
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->usage(layout->fields[0], 0), 0x00090001u);
}

TEST(ReportLayout, ReadsExtendedUsagesWithTheirOwnPage) {
  const auto layout =
      ReadReportLayout(Within({0x0B, 0xBB, 0x00, 0x02, 0x00,                                // Throttle
                               0x1B, 0x01, 0x00, 0x09, 0x00, 0x2B, 0x03, 0x00, 0x09, 0x00,  // 1..3
                               0x25, 0x01, 0x75, 0x08, 0x95, 0x04, 0x81, 0x02}));
  ASSERT_TRUE(layout) << layout.error().message();
  EXPECT_EQ(layout->usage(layout->fields[0], 0), kUsageThrottle);
  EXPECT_EQ(layout->usage(layout->fields[0], 1), 0x00090001u);
  EXPECT_EQ(layout->usage(layout->fields[0], 3), 0x00090003u);
}

TEST(ReportLayout, GivesTheLastUsageToElementsBeyondTheList) {
  const auto layout = ReadReportLayout(
      Within({0x09, 0x30, 0x09, 0x37, 0x15, 0x81, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x04, 0x81, 0x06}));
  ASSERT_TRUE(layout);
  EXPECT_EQ(FindInputs(*layout, kUsageDial, 100).size(), 3u);
  EXPECT_EQ(FindInputs(*layout, kUsageDial, 2).size(), 2u);
}

TEST(ReportLayout, KeepsReportsOfSeveralIdsApart) {
  const auto layout = ReadReportLayout(
      Within({0x15, 0x00, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x01, 0x85, 0x01, 0x09, 0x30, 0x81,
              0x02, 0x85, 0x02, 0x09, 0x31, 0x81, 0x02, 0x85, 0x01, 0x09, 0x32, 0x81, 0x02}));
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->Find(ReportKind::kInput, 1)->bytes(), 2u);
  EXPECT_EQ(layout->Find(ReportKind::kInput, 2)->bytes(), 1u);
  EXPECT_EQ(layout->fields[2].offset_bits, 8u);
  EXPECT_TRUE(OpenInput(*layout, Bytes{1, 9, 9}));
  EXPECT_THAT(OpenInput(*layout, Bytes{3, 9, 9}).error().attempt, HasSubstr("unknown id 3"));
  EXPECT_THAT(OpenInput(*layout, Bytes{2, 9, 9}).error().attempt, HasSubstr("of 2 bytes where 1"));
}

TEST(ReportLayout, StepsOverLongItemsAndReservedOnes) {
  const auto layout = ReadReportLayout(Within(
      {0xFE, 0x03, 0xF0, 1, 2, 3, 0x0C, 0xF0, 0x09, 0x30, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02}));
  ASSERT_TRUE(layout) << layout.error().message();
  EXPECT_EQ(layout->fields.size(), 1u);
}

TEST(ReportLayout, CountsOnlyTheFirstOfAlternativeUsages) {
  const auto layout = ReadReportLayout(Within({0xA9, 0x01, 0x09, 0x30, 0xA9, 0x00, 0xA9, 0x01, 0x09, 0x31,
                                               0xA9, 0x00, 0x25, 0x7F, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02}));
  ASSERT_TRUE(layout) << layout.error().message();
  EXPECT_EQ(layout->usage(layout->fields[0], 0), kUsageX);
  EXPECT_TRUE(FindInputs(*layout, kUsageY, 1).empty());
}

TEST(ReportLayout, CutsAUsageRangeThatIsTooLongAsLinuxDoes) {
  const auto layout = ReadReportLayout(Within({0x06, 0x00, 0xFF, 0x19, 0x00, 0x2A, 0xFF, 0xFF, 0x26, 0xFF,
                                               0x00, 0x75, 0x08, 0x95, 0x01, 0x81, 0x00}));
  ASSERT_TRUE(layout) << layout.error().message();
  EXPECT_EQ(layout->usages[0].last, 0xFF000000u + kMaxUsages - 1);
}

TEST(ReportLayout, RefusesEveryTruncationInsideAnItemOrCollection) {
  const auto& whole = wire::kStickPodDescriptor;
  constexpr std::size_t kOpened = 6;  // Before its collection begins, a cut leaves whole items.
  for (std::size_t length = kOpened; length < whole.size(); ++length)
    EXPECT_FALSE(ReadReportLayout(std::span(whole).first(length))) << length;
}

TEST(ReportLayout, NamesTheByteAndTheReason) {
  EXPECT_EQ(Refusal({0x05, 0x01, 0xC0}), "report descriptor, byte 2: an end without a collection");
  EXPECT_EQ(Refusal({}), "report descriptor, byte 0: the descriptor is empty");
  EXPECT_THAT(Refusal({0x05, 0x01, 0x26, 0xFF}), HasSubstr("byte 2: the descriptor ends inside an item"));
  EXPECT_THAT(Refusal({0xFE, 0x09, 0x00, 1}), HasSubstr("byte 0: the descriptor ends inside a long item"));
  EXPECT_THAT(Refusal({0x09, 0x04, 0xA1, 0x01}), HasSubstr("byte 4: a collection is not ended"));
  EXPECT_THAT(Refusal({0xB4}), HasSubstr("byte 0: a pop without a push"));
  EXPECT_THAT(Refusal({0xA4, 0xA4, 0xA4, 0xA4, 0xA4}), HasSubstr("byte 4: more than 4 pushes"));
  EXPECT_THAT(Refusal({0x85, 0x00}), HasSubstr("byte 0: a report id must be 1 to 255"));
  EXPECT_THAT(Refusal({0x86, 0x00, 0x01}), HasSubstr("a report id must be 1 to 255"));
  EXPECT_THAT(Refusal({0x76, 0x01, 0x01}), HasSubstr("an element is too wide"));
  EXPECT_THAT(Refusal({0x96, 0x01, 0x30}), HasSubstr("too many elements"));
  EXPECT_THAT(Refusal({0x19, 0x05, 0x29, 0x04}), HasSubstr("byte 2: a usage range runs backwards"));
  EXPECT_THAT(Refusal({0xA9, 0x00}), HasSubstr("never opened"));
  EXPECT_THAT(Refusal({0xA9, 0x01, 0xA9, 0x01}), HasSubstr("nested"));
  EXPECT_THAT(Refusal({0xA9, 0x01}), HasSubstr("not closed"));
  EXPECT_THAT(Refusal(Within({0x15, 0x05, 0x25, 0x04, 0x75, 0x08, 0x95, 0x01, 0x09, 0x30, 0x81, 0x02})),
              HasSubstr("the logical range is empty"));
}

TEST(ReportLayout, RefusesWhatNeverEnds) {
  EXPECT_THAT(Refusal(Bytes(kMaxDescriptorBytes + 1, 0xC0)), HasSubstr("too long"));
  Bytes nested;
  for (int n = 0; n < 2000; ++n) nested.insert(nested.end(), {0xA1, 0x00});
  EXPECT_THAT(Refusal(nested), HasSubstr("byte 128: collections nest too deep"));
}

TEST(ReportLayout, RefusesReportsAndFieldsWithoutBounds) {
  Bytes wide = {0x26, 0xFF, 0x7F, 0x75, 0x20, 0x96, 0x00, 0x10};
  for (int n = 0; n < 2; ++n) wide.insert(wide.end(), {0x09, 0x30, 0x81, 0x02});
  EXPECT_THAT(Refusal(wide), HasSubstr("a report is too long"));
  Bytes many = {0x25, 0x01, 0x75, 0x01, 0x95, 0x01};
  for (int n = 0; n < 257; ++n) many.insert(many.end(), {0x09, 0x30, 0x81, 0x02});
  EXPECT_THAT(Refusal(many), HasSubstr("too many fields in a report"));
  Bytes usages;
  for (int n = 0; n < 2; ++n) usages.insert(usages.end(), {0x19, 0x00, 0x2A, 0xFF, 0xFF});
  EXPECT_THAT(Refusal(usages), HasSubstr("too many usages"));
}

TEST(ReportLayout, StepsOverElementsThatAreTooWideForAValue) {
  const auto layout = ReadReportLayout(Within(
      {0x09, 0x01, 0x25, 0x7F, 0x75, 0x40, 0x95, 0x01, 0x81, 0x02, 0x09, 0x30, 0x75, 0x08, 0x81, 0x02}));
  ASSERT_TRUE(layout);
  ASSERT_EQ(layout->fields.size(), 1u);
  EXPECT_EQ(layout->fields[0].offset_bits, 64u);
}

}  // namespace
}  // namespace kaori::decode
