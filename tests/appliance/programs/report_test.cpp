// The show reports that the box makes by itself.
#include "appliance/programs/report/reports.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "appliance/core/last_face/show_mark.h"
#include "appliance/core/performance/animate.h"
#include "appliance/core/showlog/recorder.h"
#include "appliance/programs/report/logged_show.h"
#include "appliance/programs/report/report_times.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
namespace fs = std::filesystem;
using report::MakeReports;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class BoxReports : public PackTest {
 protected:
  BoxReports() {
    fs::create_directories(folder_ / "log");
    EXPECT_TRUE(show::SavePack(SmallShow(), folder_ / "small.kaori"));
    places_ = {.logs = folder_ / "log",
               .own = folder_ / "own",
               .packs = {folder_ / "shows", folder_ / "small.kaori"}};
  }
  fs::path LogFile(int number) const {
    return places_.logs / fmt::format("{:04}-20261122-190000.kaorilog", number);
  }
  std::string ReportOf(int number) const {
    std::ostringstream text;
    text << std::ifstream(places_.logs / fmt::format("{:04}-20261122-190000.report.txt", number)).rdbuf();
    return text.str();
  }
  // An evening of two seconds on which the foot calls the first cue; another start of the box for each number.
  void PlayEvening(int number) {
    const showlog::LogHead head{.show = last_face::ShowMark(folder_ / "small.kaori").value(),
                                .booted_at = 24h * 20000 + number * 24h};
    const show::Show show = report::LoadShowOfLog(folder_ / "small.kaori", head, "").value();
    std::vector<std::uint8_t> bytes = HeadBytes(head);
    showlog::Recorder recorder([&] {
      const auto chunk = recorder.handed();
      bytes.insert(bytes.end(), chunk.begin(), chunk.end());
      recorder.Release();
    });
    board::Snapshot board;
    Time now = Time{} + 100s;
    performance::State state = performance::Opening(show, board, now);
    for (int frame = 0; frame < 120; ++frame) {
      now += 16'666'667ns;
      auto& calls = board.calls[static_cast<std::size_t>(board::CallWriter::kInput)];
      calls.source = board::SourceState::kLive;
      if (frame == 60)
        board::Append(calls.value,
                      {.at = now, .verb = board::CallVerb::kCue, .source = board::CallSource::kFootSwitch});
      const auto events = performance::ReadEvents(state.seen, board);
      const auto performed = performance::Animate(state, board, events, show, now);
      recorder.Note({now, board, state, events}, performed);
      state = performed.state;
    }
    recorder.Close();
    std::ofstream(LogFile(number), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  report::ReportPlaces places_;
};

TEST_F(BoxReports, AreMadeOfEachEveningOnceAndSayWhatIsUsual) {
  PlayEvening(7);
  PlayEvening(8);
  const auto made = MakeReports(places_);
  EXPECT_THAT(made.faults, IsEmpty());
  EXPECT_EQ(made.files.size(), 2U);
  EXPECT_THAT(ReportOf(7), HasSubstr("There is no earlier evening"));
  EXPECT_THAT(ReportOf(7), HasSubstr("foot switch"));
  EXPECT_THAT(ReportOf(7), HasSubstr("The log plays again to the bit."));
  EXPECT_THAT(ReportOf(8), HasSubstr("Usual is the median of 1 earlier evenings."));
  EXPECT_TRUE(fs::exists(places_.logs / "0008-20261122-190000.report.html"));
  EXPECT_THAT(MakeReports(places_).files, IsEmpty()) << "they are there";
  fs::last_write_time(LogFile(8), fs::file_time_type::clock::now() + 1h);
  EXPECT_THAT(MakeReports(places_).files, ElementsAre(places_.logs / "0008-20261122-190000.report.txt"))
      << "the log has grown";
}

TEST_F(BoxReports, AreNotMadeWhereTheLogIsTornOrItsShowIsGoneAndTheOthersAre) {
  PlayEvening(7);
  std::ofstream(LogFile(6)) << "no log";
  PlayEvening(8);
  fs::resize_file(LogFile(8), fs::file_size(LogFile(8)) / 2);
  auto made = MakeReports(places_);
  EXPECT_THAT(made.files, ElementsAre(places_.logs / "0007-20261122-190000.report.txt"));
  ASSERT_EQ(made.faults.size(), 2U);
  EXPECT_THAT(made.faults[0], HasSubstr("0006-20261122-190000.kaorilog: it is no show log"));
  EXPECT_THAT(made.faults[1], HasSubstr("0008-20261122-190000.kaorilog"));
  fs::remove(places_.logs / "0007-20261122-190000.report.txt");
  fs::remove(folder_ / "small.kaori");
  made = MakeReports(places_);
  EXPECT_THAT(made.files, IsEmpty());
  EXPECT_THAT(made.faults,
              ::testing::Contains(HasSubstr("the show that was played is no longer on the box")));
}

TEST_F(BoxReports, FindTheShowAmongThoseThatWereBroughtToTheBox) {
  PlayEvening(7);
  fs::create_directories(folder_ / "shows");
  fs::rename(folder_ / "small.kaori", folder_ / "shows/0123456789abcdef.kaori");
  EXPECT_EQ(MakeReports(places_).files.size(), 1U);
}

// Where the root's disk is spoilt its header may still be whole, and the copy has played.
TEST_F(BoxReports, TakeTheCopyOfASpoiltShow) {
  PlayEvening(7);
  fs::create_directories(folder_ / "shows");
  fs::copy(folder_ / "small.kaori", folder_ / "shows/root.copy");
  places_.packs = {folder_ / "small.kaori", folder_ / "shows"};
  std::fstream(folder_ / "small.kaori", std::ios::in | std::ios::out | std::ios::binary)
      .seekp(5000)
      .put('\x5A');
  EXPECT_EQ(MakeReports(places_).files.size(), 1U);
  fs::remove(folder_ / "shows/root.copy");
  fs::remove(places_.logs / "0007-20261122-190000.report.txt");
  EXPECT_THAT(MakeReports(places_).faults, ElementsAre(HasSubstr("small.kaori is damaged")));
}

TEST_F(BoxReports, StayWhereTheirLogsAreGoneUntilThereIsTooMuchOfThem) {
  for (int number = 1; number <= 6; ++number)
    std::ofstream(places_.logs / fmt::format("{:04}-20261122-190000.report.txt", number))
        << std::string(1'000'000, 'x');
  PlayEvening(7);
  EXPECT_EQ(MakeReports(places_).files.size(), 1U);
  EXPECT_THAT(ReportOf(2), IsEmpty());
  EXPECT_EQ(ReportOf(4).size(), 1'000'000U);
  EXPECT_THAT(ReportOf(7), HasSubstr("foot switch"));
  EXPECT_TRUE(fs::exists(LogFile(7))) << "nothing else is removed";
}

TEST(ReportTimes, AreAfterTheStartWhenTheListIsOverAndWhenTheServiceKeyIsTurnedOn) {
  const Time start = Time{} + 500s;
  report::ReportTimes times(start);
  EXPECT_FALSE(times.IsDue(start + 59s, {}));
  EXPECT_TRUE(times.IsDue(start + 60s, {}));
  EXPECT_FALSE(times.IsDue(start + 61s, {}));
  EXPECT_FALSE(times.IsDue(start + 100s, {.list_over = true}));
  EXPECT_FALSE(times.IsDue(start + 139s, {.list_over = true}))
      << "the log's last part is not on the disk yet";
  EXPECT_TRUE(times.IsDue(start + 140s, {.list_over = true}));
  EXPECT_FALSE(times.IsDue(start + 999s, {.list_over = true})) << "it is over for as long as nobody plays on";
  EXPECT_TRUE(times.IsDue(start + 1000s, {.service_key = true, .list_over = true})) << "somebody packs";
  EXPECT_FALSE(times.IsDue(start + 1001s, {.service_key = true, .list_over = true}));
  EXPECT_TRUE(times.IsDue(start + 1041s, {.service_key = true, .list_over = true}));
}

}  // namespace
}  // namespace kaori::tests
