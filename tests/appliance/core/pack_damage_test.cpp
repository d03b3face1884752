// Damaged, cut, foreign and forged packs: each is refused with one line, and none is believed.
#include <gmock/gmock.h>

#include <random>

#include "appliance/core/show/check.h"
#include "appliance/core/show/pack.h"
#include "appliance/core/show/pack_container.h"
#include "appliance/core/show/pack_content.h"
#include "appliance/core/show/pack_layout.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using show::EncodePack;
using show::LoadPack;
using ::testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t kHeader = show::kPackHeader_bytes;

class DamagedPack : public PackTest {
 protected:
  // The one line with which the bytes are refused; empty if they are played.
  std::string Refusal(const Bytes& bytes) const {
    const auto loaded = LoadPack(Write(bytes));
    if (loaded) return "";
    EXPECT_EQ(loaded.error().attempt.find('\n'), std::string::npos) << loaded.error().attempt;
    return loaded.error().message();
  }

  const Bytes sound_ = EncodePack(SmallShow());
};

// Either the header is refused as it stands, or it asks for another checksum than the content has.
TEST_F(DamagedPack, NoFlippedBitOfTheHeaderPasses) {
  const auto whole = show::ReadHeader(sound_, sound_.size());
  ASSERT_TRUE(whole);
  for (std::size_t bit = 0; bit < 8 * kHeader; ++bit) {
    Bytes bytes = sound_;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    const auto seal = show::ReadHeader(bytes, bytes.size());
    EXPECT_TRUE(!seal || seal->checksum != whole->checksum) << "bit " << bit;
  }
  Bytes bytes = sound_;
  bytes[24] ^= 1U;  // The checksum's first bit.
  EXPECT_THAT(Refusal(bytes), HasSubstr("its checksum does not fit"));
}

TEST_F(DamagedPack, NoFlippedBitOfTheContentPasses) {
  std::mt19937 random(11);
  for (int i = 0; i < 50; ++i) {
    Bytes bytes = sound_;
    const std::size_t at = kHeader + random() % (bytes.size() - kHeader);
    bytes[at] ^= static_cast<std::uint8_t>(1U << (random() % 8));
    EXPECT_THAT(Refusal(bytes), HasSubstr("is damaged: its checksum does not fit")) << "byte " << at;
  }
}

TEST_F(DamagedPack, ACutOneSaysHowMuchIsMissing) {
  for (const std::size_t length :
       {sound_.size() / 2, sound_.size() - 1, kHeader, kHeader - 1, std::size_t{9}}) {
    const Bytes bytes(sound_.begin(), sound_.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_THAT(Refusal(bytes), HasSubstr("is no whole show pack")) << length;
  }
  Bytes longer = sound_;
  longer.push_back(0);
  EXPECT_THAT(Refusal(longer), HasSubstr("it should have " + std::to_string(sound_.size()) +
                                         " bytes and has " + std::to_string(longer.size())));
}

TEST_F(DamagedPack, AnotherVersionIsNamed) {
  Bytes newer = sound_;
  newer[8] = 9;
  EXPECT_THAT(Refusal(newer), HasSubstr("is a show pack of version 9; this box plays version 2"));
  const Bytes bare(sound_.begin() + kHeader, sound_.end());
  EXPECT_THAT(Refusal(bare),
              HasSubstr("is a show pack of version 1; this box plays version 2: pack it again"));
}

TEST_F(DamagedPack, AFileThatIsLargerThanAnyShowIsNotRead) {
  const auto file = Write(sound_);
  std::filesystem::resize_file(file, (std::uint64_t{3} << 30U));  // With a hole: it takes no room.
  const auto loaded = LoadPack(file);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().attempt, HasSubstr("is larger than 1024 MB"));
}

// A checksum keeps out damage, not forgers: what lies behind a fitting one is not believed either.
TEST_F(DamagedPack, ForgedContentNeverCrashesAndNeverPassesUnsound) {
  const Bytes content = show::EncodeContent(SmallShow());
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    Bytes forged = content;
    for (int flips = 0; flips < 4; ++flips)
      forged[random() % forged.size()] = static_cast<std::uint8_t>(random());
    const auto header = show::MakeHeader(forged, nullptr);
    forged.insert(forged.begin(), header.begin(), header.end());
    if (const auto loaded = LoadPack(Write(forged)); !loaded)
      ++refused;
    else
      EXPECT_THAT(CheckShow(*loaded), ::testing::IsEmpty());
  }
  EXPECT_GT(refused, 0);
}

// Whoever says so answers for it: the kernel has checked each block, and a second check only costs time.
TEST_F(DamagedPack, OnAVerifiedRootTheChecksumIsNotMadeAgainAndTheRestIsCheckedAllTheSame) {
  constexpr show::LoadOptions kVerified{.on_verified_root = true};
  Bytes other_sum = sound_;
  other_sum[24] ^= 1U;
  const auto loaded = LoadPack(Write(other_sum), kVerified);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(EncodePack(*loaded), sound_);
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 100; ++i) {
    Bytes damaged = sound_;
    damaged[kHeader + random() % (damaged.size() - kHeader)] = static_cast<std::uint8_t>(random());
    if (const auto show = LoadPack(Write(damaged), kVerified); !show)
      ++refused;
    else
      EXPECT_THAT(CheckShow(*show), ::testing::IsEmpty());
  }
  EXPECT_GT(refused, 0);
  const Bytes cut(sound_.begin(), sound_.end() - 1);
  EXPECT_FALSE(LoadPack(Write(cut), kVerified));
}

// A million textures that share one array would unfold a small file to all memory there is.
TEST(PackContent, TablesThatShareTheirArraysAreNotUnfolded) {
  flatbuffers::FlatBufferBuilder to;
  const auto pixels = to.CreateVector(Bytes(std::size_t{1} << 16U));
  const auto texture = pack::CreateTexture(to, 128, 128, pixels);
  const auto textures = to.CreateVector(std::vector(5000, texture));
  pack::PackBuilder builder(to);
  builder.add_textures(textures);
  pack::FinishPackBuffer(to, builder.Finish());
  const auto show = show::DecodeContent({to.GetBufferPointer(), to.GetSize()});
  ASSERT_FALSE(show);
  EXPECT_EQ(show.error().attempt, "is damaged: it unfolds to more than it holds");
}

}  // namespace
}  // namespace kaori::tests
