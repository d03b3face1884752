// A scenario is played in the whole system with a show log, and again from the log: to the bit, in another size.
#include "hw-sim/rehearsal/log_player.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "appliance/programs/stage/last_face.h"
#include "appliance/programs/stage/show_log.h"
#include "hw-sim/rehearsal/rehearsal.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"

namespace kaori::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class LogPlayerTest : public ::testing::Test {
 protected:
  LogPlayerTest() : folder_(fs::temp_directory_path() / fmt::format("kaori-log-player-{}", ::getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "passing");
  }
  ~LogPlayerTest() override { fs::remove_all(folder_); }

  // Plays so much of a scenario, and keeps its log.
  fs::path Rehearse(const std::string& play, Duration length) {
    auto show = show::LoadPack(KAORI_PACK);
    auto editor = editor::ExpressionEditor::Open(folder_ / "own", *show);
    const auto studio = stage::Studio::Open(std::move(*show)).value();
    const auto rehearsal =
        Rehearsal::Open({.folder = folder_ / "rehearsal", .width_px = 64, .height_px = 36, .hz = 30}, *studio)
            .value();
    rehearsal->Bring(std::move(editor));
    const auto head =
        stage::HeadOfLog(stage::ShowMark(KAORI_PACK).value(), folder_ / "none.toml", rehearsal->now());
    const auto log = stage::ShowLog::Open(folder_ / "log", head).value();
    rehearsal->SetLog(&log->recorder());
    Player player(LoadScenario(play).value(), rehearsal->rig(), rehearsal->began());
    while (rehearsal->now() - rehearsal->began() < length) {
      if (!rehearsal->NextPicture([&](Time now) { player.Perform(now); })) ADD_FAILURE() << "no picture";
      ++pictures_;
    }
    rehearsal->SetLog(nullptr);
    log->Finish();
    return log->file();
  }

  LogPlayOptions Options(const fs::path& log) {
    return {.log = log,
            .pack = KAORI_PACK,
            .own = {},
            .at = {},
            .output = {"", "", {160, 90}, 10, folder_ / "passing"}};
  }

  fs::path folder_;
  std::uint64_t pictures_ = 0;
};

TEST_F(LogPlayerTest, ShowsWhatTheWholeSystemShowedInAnySize) {
  const fs::path log = Rehearse(KAORI_PLAYS "/kaori.play", std::chrono::seconds(12));
  LogPlayOptions options = Options(log);
  options.output.pictures = folder_ / "pictures";
  const auto played = PlayLog(options);
  ASSERT_TRUE(played) << played.error().message();
  // A frame may be on its way to the screen at either end.
  EXPECT_NEAR(static_cast<double>(played->frames), static_cast<double>(pictures_), 2);
  EXPECT_EQ(played->differ, 0U) << "from " << played->first_difference;
  EXPECT_TRUE(fs::exists(folder_ / "pictures/0010.png"));

  options.at = "99:99";
  const auto refused = PlayLog(options);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("--at 99:99: a time of day is expected"));
  options.at = played->until;
  options.pack = log;
  EXPECT_FALSE(PlayLog(options)) << "that is no show";
}

}  // namespace
}  // namespace kaori::sim
