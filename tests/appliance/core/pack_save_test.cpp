// Saving: the new pack whole or the old one as it was, and nothing else in the folder.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "appliance/core/show/pack.h"
#include "appliance/core/show/pack_keys.h"
#include "drivers/base/whole_file.h"
#include "tests/appliance/core/pack_fixture.h"
#include "tests/appliance/core/small_disk.h"

namespace kaori::tests {
namespace {

using show::SavePack;
using ::testing::HasSubstr;

class SavedPack : public PackTest {
 protected:
  const std::filesystem::path file_ = folder_ / "show.kaori";
};

TEST_F(SavedPack, ReplacesTheOldOneAndLeavesNothingElse) {
  ASSERT_TRUE(SavePack(SmallShow(), file_));
  auto next = SmallShow();
  next.name = "next";
  ASSERT_TRUE(SavePack(next, file_));
  EXPECT_EQ(NameIn(file_), "next");
  EXPECT_EQ(Files(), 1);
}

TEST_F(SavedPack, CarriesPicturesOfKeysThroughASignature) {
  const std::vector<show::KeyPicture> keys{{72, 0, false, {1, 2}}, {96, ~std::uint64_t{0}, true, {3}}};
  ASSERT_TRUE(show::SavePackWithKeys({SmallShow(), keys}, file_));
  const auto signer = show::MakeKey().value();
  ASSERT_TRUE(show::SignPack(file_, file_, signer));
  const auto whole = show::LoadPackWithKeys(file_);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->keys, keys);
  EXPECT_EQ(NameIn(file_), SmallShow().name) << "who does not ask for them reads the show";
  ASSERT_TRUE(SavePack(SmallShow(), file_));
  EXPECT_TRUE(show::LoadPackWithKeys(file_)->keys.empty());
}

TEST_F(SavedPack, KeepsHowRedExpressionsMakeWhoShowsIt) {
  auto shown = SmallShow();
  shown.cast.expressions[1].flush = 0.75F;
  shown.cast.faces[2].surface.flush = 0.25F;
  ASSERT_TRUE(SavePack(shown, file_));
  const auto loaded = show::LoadPack(file_);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ(loaded->cast.expressions[1].flush, 0.75F);
  EXPECT_EQ(loaded->cast.expressions[2].flush, 0);
  EXPECT_EQ(loaded->cast.faces[2].surface.flush, 0.25F);
}

TEST_F(SavedPack, WithMorePicturesOfKeysThanThereCanBeIsRefusedWithOneLine) {
  show::ShowWithKeys whole{SmallShow(),
                           {{72, 1, false, std::vector<std::uint8_t>(show::kMostKeyPicture_bytes + 1)}}};
  ASSERT_TRUE(show::SavePackWithKeys(whole, file_));
  EXPECT_THAT(show::LoadPackWithKeys(file_).error().message(),
              HasSubstr("too many pictures of keys, or too large ones"));
  EXPECT_EQ(NameIn(file_), SmallShow().name);
}

TEST_F(SavedPack, OnAFullDiskKeepsTheOldOneAndSaysSoInOneLine) {
  ASSERT_TRUE(SavePack(SmallShow(), file_));
  auto next = SmallShow();
  next.name = "next";
  {
    const SmallDisk disk(10'000);
    const auto saved = SavePack(next, file_);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().message(), "write " + file_.string() + ": File too large");
  }
  EXPECT_EQ(NameIn(file_), "small");
  EXPECT_EQ(Files(), 1);
}

// The process is ended in the middle of its writing, by a signal that nobody can catch.
TEST_F(SavedPack, OfAKilledProcessLeavesTheOldOneWhole) {
  ASSERT_TRUE(SavePack(SmallShow(), file_));
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{10'000, 10'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    std::signal(SIGXFSZ, SIG_DFL);  // The kernel kills at the first byte too many.
    (void)SavePack(SmallShow(), file_);
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status)) << "the writer was to be killed";
  EXPECT_EQ(NameIn(file_), "small");
  EXPECT_EQ(Files(), 1);
}

TEST_F(SavedPack, IntoAFolderThatIsNotThereIsNamed) {
  const auto saved = SavePack(SmallShow(), folder_ / "nowhere" / "show.kaori");
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message(), HasSubstr("nowhere/show.kaori: No such file or directory"));
}

TEST_F(SavedPack, OverAFolderIsRefusedAndLeavesItAlone) {
  std::filesystem::create_directory(file_);
  const auto saved = SavePack(SmallShow(), file_);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message(), HasSubstr("show.kaori: Is a directory"));
  EXPECT_EQ(Files(), 1);
}

TEST_F(SavedPack, IsReadableByTheProgramsThatPlayIt) {
  ASSERT_TRUE(SavePack(SmallShow(), file_));
  using std::filesystem::perms;
  EXPECT_NE(std::filesystem::status(file_).permissions() & perms::owner_read, perms::none);
  EXPECT_EQ(std::filesystem::status(file_).permissions() & perms::owner_exec, perms::none);
}

TEST_F(SavedPack, IsMadeOfItsPiecesInTheirOrder) {
  ASSERT_TRUE(WriteWholeFile(file_, {AsBytes("one "), {}, AsBytes("two")}));
  std::ifstream in(file_);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_EQ(text, "one two");
}

}  // namespace
}  // namespace kaori::tests
