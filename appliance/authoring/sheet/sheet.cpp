#include "appliance/authoring/sheet/sheet.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "appliance/authoring/inspect/inspect.h"
#include "appliance/authoring/sheet/page.h"
#include "drivers/base/whole_file.h"
#include "render/image/text.h"

namespace kaori::authoring {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Step = std::function<void(std::string_view)>;

// A dark ground, as the stage has.
constexpr std::array<std::uint8_t, 3> kPaper{21, 24, 31};
constexpr std::array<std::uint8_t, 3> kFlaw{255, 92, 84};
// Around a cell with flaws; and the least side of a cell, however small its sheet is.
constexpr int kFrame_px = 3;
constexpr int kSmallestCell_px = 64;

// A file that is to be written when everything has been drawn.
struct File {
  std::string name;
  Bytes bytes;
};

// One colour; the fourth byte of a pixel is unused.
image::Picture Paper(int width_px, int height_px) {
  image::Picture paper = image::Picture::Blank(width_px, height_px);
  for (std::size_t i = 0; i < paper.rgbx.size(); ++i) paper.rgbx[i] = i % 4 < 3 ? kPaper[i % 4] : 0;
  return paper;
}

// Draws a frame along the inside of a picture's edge, over what is there.
void Frame(image::Picture& picture) {
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const int from_edge = std::min({x, y, picture.width_px - 1 - x, picture.height_px - 1 - y});
      if (from_edge >= kFrame_px) continue;
      const auto at = static_cast<std::ptrdiff_t>(y * picture.width_px + x) * 4;
      std::ranges::copy(kFlaw, picture.rgbx.begin() + at);
    }
}

// Draws sheets with one studio; the cell's picture is kept between cells. Borrows studio and lettering.
class Drawing {
 public:
  Drawing(stage::Studio& studio, image::Lettering& lettering) : studio_(studio), lettering_(lettering) {}

  // Pictures first, then texts over them.
  Result<image::Picture> Draw(const LaidOut& laid_out) {
    const auto& [sheet, layout] = laid_out;
    image::Picture whole = Paper(layout.width_px, layout.height_px);
    std::size_t i = 0;
    for (const Section& section : sheet.sections)
      for (const Cell& cell : section.cells)
        if (auto ok = Put(cell, layout.cells[i++], whole); !ok) return tl::unexpected(ok.error());
    for (const Label& label : layout.labels) {
      // Layouts count rows down from the top; pictures hold the bottom row first.
      const int y_px = whole.height_px - label.box.y_px - label.box.height_px;
      lettering_.Draw(label.text, label.style, label.box.x_px, y_px, whole);
    }
    return whole;
  }

 private:
  // Draws one cell and pastes it in. Errors: the studio's.
  Result<void> Put(const Cell& cell, const Box& box, image::Picture& into) {
    cell_ = image::Picture::Blank(box.width_px, box.height_px);
    if (auto ok = studio_.Draw(cell.scene, {cell_.width_px, cell_.height_px, ports::PixelMemory{cell_.rgbx}});
        !ok)
      return ok;
    if (!cell.flaws.empty()) Frame(cell_);
    image::Paste(cell_, into, box.x_px, into.height_px - box.y_px - box.height_px);
    return {};
  }

  stage::Studio& studio_;
  image::Lettering& lettering_;
  image::Picture cell_;
};

// What was asked for, times the sheet's own size. Where it lies is not known yet.
Box CellBox(const SheetOptions& options, float size) {
  const auto sized = [&](int length_px) {
    return std::max(kSmallestCell_px, static_cast<int>(std::lround(size * static_cast<float>(length_px))));
  };
  return {0, 0, sized(options.cell_width_px), sized(options.cell_height_px)};
}

// Sizes depend on texts and counts alone, so that all sheets are laid out before the first cell is drawn.
std::vector<LaidOut> LayOutAll(const show::Show& show, const SheetOptions& options, const Flaws& flaws,
                               image::Lettering& lettering) {
  std::vector<LaidOut> all;
  for (Sheet& sheet : PlanSheets(show, flaws)) {
    Layout layout = LayOut(sheet, CellBox(options, sheet.size), lettering);
    all.push_back({std::move(sheet), std::move(layout)});
  }
  return all;
}

// Everything in memory: pictures as PNG, and the page.
Result<std::vector<File>> DrawAll(stage::Studio& studio, const SheetOptions& options, const Step& step) {
  auto lettering = image::Lettering::Open();
  if (!lettering) return tl::unexpected(lettering.error());
  const show::Show& show = studio.show();
  const auto inspecting = [&](const std::string& face) { step("inspecting " + face); };
  const Flaws flaws = options.inspects ? Flaws(inspect::Inspect(show.cast, inspecting)) : Flaws();
  const std::vector<LaidOut> sheets = LayOutAll(show, options, flaws, *lettering);
  Drawing drawing(studio, *lettering);
  std::vector<File> files;
  for (const LaidOut& laid_out : sheets) {
    step(fmt::format("drawing {} ({} of {})", laid_out.sheet.file, files.size() + 1, sheets.size()));
    const auto picture = drawing.Draw(laid_out);
    if (!picture) return tl::unexpected(picture.error());
    auto bytes = image::EncodePng(*picture);
    if (!bytes) return tl::unexpected(bytes.error());
    files.push_back({laid_out.sheet.file, std::move(*bytes)});
  }
  const std::string page =
      Page(sheets, show.name, fmt::format("{}; {}", CountsOf(show.cast), flaws.summary()));
  files.push_back({"index.html", Bytes(page.begin(), page.end())});
  return files;
}

// Removes a folder that was made for nothing: all that is in it was put there by this call. A folder that was
// there before stays as it was, but for files that were written.
class NewFolder {
 public:
  static Result<NewFolder> Make(const std::filesystem::path& folder) {
    std::error_code error;
    NewFolder made;
    if (std::filesystem::create_directories(folder, error)) made.folder_ = folder;
    if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + folder.string());
    return made;
  }
  NewFolder(NewFolder&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}
  NewFolder& operator=(NewFolder&&) = delete;
  ~NewFolder() {
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  void Keep() { folder_.clear(); }

 private:
  NewFolder() = default;
  std::filesystem::path folder_;
};

}  // namespace

// Names are told after the last file is written, so that whoever reads them may open any.
Result<void> DrawSheets(stage::Studio& studio, const std::filesystem::path& folder,
                        const SheetOptions& options, const std::function<void(std::string_view)>& wrote,
                        const std::function<void(std::string_view)>& step) {
  const auto files = DrawAll(
      // `step` may be empty, and the steps below call it.
      studio, options, step ? step : [](std::string_view) {});
  if (!files) return tl::unexpected(files.error());
  auto made = NewFolder::Make(folder);
  if (!made) return tl::unexpected(made.error());
  for (const File& file : *files)
    if (auto ok = WriteWholeFile(folder / file.name, {file.bytes}); !ok) return ok;
  made->Keep();
  for (const File& file : *files) wrote((folder / file.name).string());
  return {};
}

}  // namespace kaori::authoring
