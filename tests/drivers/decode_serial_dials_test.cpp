// The bytes of the serial boxes of 1993, whole and spoilt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "drivers/decode/dial_box_reporter.h"
#include "drivers/decode/serial_dials.h"
#include "firmware/wire/dial_box.h"
#include "tests/drivers/hid_devices.h"
#include "tests/firmware/figures.h"

namespace kaori::decode {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using tests::At;

constexpr int kPerTurn = 256;
constexpr Duration kByteTime = std::chrono::microseconds(1042);

class Line {
 public:
  explicit Line(SerialBox box) : decoder(box, kPerTurn) {}
  // How often something changed.
  int Send(std::initializer_list<int> bytes) {
    int changes = 0;
    for (const int byte : bytes) changes += decoder.Accept(static_cast<std::uint8_t>(byte), now += kByteTime);
    return changes;
  }
  void Wait(Duration time) { now += time; }

  SerialDialDecoder decoder;
  Time now = At(1000);
};

TEST(SerialDials, PositionsBecomeTurnsAndTheFirstIsNone) {
  Line line(SerialBox::kSgi);
  EXPECT_EQ(line.Send({0x30, 0x12, 0x34}), 0);
  EXPECT_EQ(line.Send({0x30, 0x12, 0x3A}), 1);
  line.Wait(milliseconds(12));
  EXPECT_EQ(line.Send({0x37, 0xFF, 0xFE, 0x37, 0x00, 0x03}), 1) << "16 bits wrap";
  EXPECT_THAT(line.decoder.counts(), ElementsAre(6, 0, 0, 0, 0, 0, 0, 5));
}

TEST(SerialDials, ADls80TellsTurnsAndASpectragraphicsDifferences) {
  Line dls(SerialBox::kDls80);
  dls.Send({0x80, 0x00, 0x05, 0x87, 0xFF, 0xFD});
  EXPECT_THAT(dls.decoder.counts(), ElementsAre(5, 0, 0, 0, 0, 0, 0, -3));
  Line spectra(SerialBox::kSpectragraphics);
  spectra.Send({0x31, 9, 2, 0x31, 0, 4});
  EXPECT_THAT(spectra.decoder.counts(), ElementsAre(0, 3, 0, 0, 0, 0, 0, 0));
}

TEST(SerialDials, EveryButtonHasItsByteEachWay) {
  Line line(SerialBox::kSgi);
  for (int button = 0; button < 32; ++button) {
    const int byte = std::array{0xD8, 0xD0, 0xC8, 0xC0}[static_cast<std::size_t>(button / 8)] + button % 8;
    EXPECT_EQ(line.Send({byte}), 1);
    EXPECT_EQ(line.decoder.buttons_down(), 1U << button);
    line.Wait(milliseconds(4));
    EXPECT_EQ(line.Send({byte + 0x20}), 1);
    EXPECT_EQ(line.decoder.buttons_down(), 0U);
    line.Wait(milliseconds(4));
  }
}

TEST(SerialDials, BytesOfButtonsInsideADialsMessageAreData) {
  Line line(SerialBox::kSgi);
  line.Send({0x30, 0xD8, 0xC0, 0x30, 0xD8, 0xD8});
  EXPECT_EQ(line.decoder.buttons_down(), 0U);
  EXPECT_EQ(line.decoder.counts()[0], 0x18);
}

TEST(SerialDials, AMessageIsWholeWithinTenMilliseconds) {
  Line line(SerialBox::kSgi);
  line.Send({0x30, 0x00, 0x00, 0x30, 0x00});
  line.Wait(milliseconds(10));
  EXPECT_EQ(line.Send({0x30, 0x00, 0x04}), 1) << "silence begins anew";
  EXPECT_EQ(line.decoder.counts()[0], 4);
  EXPECT_EQ(line.decoder.torn(), 1U);
}

TEST(SerialDials, AJumpIsDroppedAndTheLineIsWatchedUntilAGap) {
  Line line(SerialBox::kSgi);
  line.Send({0x30, 0x00, 0x00});
  EXPECT_EQ(line.Send({0x30, 0x40, 0x00, 0x30, 0x00, 0x01, 0xD8}), 0) << "nothing counts until a gap";
  line.Wait(milliseconds(12));
  EXPECT_EQ(line.Send({0x30, 0x00, 0x03}), 1);
  EXPECT_EQ(line.decoder.counts()[0], 3);
  EXPECT_EQ(line.decoder.buttons_down(), 0U);
}

TEST(SerialDials, ADialThatWasTurnedFarUnheardGoesOnFromWhereItStands) {
  Line line(SerialBox::kSgi);
  line.Send({0x30, 0x00, 0x00});
  line.Wait(milliseconds(12));
  EXPECT_EQ(line.Send({0x30, 0x20, 0x00}), 0);
  EXPECT_EQ(line.Send({0x30, 0x20, 0x02}), 1);
  EXPECT_EQ(line.decoder.counts()[0], 2);
}

TEST(SerialDials, ALineOfAnotherSpeedIsStrangeAndOneTornMessageIsNot) {
  Line line(SerialBox::kSgi);
  line.Send({0x99});
  EXPECT_FALSE(line.decoder.is_strange());
  for (int n = 0; n < 20; ++n) {
    line.Wait(milliseconds(20));
    line.Send({0x99, 0x07, 0x5A});
  }
  EXPECT_TRUE(line.decoder.is_strange());
}

TEST(SerialSession, AsksAwaitsTheAnswerAndSwitchesButtonsOnAfterDials) {
  SerialDialSession session(SerialBox::kSgi, kPerTurn);
  EXPECT_THAT(session.Due(At(0)), ElementsAre(0x20));
  EXPECT_THAT(session.Due(At(500)), ElementsAre());
  EXPECT_EQ(session.state(), SerialDialSession::State::kAsking);
  session.Accept(0x20, At(600));
  EXPECT_THAT(session.Due(At(601)), ElementsAre(0x50, 0, 0xFF, 0x71, 0, 0, 0, 0, 0x73, 0xFF, 0xFF, 0xFF, 0xFF,
                                                0x71, 0, 0, 0, 0, 0x73, 0xFF, 0xFF, 0xFF, 0xFF));
  EXPECT_EQ(session.state(), SerialDialSession::State::kReady);
  EXPECT_THAT(session.LampBytes(0x80000105U), ElementsAre(0x75, 0x05, 0x01, 0x00, 0x80));
}

TEST(SerialSession, ABoxThatDoesNotAnswerIsSilentAfterASecondAndAskedAgain) {
  SerialDialSession session(SerialBox::kSpectragraphics, kPerTurn);
  session.Due(At(0));
  EXPECT_THAT(session.Due(At(999)), ElementsAre());
  EXPECT_THAT(session.Due(At(1000)), ElementsAre(0x20));
  EXPECT_EQ(session.state(), SerialDialSession::State::kSilent);
  session.Accept(0x20, At(1300));
  session.Due(At(1301));
  EXPECT_EQ(session.state(), SerialDialSession::State::kReady);
}

// The first answer took longer than a second, so that the box was asked again; that question reset it once more, after it had
// been told to report.
TEST(SerialSession, ABoxThatAnswersAQuestionTwiceIsStartedTwiceAndNoDialJumps) {
  SerialDialSession session(SerialBox::kSgi, kPerTurn);
  session.Due(At(0));
  session.Due(At(1000));
  session.Accept(0x20, At(1050));
  EXPECT_EQ(session.Due(At(1051)).size(), 23U);
  for (const std::uint8_t byte : std::to_array<std::uint8_t>({0x32, 0x00, 0x20}))
    session.Accept(byte, At(1100));
  session.Accept(0x20, At(1350));
  EXPECT_EQ(session.Due(At(1351)).size(), 23U) << "it was reset, and reports nothing until it is told to";
  EXPECT_EQ(session.state(), SerialDialSession::State::kReady);
  for (const std::uint8_t byte : std::to_array<std::uint8_t>({0x32, 0x00, 0x01}))
    session.Accept(byte, At(1400));
  EXPECT_EQ(session.decoder().counts()[2], 0) << "where it stands after a reset is no turn";
}

TEST(SerialSession, TheByteOfAnAnswerWithinAMessageIsData) {
  SerialDialSession session(SerialBox::kSgi, kPerTurn);
  session.Due(At(0));
  session.Accept(0x20, At(300));
  session.Due(At(301));
  for (const std::uint8_t byte : std::to_array<std::uint8_t>({0x30, 0x20, 0x20, 0x20}))
    session.Accept(byte, At(400));
  EXPECT_THAT(session.Due(At(401)), ElementsAre());
}

TEST(SerialSession, ADls80IsReadyAtOnceAndHasNoLamps) {
  SerialDialSession session(SerialBox::kDls80, kPerTurn);
  EXPECT_THAT(session.Due(At(0)), ElementsAre());
  EXPECT_EQ(session.state(), SerialDialSession::State::kReady);
  EXPECT_THAT(session.LampBytes(1), ElementsAre());
}

TEST(DialBoxReporter, ATurnTooLargeForAReportIsSaidByTheNext) {
  DialBoxReporter reporter;
  std::array<std::uint8_t, 64> bytes{};
  EXPECT_EQ(reporter.Report({40000}, 0, bytes), 20U);
  EXPECT_TRUE(reporter.has_rest());
  EXPECT_EQ(wire::DecodeDialBox(std::span(bytes).first<20>()).turned[0], 32767);
  reporter.Report({40000}, 0, bytes);
  EXPECT_FALSE(reporter.has_rest());
  EXPECT_EQ(wire::DecodeDialBox(std::span(bytes).first<20>()).turned[0], 40000 - 32767);
}

// A box whose line loses, doubles or changes one byte. A value is false where it comes of bytes that the box did not send as
// one message.
class SpoiltStream {
 public:
  SpoiltStream(SerialBox box, std::mt19937& dice) : box_(box), dice_(dice), line_(box) {
    for (auto& position : positions_) position = static_cast<std::uint16_t>(dice_());
  }

