// Updates that the box makes by itself: which surfaces get one, when, and how often it is tried.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/surface/update_service.h"
#include "tests/appliance/programs/surface_box.h"

namespace kaori::surface_update {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using ::testing::HasSubstr;

constexpr Circumstances kInService{.in_service = true, .show_runs = false};

void PlayService(UpdateService& service, Box& box, const Circumstances& circumstances, Duration time) {
  for (Duration t{}; t < time; t += milliseconds(50)) {
    service.Step(circumstances, box.now);
    box.Play(milliseconds(50));
  }
}

TEST(SurfaceUpdateService, AnOlderSurfaceIsUpdatedInServiceAndNotBefore) {
  Box box;
  UpdateService service(
      box, {MakeUpdate(kVersion1), MakeUpdate(kVersion2), MakeUpdate(kVersion2, kStickPodImage)});
  const auto operations = box.flash.operations();
  PlayService(service, box, {.in_service = false}, minutes(1));
  EXPECT_EQ(box.flash.operations(), operations);
  PlayService(service, box, kInService, minutes(1));
  EXPECT_EQ(box.version, kVersion2);
  EXPECT_TRUE(surface::IsKept(box.flash, surface::Slot::kB));
  const auto updated = box.flash.operations();
  PlayService(service, box, kInService, minutes(10));
  EXPECT_EQ(box.flash.operations(), updated) << "it has that version";
}

TEST(SurfaceUpdateService, ASurfaceThatIsAsNewOrNewerIsLeftAlone) {
  Box box;
  UpdateService service(box, {MakeUpdate(kVersion1), MakeUpdate(kVersion1 - 1)});
  const auto operations = box.flash.operations();
  PlayService(service, box, kInService, minutes(1));
  EXPECT_EQ(box.flash.operations(), operations);
}

TEST(SurfaceUpdateService, TheLastDialBoxOfARunningShowWaitsForTheEndAndIsNamedOnce) {
  Box box;
  UpdateService service(box, {MakeUpdate(kVersion2)});
  ::testing::internal::CaptureStderr();
  PlayService(service, box, {.in_service = true, .show_runs = true, .dial_boxes = 7}, minutes(1));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("the surface at 1-4.1: this is the last dial box of a running show"));
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  EXPECT_EQ(box.version, kVersion1);
  PlayService(service, box, kInService, minutes(1));
  EXPECT_EQ(box.version, kVersion2);
}

TEST(SurfaceUpdateService, ASurfaceThatRefusesForItsChipsSakeIsLeftAlone) {
  Box box;
  box.refusing_version = kVersion1;
  UpdateService service(box, {MakeUpdate(kVersion2)});
  const auto operations = box.flash.operations();
  PlayService(service, box, kInService, minutes(1));
  EXPECT_EQ(box.flash.operations(), operations);
  EXPECT_FALSE(service.is_updating());
}

TEST(SurfaceUpdateService, WhatAChipDidNotTakeIsNotTriedOnItAgain) {
  Box box;
  box.deadly_version = kVersion2;
  box.deadly_after = milliseconds(50);
  UpdateService service(box, {MakeUpdate(kVersion2)});
  PlayService(service, box, kInService, minutes(1));
  EXPECT_EQ(box.version, kVersion1);
  EXPECT_FALSE(service.is_updating());
  const auto operations = box.flash.operations();
  PlayService(service, box, kInService, minutes(10));
  EXPECT_EQ(box.flash.operations(), operations);
}

TEST(SurfaceUpdateService, ASurfaceThatIsLeftWhileItTriesAnImageIsWatchedToTheEnd) {
  Box box;
  std::optional<UpdateService> service;
  service.emplace(box, std::vector{MakeUpdate(kVersion2)});
  while (box.version != kVersion2) PlayService(*service, box, kInService, milliseconds(50));
  service.emplace(box, std::vector{MakeUpdate(kVersion2)});
  EXPECT_FALSE(surface::IsKept(box.flash, surface::Slot::kB));
  PlayService(*service, box, kInService, minutes(1));
  EXPECT_TRUE(surface::IsKept(box.flash, surface::Slot::kB)) << "the program was started anew in between";
}

}  // namespace
}  // namespace kaori::surface_update
