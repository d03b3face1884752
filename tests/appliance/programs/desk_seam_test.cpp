// Between desk and lips: commands, reports, pictures, and what each does when the other is slow, wrong or
// dead.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "appliance/programs/desk/lip_line.h"
#include "drivers/base/packet_socket.h"
#include "tests/appliance/programs/desk_house.h"

namespace kaori::testing {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using lips::Ask;
using lips::CalibrationStep;
using ::testing::HasSubstr;

constexpr sim::Rgb kBlue{0.08F, 0.24F, 0.78F};
constexpr sim::Rgb kSeamGreen{0.05F, 0.62F, 0.2F};

class DeskSeam : public ::testing::Test {
 protected:
  DeskSeam() {
    house_.StartLips();
    house_.each_step = [this] {
      if (line_) line_->Step(house_.clock.now());
    };
    line_.emplace(lips::ServicePath(house_.board.path()));
    house_.Play(1500ms);
  }

  // What the lips answer to it; empty: done.
  std::string Do(lips::Command command) {
    const auto number = line_->Ask(std::move(command));
    if (!number) return number.error().message();
    for (int n = 0; n < 60; ++n) {
      house_.Play(50ms);
      if (house_.lips->tuning().saving()) house_.AwaitSaved();
      if (line_->report() && line_->report()->answered == *number) return line_->report()->complaint;
    }
    return "no answer";
  }
  float Value(std::string_view name) const {
    for (std::size_t n = 0; n < lips::kSettingCount; ++n)
      if (lips::RangeOf(n).name == name) return line_->report()->values[n];
    return -1;
  }

