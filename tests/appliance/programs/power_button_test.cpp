// The power button: what is a press, and what is none.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "appliance/programs/power/power_button.h"

namespace kaori::power {
namespace {

// A pipe gives events as evdev does.
class PowerButtonTest : public ::testing::Test {
 protected:
  PowerButtonTest() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(::pipe2(ends, O_NONBLOCK | O_CLOEXEC), 0);
    button_.emplace(UniqueFd(ends[0]));
    machine_ = UniqueFd(ends[1]);
  }
  void Tell(std::uint16_t type, std::uint16_t code, std::int32_t value) const {
    input_event event{};
    event.type = type;
    event.code = code;
    event.value = value;
    ASSERT_EQ(::write(machine_.get(), &event, sizeof(event)), ssize_t{sizeof(event)});
  }

  std::optional<PowerButton> button_;
  UniqueFd machine_;
};

TEST_F(PowerButtonTest, IsPressedWhenItGoesDown) {
  EXPECT_EQ(button_->ReadPress(), false);
  Tell(EV_KEY, KEY_POWER, 1);
  Tell(EV_SYN, SYN_REPORT, 0);
  EXPECT_EQ(button_->ReadPress(), true);
  EXPECT_EQ(button_->ReadPress(), false) << "each press counts once";
}

TEST_F(PowerButtonTest, IsNotPressedByItsReleaseItsRepetitionOrAnotherKey) {
  Tell(EV_KEY, KEY_POWER, 0);
  Tell(EV_KEY, KEY_POWER, 2);
  Tell(EV_KEY, KEY_SLEEP, 1);
  Tell(EV_REL, KEY_POWER, 1);
  EXPECT_EQ(button_->ReadPress(), false);
}

TEST_F(PowerButtonTest, IsSeenAmongManyEvents) {
  for (int n = 0; n < 100; ++n) Tell(EV_SYN, SYN_REPORT, 0);
  Tell(EV_KEY, KEY_POWER, 1);
  for (int n = 0; n < 100; ++n) Tell(EV_SYN, SYN_REPORT, 0);
  EXPECT_EQ(button_->ReadPress(), true);
}

TEST_F(PowerButtonTest, ThatIsGoneIsAnError) {
  machine_.reset();
  const auto pressed = button_->ReadPress();
  ASSERT_FALSE(pressed);
  EXPECT_EQ(pressed.error().cause, std::errc::no_such_device);
}

TEST(PowerButtons, AreNotFoundAmongFilesThatAreNoDevices) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / ("power-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "event0");
  std::filesystem::create_symlink("/dev/null", folder / "event1");
  EXPECT_TRUE(PowerButton::FindAll(folder).empty());
  EXPECT_TRUE(PowerButton::FindAll(folder / "nothing").empty());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace kaori::power
