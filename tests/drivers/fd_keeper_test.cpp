// A descriptor that the fd keeper has: given to it, retrieved from it, and kept when either end dies.
#include "drivers/base/fd_keeper.h"

#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <thread>

#include "drivers/base/packet_socket.h"

namespace kaori::service {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.

class FdKeeperTest : public ::testing::Test {
 protected:
  FdKeeperTest() : loop_(EventLoop::Open().value()) {
    Start({});
    [[maybe_unused]] const auto ticks = loop_.Every(1ms, [this] {
      if (done_) loop_.Stop();
    });
  }
  ~FdKeeperTest() override { std::filesystem::remove(path_); }

  void Start(std::optional<UniqueFd> held) {
    keeper_.emplace(loop_, ListenForPackets(path_).value(), std::move(held), [this](int) { ++received_; });
    ASSERT_TRUE(keeper_->Open());
  }
  // What a program does, in a thread of its own, while the keeper's loop runs.
  template <class Program>
  void While(Program program) {
    done_ = false;
    std::thread thread([&] {
      program();
      done_ = true;
    });
    ASSERT_TRUE(loop_.Run());
    thread.join();
  }

  // Until the keeper's queue has room.
  UniqueFd Call() {
    auto call = ConnectToPeer(path_);
    while (!call && call.error().cause == std::errc::resource_unavailable_try_again)
      call = ConnectToPeer(path_);
    return std::move(call).value();
  }

  // Value that a counter among descriptors holds: tells two of them apart.
  static std::uint64_t Count(int fd) {
    std::uint64_t value = 0;
    return ::read(fd, &value, sizeof(value)) == sizeof(value) ? value : 0;
  }
  static UniqueFd Counter(unsigned value) { return UniqueFd(::eventfd(value, EFD_CLOEXEC | EFD_NONBLOCK)); }

  const std::string path_ =
      (std::filesystem::temp_directory_path() / ("kaori-fdkeeper-" + std::to_string(::getpid()))).string();
  EventLoop loop_;
  std::optional<FdKeeper> keeper_;
  std::atomic<bool> done_ = false;
  int received_ = 0;
};

TEST_F(FdKeeperTest, GivesBackWhatWasEntrustedThoughItsOwnerIsGone) {
  While([&] {
    ASSERT_TRUE(GiveToKeeper(Counter(7).get(), path_));
    auto back = RetrieveFromKeeper(path_);
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(Count(back->get()), 7U);
  });
  EXPECT_EQ(received_, 1);
}

TEST_F(FdKeeperTest, GivesItAsOftenAsItIsAsked) {
  While([&] {
    ASSERT_TRUE(GiveToKeeper(Counter(7).get(), path_));
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(RetrieveFromKeeper(path_));
  });
}

TEST_F(FdKeeperTest, HoldsTheNewestOnly) {
  While([&] {
    ASSERT_TRUE(GiveToKeeper(Counter(7).get(), path_));
    ASSERT_TRUE(GiveToKeeper(Counter(9).get(), path_));
    EXPECT_EQ(Count(RetrieveFromKeeper(path_).value().get()), 9U);
  });
}

TEST_F(FdKeeperTest, SaysThatItHoldsNothing) {
  While([&] { EXPECT_EQ(RetrieveFromKeeper(path_).error().cause, std::errc::no_such_device); });
}

TEST_F(FdKeeperTest, GoesOnWithWhatAnEarlierKeeperHeld) {
  keeper_.reset();
  Start(Counter(5));
  While([&] { EXPECT_EQ(Count(RetrieveFromKeeper(path_).value().get()), 5U); });
  EXPECT_EQ(received_, 0);
}

TEST_F(FdKeeperTest, CallersWithNothingSensibleToSayAreHungUpOn) {
  While([&] {
    ASSERT_TRUE(GiveToKeeper(Counter(7).get(), path_));
    std::vector<UniqueFd> silent;
    for (int i = 0; i < 40; ++i) silent.push_back(Call());
    const auto rude = Call();
    const std::array<std::uint8_t, 3> words{'h', 'x', 0};
    EXPECT_TRUE(SendPacket(rude.get(), words));
    const auto empty_handed = Call();
    EXPECT_TRUE(SendPacket(empty_handed.get(), std::array<std::uint8_t, 1>{'h'}));
    auto held = RetrieveFromKeeper(path_);
    while (!held && held.error().cause == std::errc::resource_unavailable_try_again)
      held = RetrieveFromKeeper(path_);
    ASSERT_TRUE(held) << held.error().message();
    EXPECT_EQ(Count(held->get()), 7U);
  });
}

TEST(WithoutAKeeper, NothingIsEntrustedAndNothingFound) {
  EXPECT_TRUE(GiveToKeeper(0, ""));
  EXPECT_EQ(RetrieveFromKeeper("").error().cause, std::errc::no_such_device);
  EXPECT_FALSE(GiveToKeeper(0, "/nowhere/at/all"));
  EXPECT_FALSE(RetrieveFromKeeper("/nowhere/at/all"));
}

}  // namespace
}  // namespace kaori::service
