// Which pack the sounds of motions are read from.
#include <gtest/gtest.h>

#include "appliance/core/store/play_log.h"
#include "appliance/programs/lips/sound_options.h"
#include "tests/appliance/core/pack_fixture.h"

namespace kaori::tests {
namespace {

class SoundsOfMotions : public PackTest {
 protected:
  SoundsOfMotions() {
    options_.board = folder_ / "board";
    options_.pack = folder_ / "root.kaori";
    options_.shows = folder_ / "shows";
    std::filesystem::create_directories(folder_ / "shows");
    Save(options_.pack, 1);
    Save(folder_ / "shows/root.copy", 2);
    Save(folder_ / "shows" / store::PackName(kBrought), 3);
  }
  // A show whose first motion has a sound of so many samples for each of two channels.
  static void Save(const std::filesystem::path& file, std::size_t samples) {
    auto show = SmallShow();
    show.motions[0].sound.samples.assign(2 * samples, 100);
    EXPECT_TRUE(show::SavePack(show, file));
  }
  void Play(const std::string& id) const {
    store::PlayLog log;
    log.last = id;
    std::ofstream(store::PlayLogBeside(options_.board)) << store::Format(log);
  }
  // Samples for each channel; nothing where the show is silent.
  std::size_t Samples() const {
    const auto settings = lips::SoundSettingsOf(options_, {});
    EXPECT_TRUE(settings) << settings.error().message();
    return !settings || settings->speaker.clips.empty() ? 0 : settings->speaker.clips[0].samples.size() / 2;
  }

  static inline const std::string kBrought = std::string(64, 'a');
  lips::LipOptions options_;
};

TEST_F(SoundsOfMotions, AreThoseOfTheShowThatPlays) {
  EXPECT_EQ(Samples(), 1U) << "before the stage has noted one";
  Play(std::string(store::kRootShow));
  EXPECT_EQ(Samples(), 1U);
  Play(kBrought);
  EXPECT_EQ(Samples(), 3U);
}

// The root's own file is not touched then: a page of it that is mapped and spoilt would end the program.
TEST_F(SoundsOfMotions, AreThoseOfTheCopyWhereTheRootIsSpoilt) {
  std::filesystem::remove(options_.pack);
  Play(std::string(store::kCopiedShow));
  EXPECT_EQ(Samples(), 2U);
}

TEST_F(SoundsOfMotions, AreNoneWhereAPackOfTheDataPartitionIsSpoiltAndTheFaceGoesOn) {
  Play(std::string(store::kCopiedShow));
  std::ofstream(folder_ / "shows/root.copy") << "torn";
  EXPECT_EQ(Samples(), 0U);
}

}  // namespace
}  // namespace kaori::tests
