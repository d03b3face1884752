#include "appliance/authoring/import/report.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kaori::import {
namespace {

// One line of a table: name, three figures in millimetres, what it means or is made of. Names longer than 26
// letters push the line.
std::string Row(const std::string& name, const std::string& what, const FitError& error) {
  return fmt::format("  {:<26} {:7.2f} {:7.2f} {:7.2f}  {}\n", name, error.rms_mm, error.most_mm,
                     error.shape_mm, what);
}

std::string TableHead(const char* title, const char* first, const char* last) {
  return fmt::format("\n{}\n  {:<26} {:>7} {:>7} {:>7}  {}\n", title, first, "rms mm", "max mm", "moves",
                     last);
}

// Of the root mean squares the mean, of the others the largest.
FitError Mean(const std::vector<ReportedShape>& shapes) {
  FitError mean;
  for (const ReportedShape& shape : shapes) {
    mean.rms_mm += shape.error.rms_mm / static_cast<float>(shapes.size());
    mean.most_mm = std::max(mean.most_mm, shape.error.most_mm);
    mean.shape_mm = std::max(mean.shape_mm, shape.error.shape_mm);
  }
  return mean;
}

// Nothing at all where there is no shape: an import without a show has no second table.
std::string Shapes(const char* title, const std::vector<ReportedShape>& shapes) {
  if (shapes.empty()) return {};
  std::string text = TableHead(title, "shape", "means");
  for (const ReportedShape& shape : shapes)
    text += Row(shape.name, shape.meaning.empty() ? "(not known; a channel of its own)" : shape.meaning,
                shape.error);
  return text + Row("mean rms, largest max", "", Mean(shapes));
}

// For a line that must not end in nothing.
std::string Listed(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::vector<std::string> UnmappedShapes(const Report& report) {
  std::vector<std::string> names;
  for (const ReportedShape& shape : report.shapes)
    if (shape.meaning.empty()) names.push_back(shape.name);
  return names;
}

std::vector<std::string> UnmappedRoles(const Report& report) {
  std::vector<std::string> names;
  for (const ReportedRole& role : report.roles)
    if (role.made_of.empty()) names.push_back(role.name);
  return names;
}

std::string Text(const Report& report) {
  std::string text;
  for (const std::string& remark : report.remarks) text += remark + "\n";
  // Before the tables, which few people read to their end.
  if (!report.doubts.empty()) text += "\nnot fit for a stage yet\n";
  for (const std::string& doubt : report.doubts) text += "  " + doubt + "\n";
  text += Shapes("the artist's shapes; what control points alone miss (the rest is kept beside them)",
                 report.shapes);
  text += TableHead("roles", "role", "made of");
  for (const ReportedRole& role : report.roles)
    text += Row(role.name, role.made_of.empty() ? "(nothing)" : role.made_of, role.error);
  text += Shapes("the artist's shapes on the show's first face", report.on_show);
  const auto shapes = UnmappedShapes(report);
  const auto roles = UnmappedRoles(report);
  return text + fmt::format("\nnot mapped\n  shapes ({} of {}): {}\n  roles ({} of {}): {}\n", shapes.size(),
                            report.shapes.size(), Listed(shapes), roles.size(), report.roles.size(),
                            Listed(roles));
}

}  // namespace kaori::import
