// Updates and what is stored, on a flash whose power goes at any moment.
#include <gtest/gtest.h>
#include <sodium.h>

#include <string_view>
#include <vector>

#include "firmware/surface/flash_store.h"
#include "firmware/surface/sha256.h"
#include "firmware/surface/slots.h"
#include "firmware/surface/updater.h"
#include "tests/firmware/figures.h"
#include "tests/firmware/proof/flash_proof.h"
#include "tests/firmware/proof/nor.h"

namespace kaori::surface {
namespace {

using proof::Nor;
constexpr std::uint32_t kProduct = 0x12090001;
constexpr std::uint32_t kFloor = 0x10000;

std::vector<std::uint8_t> ImageOf(std::uint8_t fill, std::size_t bytes = 5000) {
  return std::vector<std::uint8_t>(bytes, fill);
}

wire::SurfaceImage Describe(std::span<const std::uint8_t> image, std::uint32_t version) {
  return {.product = kProduct,
          .length = static_cast<std::uint32_t>(image.size()),
          .version = version,
          .sha256 = Sha256Of(image)};
}

// A surface with version 1.0 in slot A, confirmed.
class SurfaceUpdate : public ::testing::Test {
 protected:
  SurfaceUpdate() {
    const auto image = ImageOf(1);
    for (std::uint32_t at = 0; at < image.size(); at += kPageBytes)
      flash.Program(ImageAt(Slot::kA) + at,
                    std::span(image).subspan(at, std::min<std::size_t>(kPageBytes, image.size() - at)));
    WriteHeader(flash, Slot::kA, {.generation = 1, .image = Describe(image, 0x10000)});
    Keep(flash, Slot::kA);
  }
  bool Send(std::span<const std::uint8_t> image) {
    for (std::uint32_t at = 0; at < image.size(); at += wire::kSurfaceDataBytes)
      if (!updater.Data(at, image.subspan(at, std::min(image.size() - at, wire::kSurfaceDataBytes))))
        return false;
    return true;
  }
  bool Update(std::span<const std::uint8_t> image, std::uint32_t version) {
    return updater.Begin(Describe(image, version)) && Send(image) && updater.End();
  }

