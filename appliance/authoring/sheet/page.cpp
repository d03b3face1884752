#include "appliance/authoring/sheet/page.h"

#include <nlohmann/json.hpp>

#include "appliance/authoring/sheet/page_text.h"

namespace kaori::authoring {
namespace {

using Json = nlohmann::ordered_json;

Json SheetData(const LaidOut& laid_out) {
  const auto& [sheet, layout] = laid_out;
  Json data{
      {"file", sheet.file}, {"title", sheet.title}, {"width", layout.width_px}, {"height", layout.height_px}};
  Json& cells = data["cells"] = Json::array();
  std::size_t i = 0;
  for (const Section& section : sheet.sections)
    for (const Cell& cell : section.cells) {
      const Box& box = layout.cells[i++];
      cells.push_back({{"face", cell.face},
                       {"label", cell.label},
                       {"flaws", cell.flaws},
                       {"box", {box.x_px, box.y_px, box.width_px, box.height_px}}});
    }
  return data;
}

// JSON within a script: no text of a show may end the script.
std::string Quoted(const Json& data) {
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

std::string Page(const std::vector<LaidOut>& sheets, const std::string& show, const std::string& about) {
  Json data{{"name", show}, {"about", about}, {"sheets", Json::array()}};
  for (const LaidOut& sheet : sheets) data["sheets"].push_back(SheetData(sheet));
  constexpr std::string_view kMark = "@DATA@";
  std::string page(kPage);
  page.replace(page.find(kMark), kMark.size(), Quoted(data));
  return page;
}

}  // namespace kaori::authoring
