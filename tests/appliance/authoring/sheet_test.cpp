// Contact sheets: what is on them, where it stands, and that they are there whole or not at all.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "appliance/authoring/sheet/page.h"
#include "appliance/authoring/sheet/sheet.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::authoring {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

show::Show ShowOf(int faces) {
  show::Show show;
  show.name = "Small";
  show.cast = kaori::tests::MakeSyntheticCast({.faces = faces});
  show.cast.textures = {{1, 1, {200, 150, 120, 40}}};
  show.scenes.emplace_back().name = "studio";
  return show;
}

std::vector<std::string> FilesOf(const std::vector<Sheet>& sheets) {
  std::vector<std::string> files;
  for (const Sheet& sheet : sheets) files.push_back(sheet.file);
  return files;
}

const Sheet& Named(const std::vector<Sheet>& sheets, const std::string& file) {
  return *std::ranges::find(sheets, file, &Sheet::file);
}

Flaws TwoFlaws() {
  inspect::Inspection found;
  found.folds = 3;
  found.lid_gaps = 1;
  found.findings = {
      {.flaw = inspect::Flaw::kFold, .face = "round", .pose = "smile with a", .count = 3},
      {.flaw = inspect::Flaw::kLidGap, .face = "round", .pose = "smile", .measure = 0.2F},
      {.flaw = inspect::Flaw::kLidGap, .face = "long", .pose = "neutral, lids shut", .measure = 2}};
  return Flaws(found);
}

TEST(SheetPlan, HasAGridOfTheCastAndAPageForEachFace) {
  EXPECT_THAT(FilesOf(PlanSheets(ShowOf(2), {})),
              ElementsAre("cast.png", "faces.png", "styles.png", "morphs.png", "face-reference.png",
                          "face-round.png"));
  EXPECT_THAT(FilesOf(PlanSheets(ShowOf(1), {})), Not(Contains("morphs.png")));
}

TEST(SheetPlan, PutsFacesInRowsAndExpressionsInColumns) {
  const show::Show show = ShowOf(4);
  const auto sheets = PlanSheets(show, {});
  const Section& grid = Named(sheets, "cast.png").sections.front();
  EXPECT_THAT(grid.rows, ElementsAre("reference", "round", "turned", "long"));
  EXPECT_THAT(grid.columns, ElementsAre("neutral", "smile", "surprised"));
  ASSERT_EQ(grid.cells.size(), 12U);
  EXPECT_EQ(grid.cells[4].face, "round");
  EXPECT_EQ(grid.cells[4].label, "smile");
  EXPECT_EQ(Named(sheets, "cast.png").about,
            "4 faces, 3 expressions, 2 mouth shapes, 1 channel; not inspected");
}

TEST(SheetPlan, ShowsMouthShapesAndLidsOfEachFace) {
  const auto sheets = PlanSheets(ShowOf(1), {});
  std::vector<std::string> headings;
  for (const Section& section : Named(sheets, "face-reference.png").sections)
    headings.push_back(section.heading);
  EXPECT_THAT(headings, ElementsAre("Expressions", "Mouth shapes", "Lids shut", "Channels"));
}

TEST(SheetPlan, MarksFlawsWhereTheyAreSeen) {
  const auto sheets = PlanSheets(ShowOf(4), TwoFlaws());
  const Section& grid = Named(sheets, "cast.png").sections.front();
  EXPECT_EQ(grid.cells[4].flaws, "2 flaws, 3 folds with a");
  EXPECT_EQ(grid.cells[0].flaws, "");
  EXPECT_TRUE(Named(sheets, "cast.png").is_flawed);
  EXPECT_THAT(Named(sheets, "cast.png").about, HasSubstr("3 folds, 1 lid gaps, 0 teeth through lips"));
  EXPECT_FALSE(Named(sheets, "face-reference.png").is_flawed);
  const auto& lids = Named(sheets, "face-long.png").sections[2].cells;
  const auto shut = std::ranges::find(lids, Flaws::kLidsShut, &Cell::label);
  ASSERT_NE(shut, lids.end());
  EXPECT_EQ(shut->flaws, "lids 2.0 mm\u00b2");
}