  LipHouse house_;
  std::optional<desk::LipLine> line_;
};

TEST_F(DeskSeam, TellsWhatTheLipsHave) {
  ASSERT_TRUE(line_->live());
  EXPECT_EQ(Value("paint.blue"), 200);
  EXPECT_FALSE(line_->report()->unsaved);
  EXPECT_GT(line_->report()->box[2], line_->report()->box[0]) << "the mouth's place in the picture";
}

TEST_F(DeskSeam, ChangesTheLipsWhileTheyPlay) {
  house_.hand.scene.person.paint = kSeamGreen;
  house_.Play(300ms);
  EXPECT_LT(house_.Seen().quality, 0.5F);
  EXPECT_EQ(Do({.ask = Ask::kSample, .a = 0.5F, .b = 0.55F}), "");
  house_.Play(300ms);
  EXPECT_GT(house_.Seen().quality, 0.8F);
  EXPECT_GT(Value("paint.green"), 100);
  EXPECT_EQ(Do({.ask = Ask::kSample, .a = 0.02F, .b = 0.1F}), "sample the paint: this is grey");
  EXPECT_EQ(Do({.ask = Ask::kUndo}), "");
  EXPECT_EQ(Value("paint.green"), 60);
  EXPECT_EQ(Do({.ask = Ask::kUndo}), "there is nothing to take back");
}

TEST_F(DeskSeam, FindsAnyPaintByItselfInAnyLightBesideABlueShirt) {
  for (const sim::Rgb& paint :
       {kBlue, kSeamGreen, sim::Rgb{0.78F, 0.06F, 0.38F}, {0.9F, 0.85F, 0.1F}, {0.5F, 0.1F, 0.7F}}) {
    for (const sim::Rgb& light : {sim::Rgb{1, 1, 1}, {1.1F, 0.85F, 0.6F}, {0.5F, 0.5F, 0.5F}}) {
      for (const bool shirt : {false, true}) {
        house_.hand.scene.person.paint = paint;
        house_.hand.scene.light.colour = light;
        house_.hand.scene.person.shirt.reset();
        if (shirt) house_.hand.scene.person.shirt = sim::Rgb{0.13F, 0.25F, 0.7F};
        house_.StartLips();
        house_.Play(600ms);
        ASSERT_EQ(Do({.ask = Ask::kFind}), "") << paint.red << " " << light.red << " " << shirt;
        house_.Play(300ms);
        EXPECT_GT(house_.Seen().quality, 0.7F) << paint.red << " " << light.red << " " << shirt;
        const auto& box = line_->report()->box;
        EXPECT_NEAR((box[0] + box[2]) / 2, 0.5F, 0.05F) << paint.red << " " << light.red << " " << shirt;
        EXPECT_NEAR((box[1] + box[3]) / 2, 0.52F, 0.05F);
      }
    }
  }
}

TEST_F(DeskSeam, FindsNoPaintOnABareFace) {
  house_.hand.scene.person.paint = {0.80F, 0.59F, 0.47F};  // Skin.
  house_.Play(300ms);
  EXPECT_EQ(Do({.ask = Ask::kFind}), "no paint is seen");
}

TEST_F(DeskSeam, MakesOneChangeOfASliderThatIsDrawn) {
  for (int n = 0; n < 20; ++n)
    EXPECT_EQ(Do({.ask = Ask::kSet, .a = 100.0F + static_cast<float>(n), .b = 7, .name = "key.similarity"}),
              "");
  EXPECT_EQ(line_->report()->changes, 1U);
  EXPECT_EQ(Value("key.similarity"), 119);
  EXPECT_THAT(Do({.ask = Ask::kSet, .a = 5000, .b = 8, .name = "key.similarity"}), HasSubstr("not between"));
  EXPECT_THAT(Do({.ask = Ask::kSet, .a = 5, .b = 8, .name = "key.kettle"}), HasSubstr("not known"));
  EXPECT_THAT(Do({.ask = Ask::kSet, .a = 2, .b = 8, .name = "mouth.shut"}), HasSubstr("not below"));
  EXPECT_EQ(Do({.ask = Ask::kUndo}), "");
  EXPECT_EQ(Value("key.similarity"), 140);
}

TEST_F(DeskSeam, LearnsFromTenSecondsOfSpeech) {
  EXPECT_EQ(Do({.ask = Ask::kBegin, .name = "speak"}), "");
  for (int n = 0; n < 75 && line_->report()->step; ++n) {
    const double swing = n % 5 / 4.0;
    house_.hand.scene.person.mouth = {0.25 + 0.45 * swing, 0.8 + 0.35 * (n % 7 / 6.0)};
    house_.Play(150ms);
  }
  EXPECT_FALSE(line_->report()->step) << "ten seconds are over";
  EXPECT_EQ(line_->report()->taken, 1U << static_cast<unsigned>(CalibrationStep::kSpeak));
  EXPECT_NEAR(Value("mouth.open"), 0.69F, 0.06F);
  EXPECT_NEAR(Value("mouth.narrow"), 0.8F, 0.06F);
  EXPECT_NEAR(Value("mouth.wide"), 1.14F, 0.06F);
  EXPECT_EQ(Do({.ask = Ask::kBegin, .name = "speak"}), "");
  EXPECT_EQ(Do({.ask = Ask::kStop}), "");
  EXPECT_FALSE(line_->report()->step);
  EXPECT_EQ(Do({.ask = Ask::kBegin, .name = "sing"}), "there is no step sing");
}

TEST_F(DeskSeam, KeepsTwoGenerationsAndGoesBackToEither) {
  const auto set = [this](float value) {
    EXPECT_EQ(Do({.ask = Ask::kSet, .a = value, .name = "key.spill"}), "");
  };
  EXPECT_EQ(Do({.ask = Ask::kSaved}), "nothing was kept");
  for (const float value : {50.0F, 60.0F}) {
    set(value);
    EXPECT_EQ(Do({.ask = Ask::kSave}), "");
    EXPECT_FALSE(line_->report()->unsaved);
  }
  set(70);
  EXPECT_TRUE(line_->report()->unsaved);
  EXPECT_EQ(Do({.ask = Ask::kSaved}), "");
  EXPECT_EQ(Value("key.spill"), 60);
  EXPECT_EQ(Do({.ask = Ask::kBefore}), "");
  EXPECT_EQ(Value("key.spill"), 50);
  EXPECT_EQ(Do({.ask = Ask::kDefaults}), "");
  EXPECT_EQ(Value("key.spill"), 80);
  EXPECT_EQ(Do({.ask = Ask::kUndo}), "") << "going back can be taken back";
  EXPECT_EQ(Value("key.spill"), 50);
}

TEST_F(DeskSeam, TakesAFileThatSomebodyElseChangesWithoutARestart) {
  EXPECT_EQ(Do({.ask = Ask::kSave}), "");
  lips::LipSettings other;
  other.key.spill = 123;
  ASSERT_TRUE(lips::WriteLipSettings(house_.settings_file(), other));
  std::filesystem::last_write_time(house_.settings_file(),
                                   std::filesystem::file_time_type::clock::now() + 5s);
  house_.Play(1500ms);
  EXPECT_EQ(Value("key.spill"), 123);
  std::ofstream(house_.settings_file()) << "key.spill = kettle\n";
  std::filesystem::last_write_time(house_.settings_file(),
                                   std::filesystem::file_time_type::clock::now() + 9s);
  house_.Play(1500ms);
  EXPECT_EQ(Value("key.spill"), 123) << "what is wrong is not taken";
}

TEST_F(DeskSeam, SaysWhyItCannotSave) {
  std::filesystem::create_directories(house_.settings_file() / "a folder" / "in its place");
  EXPECT_NE(Do({.ask = Ask::kSave}), "");
  EXPECT_TRUE(line_->live()) << "and the lips go on";
}

TEST_F(DeskSeam, CarriesPicturesWhileSomebodyLooksAndNoneOtherwise) {
  EXPECT_EQ(line_->picture().number, 0U);
  for (int n = 0; n < 20; ++n) {
    line_->Look(house_.clock.now());
    house_.Play(50ms);
  }
  const auto& picture = line_->picture();
  EXPECT_NEAR(picture.number, 15, 3) << "fifteen a second";
  ASSERT_EQ(picture.width_px, OperatorCamera::kWidth_px);
  const auto at = [&](int x, int y, std::size_t channel) {
    return picture.rgbp[static_cast<std::size_t>(y * picture.width_px + x) * 4 + channel];
  };
  EXPECT_GT(at(160, 132, 2), 120) << "blue lips";
  EXPECT_GT(at(160, 132, 3), 200) << "are paint";
  EXPECT_GT(at(160, 40, 0), at(160, 40, 2)) << "skin";
  EXPECT_LT(at(160, 40, 3), 20) << "is none";
  house_.Play(3s);
  const auto seen = line_->picture().number;
  house_.Play(3s);
  EXPECT_EQ(line_->picture().number, seen) << "nobody looks any more";
}

TEST_F(DeskSeam, DoesNotHoldTheLipsWhereTheDeskNeverReads) {
  line_.reset();
  const UniqueFd deaf = ConnectToPeer(lips::ServicePath(house_.board.path())).value();
  const std::string look = "1 look";
  for (int n = 0; n < 50; ++n) {
    static_cast<void>(
        SendPacket(deaf.get(), {reinterpret_cast<const std::uint8_t*>(look.data()), look.size()}));
    house_.Play(100ms);
    ASSERT_EQ(house_.board.Read<board::Lips>().source, board::SourceState::kLive);
  }
  EXPECT_LT(house_.clock.now() - house_.board.Read<board::Lips>().at, 50ms);
}

TEST_F(DeskSeam, HangsUpOnADeskThatTalksNonsenseAndHearsTheNextOne) {
  line_.reset();
  for (const std::string words : {"", "kettle", "1", "1 set", "99999999999 undo", "1 sample a b"}) {
    const UniqueFd mad = ConnectToPeer(lips::ServicePath(house_.board.path())).value();
    static_cast<void>(
        SendPacket(mad.get(), {reinterpret_cast<const std::uint8_t*>(words.data()), words.size()}));
    house_.Play(100ms);
    EXPECT_EQ(house_.board.Read<board::Lips>().source, board::SourceState::kLive);
  }
  line_.emplace(lips::ServicePath(house_.board.path()));
  house_.Play(300ms);
  EXPECT_TRUE(line_->live());
}

TEST_F(DeskSeam, NoticesThatTheLipsAreGoneAndFindsThemAgain) {
  house_.lips.reset();
  house_.Play(50ms);
  EXPECT_FALSE(line_->live());
  EXPECT_FALSE(line_->Ask({.ask = Ask::kUndo}));
  house_.StartLips();
  house_.Play(600ms);
  EXPECT_TRUE(line_->live());
}

TEST_F(DeskSeam, SurvivesLipsThatTalkNonsense) {
  line_.reset();
  house_.lips.reset();
  const std::string path = lips::ServicePath(house_.board.path());
  const UniqueFd mad = ListenForPackets(path).value();
  line_.emplace(path);
  std::vector<std::vector<std::uint8_t>> packets{
      {1, 2, 3}, lips::HelloPacket(), lips::Packet(lips::Report{})};
  packets[2].resize(packets[2].size() - 3);
  packets.push_back(
      lips::Packet(lips::PictureNote{.slot = 0, .number = 1, .width_px = 400, .height_px = 400}));
  for (const auto& packet : packets) {
    house_.Play(300ms);
    const auto peer = AcceptPeer(mad.get());
    ASSERT_TRUE(peer);
    ASSERT_TRUE(SendPacket(peer->get(), packet));
    house_.Play(50ms);
    EXPECT_FALSE(line_->live());
    EXPECT_EQ(line_->picture().number, 0U);
  }
}

TEST(DeskWords, ComeBackAsTheyWereSaid) {
  lips::Report report{.answered = 7,
                      .complaint = "grey",
                      .step = CalibrationStep::kWide,
                      .progress = 0.5F,
                      .taken = 9,
                      .changes = 3,
                      .unsaved = true,
                      .before = true};
  report.values[3] = 1.5F;
  report.box = {0.1F, 0.2F, 0.3F, 0.4F};
  EXPECT_EQ(lips::ReadReport(lips::Packet(report)), report);
  for (const char* text :
       {"7 sample 0.5 0.25", "8 find", "9 set key.spill 80 3", "1 begin open", "2 light 1"}) {
    const auto command = lips::ParseCommand(text);
    ASSERT_TRUE(command) << text;
    EXPECT_EQ(lips::CommandText(*command), text);
  }
}

TEST(DeskWords, OfAnyLengthAndContentAreSurvived) {
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
}  // namespace kaori::testing
