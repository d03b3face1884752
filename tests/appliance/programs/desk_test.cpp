// The desk's pure parts: code and sessions, whose requests are looked at, languages, views, certificate,
// files.
#include "appliance/programs/desk/certificate.h"
#include "appliance/programs/desk/origin_check.h"
#include "appliance/programs/desk/page.h"
#include "appliance/programs/desk/pairing.h"
#include "appliance/programs/desk/state_json.h"
#include "appliance/programs/desk/view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "appliance/programs/lips/generations.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::desk {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class DeskPairing : public ::testing::Test {
 protected:
  std::string Code() const { return fmt::format("{:06}", pairing_.code()); }
  std::string Wrong() const { return fmt::format("{:06}", (pairing_.code() + 1) % 1'000'000); }

  ManualClock clock_;
  Pairing pairing_{clock_};
  std::string session_;
};

TEST_F(DeskPairing, AuthorisesByTheCodeOnceAndByNothingElse) {
  for (const std::string& code : {std::string(), Wrong(), Code() + "0", Code().substr(1)})
    EXPECT_EQ(pairing_.Try(code, session_), Verdict::kWrongCode) << code;
  const std::string code = Code();
  EXPECT_EQ(pairing_.Try(code, session_), Verdict::kAccepted);
  EXPECT_EQ(session_.size(), 64U);
  EXPECT_TRUE(pairing_.Knows(session_));
  EXPECT_FALSE(pairing_.Knows(session_.substr(1)));
  EXPECT_FALSE(pairing_.Knows(""));
  EXPECT_NE(Code(), code);
}

TEST_F(DeskPairing, AcceptsFiveWrongCodesInAnyMinute) {
  for (int n = 0; n < 5; ++n) {
    EXPECT_EQ(pairing_.Try(Wrong(), session_), Verdict::kWrongCode);
    clock_.Advance(10s);
  }
  EXPECT_EQ(pairing_.Try(Code(), session_), Verdict::kLocked);
  clock_.Advance(9s);
  EXPECT_EQ(pairing_.Try(Code(), session_), Verdict::kLocked);
  clock_.Advance(2s);  // The first of the five is a minute old.
  EXPECT_EQ(pairing_.Try(Wrong(), session_), Verdict::kWrongCode);
  EXPECT_EQ(pairing_.Try(Code(), session_), Verdict::kLocked);
  int heard = 0;
  for (int second = 0; second < 3600; ++second, clock_.Advance(1s))
    heard += pairing_.Try(Wrong(), session_) == Verdict::kWrongCode ? 1 : 0;
  EXPECT_LE(heard, 5 * 60);
}

TEST_F(DeskPairing, MakesAnotherCodeEveryFiveMinutes) {
  const std::string code = Code();
  clock_.Advance(299s);
  EXPECT_FALSE(pairing_.Step() && Code() != code);
  clock_.Advance(1s);
  EXPECT_TRUE(pairing_.Step());
  EXPECT_NE(Code(), code);
  EXPECT_EQ(pairing_.valid(), 5min);
}

TEST_F(DeskPairing, ShowsTheCodeUntilSomebodyIsPairedAndAgainWhenAnotherAsks) {
  EXPECT_TRUE(pairing_.shown());
  pairing_.Try(Code(), session_);
  EXPECT_FALSE(pairing_.shown());
  pairing_.RequestCode();
  EXPECT_TRUE(pairing_.shown());
  clock_.Advance(2min);
  EXPECT_FALSE(pairing_.shown());
  pairing_.EndSession(session_);
  EXPECT_TRUE(pairing_.shown());
}

TEST_F(DeskPairing, ForgetsASessionAfterEightHoursAndTheOldestOfFive) {
  std::vector<std::string> sessions(5);
  for (std::string& session : sessions) ASSERT_EQ(pairing_.Try(Code(), session), Verdict::kAccepted);
  EXPECT_FALSE(pairing_.Knows(sessions[0]));
  EXPECT_TRUE(pairing_.Knows(sessions[1]) && pairing_.Knows(sessions[4]));
  EXPECT_EQ(std::set<std::string>(sessions.begin(), sessions.end()).size(), 5U);
  clock_.Advance(8h);
  EXPECT_FALSE(pairing_.Knows(sessions[4]));
  pairing_.Step();
  EXPECT_EQ(pairing_.sessions(), 0U);
}

TEST(DeskCode, IsEachOfAMillionWithEqualLikelihood) {
  // What is beyond the last whole million of the numbers that four bytes hold is thrown again.
  std::vector<std::vector<std::uint8_t>> throws{{0xFF, 0xFF, 0xFF, 0xFF}, {0, 0x0F, 0x42, 0x41}};
  std::size_t thrown = 0;
  ManualClock clock;
  const Pairing pairing(
      clock, [&](std::span<std::uint8_t> bytes) { std::ranges::copy(throws.at(thrown++), bytes.begin()); });
  EXPECT_EQ(thrown, 2U);
  EXPECT_EQ(pairing.code(), 1U) << "1 000 001";
}

