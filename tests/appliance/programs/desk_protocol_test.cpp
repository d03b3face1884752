// The protocol between desk and lips: commands, reports, pictures; and a peer that is slow, wrong or gone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include "appliance/programs/desk/lip_connection.h"
#include "drivers/base/packet_socket.h"
#include "tests/appliance/programs/desk_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;
using lips::CalibrationStep;
using lips::CommandKind;
using ::testing::HasSubstr;

constexpr sim::Rgb kBlue{0.08F, 0.24F, 0.78F};
constexpr sim::Rgb kProtocolGreen{0.05F, 0.62F, 0.2F};

class DeskProtocol : public ::testing::Test {
 protected:
  DeskProtocol() {
    fixture_.StartLips();
    fixture_.each_step = [this] {
      if (connection_) connection_->Step(fixture_.clock.now());
    };
    connection_.emplace(lips::ServicePath(fixture_.board.path()));
    fixture_.Play(1500ms);
  }

  // What the lips answer to it; empty: done.
  std::string Do(lips::Command command) {
    const auto number = connection_->Send(std::move(command));
    if (!number) return number.error().message();
    for (int n = 0; n < 60; ++n) {
      fixture_.Play(50ms);
      if (fixture_.lips->tuning().saving()) fixture_.AwaitSaved();
      if (connection_->report() && connection_->report()->answered == *number)
        return connection_->report()->complaint;
    }
    return "no answer";
  }
  float Value(std::string_view name) const {
    for (std::size_t n = 0; n < lips::kSettingCount; ++n)
      if (lips::RangeOf(n).name == name) return connection_->report()->values[n];
    return -1;
  }

  LipFixture fixture_;
  std::optional<desk::LipConnection> connection_;
};

TEST_F(DeskProtocol, ReportsTheSettingsOfTheLips) {
  ASSERT_TRUE(connection_->live());
  EXPECT_EQ(Value("paint.blue"), 200);
  EXPECT_FALSE(connection_->report()->unsaved);
  EXPECT_GT(connection_->report()->box[2], connection_->report()->box[0]) << "the mouth's box in the picture";
}

TEST_F(DeskProtocol, ChangesTheLipsWhileTheyPlay) {
  fixture_.hand.scene.person.paint = kProtocolGreen;
  fixture_.Play(300ms);
  EXPECT_LT(fixture_.Seen().quality, 0.5F);
  EXPECT_EQ(Do({.kind = CommandKind::kSample, .a = 0.5F, .b = 0.55F}), "");
  fixture_.Play(300ms);
  EXPECT_GT(fixture_.Seen().quality, 0.8F);
  EXPECT_GT(Value("paint.green"), 100);
  EXPECT_EQ(Do({.kind = CommandKind::kSample, .a = 0.02F, .b = 0.1F}),
            "sample the paint: the colour here is grey");
  EXPECT_EQ(Do({.kind = CommandKind::kUndo}), "");
  EXPECT_EQ(Value("paint.green"), 60);
  EXPECT_EQ(Do({.kind = CommandKind::kUndo}), "there is no change to undo");
}

TEST_F(DeskProtocol, FindsAnyPaintByItselfInAnyLightBesideABlueShirt) {
  for (const sim::Rgb& paint :
       {kBlue, kProtocolGreen, sim::Rgb{0.78F, 0.06F, 0.38F}, {0.9F, 0.85F, 0.1F}, {0.5F, 0.1F, 0.7F}}) {
    for (const sim::Rgb& light : {sim::Rgb{1, 1, 1}, {1.1F, 0.85F, 0.6F}, {0.5F, 0.5F, 0.5F}}) {
      for (const bool shirt : {false, true}) {
        fixture_.hand.scene.person.paint = paint;
        fixture_.hand.scene.light.colour = light;
        fixture_.hand.scene.person.shirt.reset();
        if (shirt) fixture_.hand.scene.person.shirt = sim::Rgb{0.13F, 0.25F, 0.7F};
        fixture_.StartLips();
        fixture_.Play(600ms);
        ASSERT_EQ(Do({.kind = CommandKind::kFind}), "") << paint.red << " " << light.red << " " << shirt;
        fixture_.Play(300ms);
        EXPECT_GT(fixture_.Seen().quality, 0.7F) << paint.red << " " << light.red << " " << shirt;
        const auto& box = connection_->report()->box;
        EXPECT_NEAR((box[0] + box[2]) / 2, 0.5F, 0.05F) << paint.red << " " << light.red << " " << shirt;
        EXPECT_NEAR((box[1] + box[3]) / 2, 0.52F, 0.05F);
      }
    }
  }
}

