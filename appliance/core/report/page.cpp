#include <algorithm>

#include <fmt/format.h>

#include "appliance/core/report/report.h"
#include "drivers/base/markup.h"

namespace kaori::report {
namespace {

// For A4 and for a browser alike: no row is torn between pages, and no heading ends one. Fonts are
// those that systems have.
constexpr std::string_view kReportStyle = R"(
@page { size: A4; margin: 14mm 12mm; }
body { font: 10.5pt/1.35 "Noto Sans", "Noto Sans CJK JP", "DejaVu Sans", sans-serif; color: #000; margin: 2em auto; max-width: 186mm; }
@media print { body { margin: 0; } }
h1 { font-size: 16pt; }
h2 { font-size: 12pt; break-after: avoid; }
table { border-collapse: collapse; width: 100%; }
tr { break-inside: avoid; }
th { text-align: left; border-bottom: 1pt solid #000; padding: 3pt 5pt; }
td { border-bottom: .4pt solid #888; padding: 3pt 5pt; font-variant-numeric: tabular-nums; }
)";

// Code points, since names may be Japanese: a terminal shows them in columns that are nearly even.
std::size_t Letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// Nothing is filled up behind the last column.
std::string Row(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += "  " + cells[i];
    if (i + 1 < cells.size()) line.append(widths[i] - Letters(cells[i]), ' ');
  }
  return line + "\n";
}

// Names come from a show that anybody may have made: each is escaped.
std::string Cells(const std::vector<std::string>& cells, std::string_view tag) {
  std::string row;
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, Escaped(cell));
  return row;
}

}  // namespace

// Each column is as wide as its widest cell.
std::string TextOfReport(const Report& report) {
  std::string text = report.title + "\n\n";
  for (const std::string& line : report.lines) text += line + "\n";
  for (const ReportTable& table : report.tables) {
    text += "\n" + table.title + "\n";
    if (table.rows.empty()) {
      text += "  " + table.none + "\n";
      continue;
    }
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      std::size_t width = Letters(table.columns[i]);
      for (const auto& row : table.rows) width = std::max(width, Letters(row[i]));
      widths.push_back(width);
    }
    text += Row(table.columns, widths);
    for (const auto& row : table.rows) text += Row(row, widths);
  }
  return text;
}

// One file without scripts and without anything from elsewhere, which prints on A4.
std::string PageOfReport(const Report& report) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta "
      "charset=\"utf-8\"><title>{0}</title><style>{1}</style></head>\n"
      "<body><h1>{0}</h1>\n",
      Escaped(report.title), kReportStyle);
  for (const std::string& line : report.lines) page += "<p>" + Escaped(line) + "</p>\n";
  for (const ReportTable& table : report.tables) {
    page += "<h2>" + Escaped(table.title) + "</h2>\n";
    if (table.rows.empty()) {
      page += "<p>" + Escaped(table.none) + "</p>\n";
      continue;
    }
    page += "<table><thead><tr>" + Cells(table.columns, "th") + "</tr></thead><tbody>\n";
    for (const auto& row : table.rows) page += "<tr>" + Cells(row, "td") + "</tr>\n";
    page += "</tbody></table>\n";
  }
  return page + "</body></html>\n";
}

}  // namespace kaori::report
