// A stage that is slow is left alone, and one that hangs is not. The test plays the service manager for it, before the
// simulator's screen.
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr microseconds kLongestSilence = seconds(120);  // As the stage's unit says.
constexpr microseconds kFirstSilence =
    seconds(10);  // While it does not know its pace, of a machine that has time.
constexpr microseconds kFirstStep = seconds(60);  // While nothing is known of the machine.
constexpr int kSlowest = 20;                      // Of its slowest turns or steps so far it may be silent.
constexpr Duration kCalm = seconds(1);
constexpr Duration kBusy = seconds(5);
constexpr int kNeighbours = 4;
constexpr Duration kLate = milliseconds(500);  // The test too waits for a processor.
constexpr Duration kLongestBegin = seconds(60);

// What systemd does for one program that it watches: sd_notify(3).
class ServiceManager {
 public:
  explicit ServiceManager(const std::string& path)
      : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof(address.sun_path) - 1);
    EXPECT_EQ(::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ::setenv("NOTIFY_SOCKET", path.c_str(), 1);
    ::setenv("WATCHDOG_USEC", std::to_string(kLongestSilence.count()).c_str(), 1);
  }
  ~ServiceManager() {
    ::unsetenv("NOTIFY_SOCKET");
    ::unsetenv("WATCHDOG_USEC");
  }
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  // The program has just been started.
  void Expect() {
    limit_ = kLongestSilence, ready_ = false, last_ = began_ = clock_.now();
    steps_.clear();
  }

  // Reads what it says until `done`, or until the time is over. Whether `done` came true.
  template <class Condition>
  bool Until(Condition done, Duration longest) {
    const Time end = clock_.now() + longest;
    while (!done()) {
      const auto left = std::chrono::ceil<milliseconds>(end - clock_.now()).count();
      if (left <= 0) return false;
      pollfd said{socket_.get(), POLLIN, 0};
      if (::poll(&said, 1, static_cast<int>(std::min<long long>(left, 20))) > 0) Read();
    }
    return true;
  }
  void Listen(Duration length) {
    Until([] { return false; }, length);
  }

  // How long its start may take from then on, as it has said step by step; and how long it had taken until then.
  struct Step {
    Duration allowed{}, began_ago{};
  };
  const std::vector<Step>& steps() const { return steps_; }
  Duration began_ago() const { return clock_.now() - began_; }

  bool ready() const { return ready_; }
  Duration limit() const { return limit_; }  // The longest silence that the program asked for.
  bool is_silent() const { return clock_.now() - last_ >= limit_; }
  double worst() const { return worst_; }  // The longest silence so far, as a share of what it had asked for.

 private:
  static std::optional<Duration> ValueOf(const std::string& said, std::string_view name) {
    const std::size_t at = said.find(name);
    if (at == std::string::npos) return std::nullopt;
    return microseconds(std::atoll(said.c_str() + at + name.size()));
  }
  void Read() {
    std::array<char, 4096> bytes{};
    const ssize_t got = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
    const std::string said(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    const Time now = clock_.now();
    if (said.find("WATCHDOG=1") != std::string::npos) {
      worst_ = std::max(worst_, Seconds(now - last_) / Seconds(limit_));
      last_ = now;
    }
    if (const auto asked = ValueOf(said, "WATCHDOG_USEC=")) limit_ = *asked;
    if (const auto more = ValueOf(said, "EXTEND_TIMEOUT_USEC=")) steps_.push_back({*more, now - began_});
    ready_ |= said.find("READY=1") != std::string::npos;
  }

  UniqueFd socket_;
  SteadyClock clock_;
  Duration limit_ = kLongestSilence;
  Time last_{}, began_{};
  std::vector<Step> steps_;
  bool ready_ = false;
  double worst_ = 0;
};

// Processes that do nothing but keep processors busy.
class BusyNeighbours {
 public:
  BusyNeighbours() {
    for (pid_t& number : numbers_) {
      number = ::fork();
      if (number != 0) continue;
      for (volatile unsigned turns = 0;;) turns = turns + 1;
    }
  }
  ~BusyNeighbours() {
    for (const pid_t number : numbers_) ::kill(number, SIGKILL);
    for (const pid_t number : numbers_) ::waitpid(number, nullptr, 0);
  }
  BusyNeighbours(const BusyNeighbours&) = delete;
  BusyNeighbours& operator=(const BusyNeighbours&) = delete;

 private:
  std::array<pid_t, kNeighbours> numbers_{};
};