TEST_F(DeskProtocol, FindsNoPaintOnABareFace) {
  fixture_.hand.scene.person.paint = {0.80F, 0.59F, 0.47F};  // Skin.
  fixture_.Play(300ms);
  EXPECT_EQ(Do({.kind = CommandKind::kFind}), "no paint was found in the picture");
}

TEST_F(DeskProtocol, MakesOneChangeOfASliderThatIsDragged) {
  for (int n = 0; n < 20; ++n)
    EXPECT_EQ(Do({.kind = CommandKind::kSet,
                  .a = 100.0F + static_cast<float>(n),
                  .b = 7,
                  .name = "key.similarity"}),
              "");
  EXPECT_EQ(connection_->report()->changes, 1U);
  EXPECT_EQ(Value("key.similarity"), 119);
  EXPECT_THAT(Do({.kind = CommandKind::kSet, .a = 5000, .b = 8, .name = "key.similarity"}),
              HasSubstr("not between"));
  EXPECT_THAT(Do({.kind = CommandKind::kSet, .a = 5, .b = 8, .name = "key.kettle"}),
              HasSubstr("there is no setting"));
  EXPECT_THAT(Do({.kind = CommandKind::kSet, .a = 2, .b = 8, .name = "mouth.shut"}), HasSubstr("not below"));
  EXPECT_EQ(Do({.kind = CommandKind::kUndo}), "");
  EXPECT_EQ(Value("key.similarity"), 140);
}

TEST_F(DeskProtocol, LearnsFromTenSecondsOfSpeech) {
  EXPECT_EQ(Do({.kind = CommandKind::kBegin, .name = "speak"}), "");
  for (int n = 0; n < 75 && connection_->report()->step; ++n) {
    const double swing = n % 5 / 4.0;
    fixture_.hand.scene.person.mouth = {0.25 + 0.45 * swing, 0.8 + 0.35 * (n % 7 / 6.0)};
    fixture_.Play(150ms);
  }
  EXPECT_FALSE(connection_->report()->step) << "ten seconds are over";
  EXPECT_EQ(connection_->report()->done, 1U << static_cast<unsigned>(CalibrationStep::kSpeak));
  EXPECT_NEAR(Value("mouth.open"), 0.69F, 0.06F);
  EXPECT_NEAR(Value("mouth.narrow"), 0.8F, 0.06F);
  EXPECT_NEAR(Value("mouth.wide"), 1.14F, 0.06F);
  EXPECT_EQ(Do({.kind = CommandKind::kBegin, .name = "speak"}), "");
  EXPECT_EQ(Do({.kind = CommandKind::kStop}), "");
  EXPECT_FALSE(connection_->report()->step);
}

