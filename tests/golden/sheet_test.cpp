// The contact sheets of the default show, as people have accepted them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include <fmt/format.h>

#include "appliance/authoring/sheet/sheet.h"
#include "appliance/core/show/pack.h"
#include "tests/golden/compare.h"

namespace kaori::golden {
namespace {

TEST(Sheets, EveryFaceWithEveryExpressionLooksAsItDidWhenItWasAccepted) {
  auto show = show::LoadPack(KAORI_PACK);
  ASSERT_TRUE(show) << show.error().message();
  const auto studio = stage::Studio::Open(std::move(*show));
  ASSERT_TRUE(studio) << studio.error().message();
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("kaori-sheets-{}", ::getpid());
  const auto drawn = authoring::DrawSheets(**studio, folder, {.cell_width_px = 112, .cell_height_px = 126},
                                           [](std::string_view) {});
  ASSERT_TRUE(drawn) << drawn.error().message();
  int sheets = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".png") continue;
    const auto picture = image::ReadPng(entry.path());
    ASSERT_TRUE(picture) << picture.error().attempt;
    EXPECT_EQ(Compare(*picture, "sheet-" + entry.path().stem().string()), "");
    ++sheets;
  }
  EXPECT_EQ(sheets, 4 + static_cast<int>((*studio)->show().cast.faces.size()));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace kaori::golden