  Nor flash;
  Updater updater{flash, {.slot = Slot::kA, .product = kProduct, .oldest_version = kFloor}};
};

TEST(ASurfacesFlash, SurvivesACutAtEveryOperation) {
  const auto proof = proof::ProveCuts(5 * proof::Effort());
  EXPECT_GE(proof.cuts, 1000u);
  EXPECT_EQ(proof.dead, 0u);
  EXPECT_EQ(proof.unexpected, 0u);
  EXPECT_EQ(proof.lost, 0u);
  proof::Figure("update_cuts", proof.cuts);
  proof::Figure("update_cuts_dead", proof.dead + proof.unexpected + proof.lost);
}

TEST(ASurfacesFlash, NeitherTakesNorKeepsWhatItMayNot) {
  EXPECT_EQ(proof::ProveTrials(20), 0u);
}

TEST(ASurfacesFlash, UsesNothingInWhichABitFlipped) {
  EXPECT_EQ(proof::ProveDefects(500), 0u);
}

TEST_F(SurfaceUpdate, ANewImageIsStartedAndStaysOnceItIsConfirmed) {
  const auto image = ImageOf(2, 9000);
  EXPECT_EQ(updater.state(), wire::SurfaceState::kPlays);
  EXPECT_TRUE(Update(image, 0x10001));
  EXPECT_EQ(updater.state(), wire::SurfaceState::kReady);
  ASSERT_EQ(Choose(flash), Slot::kB);
  Updater next(flash, {.slot = Slot::kB, .product = kProduct, .oldest_version = kFloor});
  EXPECT_EQ(next.state(), wire::SurfaceState::kTries);
  next.Keep();
  EXPECT_EQ(next.state(), wire::SurfaceState::kPlays);
  for (int start = 0; start < 10; ++start) EXPECT_EQ(Choose(flash), Slot::kB);
}

TEST_F(SurfaceUpdate, AnImageThatIsNeverConfirmedIsTriedThreeTimes) {
  ASSERT_TRUE(Update(ImageOf(2), 0x10001));
  for (int start = 0; start < 3; ++start) EXPECT_EQ(Choose(flash), Slot::kB) << start;
  for (int start = 0; start < 3; ++start) EXPECT_EQ(Choose(flash), Slot::kA) << start;
}

TEST_F(SurfaceUpdate, AnImageThatNobodyConfirmedErasesNoOther) {
  ASSERT_TRUE(Update(ImageOf(2), 0x10001));
  ASSERT_EQ(Choose(flash), Slot::kB);
  Updater next(flash, {.slot = Slot::kB, .product = kProduct, .oldest_version = kFloor});
  EXPECT_FALSE(next.Begin(Describe(ImageOf(3), 0x10002)));
  EXPECT_TRUE(ReadHeader(flash, Slot::kA));
}

TEST_F(SurfaceUpdate, WhatIsForAnotherDeviceOrTooOldOrTooLongIsRefused) {
  const auto image = ImageOf(2);
  const auto good = Describe(image, 0x10001);
  auto other = good;
  other.product = 0x12090002;
  auto old = good;
  old.version = 0xFFFF;
  auto endless = good;
  endless.length = kMostImageBytes + 1;
  auto empty = good;
  empty.length = 0;
  const std::uint32_t before = flash.operations();
  for (const auto& bad : {other, old, endless, empty}) EXPECT_FALSE(updater.Begin(bad));
  EXPECT_FALSE(updater.Data(0, image));
  EXPECT_FALSE(updater.End());
  EXPECT_EQ(flash.operations(), before) << "nothing was touched";
}

TEST_F(SurfaceUpdate, DataOutOfOrderAndAWrongHashAreRefused) {
  const auto image = ImageOf(2);
  ASSERT_TRUE(updater.Begin(Describe(image, 0x10001)));
  EXPECT_FALSE(updater.Data(56, std::span(image).first(56)));
  EXPECT_TRUE(updater.Data(0, std::span(image).first(56)));
  EXPECT_FALSE(updater.Data(0, std::span(image).first(56)));
  EXPECT_FALSE(updater.Data(56, image)) << "more than was announced";
  EXPECT_FALSE(updater.End()) << "too early";
  EXPECT_EQ(updater.bytes_taken(), 56u);
  EXPECT_TRUE(updater.Begin(Describe(ImageOf(3), 0x10001)));
  EXPECT_TRUE(Send(image));
  EXPECT_FALSE(updater.End()) << "the hash is another one's";
  EXPECT_EQ(Choose(flash), Slot::kA);
}

TEST_F(SurfaceUpdate, AnImageThatADefectChangedIsNotStarted) {
  ASSERT_TRUE(Update(ImageOf(2), 0x10001));
  Keep(flash, Slot::kB);
  ASSERT_EQ(Choose(flash), Slot::kB);
  flash.Flip(ImageAt(Slot::kB) + 4321, 0x10);
  EXPECT_EQ(Choose(flash), Slot::kA);
  flash.Flip(At(Slot::kA) + 9, 0x01);  // In the header.
  EXPECT_EQ(Choose(flash), std::nullopt);
}

TEST_F(SurfaceUpdate, ADeviceThatNobodyEverConfirmsGoesOnPlaying) {
  Nor fresh;
  const auto image = ImageOf(1);
  for (std::uint32_t at = 0; at < image.size(); at += kPageBytes)
    fresh.Program(ImageAt(Slot::kA) + at,
                  std::span(image).subspan(at, std::min<std::size_t>(kPageBytes, image.size() - at)));
  WriteHeader(fresh, Slot::kA, {.generation = 1, .image = Describe(image, 0x10000)});
  for (int start = 0; start < 10; ++start) EXPECT_EQ(Choose(fresh), Slot::kA);
}

TEST(AFlashStore, KeepsTheNewestBytesAndFallsBackToTheOnesBefore) {
  Nor flash;
  EXPECT_FALSE(Load(flash));
  for (std::uint8_t n = 1; n < 10; ++n) {
    Store(flash, std::vector<std::uint8_t>(n, n));
    const auto stored = Load(flash);
    ASSERT_TRUE(stored);
    EXPECT_EQ(std::vector<std::uint8_t>(stored->begin(), stored->end()), std::vector<std::uint8_t>(n, n));
  }
  const std::uint32_t before = flash.operations();
  Store(flash, std::vector<std::uint8_t>(9, 9));
  EXPECT_EQ(flash.operations(), before) << "the same bytes are there already";
  flash.Flip(kStoreAt + 11, 1);
  ASSERT_TRUE(Load(flash));
  EXPECT_EQ(Load(flash)->size(), 8u);
}

TEST(ASurfacesHash, IsThatOfTheStandardAndOfLibsodium) {
  const std::string_view abc = "abc";
  const auto digest = Sha256Of({reinterpret_cast<const std::uint8_t*>(abc.data()), abc.size()});
  EXPECT_EQ(digest[0], 0xBA);  // FIPS 180-4's example.
  EXPECT_EQ(digest[31], 0xAD);
  proof::Dice dice(5);
  for (std::size_t length = 0; length < 300; ++length) {
    std::vector<std::uint8_t> message(length);
    for (auto& byte : message) byte = static_cast<std::uint8_t>(dice.Throw());
    Sha256Digest expected;
    crypto_hash_sha256(expected.data(), message.data(), message.size());
    EXPECT_EQ(Sha256Of(message), expected) << length;
  }
}

}  // namespace
}  // namespace kaori::surface