TEST_F(DeskProtocol, KeepsTwoGenerationsAndGoesBackToEither) {
  const auto set = [this](float value) {
    EXPECT_EQ(Do({.kind = CommandKind::kSet, .a = value, .name = "key.spill"}), "");
  };
  EXPECT_EQ(Do({.kind = CommandKind::kSaved}), "no settings are saved");
  for (const float value : {50.0F, 60.0F}) {
    set(value);
    EXPECT_EQ(Do({.kind = CommandKind::kSave}), "");
    EXPECT_FALSE(connection_->report()->unsaved);
  }
  set(70);
  EXPECT_TRUE(connection_->report()->unsaved);
  EXPECT_EQ(Do({.kind = CommandKind::kSaved}), "");
  EXPECT_EQ(Value("key.spill"), 60);
  EXPECT_EQ(Do({.kind = CommandKind::kBefore}), "");
  EXPECT_EQ(Value("key.spill"), 50);
  EXPECT_EQ(Do({.kind = CommandKind::kDefaults}), "");
  EXPECT_EQ(Value("key.spill"), 80);
  EXPECT_EQ(Do({.kind = CommandKind::kUndo}), "") << "going back can be undone";
  EXPECT_EQ(Value("key.spill"), 50);
}

TEST_F(DeskProtocol, UsesAFileThatSomebodyElseChangedWithoutARestart) {
  EXPECT_EQ(Do({.kind = CommandKind::kSave}), "");
  lips::LipSettings other;
  other.key.spill = 123;
  std::ofstream(fixture_.settings_file()) << lips::LipSettingsText(other);
  std::filesystem::last_write_time(fixture_.settings_file(),
                                   std::filesystem::file_time_type::clock::now() + 5s);
  fixture_.Play(1500ms);
  EXPECT_EQ(Value("key.spill"), 123);
  std::ofstream(fixture_.settings_file()) << "key.spill = kettle\n";
  std::filesystem::last_write_time(fixture_.settings_file(),
                                   std::filesystem::file_time_type::clock::now() + 9s);
  fixture_.Play(1500ms);
  EXPECT_EQ(Value("key.spill"), 123) << "a file with a mistake changes nothing";
}

TEST_F(DeskProtocol, SaysWhyItCannotSave) {
  std::filesystem::create_directories(fixture_.settings_file() / "a folder" / "in its place");
  EXPECT_NE(Do({.kind = CommandKind::kSave}), "");
  EXPECT_TRUE(connection_->live()) << "and the lips go on";
}

TEST_F(DeskProtocol, CarriesPicturesWhileSomebodyLooksAndNoneOtherwise) {
  EXPECT_EQ(connection_->picture().number, 0U);
  for (int n = 0; n < 20; ++n) {
    connection_->RequestPictures(fixture_.clock.now());
    fixture_.Play(50ms);
  }
  const auto& picture = connection_->picture();
  EXPECT_NEAR(picture.number, 15, 3) << "fifteen a second";
  ASSERT_EQ(picture.width_px, OperatorCamera::kWidth_px);
  const auto at = [&](int x, int y, std::size_t channel) {
    return picture.rgbp[static_cast<std::size_t>(y * picture.width_px + x) * 4 + channel];
  };
  EXPECT_GT(at(160, 132, 2), 120) << "blue lips";
  EXPECT_GT(at(160, 132, 3), 200) << "are paint";
  EXPECT_GT(at(160, 40, 0), at(160, 40, 2)) << "skin";
  EXPECT_LT(at(160, 40, 3), 20) << "is none";
  fixture_.Play(3s);
  const auto seen = connection_->picture().number;
  fixture_.Play(3s);
  EXPECT_EQ(connection_->picture().number, seen) << "nobody looks any more";
}

TEST_F(DeskProtocol, DoesNotHoldTheLipsWhereTheDeskNeverReads) {
  connection_.reset();
  const UniqueFd deaf = ConnectToPeer(lips::ServicePath(fixture_.board.path())).value();
  const std::string look = "1 look";
  for (int n = 0; n < 50; ++n) {
    static_cast<void>(
        SendPacket(deaf.get(), {reinterpret_cast<const std::uint8_t*>(look.data()), look.size()}));
    fixture_.Play(100ms);
    ASSERT_EQ(fixture_.board.Read<board::Lips>().source, board::SourceState::kLive);
  }
  EXPECT_LT(fixture_.clock.now() - fixture_.board.Read<board::Lips>().at, 50ms);
}

