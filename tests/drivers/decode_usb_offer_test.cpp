// The reader of USB descriptors sees each interface that the kernel sees, also where a device hides one, and refuses what is torn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "drivers/decode/usb_offer.h"
#include "hw-sim/devices/misleading_descriptors.h"
#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/uvc_descriptors.h"
#include "tests/drivers/usb_readers.h"

namespace kaori::decode {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::KernelReads;
using tests::UsbDeviceDescriptor;
using tests::UsbFile;

constexpr OfferedInterface kMouse{UsbClass::kInput, 1, 2}, kKeyboard{UsbClass::kInput, 1, 1},
    kStorage{UsbClass::kStorage, 6, 0x50};

UsbFile Interface(const OfferedInterface& one, std::uint8_t number = 0, std::uint8_t setting = 0) {
  return {9, 4, number, setting, 0, static_cast<std::uint8_t>(one.kind), one.subclass, one.protocol, 0};
}

UsbFile Configuration(std::initializer_list<UsbFile> parts) {
  UsbFile all;
  for (const UsbFile& part : parts) all.insert(all.end(), part.begin(), part.end());
  return sim::ConfigurationOf(1, all);
}

// The file of a device in sysfs that has these configurations.
UsbFile FileOf(const std::vector<UsbFile>& configurations) {
  return KernelReads(UsbDeviceDescriptor(), configurations).value().file;
}

// Why it is refused; empty where it is not.
std::string Refusal(const UsbFile& file) {
  const auto offer = ReadUsbOffer(file);
  return offer ? "" : offer.error().message();
}

TEST(UsbOffer, IsWhoTheDeviceSaysItIsAndEverySettingOfEveryConfiguration) {
  auto kernel =
      KernelReads(UsbDeviceDescriptor(0x0403, 0x6001),
                  {Configuration({Interface(kMouse), Interface(kKeyboard, 0, 1)}),
                   Configuration({Interface(kMouse), {7, 5, 0x81, 3, 8, 0, 10}, Interface(kStorage, 1)})});
  const auto offer = ReadUsbOffer(kernel->file);
  ASSERT_TRUE(offer) << offer.error().message();
  EXPECT_EQ(offer->vendor, 0x0403);
  EXPECT_EQ(offer->product, 0x6001);
  EXPECT_THAT(offer->interfaces, ElementsAre(kMouse, kKeyboard, kMouse, kStorage));
}

TEST(UsbOffer, OfTheSimulatedCameraIsVideoAlone) {
  const auto offer = ReadUsbOffer(FileOf({sim::UvcConfiguration({})}));
  ASSERT_TRUE(offer) << offer.error().message();
  EXPECT_THAT(offer->interfaces, ElementsAre(OfferedInterface{UsbClass::kCamera, 1, 0},
                                             OfferedInterface{UsbClass::kCamera, 2, 0}));
}

// What udev makes of each is shown too: without that the test would not say why there is a reader of our own.
TEST(UsbOffer, HasTheStorageThatUdevDoesNotSee) {
  for (const UsbFile& misleading :
       {sim::StorageBehindAShortDescriptor(), sim::StorageBehindManySettings(), sim::StorageAtTheVeryEnd()}) {
    const auto kernel = KernelReads(UsbDeviceDescriptor(), {misleading});
    EXPECT_THAT(kernel->interfaces, Contains(kStorage)) << "the kernel would bind usb-storage";
    EXPECT_THAT(tests::UdevReads(kernel->file), Not(HasSubstr(":08")));
    const auto offer = ReadUsbOffer(kernel->file);
    ASSERT_TRUE(offer) << offer.error().message();
    EXPECT_THAT(offer->interfaces, Contains(kStorage));
  }
}

TEST(UsbOffer, IsReadPastAConfigurationThatIsShorterThanItSays) {
  // The kernel stops at the first byte that is no length; what it has kept is followed by the next configuration.
  UsbFile spoilt = Configuration({Interface(kMouse), {0, 0, 0, 0}});
  const auto kernel = KernelReads(UsbDeviceDescriptor(), {spoilt, Configuration({Interface(kStorage)})});
  EXPECT_THAT(ReadUsbOffer(kernel->file)->interfaces, ElementsAre(kMouse, kStorage));
}

TEST(UsbOffer, OfATornBlockIsNoneWhereverItEnds) {
  const UsbFile whole = FileOf({Configuration({Interface(kMouse), {7, 5, 0x81, 3, 8, 0, 10}})});
  ASSERT_EQ(Refusal(whole), "");
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    const UsbFile torn(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes));
    // Cut between two descriptors it is a shorter device, and that is for the kernel to say.
    if (bytes == whole.size() - 7) continue;
    EXPECT_NE(Refusal(torn), "") << "cut to " << bytes << " bytes";
  }
}

