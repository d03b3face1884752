// Which USB devices are authorised, and what is said of the others: the policy of docs/image.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "appliance/programs/usb/policy.h"

namespace kaori::usb {
namespace {

using decode::OfferedInterface;
using decode::UsbClass;
using decode::UsbOffer;
using store::Weight;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr OfferedInterface kSound{UsbClass::kSound, 1, 0}, kMidi{UsbClass::kSound, 3, 0},
    kKnobs{UsbClass::kInput, 0, 0}, kKeyboard{UsbClass::kInput, 1, 1}, kMouse{UsbClass::kInput, 1, 2},
    kCamera{UsbClass::kCamera, 1, 0}, kHub{UsbClass::kHub, 0, 1}, kStorage{UsbClass::kStorage, 6, 0x50},
    kFastStorage{UsbClass::kStorage, 6, 0x62}, kNetwork{UsbClass::kCommunication, 6, 0},
    kData{UsbClass::kData, 0, 0}, kVendors{UsbClass::kVendor, 0xFF, 0xFF},
    kPictures{UsbClass::kStillImage, 1, 1};
constexpr std::uint16_t kFtdi = 0x0403, kProlific = 0x067B, kCh340 = 0x1A86, kElse = 0x1209;

std::optional<store::RefusedUsb> Judge(std::vector<OfferedInterface> interfaces,
                                       const Situation& situation = {}, std::uint16_t vendor = kElse) {
  return WhyRefused(UsbOffer{.vendor = vendor, .product = 1, .interfaces = std::move(interfaces)}, "1-2",
                    situation);
}

// What is said in English, with its weight before it; "authorised" where nothing is.
std::string Said(std::vector<OfferedInterface> interfaces, const Situation& situation = {},
                 std::uint16_t vendor = kElse) {
  const auto refused = Judge(std::move(interfaces), situation, vendor);
  if (!refused) return "authorised";
  constexpr std::array kWeights{"quiet: ", "named: ", "fault: "};
  return kWeights.at(static_cast<std::size_t>(refused->weight)) + refused->english;
}

TEST(UsbPolicy, WhatOperatorsBringIsAuthorised) {
  for (const auto& device : {std::vector{kKnobs},
                             {kKeyboard},
                             {kKeyboard, kMouse, kKnobs},
                             {kSound, kKnobs},
                             {kMidi},
                             {kCamera, kCamera, kSound},
                             {kHub}})
    EXPECT_EQ(Said(device), "authorised");
}

TEST(UsbPolicy, OneInterfaceWithoutARoleKeepsAllOfItOutWhereverItStands) {
  constexpr std::array kWithout{
      UsbClass::kCommunication, UsbClass::kData,      UsbClass::kStillImage, UsbClass::kPrinter,
      UsbClass::kStorage,       UsbClass::kSmartCard, UsbClass::kWireless,   UsbClass::kApplication,
      UsbClass::kVendor,        UsbClass{0},          UsbClass{0x10},        UsbClass{0x13},
      UsbClass{0x81},           UsbClass{0x93}};
  for (const UsbClass kind : kWithout)
    for (const bool key : {false, true}) {
      std::vector device{kKeyboard, kMouse, OfferedInterface{kind, 0, 0}};
      std::ranges::sort(device, {}, &OfferedInterface::kind);
      do {
        EXPECT_TRUE(Judge(device, {.key_is_on = key})) << static_cast<int>(kind);
      } while (std::ranges::next_permutation(device, {}, &OfferedInterface::kind).found);
    }
}

TEST(UsbPolicy, AStickIsAuthorisedWhileTheServiceKeyIsOnAndNothingElseWithIt) {
  EXPECT_EQ(Said({kStorage}, {.key_is_on = true}), "authorised");
  EXPECT_EQ(Said({kStorage, kFastStorage}, {.key_is_on = true, .is_kiosk = true}), "authorised");
  EXPECT_EQ(Said({kStorage}), "named: USB port 1-2: a storage device stays out while the service key is off");
  EXPECT_NE(Said({kStorage, kKeyboard}, {.key_is_on = true}), "authorised");
  EXPECT_NE(Said({kStorage, kVendors}, {.key_is_on = true}), "authorised");
}

TEST(UsbPolicy, AMakersOwnClassIsASerialAdapterOfThreeMakersAlone) {
  for (const std::uint16_t maker : {kFtdi, kProlific, kCh340}) {
    EXPECT_EQ(Said({kVendors}, {}, maker), "authorised");
    EXPECT_EQ(Said({kVendors, kVendors}, {.is_kiosk = true}, maker), "authorised");
    EXPECT_EQ(Said({kVendors, kStorage}, {}, maker),
              "fault: USB port 1-2: a storage device that also calls itself a serial adapter stays out");
    EXPECT_EQ(Said({kKeyboard, kVendors}, {}, maker),
              "fault: USB port 1-2: a serial adapter that also calls itself a keyboard stays out");
  }
  EXPECT_EQ(
      Said({kNetwork, kData}, {}, kCh340),
      "fault: USB port 1-2: a network adapter or modem with the number of a serial adapter's maker stays "
      "out");
  EXPECT_EQ(Said({kNetwork, kData}),
            "quiet: USB port 1-2: a network adapter or modem stays out, since the box has no role for it");
  EXPECT_EQ(
      Said({kVendors}),
      "quiet: USB port 1-2: a device of its maker's own kind stays out, since the box has no role for it");
}

TEST(UsbPolicy, ABridgeOfLinesMayBeASerialPortBesidesAndNoNetwork) {
  constexpr OfferedInterface kModem{UsbClass::kCommunication, 2, 1},
      kRndis{UsbClass::kCommunication, 2, 0xFF};
  const auto judge = [](std::uint16_t product, std::vector<OfferedInterface> interfaces) {
    return WhyRefused(UsbOffer{.vendor = 0x04D8, .product = product, .interfaces = std::move(interfaces)},
                      "1-2", {.is_kiosk = true});
  };
  EXPECT_FALSE(judge(0x00DD, {kModem, kData, kKnobs})) << "an MCP2221A as it is sold";
  EXPECT_TRUE(judge(0x00DE, {kModem, kData, kKnobs}));
  for (const OfferedInterface& wrong : {kRndis, kNetwork, kStorage, kVendors, kKeyboard})
    EXPECT_TRUE(judge(0x00DD, {kModem, kData, kKnobs, wrong})) << "whatever it calls itself";
}

TEST(UsbPolicy, TheBridgeOfLinesIsTheFirstOneOfAStartAndStaysAtItsPort) {
  const auto judge = [](std::uint16_t vendor, std::uint16_t product, const Situation& situation) {
    const auto refused = WhyRefused(UsbOffer{.vendor = vendor, .product = product, .interfaces = {kKnobs}},
                                    "1-2.4", situation);
    return refused ? refused->english : "authorised";
  };
  for (const auto& [vendor, product] :
       {std::pair<std::uint16_t, std::uint16_t>{0x10C4, 0xEA90}, {0x04D8, 0x00DD}}) {
    EXPECT_EQ(judge(vendor, product, {}), "authorised") << "it is there when power comes";
    EXPECT_EQ(judge(vendor, product, {.own_bridge = "1-2.4", .has_started = true}), "authorised")
        << "plugged in again in a show";
    EXPECT_EQ(judge(vendor, product, {.own_bridge = "1-3"}),
              "USB port 1-2.4: a GPIO bridge stays out here, since the box's own is that of port 1-3");
    EXPECT_EQ(judge(vendor, product, {.key_is_on = true, .has_started = true}),
              "USB port 1-2.4: a GPIO bridge that comes after the start stays out; switch the box on with it "
              "plugged in");
  }
  EXPECT_EQ(judge(0x10C4, 0xEA91, {.own_bridge = "1-3", .has_started = true}), "authorised")
      << "another device of that maker";
}

TEST(UsbPolicy, InAKioskNoKeyboardIsAuthorisedWhateverElseItIs) {
  const Situation kiosk{.is_kiosk = true};
  EXPECT_EQ(Said({kKnobs, kMouse, kCamera}, kiosk), "authorised");
  EXPECT_EQ(Said({kKeyboard}, kiosk), "named: USB port 1-2: a keyboard stays out, since this box is a kiosk");
  EXPECT_EQ(Said({kMouse, kSound, kKeyboard}, kiosk),
            "named: USB port 1-2: a keyboard stays out, since this box is a kiosk");
  EXPECT_NE(Said({{UsbClass::kInput, 0, 1}}, kiosk), "authorised") << "whatever the subclass";
}

TEST(UsbPolicy, WhoSaysThatItIsTwoThingsIsAFaultThatNamesBoth) {
  const auto refused = Judge({kKeyboard, kMouse, kStorage});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->weight, Weight::kFault);
  EXPECT_EQ(refused->english, "USB port 1-2: a storage device that also calls itself a keyboard stays out");
  EXPECT_EQ(refused->japanese, "USBポート1-2: キーボードとも名乗る記憶装置は使えません");
  EXPECT_EQ(
      Said({kNetwork, kData, kKnobs}),
      "fault: USB port 1-2: a network adapter or modem that also calls itself an input device stays out");
  EXPECT_EQ(
      Said({kNetwork, kStorage}),
      "fault: USB port 1-2: a network adapter or modem that also calls itself a storage device stays out");
}

TEST(UsbPolicy, ATelephoneOrWhatNobodyBringsToAShowIsNotOnTheStatusPicture) {
  // A telephone offers its pictures in one configuration and sound and buttons in another.
  EXPECT_EQ(Said({kPictures, kSound, kKnobs, kVendors}),
            "quiet: USB port 1-2: a telephone or photo camera stays out, since the box has no role for it");
  for (const auto& device : {std::vector{kNetwork, kData},
                             {kVendors},
                             {OfferedInterface{UsbClass::kPrinter, 1, 2}},
                             {{UsbClass{0x42}, 0, 0}}})
    EXPECT_THAT(Said(device), StartsWith("quiet: USB port 1-2: a "));
}

TEST(UsbPolicy, WhatCannotBeReadStaysOutWithItsReason) {
  const auto refused =
      WhyRefused(FailInput("byte 27: a descriptor of length 1"), "2-1.4", {.key_is_on = true});
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->weight, Weight::kFault);
  EXPECT_EQ(refused->english,
            "USB port 2-1.4: a device whose descriptors cannot be read stays out (byte 27: a descriptor of "
            "length 1)");
}

