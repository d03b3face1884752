// Surfaces of other makers as USB devices: decks, MIDI surfaces, and serial boxes behind an adapter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/decode/report_layout.h"
#include "firmware/wire/bytes.h"
#include "hw-sim/devices/owned_device.h"
#include "hw-sim/devices/stream_deck.h"
#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_hid.h"
#include "hw-sim/devices/usb_midi.h"
#include "hw-sim/devices/usb_serial.h"

namespace kaori::sim {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;

void ExpectWholeConfiguration(const UsbDevice& device) {
  const UsbBytes& configuration = device.descriptors().configuration;
  EXPECT_EQ(wire::GetU16(configuration, 2), configuration.size());
  std::size_t at = 0;
  while (at < configuration.size() && configuration[at] > 0) at += configuration[at];
  EXPECT_EQ(at, configuration.size());
}

TEST(UsbStreamDeck, ItsReportsFitIntoOnePacketEachWay) {
  StreamDeck deck(StreamDeck::Kind::kMk2);
  UsbHid usb(deck);
  ExpectWholeConfiguration(usb);
  const auto endpoints = ContentsOf(usb.descriptors().configuration).endpoints;
  ASSERT_EQ(endpoints.size(), 2U);
  EXPECT_EQ(endpoints[0].max_packet_bytes, 1024);
  deck.Push(14);
  const auto report = usb.NextIn(UsbHid::kIn, 1024, {});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->size(), 512U);
  EXPECT_EQ((*report)[4 + 14], 1);
  UsbBytes page(1024);
  page[0] = 2, page[1] = 7, page[3] = 1;
  usb.HandleOut(UsbHid::kOut, page);
  EXPECT_EQ(deck.wrong_pages(), 0) << "the report's number is on the cable";
  EXPECT_EQ(deck.wrong_pictures(), 1) << "nothing is no picture";
}

TEST(UsbStreamDeck, PagesOutOfOrderAndOfKeysThatThereAreNotAreWrong) {
  StreamDeck deck(StreamDeck::Kind::kMk2);
  UsbBytes page(1024);
  page[0] = 2, page[1] = 7;
  wire::PutU16(page, 6, 1);
  deck.HandleOutput(page);
  page[6] = 0, page[2] = 15;
  deck.HandleOutput(page);
  deck.HandleOutput(std::span(page).first(512));
  EXPECT_EQ(deck.wrong_pages(), 3);
}

// Linux passes on no report that is shorter than the descriptor says.
TEST(UsbHid, OwnedDevicesSendReportsOfTheLengthThatTheirDescriptorsSay) {
  for (const OwnedKind kind : {OwnedKind::kPowerMate, OwnedKind::kShuttlePro, OwnedKind::kExtreme3dPro,
                               OwnedKind::kAttack3, OwnedKind::kT16000m, OwnedKind::kDragonRise}) {
    OwnedDevice device(kind);
    const auto layout = decode::ReadReportLayout(device.device_name().descriptor);
    ASSERT_TRUE(layout);
    const auto* const shape = layout->Find(decode::ReportKind::kInput, 0);
    ASSERT_NE(shape, nullptr);
    EXPECT_EQ(device.Standing().size(), shape->bytes()) << device.device_name().name;
  }
}

TEST(UsbMidi, MessagesAreEventsOfFourBytesWithTheClockInBetween) {
  MidiTwin touch(MidiTwin::Kind::kXTouchMini);
  UsbMidi usb(touch);
  ExpectWholeConfiguration(usb);
  EXPECT_FALSE(usb.NextIn(UsbMidi::kIn, 64, {}));
  touch.Turn(0, 1);
  touch.Push(2, true);
  EXPECT_TRUE(usb.next_due(Time{}));
  const auto events = usb.NextIn(UsbMidi::kIn, 64, {});
  ASSERT_TRUE(events);
  EXPECT_THAT(*events, ElementsAre(0x0F, 0xF8, 0, 0, 0x0B, 0xBA, 1, 1, 0x09, 0x9A, 10, 127));
  EXPECT_FALSE(usb.next_due(Time{}));
}

TEST(UsbMidi, RunningStatusIsWrittenOutAndAPacketHoldsWholeEvents) {
  MidiTwin twister(MidiTwin::Kind::kTwister);
  UsbMidi usb(twister);
  // F0 00 01 79 05 00 01 F7, as a host sends it.
  usb.HandleOut(UsbMidi::kOut, UsbBytes{0x04, 0xF0, 0x00, 0x01, 0x04, 0x79, 0x05, 0x00, 0x06, 0x01, 0xF7, 0});
  twister.Turn(3, 20);
  const auto first = usb.NextIn(UsbMidi::kIn, 10, {}), rest = usb.NextIn(UsbMidi::kIn, 512, {});
  ASSERT_TRUE(first && rest);
  EXPECT_THAT(*first, ElementsAre(0x0B, 0xB0, 3, 65, 0x0B, 0xB0, 3, 65));
  EXPECT_EQ(rest->size(), 64U);
  usb.PowerCycle();
  twister.Turn(3, 1);
  EXPECT_FALSE(usb.NextIn(UsbMidi::kIn, 64, {})) << "its mode is lost with the power";
}

