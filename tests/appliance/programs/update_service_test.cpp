// kaori-shows asks and kaori-update answers, over a real socket.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <fstream>

#include "appliance/programs/update/service.h"
#include "appliance/programs/update/trial.h"
#include "drivers/base/packet_socket.h"
#include "hw-sim/devices/boot_loader.h"
#include "tests/appliance/programs/update_fixture.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::update {
namespace {

class UpdateServiceTest : public UpdateTest {
 protected:
  UpdateServiceTest()
      : service_(ListenForPackets(socket_).value(),
                 {.running = running_,
                  .keys = [this] { return keys_; },
                  .open_disk = [this]() -> Result<Disk> {
                    return Disk{disk_.Partition(kRootB, kMiB), disk_.Partition(kVerityB, kMiB),
                                disk_.Partition(0, tests::FatFixture::kBytes), kKernelB, kKernel};
                  },
                  .open_choice = [this]() -> Result<std::unique_ptr<ports::BootChoice>> {
                    return std::make_unique<Lent>(choice_);
                  },
                  .restart = [this] { ++restarts_; },
                  .may_work = [this] { return may_work_; }},
                 notes_) {}

  UniqueFd File(const Bytes& content) {
    const std::string name = folder_.path() + "/a.kaoriupdate";
    std::ofstream(name, std::ios::binary)
        .write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()))
        .flush();
    return UniqueFd(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
  }
  void Step() {
    clock_.Advance(UpdateService::kPeriod);
    service_.Step(clock_.now());
  }
  // The last answer to a request.
  Answer Ask(std::string_view request, const Bytes& content = {}) {
    const UniqueFd file = File(content);
    auto caller = Caller::Ask(socket_, request, file.get());
    EXPECT_TRUE(caller);
    for (int n = 0; n < 1000; ++n) {
      Step();
      if (auto answer = caller->Read(); answer && answer->is_last()) {
        *caller = Caller::Ask(socket_, kIsWaiting).value();
        Step();
        return *answer;
      }
    }
    ADD_FAILURE() << "no answer";
    return {};
  }

  // The loader outlives what is opened of it.
  class Lent final : public ports::BootChoice {
   public:
    explicit Lent(sim::BootLoader& loader) : loader_(loader) {}
    Result<ports::Slot> Default() override { return loader_.Default(); }
    ports::Slot running() const override { return loader_.running(); }
    Result<void> TryOnce(ports::Slot slot) override { return loader_.TryOnce(slot); }
    Result<void> Confirm(ports::Slot slot) override { return loader_.Confirm(slot); }

   private:
    sim::BootLoader& loader_;
  };

  ManualClock clock_;
  sim::TempFolder folder_;
  std::string socket_ = folder_.path() + "/socket";
  sim::BootLoader choice_;
  int restarts_ = 0;
  bool may_work_ = true;
  UpdateService service_;
};

TEST_F(UpdateServiceTest, SaysWhatLiesOnAStickAndWritesNothing) {
  const Answer fits = Ask(kLook, BundleOf(6));
  EXPECT_EQ(fits.message, Message::kFits);
  EXPECT_EQ(fits.version, 6U);
  EXPECT_EQ(fits.detail, "what is new");
  EXPECT_EQ(Ask(kLook, BundleOf(4)).message, Message::kOlder);
  EXPECT_EQ(Ask(kLook, Bytes(10, 'x')).message, Message::kNotAnUpdate);
  EXPECT_TRUE(disk_.events().empty());
}

TEST_F(UpdateServiceTest, BringsAnUpdateInAndRestartsWhenItIsAsked) {
  EXPECT_EQ(Ask(kRestart).message, Message::kNothingWaits);
  EXPECT_EQ(Ask(kInstall, BundleOf(6)).message, Message::kWaits);
  EXPECT_EQ(Ask(kIsWaiting).version, 6U);
  EXPECT_EQ(restarts_, 0);
  EXPECT_EQ(Ask(kRestart).message, Message::kRestarts);
  EXPECT_EQ(restarts_, 1);
  EXPECT_EQ(choice_.SwitchOn(), ports::Slot::kB);
  EXPECT_EQ(Ask(kInstall, BundleOf(7)).message, Message::kTrialRuns);
}

TEST_F(UpdateServiceTest, GoesBackToTheSystemBeforeUntilItsSlotIsWrittenAnew) {
  ASSERT_EQ(Ask(kInstall, BundleOf(6)).message, Message::kWaits);
  ASSERT_EQ(Ask(kRestart).message, Message::kRestarts);
  choice_.SwitchOn();
  ASSERT_TRUE(ConfirmTried(choice_, notes_));
  const Answer back = Ask(kRestart);
  EXPECT_EQ(back.message, Message::kRestarts);
  EXPECT_EQ(back.version, 5U);
  EXPECT_EQ(notes_.pending, (Pending{5, ports::Slot::kA, 1}));
  EXPECT_EQ(choice_.SwitchOn(), ports::Slot::kA);
  ASSERT_TRUE(ConfirmTried(choice_, notes_));
  EXPECT_EQ(notes_.before->slot, ports::Slot::kB) << "and forward again";
  auto caller = Caller::Ask(socket_, kInstall, File(BundleOf(6)).get());
  for (int n = 0; n < 20 && notes_.before; ++n) Step();
  EXPECT_EQ(notes_.before, std::nullopt) << "what was there is half written over";
}

TEST_F(UpdateServiceTest, GivesAnUpdateUpWhenWhoeverAskedIsGone) {
  const UniqueFd file = File(BundleOf(6));
  auto caller = std::make_optional(Caller::Ask(socket_, kInstall, file.get()).value());
  Step();
  Step();
  caller.reset();
  for (int n = 0; n < 1000; ++n) Step();
  EXPECT_EQ(notes_.pending, std::nullopt);
  EXPECT_EQ(Ask(kInstall, BundleOf(6)).message, Message::kWaits) << "it can be taken again";
}

TEST_F(UpdateServiceTest, WritesNothingWhileTheFaceNeedsTheBox) {
  may_work_ = false;
  const UniqueFd file = File(BundleOf(6));
  auto caller = Caller::Ask(socket_, kInstall, file.get());
  for (int n = 0; n < 1000; ++n) Step();
  EXPECT_TRUE(disk_.events().empty());
  may_work_ = true;
  for (int n = 0; n < 1000; ++n) Step();
  EXPECT_TRUE(notes_.pending.has_value());
}

TEST_F(UpdateServiceTest, IsIdleWhenNobodyHasAskedForAWhile) {
  Step();
  EXPECT_FALSE(service_.IsIdle(clock_.now()));
  EXPECT_TRUE(service_.IsIdle(clock_.now() + UpdateService::kPatience + UpdateService::kPeriod));
}

TEST(UpdateAnswers, AreTheSameAfterTheirWayAndOtherTextsAreNone) {
  const Answer answer{Message::kOlder, 12, 345, "this box runs version 13"};
  EXPECT_EQ(ParseAnswer(Format(answer)), answer);
  for (const char* text : {"", "1 2", "99 1 0 x", "a 1 0 x", "-1 1 0 x"})
    EXPECT_EQ(ParseAnswer(text), std::nullopt) << text;
  EXPECT_LE(Format({Message::kOlder, 1, 0, std::string(5000, 'x')}).size(), kLongestPacket_bytes);
}

}  // namespace
}  // namespace kaori::update