// Whatever it offers: the sentence is one line of the letters that the status picture has.
TEST(UsbPolicy, EachKindHasAName) {
  for (unsigned kind = 0; kind < 256; ++kind)
    for (const std::uint16_t vendor : {kElse, kFtdi}) {
      const auto refused = Judge({{UsbClass{static_cast<std::uint8_t>(kind)}, 0, 0}, kStorage}, {}, vendor);
      ASSERT_TRUE(refused) << kind;
      EXPECT_TRUE(std::ranges::all_of(refused->english, [](char c) { return c >= ' ' && c <= '~'; }))
          << refused->english;
      EXPECT_THAT(refused->japanese, HasSubstr("使えません"));
      EXPECT_EQ(store::ParseRefusedUsb(store::FormatRefusedUsb(*refused)), *refused);
    }
}

TEST(UsbPolicy, AFileThatSaysNothingIsNoRefusal) {
  for (const char* text : {"", "\n", "loud\nit\nそれ\n", "fault\n\n\n"})
    EXPECT_FALSE(store::ParseRefusedUsb(text)) << text;
  EXPECT_EQ(store::ParseRefusedUsb("named\nit"), (store::RefusedUsb{Weight::kNamed, "it", ""})) << "torn";
}

}  // namespace
}  // namespace kaori::usb
