// MIDI streams, whole and torn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/decode/midi.h"
#include "drivers/decode/midi_surface.h"

namespace kaori::decode {
namespace {

using ::testing::ElementsAre;

std::vector<MidiMessage> Parse(MidiParser& parser, std::initializer_list<int> bytes) {
  std::vector<MidiMessage> messages;
  for (const int byte : bytes)
    if (const auto message = parser.Accept(static_cast<std::uint8_t>(byte))) messages.push_back(*message);
  return messages;
}

TEST(Midi, RunningStatusHoldsUntilTheNextAndTheClockIsNoStatus) {
  MidiParser parser;
  const auto messages = Parse(parser, {0xB2, 7, 0xF8, 64, 8, 0xFE, 65, 0x92, 60, 100, 60, 0});
  ASSERT_EQ(messages.size(), 4U);
  EXPECT_EQ(messages[0].kind, MidiMessage::Kind::kControl);
  EXPECT_EQ(messages[0].channel, 3);
  EXPECT_EQ(messages[1].number, 8);
  EXPECT_EQ(messages[1].value, 65);
  EXPECT_EQ(messages[2].kind, MidiMessage::Kind::kNoteOn);
  EXPECT_EQ(messages[3].kind, MidiMessage::Kind::kNoteOff) << "a note-on of velocity 0";
}

TEST(Midi, DataWithoutAStatusAndAfterASystemMessageMeanNothing) {
  MidiParser parser;
  EXPECT_TRUE(Parse(parser, {1, 2, 3, 0xB0, 1, 0xF6, 2, 3}).empty());
  EXPECT_EQ(Parse(parser, {0xC0, 5, 6, 0xB0, 1, 2}).size(), 3U) << "a program change has one byte of data";
}

TEST(Midi, SysExIsPassedOverToItsEndHoweverLong) {
  MidiParser parser;
  EXPECT_TRUE(Parse(parser, {0x90, 60, 1, 0xF0, 1, 0xF8, 2, 0xF7, 60, 1}).size() == 1)
      << "behind it no status runs on";
  Parse(parser, {0xF0});
  for (int n = 0; n < 1000; ++n) EXPECT_TRUE(Parse(parser, {5}).empty());
  EXPECT_EQ(Parse(parser, {0xF7, 0x90, 60, 1}).size(), 1U);
  EXPECT_EQ(Parse(parser, {0xF0, 3, 0x90, 60, 1}).size(), 1U) << "another status ends it";
}

TEST(MidiSurface, EachModeOfADialTurnsItsWay) {
  const struct {
    MidiDialMode mode;
    int forth, back;
  } modes[] = {
      {MidiDialMode::kOffset, 66, 62}, {MidiDialMode::kTwos, 2, 126}, {MidiDialMode::kSigned, 2, 66}};
  for (const auto& mode : modes) {
    MidiMap map{.dials = {{.channel = 1, .control = 9, .mode = mode.mode}}, .buttons = {}, .start = {}};
    MidiSurface surface(map);
    for (const int byte : {0xB0, 9, mode.forth, 9, mode.forth, 9, mode.back})
      surface.Accept(static_cast<std::uint8_t>(byte));
    EXPECT_EQ(surface.counts()[0], 2);
  }
}

TEST(MidiSurface, WithoutAMapControlsAreDialsAndNotesButtonsByTheirNumbersOnAnyChannel) {
  const MidiMap map{.dials = {}, .buttons = {}, .start = {}, .any = true};
  MidiSurface surface(map);
  const auto accept = [&surface](std::initializer_list<int> bytes) {
    bool changed = false;
    for (const int byte : bytes) changed = surface.Accept(static_cast<std::uint8_t>(byte)) || changed;
    return changed;
  };
  EXPECT_FALSE(accept({0xB4, 17, 10})) << "where it stands was not known before";
  EXPECT_TRUE(accept({0xB4, 17, 40}));
  EXPECT_EQ(surface.counts()[1], 60);
  EXPECT_FALSE(accept({0xB5, 17, 90})) << "another channel's control stands elsewhere";
  EXPECT_TRUE(accept({0xB5, 17, 80}));
  EXPECT_EQ(surface.counts()[1], 40);
  EXPECT_FALSE(accept({0xB0, 40, 1, 40, 100, 121, 0, 121, 127})) << "lower halves, and a channel's mode";
  EXPECT_TRUE(accept({0x99, 36, 100}));
  EXPECT_EQ(surface.buttons_down(), 1U << 4U);
  EXPECT_TRUE(accept({0x89, 36, 0, 0xB0, 64, 127}));
  EXPECT_EQ(surface.buttons_down(), 1U << 24U) << "the pedal";
  EXPECT_TRUE(surface.LampBytes(0xFFFFFFFF, true).empty());
}

TEST(MidiSurface, LampsAreSentWhereTheyChangeAndAllOfThemAgain) {
  const MidiMap map{.dials = {},
                    .buttons = {{.channel = 2, .number = 5, .has_lamp = true},
                                {.channel = 2, .number = 6},
                                {.channel = 2, .number = 7, .has_lamp = true}},
                    .start = {}};
  MidiSurface surface(map);
  EXPECT_THAT(surface.LampBytes(0x7, false), ElementsAre(0x91, 5, 127, 0x91, 7, 127));
  EXPECT_THAT(surface.LampBytes(0x4, false), ElementsAre(0x91, 5, 0));
  EXPECT_THAT(surface.LampBytes(0x4, true), ElementsAre(0x91, 5, 0, 0x91, 7, 127));
  EXPECT_THAT(surface.LampBytes(0x4, false), ElementsAre());
  surface.ForgetLamps();
  EXPECT_THAT(surface.LampBytes(0x4, false), ElementsAre(0x91, 5, 0, 0x91, 7, 127)) << "they were not sent";
}

}  // namespace
}  // namespace kaori::decode
