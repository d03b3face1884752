// The desk and kaori-shows: its visitors see the list and the settings, take lines and bring settings; and who is not heard.
#include <fcntl.h>

#include <array>

#include "appliance/core/restore/apply.h"
#include "appliance/core/restore/plan.h"
#include "appliance/programs/shows/settings_check.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/whole_file.h"
#include "tests/appliance/programs/shows_service_fixture.h"

namespace kaori::shows {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kFileOfBox = "settings/box.toml";
constexpr const char* kOfBox = "# ours\nprofile = \"stage\"\n[lines]\ngo = 0\n";

class ShowsDeskTest : public ServiceTest {
 protected:
  explicit ShowsDeskTest(Offers offers = Offers::kSettings) : ServiceTest(offers) {
    fs::create_directories(folder_ / "settings");
    Put(kFileOfBox, kOfBox);
    Connect();
  }
  void Connect() { page_ = ConnectToPeer((folder_ / "desk").string()).value(); }
  // The newest state, after a second.
  std::string State() {
    Play(1s);
    std::array<std::uint8_t, kLongestState_bytes> bytes;
    while (auto packet = ReceivePacket(page_.get(), bytes)) {
      const std::string text(reinterpret_cast<const char*>(bytes.data()), packet->bytes);
      if (packet->descriptor.valid())
        backup_ = BackupFile{text, std::move(packet->descriptor)};
      else
        state_ = text;
    }
    return state_;
  }
  std::string Ask(std::string_view request, int file = -1) {
    EXPECT_TRUE(SendPacket(page_.get(), AsBytes(request), file));
    return State();
  }
  // Takes the line of the newest state with these words.
  std::string ChooseAtDesk(const std::string& words) {
    State();
    const auto choices = state_.find("\"choices\":["), at = state_.find(words, choices);
    EXPECT_NE(at, std::string::npos) << "no \"" << words << "\" in " << state_;
    std::size_t line = 0;
    for (auto each = choices; (each = state_.find("\",\"", each + 1)) < at;) ++line;
    return Ask("take " + std::to_string(line) + " " + List());
  }
  // The number of the list of the newest state.
  std::string List() const {
    const auto at = state_.find("\"list\":") + 7;
    return state_.substr(at, state_.find(',', at) - at);
  }
  bool IsHungUpOn() {
    State();
    std::array<std::uint8_t, 1> byte{};
    const auto packet = ReceivePacket(page_.get(), byte);
    return !packet && packet.error().cause == std::errc::no_such_device;
  }

