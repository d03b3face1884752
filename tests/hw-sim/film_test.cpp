// Films: written whole, or not at all with one line that says why.
#include "hw-sim/rehearsal/film.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

namespace kaori::sim {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class FilmTest : public ::testing::Test {
 protected:
  FilmTest() {
    std::string name = (fs::temp_directory_path() / "kaori film-XXXXXX").string();  // With a space.
    folder_ = ::mkdtemp(name.data());
  }
  ~FilmTest() override { fs::remove_all(folder_); }

  // Records until something is wrong; the line that says so, or nothing.
  std::string Record(const FilmOptions& options, int pictures) {
    auto film = Film::Start(options);
    if (!film) return film.error().message();
    const std::vector<std::uint8_t> picture(
        static_cast<std::size_t>(options.width_px * options.height_px) * 4, 99);
    for (int i = 0; i < pictures; ++i)
      if (auto ok = film->Add(picture); !ok) return ok.error().message();
    const auto done = film->Finish();
    return done ? "" : done.error().message();
  }

  static bool HasFfmpeg() { return std::system("command -v ffmpeg >/dev/null") == 0; }

  fs::path folder_;
};

TEST_F(FilmTest, WithoutFfmpegSaysWhatIsMissing) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  const std::string said = Record({.file = folder_ / "a.mp4", .width_px = 64, .height_px = 36}, 1);
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(said, HasSubstr("start ffmpeg, Debian's package ffmpeg: No such file"));
}

TEST_F(FilmTest, OfAnOddSizeIsRefused) {
  EXPECT_THAT(Record({.file = folder_ / "a.mp4", .width_px = 65, .height_px = 36}, 1),
              HasSubstr("of 65x36: its sides must be even"));
}

TEST_F(FilmTest, IsWrittenUnderANameWithSpacesAndColons) {
  if (!HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const fs::path file = folder_ / "act 1: poster.mp4";
  EXPECT_EQ(Record({.file = file, .width_px = 64, .height_px = 36}, 12), "");
  EXPECT_GT(fs::file_size(file), 500U);
}

TEST_F(FilmTest, OnAFullDiskSaysSoInOneLine) {
  if (!HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  fs::create_symlink("/dev/full", folder_ / "full.mp4");
  const std::string said = Record({.file = folder_ / "full.mp4", .width_px = 64, .height_px = 36}, 300);
  EXPECT_THAT(said, HasSubstr("write the film"));
  EXPECT_THAT(said, HasSubstr("No space left"));
  EXPECT_THAT(said, Not(HasSubstr("\n")));
}

TEST_F(FilmTest, IntoAFolderThatIsNotThereSaysSoInOneLine) {
  if (!HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const std::string said = Record({.file = folder_ / "no" / "a.mp4", .width_px = 640, .height_px = 360}, 40);
  EXPECT_THAT(said, HasSubstr("No such file"));
  EXPECT_THAT(said, Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace kaori::sim