  // Three bursts, a fault somewhere in the second.
  void Play() {
    Burst({});
    Burst(dice_() % 16);
    is_after_gap_ = true;
    Burst({});
  }
  int false_in_burst = 0;
  int false_after_gap = 0;
  std::int32_t furthest = 0;  // Of false turns, in counts.

 private:
  void Burst(std::optional<std::size_t> spoilt_byte) {
    line_.Wait(milliseconds(12));
    // A button that waited for the gap: true where the burst before ended with a button.
    if (line_.decoder.Settle(line_.now) && !ended_with_button_) ++false_in_burst;
    for (std::size_t sent = 0; sent < 18;) {
      const auto message = dice_() % 8 == 0 && box_ != SerialBox::kDls80 ? Button() : Turn();
      bool is_intact = true;
      ended_with_button_ = message.size() == 1;
      for (std::size_t n = 0; n < message.size(); ++n, ++sent) {
        const auto fault = sent == spoilt_byte ? 1 + dice_() % 3 : 0;
        is_intact &= fault == 0;
        if (fault == 1) continue;
        Deliver(fault == 2 ? static_cast<std::uint8_t>(dice_()) : message[n],
                is_intact && n + 1 == message.size());
        if (fault == 3) Deliver(message[n], false);
      }
    }
  }