TEST(UsbOffer, NamesTheByteAndTheReasonOfARefusal) {
  const UsbFile good = FileOf({Configuration({Interface(kMouse)})});
  const auto with = [&](UsbFile more) {
    UsbFile file = good;
    file.insert(file.end(), more.begin(), more.end());
    return Refusal(file);
  };
  EXPECT_EQ(with({1, 4}), "byte 36: a descriptor of length 1");
  EXPECT_EQ(with({0}), "byte 36: a descriptor of length 0");
  EXPECT_EQ(with({9, 4, 1}), "byte 36: a descriptor of length 9, of which 3 bytes are there");
  EXPECT_EQ(with({5, 4, 1, 0, 8}), "byte 36: an interface of less than 9 bytes");
  EXPECT_EQ(with({2, 1}), "byte 36: a second device descriptor");
  EXPECT_EQ(with({2, 2}), "byte 36: a configuration of less than 9 bytes");
  EXPECT_EQ(with(Configuration({Interface(kStorage)})),
            "byte 17: 1 configurations are said, and 2 are there");
  EXPECT_EQ(Refusal({}), "byte 0: no device descriptor");
  UsbFile other = good;
  other[1] = 2;
  EXPECT_EQ(Refusal(other), "byte 0: no device descriptor");
  other = good;
  other[17] = 2;
  EXPECT_EQ(Refusal(other), "byte 17: 2 configurations are said, and 1 are there");
  other = UsbDeviceDescriptor();
  EXPECT_EQ(Refusal(other), "byte 18: no interface");
  const UsbFile before = Interface(kStorage);
  other.insert(other.end(), before.begin(), before.end());
  EXPECT_EQ(Refusal(other), "byte 18: no configuration begins here");
}

// sysfs gives 65553 bytes, and of two configurations the second could lie behind them.
TEST(UsbOffer, OfMoreBytesOrInterfacesThanAnHonestDeviceHasIsNone) {
  UsbFile padding;
  while (padding.size() + 255 < 65'535 - 18)
    padding.insert(padding.end(), {255, 0xFF}), padding.resize(padding.size() + 253);
  const auto hidden = KernelReads(UsbDeviceDescriptor(), {Configuration({Interface(kMouse), padding}),
                                                          Configuration({Interface(kStorage)})});
  EXPECT_EQ(ReadUsbOffer(hidden->file).error().cause, std::errc::file_too_large);
  UsbFile many = UsbDeviceDescriptor();
  many[17] = 1;
  for (const UsbFile& part : {Configuration({})}) many.insert(many.end(), part.begin(), part.end());
  for (std::size_t n = 0; n <= kMostOfferedInterfaces; ++n) {
    const UsbFile one = Interface(kMouse, static_cast<std::uint8_t>(n));
    many.insert(many.end(), one.begin(), one.end());
  }
  EXPECT_THAT(Refusal(many), HasSubstr("more than 1024 interfaces"));
  many.resize(many.size() - 9);
  EXPECT_EQ(Refusal(many), "");
}

// Whatever a device sends: what the kernel keeps of it is in the offer, or there is none.
TEST(UsbOffer, MissesNothingThatTheKernelKeepsOfSpoiltDescriptors) {
  std::mt19937 random(1993);
  const auto draw = [&](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
  };
  int read = 0;
  for (int n = 0; n < 20'000; ++n) {
    std::vector<UsbFile> sent{
        Configuration({Interface(kMouse), {7, 5, 0x81, 3, 8, 0, 10}, Interface(kStorage, 1)}),
        Configuration({Interface(kKeyboard), {2, 0xFF}, Interface(kStorage, 1), {3, 0x24, 0}})};
    for (std::size_t spoilt = draw(4); spoilt > 0; --spoilt) {
      UsbFile& one = sent[draw(2)];
      one[draw(one.size())] = static_cast<std::uint8_t>(draw(2) == 0 ? draw(12) : draw(256));
    }
    const auto kernel = KernelReads(UsbDeviceDescriptor(), sent);
    if (!kernel) continue;
    const auto offer = ReadUsbOffer(kernel->file);
    if (!offer) continue;
    ++read;
    for (const OfferedInterface& one : kernel->interfaces) ASSERT_THAT(offer->interfaces, Contains(one)) << n;
  }
  EXPECT_GT(read, 10'000);
}

}  // namespace
}  // namespace kaori::decode
