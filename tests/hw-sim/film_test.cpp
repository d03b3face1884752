// Films: written whole, or not at all with one line that says why.
#include "hw-sim/rehearsal/film.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "hw-sim/rehearsal/film_sound.h"

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

// What a program says, its first line.
std::string Ask(const std::string& command) {
  std::array<char, 200> line{};
  FILE* const said = ::popen(command.c_str(), "r");
  const char* const got = std::fgets(line.data(), line.size(), said);
  ::pclose(said);
  return got == nullptr ? "" : got;
}

TEST_F(FilmTest, HasTheSoundAsLongAsItsPicturesAndInTime) {
  if (!HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  constexpr int kPictures = 45, kHz = 30;
  const Time begin{std::chrono::seconds(7)};
  const fs::path pictures = folder_ / "pictures.mp4", sound = folder_ / "sound.wav",
                 film = folder_ / "film.mp4";
  ASSERT_EQ(Record({.file = pictures, .width_px = 64, .height_px = 36, .hz = kHz}, kPictures), "");
  auto wave = FilmSound::Start(sound, begin);
  ASSERT_TRUE(wave) << wave.error().message();
  Loudspeaker::Heard before, click;  // Before the film; and a click of 10 ms, 0.8 s after its first picture.
  before.at = begin - std::chrono::milliseconds(100);
  before.samples.assign(2 * 480, 30000);
  click.at = begin + std::chrono::milliseconds(800);
  click.samples.assign(2 * 480, 30000);
  wave->Add({before, click});
  ASSERT_TRUE(wave->Finish(FromSeconds(static_cast<double>(kPictures) / kHz)));
  const auto joined = JoinSound(pictures, sound, film);
  ASSERT_TRUE(joined) << joined.error().message();

  const double frame_s = 1.0 / kHz;
  const auto length_s = [&](const char* stream) {
    return std::atof(
        Ask(fmt::format("ffprobe -v error -select_streams {} -show_entries stream=duration -of csv=p=0 '{}'",
                        stream, film.string()))
            .c_str());
  };
  EXPECT_NEAR(length_s("v"), kPictures * frame_s, 0.001);
  EXPECT_NEAR(length_s("a"), kPictures * frame_s, frame_s);

  const fs::path raw = folder_ / "sound.raw";
  Ask(fmt::format("ffmpeg -v error -y -i '{}' -f s16le -ac 1 -ar 48000 '{}'", film.string(), raw.string()));
  std::ifstream file(raw, std::ios::binary);
  std::vector<std::int16_t> samples(fs::file_size(raw) / 2);
  file.read(reinterpret_cast<char*>(samples.data()), static_cast<std::streamsize>(2 * samples.size()));
  const auto loud =
      std::ranges::find_if(samples, [](std::int16_t sample) { return std::abs(sample) > 8000; });
  EXPECT_NEAR(static_cast<double>(loud - samples.begin()) / 48000, 0.8, frame_s);
}

TEST_F(FilmTest, WhoseSoundCannotBeWrittenSaysWhy) {
  const auto sound = [](const fs::path& file) { return FilmSound::Start(file, Time{}).error(); };
  EXPECT_EQ(sound(folder_ / "none" / "sound.wav").cause, std::errc::no_such_file_or_directory);
  EXPECT_EQ(sound(folder_).cause, std::errc::is_a_directory);
}

TEST_F(FilmTest, WithSoundOnAFullDiskSaysSoInOneLine) {
  if (!HasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const fs::path pictures = folder_ / "pictures.mp4", sound = folder_ / "sound.wav";
  ASSERT_EQ(Record({.file = pictures, .width_px = 64, .height_px = 36}, 30), "");
  auto wave = FilmSound::Start(sound, Time{});
  ASSERT_TRUE(wave);
  ASSERT_TRUE(wave->Finish(std::chrono::seconds(1)));
  fs::create_symlink("/dev/full", folder_ / "full.mp4");
  const auto joined = JoinSound(pictures, sound, folder_ / "full.mp4");
  ASSERT_FALSE(joined);
  EXPECT_THAT(joined.error().message(), HasSubstr("No space left"));
  EXPECT_THAT(joined.error().message(), Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace kaori::sim
