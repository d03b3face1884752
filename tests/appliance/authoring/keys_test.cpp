// Pictures for keys: what a deck's twin makes of them, and that every call has its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "appliance/authoring/keys/key_file.h"
#include "appliance/authoring/keys/key_pictures.h"
#include "appliance/authoring/keys/key_scene.h"
#include "appliance/core/roles/own_buttons.h"
#include "hw-sim/devices/stream_deck.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::authoring {
namespace {

namespace fs = std::filesystem;
using Kind = sim::StreamDeck::Kind;

show::Show SmallShow(const char* name) {
  show::Show show;
  show.name = name;
  show.cast = kaori::tests::MakeSyntheticCast({.faces = 2});
  show.cast.textures = {{1, 1, {200, 150, 120, 40}}};
  show.scenes.emplace_back().name = "studio";
  return show;
}

// Dark, but for its upper left quarter, which is red.
image::Picture Marked(int side_px) {
  image::Picture picture = image::Picture::Blank(side_px, side_px);
  for (int y = side_px / 2; y < side_px; ++y)
    for (int x = 0; x < side_px / 2; ++x) picture.rgbx[static_cast<std::size_t>((y * side_px + x) * 4)] = 250;
  return picture;
}

void Send(sim::StreamDeck& deck, std::uint16_t product, const std::vector<std::uint8_t>& file) {
  for (const auto& page : decode::PicturePages(decode::StreamDeckOf(0x0FD9, product), 0, file))
    deck.HandleOutput(page);
}

// The red of a key's quarter, 0 left above, 1 right above, 2 left below, 3 right below.
int RedOf(const sim::KeyPicture& key, int quarter) {
  const int x = key.side_px / 4 + quarter % 2 * key.side_px / 2,
            y = key.side_px / 4 + quarter / 2 * key.side_px / 2;
  return key.rgb[static_cast<std::size_t>((y * key.side_px + x) * 3)];
}

TEST(KeyFile, StandsUprightOnEveryDeck) {
  for (const auto& [kind, product] : {std::pair<Kind, std::uint16_t>{Kind::kMk2, 0x0080},
                                      {Kind::kXl, 0x006C},
                                      {Kind::kPlus, 0x0084},
                                      {Kind::kMini, 0x0063}}) {
    const decode::StreamDeck shape = decode::StreamDeckOf(0x0FD9, product);
    const auto file = KeyFile(Marked(shape.shape.key_px), shape.shape);
    ASSERT_TRUE(file);
    sim::StreamDeck deck(kind);
    Send(deck, product, *file);
    ASSERT_TRUE(deck.picture(0)) << deck.device_name().name;
    EXPECT_GT(RedOf(*deck.picture(0), 0), 200) << deck.device_name().name;
    for (const int dark : {1, 2, 3})
      EXPECT_LT(RedOf(*deck.picture(0), dark), 40) << deck.device_name().name << dark;
    EXPECT_EQ(deck.wrong_pages() + deck.wrong_pictures(), 0);
  }
}

TEST(KeyFile, OfAnotherSizeIsRefused) {
  EXPECT_FALSE(KeyFile(Marked(80), decode::kDeckShapes[0]));
}

TEST(KeyText, SaysWhatIsCalledInFewLetters) {
  EXPECT_EQ(TextOfKey("face old_woman"), "Old woman");
  EXPECT_EQ(TextOfKey("cue go"), "Go");
  EXPECT_EQ(TextOfKey("cue 14"), "Cue 14");
  EXPECT_EQ(TextOfKey("wink left"), "Wink left");
}

class DrawnKeys : public ::testing::Test {
 protected:
  DrawnKeys() {
    std::string pattern = (fs::temp_directory_path() / "kaori-keys-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~DrawnKeys() override { fs::remove_all(folder_); }
  int Draw(const show::Show& show) const {
    const auto studio = stage::Studio::Open(show).value();
    return DrawKeys(*studio, KeyFiles(folder_).value(), [](std::string_view) {}).value();
  }
  std::set<std::string> Names(const char* size) const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / size)) names.insert(entry.path().filename());
    return names;
  }
  std::vector<std::uint8_t> File(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  fs::path folder_;
};

TEST_F(DrawnKeys, HaveADimmedAndABrightPictureOfEachCallAtEachSize) {
  const show::Show show = SmallShow("Small");
  const int calls = Draw(show);
  EXPECT_GE(calls, 2 + 3 + 5 + 6 + 3 + 1) << "faces, expressions, styles, the cue list, blinks, a scene";
  for (const char* size : {"72", "80", "96", "120"})
    EXPECT_EQ(Names(size).size(), static_cast<std::size_t>(2 * calls + 1)) << size;
  const roles::Items items = roles::ItemsOf(show);
  const auto sum = roles::SumOfCall(roles::CallNamed("face round", items).value(), "Small", items);
  sim::StreamDeck dark(Kind::kMk2), lit(Kind::kMk2), blank(Kind::kMk2);
  Send(dark, 0x0080, File(fmt::format("72/{:016x}.jpg", sum)));
  Send(lit, 0x0080, File(fmt::format("72/{:016x}-lit.jpg", sum)));
  Send(blank, 0x0080, File("72/blank.jpg"));
  ASSERT_TRUE(dark.picture(0) && lit.picture(0) && blank.picture(0));
  EXPECT_GT(lit.picture(0)->brightness(), 1.5 * dark.picture(0)->brightness());
  EXPECT_GT(dark.picture(0)->brightness(), 5);
  EXPECT_LT(blank.picture(0)->brightness(), 1);
}

TEST_F(DrawnKeys, OfTwoShowsLieInOneFolder) {
  Draw(SmallShow("Small"));
  const auto of_one = Names("72").size();
  Draw(SmallShow("Other"));
  EXPECT_EQ(Names("72").size(), 2 * of_one - 1) << "a face of the same name is another face; blank is blank";
}

TEST(SumOfCall, IsTheSameHoweverItJoinsAndNothingForWhatHasNoName) {
  const show::Show show = SmallShow("Small");
  const roles::Items items = roles::ItemsOf(show);
  using show::CallKind, show::CallMode;
  EXPECT_EQ(roles::SumOfCall({CallKind::kFace, 1, CallMode::kToggle}, "Small", items),
            roles::SumOfCall({CallKind::kFace, 1}, "Small", items));
  EXPECT_NE(roles::SumOfCall({CallKind::kFace, 1}, "Small", items),
            roles::SumOfCall({CallKind::kFace, 0}, "Small", items));
  EXPECT_EQ(roles::SumOfCall({CallKind::kNothing, 0}, "Small", items), 0U);
}

}  // namespace
}  // namespace kaori::authoring
