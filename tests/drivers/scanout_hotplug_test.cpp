// The kernel's uevents of screens that come and go.
#include "drivers/scanout/hotplug_monitor.h"

#include <gtest/gtest.h>

#include <string>

namespace kaori::scanout {
namespace {

// As the kernel sends it: strings, each with a zero behind it.
bool Reports(std::initializer_list<const char*> fields) {
  std::string bytes;
  for (const char* field : fields) bytes.append(field).push_back('\0');
  return IsScreenHotplug(bytes);
}

TEST(HotplugUevent, AScreenThatCameIsReported) {
  EXPECT_TRUE(Reports({"change@/devices/pci0000:00/0000:00:02.0/drm/card0", "ACTION=change",
                       "DEVPATH=/devices/pci0000:00/0000:00:02.0/drm/card0", "SUBSYSTEM=drm", "HOTPLUG=1",
                       "CONNECTOR=34", "DEVNAME=dri/card0", "SEQNUM=1234"}));
}

TEST(HotplugUevent, OtherDevicesAreNoScreens) {
  EXPECT_FALSE(Reports({"add@/devices/usb1", "SUBSYSTEM=usb", "HOTPLUG=1"}));
  EXPECT_FALSE(Reports({"add@/devices/x/drm/card0", "SUBSYSTEM=drm"}));
  EXPECT_FALSE(Reports({"SUBSYSTEM=drmx", "HOTPLUG=10"}));
  EXPECT_FALSE(Reports({}));
}

TEST(HotplugUevent, OneThatBreaksOffIsReadAsFarAsItGoes) {
  const std::string whole("x\0SUBSYSTEM=drm\0HOTPLUG=1", 25);
  EXPECT_TRUE(IsScreenHotplug(whole)) << "the last zero is lost";
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(IsScreenHotplug(std::span(whole).first(length))) << length;
}

TEST(ScreenHotplugMonitor, OneThatListensToNothingHearsNothing) {
  HotplugMonitor closed;
  EXPECT_FALSE(closed.Drain());
}

TEST(ScreenHotplugMonitor, NeverWaits) {
  auto hotplug = HotplugMonitor::Open();
  if (!hotplug) GTEST_SKIP() << hotplug.error().message();
  hotplug->Drain();
  EXPECT_FALSE(hotplug->Drain()) << "no screen comes in a test";
}

}  // namespace
}  // namespace kaori::scanout