TEST_F(DeskProtocol, ClosesTheConnectionToADeskThatSendsNonsenseAndAcceptsTheNextOne) {
  connection_.reset();
  for (const std::string text : {"", "kettle", "1", "1 set", "99999999999 undo", "1 sample a b",
                                 "1 begin sing", "1 sample -5 99", "1 undo\n"}) {
    const UniqueFd mad = ConnectToPeer(lips::ServicePath(fixture_.board.path())).value();
    static_cast<void>(
        SendPacket(mad.get(), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    fixture_.Play(100ms);
    EXPECT_EQ(fixture_.board.Read<board::Lips>().source, board::SourceState::kLive);
  }
  connection_.emplace(lips::ServicePath(fixture_.board.path()));
  fixture_.Play(300ms);
  EXPECT_TRUE(connection_->live());
}

TEST_F(DeskProtocol, NoticesThatTheLipsAreGoneAndConnectsAgain) {
  fixture_.lips.reset();
  fixture_.Play(50ms);
  EXPECT_FALSE(connection_->live());
  EXPECT_FALSE(connection_->Send({.kind = CommandKind::kUndo}));
  fixture_.StartLips();
  fixture_.Play(600ms);
  EXPECT_TRUE(connection_->live());
}

TEST_F(DeskProtocol, SurvivesLipsThatSendNonsense) {
  connection_.reset();
  fixture_.lips.reset();
  const std::string path = lips::ServicePath(fixture_.board.path());
  const UniqueFd mad = ListenForPackets(path).value();
  connection_.emplace(path);
  std::vector<std::vector<std::uint8_t>> packets{
      {1, 2, 3}, lips::HelloPacket(), lips::Packet(lips::Report{})};
  packets[2].resize(packets[2].size() - 3);
  packets.push_back(
      lips::Packet(lips::PictureNote{.slot = 0, .number = 1, .width_px = 400, .height_px = 400}));
  for (const auto& packet : packets) {
    fixture_.Play(300ms);
    const auto peer = AcceptPeer(mad.get());
    ASSERT_TRUE(peer);
    ASSERT_TRUE(SendPacket(peer->get(), packet));
    fixture_.Play(50ms);
    EXPECT_FALSE(connection_->live());
    EXPECT_EQ(connection_->picture().number, 0U);
  }
}

TEST(ProtocolPackets, AreParsedAsTheyWereWritten) {
  lips::Report report{.answered = 7,
                      .complaint = "grey",
                      .step = CalibrationStep::kWide,
                      .progress = 0.5F,
                      .done = 9,
                      .changes = 3,
                      .unsaved = true,
                      .before = true};
  report.values[3] = 1.5F;
  report.box = {0.1F, 0.2F, 0.3F, 0.4F};
  EXPECT_EQ(lips::ReadReport(lips::Packet(report)), report);
  for (const char* text :
       {"7 sample 0.5 0.25", "8 find", "9 set key.spill 80 3", "1 begin open", "2 exposure 1"}) {
    const auto command = lips::ParseCommand(text);
    ASSERT_TRUE(command) << text;
    EXPECT_EQ(lips::CommandText(*command), text);
  }
}

TEST(ProtocolPackets, OfAnyLengthAndContentAreSurvived) {
  const auto whole = lips::Packet(lips::Report{.complaint = "why"});
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes)
    EXPECT_FALSE(lips::ReadReport(std::span(whole).first(bytes)));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    auto spoilt = whole;
    spoilt[at] ^= 0xFF;
    if (const auto read = lips::ReadReport(spoilt)) {
      EXPECT_TRUE(read->progress >= 0 && read->progress <= 1);
      for (const float value : read->values) EXPECT_TRUE(std::isfinite(value));
    }
  }
}

}  // namespace
}  // namespace kaori::tests