TEST(UsbMidi, LampsOfTheHostReachTheSurface) {
  MidiTwin touch(MidiTwin::Kind::kXTouchMini);
  UsbMidi usb(touch);
  usb.HandleOut(UsbMidi::kOut, UsbBytes{0x09, 0x9A, 8 + 5, 127, 0, 0, 0, 0});
  EXPECT_TRUE(touch.lamp(5));
}

// The line as the kernel sets it up.
void SetLine(UsbSerial& usb, std::uint16_t divisor, std::uint16_t index = 0) {
  ASSERT_TRUE(usb.Answer({0x40, 0, 0, 0, 0}, {}));
  ASSERT_TRUE(usb.Answer({0x40, 3, divisor, index, 0}, {}));
  ASSERT_TRUE(usb.Answer({0x40, 4, 0x0008, 0, 0}, {}));
}

TEST(UsbSerial, UnderstandsTheDivisorsOfThreeMegahertz) {
  SerialDialBox box(SerialDialBox::Kind::kDls80);
  UsbSerial usb(box);
  ExpectWholeConfiguration(usb);
  for (const auto& [divisor, index, baud] :
       {std::tuple<std::uint16_t, std::uint16_t, double>{0x4138, 0, 9600},
        {0x809C, 0, 19200},
        {0x001A, 0, 115384.6},
        {0xC034, 0, 57553.9},
        {0x0271, 0, 4800},
        {0x0000, 0, 3e6},
        {0x0001, 0, 2e6},
        {0x0138, 1, 9603.8}}) {
    SetLine(usb, divisor, index);
    EXPECT_NEAR(usb.baud(), baud, baud / 1000) << divisor;
  }
}

TEST(UsbSerial, CarriesWhatTheBoxSaysBehindTwoBytesOfStatus) {
  SerialDialBox box(SerialDialBox::Kind::kDls80);
  UsbSerial usb(box);
  SetLine(usb, 0x4138);
  box.Turn(2, 5);
  EXPECT_FALSE(usb.NextIn(UsbSerial::kIn, 512, Time{})) << "its bytes are still on the line";
  EXPECT_FALSE(usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(4))) << "the line may go on";
  const auto data = usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(10));
  ASSERT_TRUE(data);
  EXPECT_THAT(*data, ElementsAre(0x31, 0x60, 0x82, 0, 5)) << "in one piece";
  for (int n = 0; n < 40; ++n) box.Turn(2, 5);
  static_cast<void>(usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(20)));
  const auto full =
      usb.NextIn(UsbSerial::kIn, 512, Time{} + std::chrono::seconds(1));  // More than sixty bytes have come.
  ASSERT_TRUE(full);
  EXPECT_LT(full->size(), 64U) << "a packet of 64 bytes would not end what the host reads";
}

TEST(UsbSerial, AHostIsHeardWithTheNextLookAtTheLine) {
  SerialDialBox box(SerialDialBox::Kind::kSgi);
  UsbSerial usb(box);
  SetLine(usb, 0x4138);
  usb.HandleOut(UsbSerial::kOut, UsbBytes{0x20});
  EXPECT_EQ(usb.next_due(Time{} + milliseconds(1)), Time{} + milliseconds(1));
  EXPECT_FALSE(usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(1)));
  static_cast<void>(usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(400)));
  const auto answer = usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(410));
  ASSERT_TRUE(answer);
  EXPECT_THAT(*answer, ElementsAre(0x31, 0x60, 0x20));
}

TEST(UsbSerial, OfAnotherSpeedBytesArriveSpoiltAndTheBoxHearsNothing) {
  SerialDialBox box(SerialDialBox::Kind::kDls80);
  UsbSerial usb(box);
  SetLine(usb, 0x809C);
  box.Turn(2, 5);
  static_cast<void>(usb.NextIn(UsbSerial::kIn, 512, Time{}));
  static_cast<void>(usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(4)));
  const auto data = usb.NextIn(UsbSerial::kIn, 512, Time{} + milliseconds(10));
  ASSERT_TRUE(data);
  EXPECT_NE((*data)[2], 0x82);
  SerialDialBox asked(SerialDialBox::Kind::kSgi);
  UsbSerial wrong(asked);
  SetLine(wrong, 0x809C);
  wrong.HandleOut(UsbSerial::kOut, UsbBytes{0x20});
  EXPECT_FALSE(wrong.NextIn(UsbSerial::kIn, 512, Time{} + std::chrono::seconds(1)));
}

}  // namespace
}  // namespace kaori::sim