bool Overlap(const Box& a, const Box& b) {
  return a.x_px < b.x_px + b.width_px && b.x_px < a.x_px + a.width_px && a.y_px < b.y_px + b.height_px &&
         b.y_px < a.y_px + a.height_px;
}

TEST(SheetLayout, KeepsEverythingInsideAndApart) {
  auto lettering = image::Lettering::Open();
  ASSERT_TRUE(lettering);
  for (const Sheet& sheet : PlanSheets(ShowOf(4), TwoFlaws())) {
    const Layout layout = LayOut(sheet, {0, 0, 80, 90}, *lettering);
    std::vector<Box> boxes = layout.cells;
    for (const Label& label : layout.labels) {
      EXPECT_LE(lettering->width_px(label.text, label.style.size_px), label.box.width_px);
      boxes.push_back(label.box);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_TRUE(boxes[i].x_px >= 0 && boxes[i].x_px + boxes[i].width_px <= layout.width_px) << sheet.file;
      EXPECT_TRUE(boxes[i].y_px >= 0 && boxes[i].y_px + boxes[i].height_px <= layout.height_px) << sheet.file;
      for (std::size_t j = 0; j < i && i < layout.cells.size(); ++j)
        EXPECT_FALSE(Overlap(boxes[i], boxes[j])) << sheet.file << " " << i << " " << j;
    }
  }
}

TEST(SheetPage, LetsNoNameOfAShowEndItsScript) {
  const std::string page = Page({}, "</script><b>\"", "about");
  EXPECT_THAT(page, HasSubstr("\\u003c/script>\\u003cb>\\\""));
  EXPECT_THAT(page, Not(HasSubstr("@DATA@")));
}

class DrawnSheets : public ::testing::Test {
 protected:
  void SetUp() override {
    auto studio = stage::Studio::Open(ShowOf(1));
    ASSERT_TRUE(studio) << studio.error().message();
    studio_ = std::move(*studio);
  }
  void TearDown() override { std::filesystem::remove_all(base_); }

  Result<void> Draw(const std::filesystem::path& folder) {
    written_.clear();
    return DrawSheets(*studio_, folder, {.cell_width_px = 64, .cell_height_px = 72},
                      [&](std::string_view name) { written_.emplace_back(name); });
  }

  const std::filesystem::path base_ =
      std::filesystem::temp_directory_path() / fmt::format("kaori-sheet-test-{}", ::getpid());
  std::vector<std::string> written_;

 private:
  std::unique_ptr<stage::Studio> studio_;
};

TEST_F(DrawnSheets, OfOneFaceAreWrittenWithTheirPage) {
  const auto drawn = Draw(base_ / "sheets");
  ASSERT_TRUE(drawn) << drawn.error().message();
  ASSERT_EQ(written_.size(), 5U);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(base_ / "sheets")) {
    EXPECT_THAT(written_, Contains(entry.path().string()));
    ++files;
  }
  EXPECT_EQ(files, written_.size());
  const auto picture = image::ReadPng(base_ / "sheets" / "face-reference.png");
  ASSERT_TRUE(picture) << picture.error().message();
  std::ifstream in(base_ / "sheets" / "index.html");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  EXPECT_THAT(page, HasSubstr("\"face-reference.png\""));
}

TEST_F(DrawnSheets, LeaveOtherFilesOfTheFolderAlone) {
  std::filesystem::create_directories(base_);
  std::ofstream(base_ / "notes.txt") << "mine";
  ASSERT_TRUE(Draw(base_));
  EXPECT_TRUE(std::filesystem::exists(base_ / "notes.txt"));
}

TEST_F(DrawnSheets, ThatCannotBeWrittenLeaveNothing) {
  std::filesystem::create_directories(base_);
  std::ofstream(base_ / "file") << "no folder";
  const auto drawn = Draw(base_ / "file" / "sheets");
  ASSERT_FALSE(drawn);
  EXPECT_THAT(drawn.error().attempt, HasSubstr("make the folder"));
  EXPECT_THAT(written_, IsEmpty());
}

}  // namespace
}  // namespace kaori::authoring