  std::vector<std::uint8_t> Button() {
    const unsigned button = dice_() % 32;
    down_ ^= 1U << button;
    const unsigned released = (down_ >> button & 1U) != 0 ? 0 : 0x20;
    return {static_cast<std::uint8_t>(0xD8 + released - button / 8 * 8 + button % 8)};
  }
  std::vector<std::uint8_t> Turn() {
    const std::size_t dial = dice_() % 3;
    const int turn = static_cast<int>(dice_() % 19) - 9;
    positions_[dial] = static_cast<std::uint16_t>(positions_[dial] + turn);
    const unsigned word = box_ == SerialBox::kSgi ? positions_[dial] : static_cast<unsigned>(turn) & 0xFFFFU;
    const auto head = static_cast<std::uint8_t>((box_ == SerialBox::kDls80 ? 0x80 : 0x30) + dial);
    if (box_ == SerialBox::kSpectragraphics)
      return {head, static_cast<std::uint8_t>(std::max(turn, 0)),
              static_cast<std::uint8_t>(std::max(-turn, 0))};
    return {head, static_cast<std::uint8_t>(word >> 8U), static_cast<std::uint8_t>(word)};
  }

  void Deliver(std::uint8_t byte, bool ends_intact_message) {
    const auto before = line_.decoder.counts();
    if (!line_.decoder.Accept(byte, line_.now += kByteTime) || ends_intact_message) return;
    ++(is_after_gap_ ? false_after_gap : false_in_burst);
    for (std::size_t n = 0; n < before.size(); ++n)
      furthest = std::max(furthest, std::abs(line_.decoder.counts()[n] - before[n]));
  }

  SerialBox box_;
  std::mt19937& dice_;
  Line line_;
  std::array<std::uint16_t, 3> positions_{};
  std::uint32_t down_ = 0;
  bool is_after_gap_ = false;
  bool ended_with_button_ = false;
};

TEST(SerialDials, OverAMillionSpoiltStreamsAFaultLetsOneValuePassAndNoneAfterTheNextGap) {
  std::mt19937 dice(1993);
  std::uint64_t after_gap = 0;
  std::uint64_t more_than_one = 0;
  std::uint64_t passed = 0;
  std::int32_t furthest = 0;
  const std::uint32_t streams = 1'000'000 * proof::Effort();
  for (std::uint32_t n = 0; n < streams; ++n) {
    SpoiltStream stream(static_cast<SerialBox>(n % 3), dice);
    stream.Play();
    after_gap += static_cast<std::uint64_t>(stream.false_after_gap);
    passed += static_cast<std::uint64_t>(stream.false_in_burst);
    more_than_one += stream.false_in_burst > 1 ? 1U : 0U;
    furthest = std::max(furthest, stream.furthest);
  }
  proof::Figure("serial_streams", streams);
  proof::Figure("serial_false_values_after_gap", after_gap);
  EXPECT_EQ(after_gap, 0U);
  // Bytes that are a dial by chance, where it stands by chance: a few in a million.
  EXPECT_LE(more_than_one, streams / 100'000) << "of " << passed << " that passed";
  EXPECT_GT(passed, 0U) << "the streams are spoilt where it matters";
  EXPECT_LE(furthest, kPerTurn / 3);
}

}  // namespace
}  // namespace kaori::decode