bool Refuses(const web::Visitor& visitor) {
  return Refusal(visitor, {{"localhost", "box", "box.local"}, true}).has_value();
}

TEST(DeskOriginCheck, AcceptsItsOwnPagesUnderAnyAddressOfTheBox) {
  for (const char* host :
       {"192.168.0.2:8443", "10.1.2.3", "[fe80::1]:8443", "box", "BOX.local:8443", "localhost:1"})
    EXPECT_FALSE(Refuses({.method = "GET", .host = host})) << host;
  EXPECT_FALSE(Refuses({.method = "POST",
                        .host = "10.1.2.3:8443",
                        .origin = "https://10.1.2.3:8443",
                        .fetch_site = "same-origin"}));
}

TEST(DeskOriginCheck, RefusesNamesThatAreNotTheBoxs) {
  for (const char* host : {"", "example.org", "box.example.org", "192.168.0.2.example.org", "box:80@x",
                           "1.2.3", "[]", "[::1", "300.1.1.1", "box:x"})
    EXPECT_TRUE(Refuses({.method = "GET", .host = host})) << host;
}

TEST(DeskOriginCheck, RefusesPagesOfOtherSites) {
  for (const char* origin :
       {"", "null", "http://box", "https://box:1", "https://example.org", "https://boxx"})
    EXPECT_TRUE(Refuses({.method = "POST", .host = "box", .origin = origin})) << origin;
  EXPECT_TRUE(Refuses({.method = "GET", .host = "box", .origin = "https://example.org"}));
  for (const char* site : {"cross-site", "same-site"})
    EXPECT_TRUE(Refuses({.method = "GET", .host = "box", .fetch_site = site})) << site;
}

TEST(DeskLanguage, IsTheOneThatTheBrowserPrefers) {
  for (const char* japanese :
       {"ja", "ja-JP,ja;q=0.9,en;q=0.8", "de,ja;q=0.5", "fr;q=0.9, ja;q=0.8, en;q=0.7"})
    EXPECT_TRUE(PrefersJapanese(japanese)) << japanese;
  for (const char* english : {"", "en", "en,ja;q=0.9", "de", "en-US,en;q=0.9,ja;q=0.1", "ja;q=0", "jam"})
    EXPECT_FALSE(PrefersJapanese(english)) << english;
}

TEST(DeskView, EmphasisesThePaintOrShowsItAlone) {
  const std::vector<std::uint8_t> skin_and_paint{200, 150, 120, 0, 10, 150, 50, 255};
  std::vector<std::uint8_t> shown;
  Compose(View::kPlain, skin_and_paint, shown);
  EXPECT_THAT(std::vector(shown.begin(), shown.begin() + 3), ElementsAre(200, 150, 120));
  Compose(View::kBoth, skin_and_paint, shown);
  EXPECT_LT(shown[0], 100) << "skin falls back";
  EXPECT_GT(shown[5], 150) << "paint comes out";
  Compose(View::kMask, skin_and_paint, shown);
  EXPECT_EQ(shown[0] + shown[1] + shown[2], 0);
  EXPECT_EQ(shown[4], 255);
}