  UniqueFd page_;
  std::string state_;
  std::optional<BackupFile> backup_;
};

TEST_F(ShowsDeskTest, SeesTheListAndTheSettingsThoughTheListIsShutAtTheBox) {
  EXPECT_THAT(State(), HasSubstr(R"("settings of this box")"));
  EXPECT_THAT(state_, HasSubstr(R"("settings":"# ours\nprofile = \"stage\"\n[lines]\ngo = 0\n")"));
  EXPECT_FALSE(IsOpen());
}

TEST_F(ShowsDeskTest, SeesWhatLiesOnAStickAndTakesAShowOfIt) {
  PutOnStick("evening", &company_);
  plugged_ = true;
  ChooseAtDesk("evening");
  EXPECT_THAT(State(), HasSubstr("evening: it is on the box"));
  EXPECT_THAT(state_, HasSubstr("evening: 入りました"));
  EXPECT_NE(ReadChoice(*shows_).current, store::kRootShow);
}

TEST_F(ShowsDeskTest, ChoosesASettingAndSeesWhatChangesBeforeItDoes) {
  ChooseAtDesk("settings of this box");
  ChooseAtDesk("profile");
  EXPECT_THAT(ChooseAtDesk("kiosk"), HasSubstr(R"("notes":["changed profile  \"stage\" -> \"kiosk\""])"));
  EXPECT_EQ(Text(kFileOfBox), kOfBox);
  EXPECT_THAT(ChooseAtDesk("yes, change them"), HasSubstr("switch the box off and on"));
  EXPECT_THAT(Text(kFileOfBox), HasSubstr("profile = \"kiosk\""));
  EXPECT_THAT(state_, HasSubstr(R"("settings":"profile = \"kiosk\"\n)")) << "and the page has it";
}

TEST_F(ShowsDeskTest, BringsAllSettingsAndTheOldOnesAreKept) {
  const std::string fresh = "profile = \"stage\"\n[network]\naddress = \"10.101.90.20/24\"\n";
  EXPECT_THAT(Ask("settings\n" + fresh), HasSubstr("new     network.address"));
  EXPECT_THAT(state_, HasSubstr("gone    lines.go  0"));
  EXPECT_EQ(Text(kFileOfBox), kOfBox);
  ChooseAtDesk("yes, change them");
  EXPECT_EQ(Text(kFileOfBox), fresh);
  EXPECT_EQ(Text("settings/box.before.toml"), kOfBox);
}

TEST_F(ShowsDeskTest, LeavesTheSettingsWhereTheAnswerIsNo) {
  Ask("settings\nprofile = \"kiosk\"\n");
  EXPECT_THAT(ChooseAtDesk("leave the settings"), HasSubstr("the box stays as it is"));
  EXPECT_EQ(Text(kFileOfBox), kOfBox);
}

TEST_F(ShowsDeskTest, IsToldTheLineAndTheReasonOfAMistake) {
  const std::string said = Ask("settings\nprofile = \"stage\"\n[stick.left]\ndead_zone = 7\n");
  EXPECT_THAT(said, HasSubstr("box.toml:3:13: stick.left.dead_zone is not between 0 and 0.9"));
  EXPECT_THAT(said, HasSubstr(R"("refused":true)"));
  EXPECT_THAT(said, Not(HasSubstr("yes, change them")));
  EXPECT_THAT(Ask("settings\n" + std::string(kMostSettings_bytes, '#') + "\n"), HasSubstr("longer than any"));
  EXPECT_EQ(Text(kFileOfBox), kOfBox);
}

// Between what the visitor saw and the finger that came down another list took its place.
TEST_F(ShowsDeskTest, TakesNothingFromAListThatIsGone) {
  Ask("settings\nprofile = \"kiosk\"\n");
  const std::string list = List();
  ChooseAtDesk("leave the settings");
  EXPECT_THAT(Ask("take 1 " + list), Not(HasSubstr("switch the box off and on")));
  EXPECT_THAT(Ask("take 99 " + List()), HasSubstr("settings of this box"));
  EXPECT_EQ(Text(kFileOfBox), kOfBox);
}

TEST_F(ShowsDeskTest, IsHungUpOnWhereItAsksForAnythingElse) {
  State();
  Ask("reset");
  EXPECT_TRUE(IsHungUpOn());
  Connect();
  EXPECT_THAT(State(), HasSubstr("settings of this box")) << "and is heard again";
}

TEST_F(ShowsDeskTest, ThatWasStartedAgainTakesThePlaceOfTheOldOne) {
  State();
  const UniqueFd old = std::move(page_);
  Connect();
  state_.clear();
  EXPECT_THAT(State(), HasSubstr("settings of this box"));
  std::array<std::uint8_t, kLongestState_bytes> bytes;
  while (ReceivePacket(old.get(), bytes)) continue;
  EXPECT_EQ(ReceivePacket(old.get(), bytes).error().cause, std::errc::no_such_device);
}

// The file cannot be sent as one packet: control characters, which TOML has not, are six letters each in JSON.
TEST_F(ShowsDeskTest, SeesTheListWhereTheSettingsCannotBeShown) {
  Put(kFileOfBox, std::string(kMostSettings_bytes, '\x01'));
  EXPECT_THAT(State(), HasSubstr("settings of this box"));
  EXPECT_THAT(state_, HasSubstr(R"("settings":null)"));
}

class ShowsDeskCopiesTest : public ShowsDeskTest {
 protected:
  ShowsDeskCopiesTest() : ShowsDeskTest(Offers::kAll) {
    fs::create_directories(folder_ / "own");
    Put("own/01-smile.toml", "smile");
  }
};

TEST_F(ShowsDeskCopiesTest, SeesWhichBoxItIs) {
  EXPECT_THAT(State(), HasSubstr("\"box\":\"left-1a2b3c4d\""));
}

TEST_F(ShowsDeskCopiesTest, GetsABackupWithoutAStickAndTheDiskKeepsNothingOfIt) {
  const std::string said = Ask("backup");
  ASSERT_TRUE(backup_) << said;
  EXPECT_EQ(backup_->name, "left-1a2b3c4d-20261119-070640.kaorishow");
  EXPECT_THAT(State(), HasSubstr(Words(Message::kBackupForDesk, Language::kJapanese)));
  EXPECT_THAT(state_, HasSubstr(R"("backup":"left-1a2b3c4d-20261119-070640.kaorishow")"));
  EXPECT_EQ(opened_, 0) << "no stick was made one that can be written";
  EXPECT_FALSE(fs::exists(folder_ / "restore/for-desk"));
  EXPECT_TRUE(backup::Reader::Begin(backup::InputOf(std::move(backup_->file), "backup").value()));
}

TEST_F(ShowsDeskCopiesTest, RestoresABackupThatAVisitorBringsOnceItSaidWhatDiffers) {
  Ask("backup");
  ASSERT_TRUE(backup_);
  Put("own/01-smile.toml", "grin");
  EXPECT_THAT(Ask("restore left.kaorishow", backup_->file.get()),
              HasSubstr("left.kaorishow: the lines below"));
  EXPECT_THAT(state_, HasSubstr("changed own/01-smile.toml"));
  EXPECT_FALSE(fs::exists(folder_ / restore::kNext));
  EXPECT_THAT(ChooseAtDesk("yes, restore this"), HasSubstr("switch the box off and on"));
  ASSERT_TRUE(restore::FinishRestore(folder_).value());
  EXPECT_EQ(Text("own/01-smile.toml"), "smile");
}

TEST_F(ShowsDeskCopiesTest, AgreesToNothingButWhatItBroughtLast) {
  Ask("backup");
  ASSERT_TRUE(backup_);
  Put("own/01-smile.toml", "grin");
  Ask("restore left.kaorishow", backup_->file.get());
  EXPECT_THAT(Ask("settings\nprofile = \"kiosk\"\n"), HasSubstr("yes, change them"));
  ChooseAtDesk("yes, change them");
  EXPECT_EQ(Text(kFileOfBox), "profile = \"kiosk\"\n");
  EXPECT_FALSE(fs::exists(folder_ / restore::kNext)) << "the restore was dropped";
  Ask("settings\nprofile = \"bench\"\n");
  Ask("restore left.kaorishow", backup_->file.get());
  ChooseAtDesk("yes, restore this");
  EXPECT_EQ(Text(kFileOfBox), "profile = \"kiosk\"\n") << "the settings were dropped";
}

TEST_F(ShowsDeskCopiesTest, IsToldThatWhatItBringsIsNoBackupAndIsHungUpOnWithoutAFile) {
  Put("holiday.jpg", "a picture");
  const UniqueFd picture(::open((folder_ / "holiday.jpg").c_str(), O_RDONLY | O_CLOEXEC));
  EXPECT_THAT(Ask("restore holiday.jpg", picture.get()), HasSubstr(R"("refused":true)"));
  Ask("restore nothing");
  EXPECT_TRUE(IsHungUpOn());
}

TEST(DeskLinkTest, HearsNoProgramOfAnotherUser) {
  const board::BoardFile folder;
  const std::string path = (folder.folder() / "desk").string();
  DeskLink link = DeskLink::Open(path, ::geteuid() + 1).value();
  const UniqueFd other = ConnectToPeer(path).value();
  EXPECT_TRUE(SendPacket(other.get(), AsBytes(std::string_view("take 0 1"))));
  EXPECT_FALSE(link.Hear());
  EXPECT_FALSE(link.connected());
  std::array<std::uint8_t, 1> byte{};
  EXPECT_EQ(ReceivePacket(other.get(), byte).error().cause, std::errc::no_such_device);
}

TEST(DeskRequestTest, HasOneFormOnly) {
  const auto take = ParseRequest("take 3 17");
  ASSERT_TRUE(take);
  EXPECT_EQ(take->line, 3U);
  EXPECT_EQ(take->list, 17U);
  EXPECT_EQ(ParseRequest("settings\na = 1\n")->text, "a = 1\n");
  EXPECT_EQ(ParseRequest("restore left lobby.kaorishow")->text, "left lobby.kaorishow");
  EXPECT_TRUE(ParseRequest("backup"));
  for (const char* text :
       {"", "take", "take ", "take 1", "take 1 2 3", "take -1 2", "take 1 x", " take 1 2",
        "take 99999999999 1", "settings", "settings a", "reset", "backup ", "restore", "restore "})
    EXPECT_FALSE(ParseRequest(text)) << text;
  EXPECT_FALSE(ParseRequest("settings\n" + std::string(kLongestRequest_bytes, '#')));
}

}  // namespace
}  // namespace kaori::shows
