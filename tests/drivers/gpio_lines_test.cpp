// Our lines against a chip made of memory, whose inputs are packets in sockets.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>

#include <map>

#include "drivers/gpio/chip_lines.h"
#include "drivers/gpio/polled_line.h"

namespace kaori::gpio {
namespace {

// What a hand can do, and what a lamp shows. Lines refer to it, so it outlives them.
struct Bench {
  std::map<std::uint32_t, int> switches;  // The hand's end of each taken input.
  std::map<std::uint32_t, bool> levels;
  std::map<std::uint32_t, bool> lamps;
  int taken = 0;
  bool pulled = false;

  void Switch(std::uint32_t offset, bool active, Time at) {
    levels[offset] = active;
    const LineEdge edge{.at = at, .active = active};
    ASSERT_EQ(::send(switches.at(offset), &edge, sizeof edge, 0), static_cast<ssize_t>(sizeof edge));
  }
};

tl::unexpected<Error> Pulled() {
  return Fail(std::errc::no_such_device, "read a pulled chip");
}

class MemoryInput final : public InputLine {
 public:
  MemoryInput(Bench& bench, std::uint32_t offset) : bench_(bench), offset_(offset) {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
    ours_ = UniqueFd(ends[0]);
    hand_ = UniqueFd(ends[1]);
    bench_.switches[offset] = hand_.get();
    ++bench_.taken;
  }
  ~MemoryInput() override { --bench_.taken; }
  int pollable() const override { return ours_.get(); }
  Result<bool> Level() override {
    if (bench_.pulled) return Pulled();
    return bench_.levels[offset_];
  }
  Result<LineEdge> ReadEdge() override {
    if (bench_.pulled) return Pulled();
    LineEdge edge;
    if (::recv(ours_.get(), &edge, sizeof edge, 0) < 0) return FailErrno("read a line");
    return edge;
  }

 private:
  Bench& bench_;
  std::uint32_t offset_;
  UniqueFd ours_;
  UniqueFd hand_;
};

class MemoryOutput final : public OutputLine {
 public:
  MemoryOutput(Bench& bench, std::uint32_t offset) : bench_(bench), offset_(offset) {
    bench_.lamps[offset] = false;
  }
  Result<void> Drive(bool active) override {
    if (bench_.pulled) return Pulled();
    bench_.lamps[offset_] = active;
    return {};
  }

 private:
  Bench& bench_;
  std::uint32_t offset_;
};

class MemoryChip final : public GpioChip {
 public:
  explicit MemoryChip(Bench& bench) : bench_(bench) {}
  Result<std::unique_ptr<InputLine>> RequestInput(const LineWiring& wiring) override {
    if (wiring.offset >= kLines) return FailInput("take a line that the chip has not");
    return std::make_unique<MemoryInput>(bench_, wiring.offset);
  }
  Result<std::unique_ptr<OutputLine>> RequestOutput(const LineWiring& wiring) override {
    return std::make_unique<MemoryOutput>(bench_, wiring.offset);
  }

 private:
  static constexpr std::uint32_t kLines = 40;
  Bench& bench_;
};

class ChipLinesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    lines_ = ChipLines::Request(std::make_unique<MemoryChip>(bench_),
                             {.inputs = {{.offset = 7}, {.offset = 3}}, .outputs = {{.offset = 20}}})
                 .value();
  }
  bool readable() const {
    pollfd state{.fd = lines_->pollable(), .events = POLLIN, .revents = 0};
    return ::poll(&state, 1, 0) > 0;
  }
  static Time At(int ms) { return Time{} + std::chrono::milliseconds(ms); }

  Bench bench_;
  std::unique_ptr<ChipLines> lines_;
};

TEST_F(ChipLinesTest, GivesTheEdgesOfAllLinesInTheOrderOfTime) {
  bench_.Switch(7, true, At(20));
  bench_.Switch(7, false, At(40));
  bench_.Switch(3, true, At(10));
  bench_.Switch(3, false, At(30));
  for (const auto& [ms, line, active] : std::vector<std::tuple<int, std::uint32_t, bool>>{
           {10, 1, true}, {20, 0, true}, {30, 1, false}, {40, 0, false}}) {
    EXPECT_TRUE(readable());
    const auto edge = lines_->ReadEdge();
    ASSERT_TRUE(edge) << edge.error().message();
    EXPECT_EQ(edge->at, At(ms));
    EXPECT_EQ(edge->line, line);
    EXPECT_EQ(edge->active, active);
  }
  EXPECT_FALSE(readable());
  EXPECT_EQ(lines_->ReadEdge().error().cause, std::errc::resource_unavailable_try_again);
}

