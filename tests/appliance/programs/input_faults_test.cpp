// Buses and devices that are broken: the input service goes on and serves the others.
#include <sys/eventfd.h>

#include <algorithm>

#include <gtest/gtest.h>

#include "appliance/programs/input/input_service.h"
#include "firmware/wire/dial_box.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::input {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// How the one device of the bus behaves; it outlives the device.
struct Fault {
  std::errc read = std::errc::resource_unavailable_try_again;
  std::errc write{};
  std::errc ports{};
  Time stamp{};
  int reports = 0;  // Waiting.
  int opened = 0, written = 0, listed = 0;
  UniqueFd fd{::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK)};  // Readable at all times.
};

class FaultyBox final : public ports::HidChannel {
 public:
  explicit FaultyBox(Fault& fault) : fault_(fault) {
    identity_.port = "1-1";
    identity_.name = "box\nkaori-input: \x1b[2J all is well";
    identity_.descriptor.assign(wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end());
  }
  int pollable() const override { return fault_.fd.get(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override {
    if (fault_.reports == 0) return Fail(fault_.read, "read 1-1");
    --fault_.reports;
    const auto report = wire::Encode(wire::DialBoxReport{.turned = {1}});
    std::copy(report.begin(), report.end(), into.begin());
    return ports::HidInput{.at = fault_.stamp, .bytes = report.size()};
  }
  Result<void> Write(std::span<const std::uint8_t>) override {
    ++fault_.written;
    if (fault_.write != std::errc{}) return Fail(fault_.write, "write 1-1");
    return {};
  }

 private:
  Fault& fault_;
  ports::HidIdentity identity_;
};

class FaultyBus final : public ports::HidBus {
 public:
  explicit FaultyBus(Fault& fault) : fault_(fault) {}
  int pollable() const override { return fault_.fd.get(); }
  Result<std::vector<std::string>> Ports() override {
    ++fault_.listed;
    if (fault_.ports != std::errc{}) return Fail(fault_.ports, "list ports");
    return std::vector<std::string>{"1-1"};
  }
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string&) override {
    ++fault_.opened;
    return std::make_unique<FaultyBox>(fault_);
  }

 private:
  Fault& fault_;
};

class Faults : public ::testing::Test {
 protected:
  Faults() : board_(file_.Open()) {
    service_.emplace(board_, InputWriters::Acquire(board_).value(),
                     InputSources{.buses = {&bus_}, .lines = {}}, InputSettings{}, clock_);
  }
  void Play(Duration time) {
    for (Duration t{}; t < time; t += milliseconds(1)) {
      clock_.Advance(milliseconds(1));
      service_->Step();
    }
  }

