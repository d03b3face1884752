// Signed packs: a box that has a key plays what that key has signed, and nothing else.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "appliance/core/show/pack.h"
#include "appliance/core/show/pack_container.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

using show::EncodePack;
using show::LoadPack;
using show::MakeKey;
using show::SecretKey;
using ::testing::HasSubstr;

class SignedPack : public PackTest {
 protected:
  std::string Refusal(const std::filesystem::path& file, const SecretKey& trusted) const {
    const auto loaded = LoadPack(file, {.signed_by = show::PublicKeys{trusted.public_key()}});
    return loaded ? "" : loaded.error().message();
  }

  const SecretKey company_ = MakeKey().value();
  const SecretKey other_signer_ = MakeKey().value();
};

TEST_F(SignedPack, IsPlayedByABoxThatTrustsItsKeyAndByOneThatAsksForNone) {
  const auto file = Write(EncodePack(SmallShow(), &company_));
  EXPECT_TRUE(LoadPack(file, {.signed_by = show::PublicKeys{company_.public_key()}}));
  EXPECT_TRUE(LoadPack(file));
  EXPECT_EQ(*show::ReadSigner(file), company_.public_key());
}

TEST_F(SignedPack, OfNobodyOrOfAnotherSignerIsRefusedWithOneLine) {
  const auto unsigned_file = Write(EncodePack(SmallShow()));
  EXPECT_THAT(Refusal(unsigned_file, company_), HasSubstr("show.kaori is not signed"));
  EXPECT_EQ(*show::ReadSigner(unsigned_file), std::nullopt);
  EXPECT_THAT(Refusal(Write(EncodePack(SmallShow(), &other_signer_)), company_),
              HasSubstr("is signed by another key"));
}

// Another signer writes the trusted key's name over a pack of his own.
TEST_F(SignedPack, WithABorrowedNameIsRefused) {
  auto bytes = EncodePack(SmallShow(), &other_signer_);
  std::ranges::copy(company_.public_key().bytes, bytes.begin() + 56);
  EXPECT_THAT(Refusal(Write(bytes), company_), HasSubstr("is wrongly signed"));
}

// Another signer puts a show of his own behind a header that the company has signed.
TEST_F(SignedPack, WithOtherContentIsRefused) {
  const auto header = EncodePack(SmallShow(), &company_);
  auto other = SmallShow();
  other.scenes[0].exposure = 0.25F;
  auto bytes = EncodePack(other, &other_signer_);
  ASSERT_EQ(bytes.size(), header.size());
  std::copy_n(header.begin(), show::kPackHeader_bytes, bytes.begin());
  EXPECT_THAT(Refusal(Write(bytes), company_), HasSubstr("its checksum does not fit"));
}

TEST_F(SignedPack, NoFlippedBitOfTheHeaderPassesEvenWhereNoKeyIsAskedFor) {
  const auto sound = EncodePack(SmallShow(), &company_);
  for (std::size_t bit = 0; bit < 8 * show::kPackHeader_bytes; ++bit) {
    auto bytes = sound;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(show::ReadHeader(bytes, bytes.size())) << "bit " << bit;
  }
}

TEST_F(SignedPack, KeysAreKeptInFilesThatOnlyTheirOwnerReads) {
  const auto file = folder_ / "company.key";
  ASSERT_TRUE(SaveKey(company_, file));
  EXPECT_EQ(show::ReadSecretKey(file).value().bytes(), company_.bytes());
  EXPECT_EQ(show::ReadPublicKey(file.string() + ".pub").value(), company_.public_key());
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  EXPECT_EQ(SaveKey(other_signer_, file).error().cause, std::errc::file_exists)
      << "a key is never written over";
}

TEST_F(SignedPack, FilesThatHoldAnotherKeyOrNoneAreNamed) {
  const auto file = folder_ / "company.key";
  ASSERT_TRUE(SaveKey(company_, file));
  EXPECT_THAT(show::ReadPublicKey(file).error().message(),
              HasSubstr("company.key: holds no \"kaori-public-key\""));
  EXPECT_THAT(show::ReadSecretKey(file.string() + ".pub").error().message(),
              HasSubstr("\"kaori-secret-key\""));
  EXPECT_THAT(show::ReadSecretKey(folder_ / "none").error().message(), HasSubstr("No such file"));
  EXPECT_FALSE(show::ReadPublicKey(Write({'k', 'a', 'o'})));
}

}  // namespace
}  // namespace kaori::tests
