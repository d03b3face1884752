#include "appliance/atelier/sheet/sheet.h"

#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "render/image/png.h"

namespace kaori::atelier {
namespace {

constexpr int kColumns = 8;
constexpr std::array<const char*, scene::kStyleCount> kStyles{"wire", "flat", "bare", "hair", "soft"};
constexpr std::array<float, 5> kSides_rad{-1.3F, -0.6F, 0.0F, 0.6F, 1.3F};

struct Cell {
  std::string caption;
  scene::Scene scene;
};

struct Sheet {
  std::string file;
  std::string title;
  int columns = kColumns;
  std::vector<Cell> cells;
};

scene::Scene Portrait(std::uint16_t face) {
  scene::Scene scene;
  scene.weights.faces.Push(face, 1);
  scene.weights.expressions.Push(0, 1);
  return scene;
}

scene::Scene Wearing(const face::Cast& cast, std::uint16_t face, std::uint16_t expression) {
  scene::Scene scene = Portrait(face);
  if (cast.expressions[expression].kind == face::ExpressionKind::kExpression) {
    scene.weights.expressions.clear();
    scene.weights.expressions.Push(expression, 1);
  } else {
    scene.weights.channels.Push(expression, 1);
  }
  return scene;
}

Sheet FacesSheet(const face::Cast& cast) {
  Sheet sheet{"faces.png", "The cast from five sides", static_cast<int>(kSides_rad.size()), {}};
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face)
    for (const float side : kSides_rad) {
      Cell cell{cast.faces[face].name, Portrait(face)};
      cell.scene.camera.yaw_rad = side;
      sheet.cells.push_back(cell);
    }
  return sheet;
}

Sheet StylesSheet(const face::Cast& cast) {
  Sheet sheet{"styles.png", "The ways of drawing", scene::kStyleCount, {}};
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face)
    for (std::size_t style = 0; style < kStyles.size(); ++style) {
      Cell cell{fmt::format("{}, {}", cast.faces[face].name, kStyles[style]), Portrait(face)};
      cell.scene.styles = {};
      cell.scene.styles[style] = 1;
      cell.scene.head.yaw_rad = 0.35F;
      sheet.cells.push_back(cell);
    }
  return sheet;
}

Sheet MorphsSheet(const face::Cast& cast) {
  constexpr int kSteps = 5;
  Sheet sheet{"morphs.png", "From the first face to the others", kSteps, {}};
  for (std::uint16_t face = 1; face < cast.faces.size(); ++face)
    for (int step = 0; step < kSteps; ++step) {
      const float share = static_cast<float>(step) / (kSteps - 1);
      Cell cell{fmt::format("{} {:.2f}", cast.faces[face].name, share), Portrait(0)};
      cell.scene.weights.faces.clear();
      cell.scene.weights.faces.Push(0, 1 - share);
      cell.scene.weights.faces.Push(face, share);
      cell.scene.head.yaw_rad = 0.3F;
      sheet.cells.push_back(cell);
    }
  return sheet;
}

Sheet FaceSheet(const face::Cast& cast, std::uint16_t face) {
  const std::string& name = cast.faces[face].name;
  Sheet sheet{fmt::format("face-{}.png", name), fmt::format("{}: every expression", name), kColumns, {}};
  for (std::uint16_t e = 0; e < cast.expressions.size(); ++e) {
    Cell cell{cast.expressions[e].name, Wearing(cast, face, e)};
    cell.scene.head.yaw_rad = 0.2F;
    sheet.cells.push_back(cell);
  }
  for (const float shut : {0.5F, 1.0F}) {
    Cell cell{fmt::format("lids {:.1f}", shut), Portrait(face)};
    cell.scene.weights.lids_shut = {shut, shut};
    sheet.cells.push_back(cell);
  }
  return sheet;
}

std::vector<Sheet> AllSheets(const face::Cast& cast) {
  std::vector<Sheet> sheets{FacesSheet(cast), StylesSheet(cast), MorphsSheet(cast)};
  for (std::uint16_t face = 0; face < cast.faces.size(); ++face) sheets.push_back(FaceSheet(cast, face));
  return sheets;
}

Result<image::Picture> Draw(stage::Studio& studio, const Sheet& sheet, const SheetOptions& options) {
  const int rows = (static_cast<int>(sheet.cells.size()) + sheet.columns - 1) / sheet.columns;
  image::Picture whole =
      image::Picture::Blank(sheet.columns * options.cell_width_px, rows * options.cell_height_px);
  image::Picture cell = image::Picture::Blank(options.cell_width_px, options.cell_height_px);
  for (std::size_t i = 0; i < sheet.cells.size(); ++i) {
    const ports::PixelBuffer buffer{cell.width_px, cell.height_px, cell.rgbx};
    if (auto ok = studio.Draw(sheet.cells[i].scene, buffer); !ok) return tl::unexpected(ok.error());
    const int column = static_cast<int>(i) % sheet.columns;
    const int row = rows - 1 - static_cast<int>(i) / sheet.columns;
    image::Paste(cell, whole, column * cell.width_px, row * cell.height_px);
  }
  return whole;
}

// Captions lie over each cell of the picture.
std::string Page(const std::vector<Sheet>& sheets, const std::string& show) {
  std::string page = fmt::format(
      "<!doctype html><meta "
      "charset=utf-8><title>{0}</title><style>body{{background:#15181f;color:#dde;font:14px "
      "sans-serif}}div{{position:relative;width:100%}}img{{width:100%}}span{{position:absolute;padding:2px "
      "6px}}"
      "</style><h1>{0}</h1>",
      show);
  for (const Sheet& sheet : sheets) {
    const auto rows = (sheet.cells.size() + static_cast<std::size_t>(sheet.columns) - 1) /
                      static_cast<std::size_t>(sheet.columns);
    page += fmt::format("<h2>{}</h2><div><img src=\"{}\">", sheet.title, sheet.file);
    for (std::size_t i = 0; i < sheet.cells.size(); ++i)
      page += fmt::format(
          "<span style=\"left:{:.2f}%;top:{:.2f}%\">{}</span>",
          100.0 * static_cast<double>(i % static_cast<std::size_t>(sheet.columns)) / sheet.columns,
          100.0 * static_cast<double>(i / static_cast<std::size_t>(sheet.columns)) /
              static_cast<double>(rows),
          sheet.cells[i].caption);
    page += "</div>";
  }
  return page;
}

}  // namespace

Result<void> DrawSheets(stage::Studio& studio, const std::filesystem::path& folder,
                        const SheetOptions& options, const std::function<void(std::string_view)>& wrote) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + folder.string());
  const std::vector<Sheet> sheets = AllSheets(studio.show().cast);
  for (const Sheet& sheet : sheets) {
    const auto picture = Draw(studio, sheet, options);
    if (!picture) return tl::unexpected(picture.error());
    if (auto ok = image::WritePng(folder / sheet.file, *picture); !ok) return ok;
    wrote((folder / sheet.file).string());
  }
  std::ofstream page(folder / "index.html");
  page << Page(sheets, studio.show().name);
  if (!page.flush()) return Fail(std::errc::io_error, "write " + (folder / "index.html").string());
  wrote((folder / "index.html").string());
  return {};
}

}  // namespace kaori::atelier