class WatchedStage : public ::testing::Test {
 protected:
  WatchedStage() {
    programs_.Start("kaori-sim", {"--links", programs_.links(), "--size", "320x180", "--hz", "30"});
    Await([&] { return std::filesystem::exists(programs_.links() + "/screen.screen"); });
    manager_.emplace(programs_.File("notify"));
    StartStage();
  }

  // A new stage does not know its own pace at once: until then it asks for ten seconds, or more where it is slow.
  void StartStage() {
    StartNewStage();
    ASSERT_TRUE(manager_->Until([&] { return manager_->limit() < kFirstSilence; }, kLongestBegin))
        << programs_.LogOf("kaori-stage");
  }

  void BeginStage() {
    programs_.Start("kaori-stage",
                    {"--links", programs_.links(), "--board", programs_.board(), "--pack",
                     (ProgramRunner::Programs().parent_path() / "shows" / "kaori.kaori").string()});
  }

  // What the stage keeps of its starts begins with how many came to no end.
  std::string StartsInVain() const {
    const std::string kept = ReadFile(programs_.board() + "-starts").value_or("");
    return kept.substr(0, kept.find(' '));
  }

  // No step and no turn took longer than all of them: 20 of that, and ten seconds at least.
  static Duration Allowed(Duration all) { return std::max<Duration>(kSlowest * all, kFirstSilence); }

  void StartNewStage() {
    manager_->Expect();
    BeginStage();
    ASSERT_TRUE(manager_->Until([&] { return manager_->ready() && manager_->limit() < kLongestSilence; },
                                kLongestBegin))
        << programs_.LogOf("kaori-stage");
  }

  ProgramRunner programs_;
  std::optional<ServiceManager> manager_;
};

TEST_F(WatchedStage, BesideBusyProgramsIsNeverSilentForLongerThanItAskedFor) {
  manager_->Listen(kCalm);
  {
    const BusyNeighbours neighbours;
    manager_->Listen(kBusy);
  }
  manager_->Listen(kCalm);
  EXPECT_GT(manager_->worst(), 0);
  EXPECT_LT(manager_->worst(), 1);
}

TEST_F(WatchedStage, ThatHasJustBegunAsksForSecondsAndNotForMinutes) {
  programs_.Kill("kaori-stage");
  StartNewStage();
  EXPECT_GE(manager_->limit(), kFirstSilence);
  EXPECT_LE(manager_->limit(), Allowed(manager_->began_ago()));
}

TEST_F(WatchedStage, SaysStepByStepHowLongItsStartMayTake) {
  programs_.Kill("kaori-stage");
  std::filesystem::remove(programs_.board() + "-starts");
  StartNewStage();
  const auto& steps = manager_->steps();
  ASSERT_GE(steps.size(), 4U);
  EXPECT_EQ(steps.front().allowed, kFirstStep) << "nothing is known of this machine";
  for (std::size_t n = 1; n < steps.size(); ++n) {
    EXPECT_GE(steps[n].allowed, std::max<Duration>(kFirstSilence, n > 1 ? steps[n - 1].allowed : Duration()));
    EXPECT_LE(steps[n].allowed, Allowed(steps[n].began_ago)) << n;
  }
}

TEST_F(WatchedStage, ThatWasEndedInItsStartIsMorePatientInTheNext) {
  Duration before{};
  for (int starts = 0; starts < 2; ++starts) {
    programs_.Kill("kaori-stage");
    manager_->Expect();
    BeginStage();
    ASSERT_TRUE(manager_->Until([&] { return !manager_->steps().empty(); }, kLongestBegin));
    ASSERT_TRUE(Await([&] { return StartsInVain() == std::to_string(starts + 1); })) << "it is counted";
    const Duration allowed = std::exchange(before, manager_->steps().front().allowed);
    if (starts > 0) {
      EXPECT_EQ(before, 2 * allowed);
    } else {
      EXPECT_GE(before, kFirstSilence) << "it is known how long the first step of the one before took";
    }
  }
}

TEST_F(WatchedStage, ThatHangsIsSilentAndPlaysAgainAfterItsDeath) {
  manager_->Listen(kCalm);
  const Duration asked = manager_->limit();
  const Time frozen = SteadyClock().now();
  ::kill(programs_.PidOf("kaori-stage"), SIGSTOP);
  ASSERT_TRUE(manager_->Until([&] { return manager_->is_silent(); }, asked + kLate));
  EXPECT_LT(SteadyClock().now() - frozen, asked + kLate);
  programs_.Kill("kaori-stage");
  StartStage();
}

}  // namespace
}  // namespace kaori::test
