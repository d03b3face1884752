// The kernel's word of screens that come and go.
#include "drivers/scanout/hotplug.h"

#include <gtest/gtest.h>

#include <string>

namespace kaori::scanout {
namespace {

// As the kernel sends it: strings, each with a zero behind it.
bool Speaks(std::initializer_list<const char*> words) {
  std::string bytes;
  for (const char* word : words) bytes.append(word).push_back('\0');
  return SpeaksOfScreens(bytes);
}

TEST(HotplugWords, AScreenThatCameIsUnderstood) {
  EXPECT_TRUE(Speaks({"change@/devices/pci0000:00/0000:00:02.0/drm/card0", "ACTION=change",
                      "DEVPATH=/devices/pci0000:00/0000:00:02.0/drm/card0", "SUBSYSTEM=drm", "HOTPLUG=1",
                      "CONNECTOR=34", "DEVNAME=dri/card0", "SEQNUM=1234"}));
}

TEST(HotplugWords, WhatIsOfOtherThingsIsPassedOver) {
  EXPECT_FALSE(Speaks({"add@/devices/usb1", "SUBSYSTEM=usb", "HOTPLUG=1"}));
  EXPECT_FALSE(Speaks({"add@/devices/x/drm/card0", "SUBSYSTEM=drm"}));
  EXPECT_FALSE(Speaks({"SUBSYSTEM=drmx", "HOTPLUG=10"}));
  EXPECT_FALSE(Speaks({}));
}

TEST(HotplugWords, WordsThatBreakOffAreReadAsFarAsTheyGo) {
  const std::string whole("x\0SUBSYSTEM=drm\0HOTPLUG=1", 25);
  EXPECT_TRUE(SpeaksOfScreens(whole)) << "the last zero is lost";
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(SpeaksOfScreens(std::span(whole).first(length))) << length;
}

TEST(HotplugWords, WhoListensToNothingHearsNothing) {
  Hotplug deaf;
  EXPECT_FALSE(deaf.Heard());
}

TEST(HotplugWords, ListeningNeverWaits) {
  auto hotplug = Hotplug::Open();
  if (!hotplug) GTEST_SKIP() << hotplug.error().message();
  hotplug->Heard();
  EXPECT_FALSE(hotplug->Heard()) << "no screen comes in a test";
}

}  // namespace
}  // namespace kaori::scanout
