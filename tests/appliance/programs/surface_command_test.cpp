// A technician's commands: a dial box with its real firmware takes those that it knows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/surface/surface_command.h"
#include "tests/appliance/programs/surface_box.h"

namespace kaori::surface_update {
namespace {

using ::testing::HasSubstr;

TEST(SurfaceCommand, IsReadFromAnOptionAndItsValue) {
  EXPECT_EQ(ParseCommand("lamp-test", "on")->number, 1);
  EXPECT_EQ(ParseCommand("lamp-test", "off")->number, 0);
  EXPECT_EQ(ParseCommand("brightness", "15")->operation, wire::SurfaceOperation::kBrightness);
  EXPECT_EQ(ParseCommand("calibrate", "end")->operation, wire::SurfaceOperation::kCalibrate);
  for (const auto& [option, value, wanted] :
       {std::tuple{"lamp-test", "yes", "--lamp-test: expected on or off"},
        {"calibrate", "", "--calibrate: expected begin or end"},
        {"brightness", "16", "--brightness: expected a whole number from 0 to 15"},
        {"brightness", "bright", "--brightness: expected a whole number from 0 to 15"}})
    EXPECT_THAT(ParseCommand(option, value).error().message(), HasSubstr(wanted));
}

TEST(SurfaceCommand, ReachesTheSurfaceAtItsPortAndARefusalIsSaidInWords) {
  Box box;
  EXPECT_EQ(GiveCommand(box, "1-4.1", *ParseCommand("brightness", "3")).value_or(""), "done");
  EXPECT_EQ(GiveCommand(box, "1-4.1", *ParseCommand("lamp-test", "on")).value_or(""), "done");
  EXPECT_EQ(box.lamps_now(), 0xFFFFFFFFU);
  EXPECT_EQ(GiveCommand(box, "1-4.1", *ParseCommand("lamp-test", "off")).value_or(""), "done");
  EXPECT_EQ(box.lamps_now(), 0U);
  const auto refused = GiveCommand(box, "1-4.1", *ParseCommand("calibrate", "begin"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message(), HasSubstr("it has no axes, was not told to begin"));
  box.PowerOff(std::chrono::seconds(1));
  EXPECT_EQ(GiveCommand(box, "1-4.1", *ParseCommand("lamp-test", "on")).error().cause,
            std::errc::no_such_device);
}

}  // namespace
}  // namespace kaori::surface_update
