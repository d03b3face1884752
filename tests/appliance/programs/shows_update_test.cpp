// An update of the box in the list of shows: kaori-update, played by the test, brings it in.
#include <sys/stat.h>

#include "appliance/core/update/bundle.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/whole_file.h"
#include "tests/appliance/programs/shows_service_fixture.h"

namespace kaori::shows {
namespace {

using std::chrono::seconds;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class UpdateOnStick : public ServiceTest {
 protected:
  UpdateOnStick() {
    PutUpdate("it blinks");
    plugged_ = true;
  }
  void PutUpdate(const std::string& news) {
    update::Manifest manifest{.version = 12, .from = 1, .news = news};
    for (auto& part : manifest.parts) part = {.packed_bytes = 1, .bytes = 1};
    manifest.payload_bytes = manifest.parts.size();
    const auto header = update::MakeHeader(manifest, company_);
    EXPECT_TRUE(WriteWholeFile(folder_ / "stick/box.kaoriupdate", {header, AsBytes("four")}));
  }
  // What was asked for, with the file beside it.
  std::string Asked() {
    client_ = AcceptPeer(listener_.get()).value();
    std::array<std::uint8_t, 100> bytes{};
    auto packet = ReceivePacket(client_.get(), bytes);
    if (!packet) return "nothing";
    file_ = std::move(packet->descriptor);
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(packet->bytes)};
  }
  std::string Answer(update::Message message, std::uint32_t done, const std::string& detail = {}) {
    EXPECT_TRUE(SendPacket(client_.get(), AsBytes(update::Format({message, 12, done, detail}))));
    return Play(seconds(1));
  }

  UniqueFd listener_ = ListenForPackets((folder_ / "update").string()).value();
  UniqueFd client_, file_;
};

TEST_F(UpdateOnStick, IsListedWithItsVersionAndWhatIsNew) {
  EXPECT_THAT(Play(seconds(1)), HasSubstr("> 1. update box  version 12, it blinks"));
}

TEST_F(UpdateOnStick, SaysWhatIsNewInJapaneseAndEndsBehindALetter) {
  PutUpdate("まばたきします");
  EXPECT_THAT(Play(seconds(1)), HasSubstr("version 12, まばたきします\n"));
  update::Manifest manifest{.version = 12, .from = 1, .news = "x"};
  for (int i = 0; i < 40; ++i) manifest.news += "香";
  for (auto& part : manifest.parts) part = {.packed_bytes = 1, .bytes = 1};
  manifest.payload_bytes = manifest.parts.size();
  const auto read = update::ReadHeader(update::MakeHeader(manifest, company_), update::kHeader_bytes + 4);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->news, manifest.news.substr(0, 1 + 31 * std::string_view("香").size()));
}

TEST_F(UpdateOnStick, ThatIsNoneIsListedAsSuch) {
  EXPECT_TRUE(WriteWholeFile(folder_ / "stick/box.kaoriupdate", {AsBytes("something else")}));
  EXPECT_THAT(Play(seconds(1)), HasSubstr("update box  no update that can be read"));
}

TEST_F(UpdateOnStick, IsBroughtInByAnotherProgramWhichGetsItsOpenFile) {
  Play(seconds(1));
  Strike(board::key::k1);
  Play(seconds(1));
  EXPECT_EQ(Asked(), "install");
  struct stat status {};
  ASSERT_EQ(::fstat(file_.get(), &status), 0);
  EXPECT_EQ(status.st_size, static_cast<off_t>(update::kHeader_bytes + 4));
  EXPECT_THAT(Answer(update::Message::kWriting, 345),
              AllOf(HasSubstr("version 12: it is being written"), HasSubstr("(34 %)")));
  Strike(board::key::k1);  // Whoever presses again meanwhile takes nothing more.
  EXPECT_TRUE(WriteWholeFile(folder_ / "pending", {AsBytes("12 B 0\n")}));
  EXPECT_THAT(Answer(update::Message::kWaits, 1000),
              AllOf(HasSubstr("it is on the box and waits"), HasSubstr("restart the box to try version 12")));
  EXPECT_FALSE(AcceptPeer(listener_.get()));
}

TEST_F(UpdateOnStick, ThatIsRefusedSaysWhyInBothLanguages) {
  Play(seconds(1));
  Strike(board::key::k1);
  Play(seconds(1));
  Asked();
  EXPECT_THAT(Answer(update::Message::kOlder, 0, "this box runs version 13"),
              AllOf(HasSubstr("! version 12: it is older than what runs (this box runs version 13)"),
                    HasSubstr("! バージョン12: 今のものより古いアップデートです")));
}

TEST_F(UpdateOnStick, WhoseProgramEndsIsToldOf) {
  Play(seconds(1));
  Strike(board::key::k1);
  Play(seconds(1));
  Asked();
  client_.reset();
  EXPECT_THAT(Play(seconds(1)), HasSubstr("! the box's own disk cannot be written"));
}

TEST_F(UpdateOnStick, ThatWasKeptLeavesAWayBackToTheSystemBefore) {
  plugged_ = false;
  EXPECT_TRUE(WriteWholeFile(folder_ / "before", {AsBytes("11 A 0\n")}));
  Play(seconds(1));
  Strike(board::key::kPageUp);
  EXPECT_THAT(Play(seconds(1)), HasSubstr("> 1. restart the box to go back to version 11"));
  Strike(board::key::k1);
  Play(seconds(1));
  EXPECT_EQ(Asked(), "restart");
  EXPECT_FALSE(file_.valid());
}

TEST_F(UpdateOnStick, ThatWaitsIsTriedByARestartWithoutTheStickAsWell) {
  plugged_ = false;
  EXPECT_TRUE(WriteWholeFile(folder_ / "pending", {AsBytes("12 B 0\n")}));
  EXPECT_THAT(Play(seconds(1)), Not(HasSubstr("restart the box"))) << "the list is shut";
  Strike(board::key::kPageUp);
  EXPECT_THAT(Play(seconds(1)), HasSubstr("> 1. restart the box to try version 12"));
  Strike(board::key::k1);
  Play(seconds(1));
  EXPECT_EQ(Asked(), "restart");
  EXPECT_FALSE(file_.valid());
  EXPECT_THAT(Answer(update::Message::kForgets, 0), HasSubstr("! version 12: this PC forgets"));
}

}  // namespace
}  // namespace kaori::shows
