#include "appliance/authoring/sheet/page.h"

#include "appliance/authoring/sheet/page_text.h"
#include "drivers/base/json.h"

namespace kaori::authoring {
namespace {

// What the page's script needs: where each cell lies in the picture file, and by which words it is found.
json::Object SheetData(const LaidOut& laid_out) {
  const auto& [sheet, layout] = laid_out;
  json::List cells;
  std::size_t i = 0;
  for (const Section& section : sheet.sections)
    for (const Cell& cell : section.cells) {
      // Layout keeps the cells in the sections' order.
      const Box& box = layout.cells[i++];
      cells.push_back(json::Object{{"face", cell.face},
                                   {"label", cell.label},
                                   {"flaws", cell.flaws},
                                   {"box", json::List{box.x_px, box.y_px, box.width_px, box.height_px}}});
    }
  return {{"file", sheet.file},
          {"title", sheet.title},
          {"width", layout.width_px},
          {"height", layout.height_px},
          {"cells", std::move(cells)}};
}

// JSON within a script element: no text of a show may end the script, so each "<" is written as an escape,
// which JSON reads as the same character.
std::string Quoted(const json::Value& data) {
  std::string text = json::Write(data);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

// The page's script is part of page.html; only data is put in here.
std::string Page(const std::vector<LaidOut>& sheets, const std::string& show, const std::string& about) {
  json::List data;
  for (const LaidOut& sheet : sheets) data.emplace_back(SheetData(sheet));
  constexpr std::string_view kMark = "@DATA@";
  std::string page(kSheetPage);
  page.replace(page.find(kMark), kMark.size(),
               Quoted(json::Object{{"name", show}, {"about", about}, {"sheets", std::move(data)}}));
  return page;
}

}  // namespace kaori::authoring