TEST_F(ChipLinesTest, TellsTheLevelsByIndex) {
  EXPECT_EQ(*lines_->Levels(), 0u);
  bench_.levels[3] = true;
  EXPECT_EQ(*lines_->Levels(), 2u);
}

TEST_F(ChipLinesTest, DrivesItsOutputsAndNoOthers) {
  EXPECT_FALSE(bench_.lamps[20]);
  ASSERT_TRUE(lines_->Drive(0, true));
  EXPECT_TRUE(bench_.lamps[20]);
  EXPECT_EQ(lines_->Drive(1, true).error().cause, std::errc::invalid_argument);
}

TEST_F(ChipLinesTest, SaysThatTheChipWasPulled) {
  bench_.pulled = true;
  EXPECT_EQ(lines_->Levels().error().cause, std::errc::no_such_device);
  EXPECT_EQ(lines_->ReadEdge().error().cause, std::errc::no_such_device);
  EXPECT_EQ(lines_->Drive(0, true).error().cause, std::errc::no_such_device);
}

TEST(ChipLines, ALineThatIsNotWiredIsNeverTakenAndNeverActive) {
  Bench bench;
  const auto lines =
      ChipLines::Request(std::make_unique<MemoryChip>(bench), {.inputs = {{.wired = false}, {.offset = 3}}});
  ASSERT_TRUE(lines) << lines.error().message();
  EXPECT_EQ(bench.taken, 1);
  bench.levels[3] = true;
  EXPECT_EQ(*(*lines)->Levels(), 2U);
  bench.Switch(3, true, Time{} + std::chrono::milliseconds(1));
  EXPECT_EQ((*lines)->ReadEdge()->line, 1U);
}

TEST(ChipLines, TakesEveryLineOrNone) {
  Bench bench;
  EXPECT_FALSE(
      ChipLines::Request(std::make_unique<MemoryChip>(bench), {.inputs = {{.offset = 1}, {.offset = 99}}}));
  EXPECT_EQ(bench.taken, 0);
  EXPECT_FALSE(ChipLines::Request(std::make_unique<MemoryChip>(bench), {.inputs = std::vector<LineWiring>(33)}));
}

TEST(GpioChip, ThatIsNotThereIsNoSuchDevice) {
  const auto lines = OpenLines("gpiochip-of-nobody", {});
  ASSERT_FALSE(lines);
  EXPECT_EQ(lines.error().cause, std::errc::no_such_device);
  EXPECT_EQ(lines.error().attempt, "open GPIO chip gpiochip-of-nobody");
}

// A chip that tells no edges; the level is what a hand says.
struct Contact {
  bool active = false;
  bool pulled = false;
};

class PlainInput final : public InputLine {
 public:
  explicit PlainInput(const Contact& contact) : contact_(contact) {}
  int pollable() const override { return -1; }
  Result<bool> Level() override {
    if (contact_.pulled) return Pulled();
    return contact_.active;
  }
  Result<LineEdge> ReadEdge() override { return Fail(std::errc::io_error, "no edges here"); }

 private:
  const Contact& contact_;
};

class PolledLine : public ::testing::Test {
 protected:
  // The first edge that a look finds; looks are waited for as a program does.
  Result<LineEdge> Next(int looks = 50) {
    Result<LineEdge> edge = line_->ReadEdge();
    for (; looks > 0 && !edge && edge.error().cause == std::errc::resource_unavailable_try_again; --looks) {
      pollfd state{.fd = line_->pollable(), .events = POLLIN, .revents = 0};
      EXPECT_EQ(::poll(&state, 1, 10'000), 1);
      edge = line_->ReadEdge();
    }
    return edge;
  }

  Contact contact_;
  std::unique_ptr<InputLine> line_ =
      PollLine(std::make_unique<PlainInput>(contact_), std::chrono::milliseconds(1)).value();
};

TEST_F(PolledLine, TellsEachChangeOnce) {
  EXPECT_FALSE(Next(2)) << "nothing changed";
  for (const bool active : {true, false}) {
    contact_.active = active;
    const Time before = SteadyClock().now();
    const auto edge = Next();
    ASSERT_TRUE(edge) << edge.error().message();
    EXPECT_EQ(edge->active, active);
    EXPECT_GE(edge->at, before);
    EXPECT_FALSE(Next(2));
  }
}

TEST_F(PolledLine, ASwitchThatStoodSoWhenItWasTakenIsNoEdge) {
  contact_.active = true;
  EXPECT_TRUE(*line_->Level());
  EXPECT_FALSE(Next(2));
}

TEST_F(PolledLine, SaysThatTheChipWasPulled) {
  contact_.pulled = true;
  EXPECT_EQ(Next().error().cause, std::errc::no_such_device);
}

}  // namespace
}  // namespace kaori::gpio
