// The contract of ports::HidBus.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/hid_channel.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A bus, and the devices that a person plugs into it.
class HidBusSubject : public AnySubject {
 public:
  virtual ports::HidBus& bus() = 0;
  // How many devices can be plugged in; and whether they are soldered in: then the first is there from the start.
  virtual int sockets() const { return 2; }
  virtual bool is_fixed() const { return false; }
  // Plugs device `n` in; the name of its port. Pulls it.
  virtual std::string Plug(int n) = 0;
  virtual void Unplug(int n) = 0;
  // A little time passes for the devices: what they have to say comes to the bus.
  virtual void Pass() {}
  // False where the bus looks now and then, and its descriptor is readable at any such time.
  virtual bool is_told() const { return true; }

  ManualClock clock;
};

class HidBusContract : public Contract<HidBusSubject> {
 protected:
  using Names = std::vector<std::string>;
  ports::HidBus& bus() { return subject_->bus(); }

  // The ports once they are these, or those that there are after a while: devices and kernels have threads of their own.
  Names Await(const Names& wanted) {
    auto ports = bus().Ports();
    for (int n = 0; n < kLooks && ports && *ports != wanted; ++n) {
      subject_->Pass();
      static_cast<void>(IsReadable(bus().pollable(), 1));
      ports = bus().Ports();
    }
    EXPECT_TRUE(ports);
    return ports.value_or(Names{"an error"});
  }
  // A device is busy while it has not answered yet.
  Result<std::unique_ptr<ports::HidChannel>> Open(const std::string& port) {
    auto channel = bus().Open(port);
    for (int n = 0; n < kLooks && Cause(channel) == std::errc::device_or_resource_busy; ++n) {
      subject_->Pass();
      static_cast<void>(IsReadable(bus().pollable(), 1));
      static_cast<void>(bus().Ports());
      channel = bus().Open(port);
    }
    return channel;
  }
  static constexpr int kLooks = 5000;
};

TEST_P(HidBusContract, HasNoPortsBeforeSomethingIsPluggedIn) {
  if (subject_->is_fixed()) GTEST_SKIP() << "its devices are soldered in";
  EXPECT_EQ(Await({}), Names{});
  EXPECT_EQ(Cause(bus().Open("nowhere")), std::errc::no_such_device);
}

TEST_P(HidBusContract, ListsThePortsThatHaveADeviceByTheirNames) {
  Names wanted;
  for (int n = 0; n < subject_->sockets(); ++n) wanted.push_back(subject_->Plug(n));
  std::ranges::sort(wanted);
  EXPECT_EQ(Await(wanted), wanted);
  EXPECT_EQ(Await(wanted), wanted) << "a look changes nothing";
}

TEST_P(HidBusContract, IsReadableWhenADeviceCameAndNoMoreOnceItWasListed) {
  if (subject_->is_fixed()) GTEST_SKIP() << "its devices are soldered in";
  ASSERT_EQ(Await({}), Names{});
  const std::string port = subject_->Plug(0);
  EXPECT_TRUE(IsReadable(bus().pollable(), kLongestWait_ms));
  EXPECT_EQ(Await({port}), Names{port});
  if (subject_->is_told()) {
    EXPECT_FALSE(IsReadable(bus().pollable()));
  }
}

TEST_P(HidBusContract, OpensTheDeviceOfAPortWhoIsKnownByTheNameOfThatPort) {
  const std::string port = subject_->Plug(0);
  ASSERT_EQ(Await({port}), Names{port});
  const auto channel = Open(port);
  ASSERT_TRUE(channel) << channel.error().message();
  EXPECT_EQ((*channel)->identity().port, port);
  EXPECT_FALSE((*channel)->identity().descriptor.empty());
  EXPECT_EQ(Await({port}), Names{port}) << "an opened device is there all the same";
}

TEST_P(HidBusContract, SaysNoSuchDeviceOfAPortWithoutOne) {
  const std::string port = subject_->Plug(0);
  ASSERT_EQ(Await({port}), Names{port});
  EXPECT_EQ(Cause(bus().Open(port + "-and-none")), std::errc::no_such_device);
}

TEST_P(HidBusContract, ForgetsADeviceThatIsPulledAndListsItAgainWhenItComesBack) {
  if (subject_->is_fixed()) GTEST_SKIP() << "its devices are soldered in";
  const std::string port = subject_->Plug(0);
  ASSERT_EQ(Await({port}), Names{port});
  subject_->Unplug(0);
  EXPECT_EQ(Await({}), Names{});
  EXPECT_EQ(Cause(bus().Open(port)), std::errc::no_such_device);
  EXPECT_EQ(subject_->Plug(0), port);
  ASSERT_EQ(Await({port}), Names{port});
  EXPECT_TRUE(Open(port));
}

TEST_P(HidBusContract, OpensADeviceAgainOnceItsChannelIsGone) {
  const std::string port = subject_->Plug(0);
  ASSERT_EQ(Await({port}), Names{port});
  for (int n = 0; n < 2; ++n) {
    const auto channel = Open(port);
    ASSERT_TRUE(channel) << channel.error().message();
  }
}

}  // namespace kaori::contracts
