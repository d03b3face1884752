#include "appliance/atelier/import/report.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kaori::import {
namespace {

std::string Row(const std::string& name, const std::string& what, const FitError& error) {
  return fmt::format("  {:<26} {:<50} {:7.2f} {:7.2f} {:7.2f}\n", name, what, error.rms_mm, error.most_mm,
                     error.shape_mm);
}

std::string Head(const char* title, const char* first, const char* second) {
  return fmt::format("\n{}\n  {:<26} {:<50} {:>7} {:>7} {:>7}\n", title, first, second, "rms mm", "max mm",
                     "moves");
}

FitError Mean(const std::vector<ReportedShape>& shapes) {
  FitError mean;
  for (const ReportedShape& shape : shapes) {
    mean.rms_mm += shape.error.rms_mm / static_cast<float>(shapes.size());
    mean.most_mm = std::max(mean.most_mm, shape.error.most_mm);
    mean.shape_mm = std::max(mean.shape_mm, shape.error.shape_mm);
  }
  return mean;
}

std::string Shapes(const char* title, const std::vector<ReportedShape>& shapes) {
  if (shapes.empty()) return {};
  std::string text = Head(title, "shape", "means");
  for (const ReportedShape& shape : shapes)
    text += Row(shape.name, shape.meaning.empty() ? "(not known; a channel of its own)" : shape.meaning,
                shape.error);
  return text + Row("mean rms, largest max", "", Mean(shapes));
}

std::string Unmapped(const Report& report) {
  std::vector<std::string> shapes;
  std::vector<std::string> roles;
  for (const ReportedShape& shape : report.shapes)
    if (shape.meaning.empty()) shapes.push_back(shape.name);
  for (const ReportedRole& role : report.roles)
    if (role.made_of.empty()) roles.push_back(role.name);
  return fmt::format("\nnot mapped\n  shapes: {}\n  roles:  {}\n",
                     shapes.empty() ? "none" : fmt::format("{}", fmt::join(shapes, ", ")),
                     roles.empty() ? "none" : fmt::format("{}", fmt::join(roles, ", ")));
}

}  // namespace

std::string Text(const Report& report) {
  std::string text;
  for (const std::string& remark : report.remarks) text += remark + "\n";
  text += Shapes("the artist's shapes; what control points alone miss (the rest is kept beside them)",
                 report.shapes);
  text += Head("roles", "role", "made of");
  for (const ReportedRole& role : report.roles)
    text += Row(role.name, role.made_of.empty() ? "(nothing)" : role.made_of, role.error);
  text += Shapes("the artist's shapes on the show's first face", report.on_show);
  return text + Unmapped(report);
}

}  // namespace kaori::import