  board::BoardFile file_;
  board::Board board_;
  ManualClock clock_;
  Fault fault_;
  FaultyBus bus_{fault_};
  std::optional<InputService> service_;
};

TEST_F(Faults, OfABusAreAskedAboutNowAndThenAndNotWaitedFor) {
  fault_.ports = std::errc::io_error;
  Play(seconds(2));
  EXPECT_LE(fault_.listed, 9);
  EXPECT_TRUE(service_->pollables().empty()) << "it would wake the program all the time";
  const auto generation = service_->generation();
  fault_.ports = {};
  Play(milliseconds(300));
  EXPECT_EQ(service_->attached_devices(), 1);
  EXPECT_NE(service_->generation(), generation);
  EXPECT_EQ(service_->pollables().size(), 2u);
}

TEST_F(Faults, OfABusThatHasNewsAllTheTimeAreNoNewsOfTheOthers) {
  Fault quiet;
  quiet.fd = UniqueFd(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  FaultyBus other(quiet);
  board::BoardFile file;
  const board::Board board = file.Open();
  InputService service(board, InputWriters::Acquire(board).value(),
                       InputSources{.buses = {&bus_, &other}, .lines = {}}, InputSettings{}, clock_);
  for (int n = 0; n < 100; ++n) {
    clock_.Advance(milliseconds(1));
    service.Step();
  }
  EXPECT_EQ(fault_.listed, 100);
  EXPECT_EQ(quiet.listed, 1);
}

TEST_F(Faults, OfADeviceThatIsGoneAsSoonAsItIsOpenedDoNotKeepTheServiceBusy) {
  fault_.read = std::errc::no_such_device;
  Play(seconds(2));
  EXPECT_GE(fault_.opened, 4);
  EXPECT_LE(fault_.opened, 9);
  fault_.read = std::errc::resource_unavailable_try_again;
  Play(milliseconds(300));
  EXPECT_EQ(service_->attached_devices(), 1);
}

TEST_F(Faults, OfTransfersDetachADeviceOnlyWhenTheyDoNotEnd) {
  Play(milliseconds(5));
  fault_.read = std::errc::io_error;
  Play(milliseconds(20));
  EXPECT_EQ(fault_.opened, 1) << "a few are harmless";
  Play(milliseconds(100));
  EXPECT_EQ(fault_.opened, 2) << "this many mean a dead device, which is opened again";
}

// The kernel may delay the program for seconds with each report that a box does not accept.
TEST_F(Faults, OfTheLampsAreTriedThreeTimesAndThenLeftUntilTheNextPlug) {
  fault_.write = std::errc::io_error;
  Play(seconds(30));
  EXPECT_EQ(fault_.written, 3);
  EXPECT_EQ(service_->attached_devices(), 1) << "its dials still count";
  fault_.write = {};
  fault_.read = std::errc::no_such_device;
  Play(milliseconds(1));
  fault_.read = std::errc::resource_unavailable_try_again;
  Play(milliseconds(300));
  EXPECT_EQ(fault_.written, 4);
}

TEST_F(Faults, OfTheLampsThatAreAMinuteApartAreForgotten) {
  const auto play = [&](Duration time) {
    for (const Time end = clock_.now() + time; clock_.now() < end;) {
      clock_.Advance(milliseconds(10));
      service_->Step();
    }
  };
  for (int minute = 0; minute < 5; ++minute) {
    fault_.write = std::errc::io_error;
    play(seconds(2));
    fault_.write = {};
    play(seconds(58));
  }
  const int before = fault_.written;
  play(seconds(10));
  EXPECT_GE(fault_.written - before, 9) << "they are still told again";
}

TEST_F(Faults, OfABoxThatForgetsItsLampsLastASecond) {
  Play(milliseconds(100));
  const int before = fault_.written;
  Play(seconds(10));
  EXPECT_GE(fault_.written - before, 9) << "they are told again though none has changed";
  EXPECT_LE(fault_.written - before, 11);
}

TEST_F(Faults, OfTheLampsOfABusyBoxAreNone) {
  fault_.write = std::errc::resource_unavailable_try_again;
  Play(milliseconds(100));
  fault_.write = {};
  const int before = fault_.written;
  Play(milliseconds(2));
  EXPECT_EQ(fault_.written, before + 1);
}

TEST_F(Faults, OfANameReachTheLogAsQuestionMarks) {
  testing::internal::CaptureStderr();
  Play(milliseconds(2));
  const std::string log = testing::internal::GetCapturedStderr();
  EXPECT_NE(log.find("box?kaori-input: ?[2J all is well"), std::string::npos) << log;
  EXPECT_EQ(std::ranges::count(log, '\n'), 1);
}

TEST_F(Faults, OfAClockThatLiesDoNotReachTheBoard) {
  for (const Time lie : {Time::min(), Time::max(), Time{} - Duration(1)}) {
    fault_.stamp = lie;
    fault_.reports = 1;
    Play(milliseconds(2));
    const Time at = board_.Read<board::Surface>().at;
    EXPECT_LE(at, clock_.now());
    EXPECT_GE(at, clock_.now() - seconds(2));
  }
  EXPECT_EQ(board_.Read<board::Surface>().value.counts[0], 3);
}

}  // namespace
}  // namespace kaori::input