TEST(DeskPage, IsSmallAndNamesNoOtherHost) {
  std::size_t bytes = 0;
  for (const char* path : {"/", "/style.css", "/icon.svg", "/main.js", "/pair.js", "/picture.js", "/mouth.js",
                           "/steps.js", "/tuning.js", "/wire.js", "/texts.js"}) {
    ASSERT_NE(FindPageFile(path), nullptr) << path;
    const std::string text(FindPageFile(path)->bytes);
    bytes += text.size();
    for (auto at = text.find("://"); at != std::string::npos; at = text.find("://", at + 1))
      EXPECT_EQ(text.substr(at - 4, 17), "http://www.w3.org") << path << " has an address of another machine";
  }
  EXPECT_LT(bytes, 200'000U);
}

class DeskCertificate : public ::testing::Test {
 protected:
  static constexpr std::int64_t kNow_s = 1'795'000'000;  // In 2026.
  Result<OwnCertificate> Kept(std::int64_t now_s = kNow_s) {
    return LoadOrMakeCertificate(folder_.folder() / "data", {{"box", "box.local"}, 0xC0A80001, now_s});
  }
  std::filesystem::path file() const { return folder_.folder() / "data" / "desk.pem"; }
  board::BoardFile folder_;
};

TEST_F(DeskCertificate, IsMadeOnceAndReadableByItsOwnerAlone) {
  const auto made = Kept();
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_THAT(made->pem.chain, HasSubstr("BEGIN CERTIFICATE"));
  EXPECT_THAT(made->pem.key, HasSubstr("PRIVATE KEY"));
  EXPECT_NE(made->fingerprint, 0U);
  EXPECT_EQ(std::filesystem::status(file()).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  const auto again = Kept();
  EXPECT_EQ(again->fingerprint, made->fingerprint);
  EXPECT_EQ(again->pem.key, made->pem.key);
}

// A box without a data partition has its desk all the same; in /sys nobody makes a folder either.
TEST_F(DeskCertificate, IsUsedWhereItCannotBeKept) {
  const auto made = LoadOrMakeCertificate("/sys/kaori-desk", {{"box", "box.local"}, 0xC0A80001, kNow_s});
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_THAT(made->pem.key, HasSubstr("PRIVATE KEY"));
}

TEST_F(DeskCertificate, IsMadeAgainWhenItEndsOrIsDamaged) {
  const auto first = Kept().value();
  EXPECT_EQ(Kept(kNow_s + 700LL * 86'400)->fingerprint, first.fingerprint);
  EXPECT_NE(Kept(kNow_s + 800LL * 86'400)->fingerprint, first.fingerprint);
  for (const char* damage : {"", "kettle", "-----BEGIN CERTIFICATE-----\nx\n"}) {
    const auto before = Kept()->fingerprint;
    std::ofstream(file()) << damage;
    const auto made = Kept();
    ASSERT_TRUE(made);
    EXPECT_NE(made->fingerprint, before) << damage;
  }
}

TEST_F(DeskCertificate, SaysWhyItCannotBeKept) {
  std::ofstream(folder_.folder() / "data") << "a file in the folder's place";
  const auto made = Kept();
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message(), HasSubstr("data"));
}

// Two generations of the lips' settings.
class LipGenerations : public ::testing::Test {
 protected:
  static lips::LipSettings With(float spill) {
    lips::LipSettings settings;
    settings.key.spill = spill;
    return settings;
  }
  std::string Text(const std::filesystem::path& file) const {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  board::BoardFile folder_;
  std::filesystem::path file_ = folder_.folder() / "settings" / "lips";
  std::filesystem::path before_ = file_.string() + ".before";
};

TEST_F(LipGenerations, AreNoneAtFirstThenOneThenTwo) {
  EXPECT_FALSE(lips::ReadGenerations(file_).now);
  EXPECT_EQ(lips::ReadGenerations(file_).complaint, "");
  ASSERT_TRUE(lips::WriteGeneration(file_, With(50)));
  EXPECT_EQ(lips::ReadGenerations(file_).now, With(50));
  EXPECT_FALSE(lips::ReadGenerations(file_).before);
  ASSERT_TRUE(lips::WriteGeneration(file_, With(60)));
  ASSERT_TRUE(lips::WriteGeneration(file_, With(60)));  // The same once more pushes nothing out.
  EXPECT_EQ(lips::ReadGenerations(file_).now, With(60));
  EXPECT_EQ(lips::ReadGenerations(file_).before, With(50));
}

TEST_F(LipGenerations, FallBackToTheOneBeforeWhereADiskHasSpoiltAnyByte) {
  ASSERT_TRUE(lips::WriteGeneration(file_, With(50)));
  ASSERT_TRUE(lips::WriteGeneration(file_, With(60)));
  const std::string whole = Text(file_);
  for (std::size_t at = 0; at < whole.size(); at += 5) {
    std::string spoilt = whole;
    spoilt[at] = static_cast<char>(spoilt[at] ^ 0x15);
    std::ofstream(file_, std::ios::binary) << spoilt;
    const auto kept = lips::ReadGenerations(file_);
    ASSERT_TRUE(!kept.now || *kept.now == With(60)) << "byte " << at << " of\n" << spoilt;
  }
  for (std::size_t bytes = 0; bytes < whole.size(); bytes += 5) {
    std::ofstream(file_, std::ios::binary) << whole.substr(0, bytes);
    ASSERT_FALSE(lips::ReadGenerations(file_).now) << bytes << " bytes";
  }
  EXPECT_EQ(lips::SettingsFrom(file_), With(50));
  ASSERT_TRUE(lips::WriteGeneration(file_, With(70)));
  EXPECT_EQ(lips::ReadGenerations(file_).before, With(50)) << "nothing spoilt is kept as the one before";
}

TEST_F(LipGenerations, AcceptWhatAPersonWrote) {
  std::filesystem::create_directories(file_.parent_path());
  std::ofstream(file_) << "key.spill = 90  # by hand\n";
  EXPECT_EQ(lips::SettingsFrom(file_), With(90));
  ASSERT_TRUE(lips::WriteGeneration(file_, With(91)));
  EXPECT_EQ(lips::ReadGenerations(file_).before, With(90));
}

}  // namespace
}  // namespace kaori::desk
