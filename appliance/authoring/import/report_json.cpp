#include "appliance/authoring/import/report.h"
#include "drivers/base/json.h"

namespace kaori::import {
namespace {

// A name that means nothing is null, so that no program takes "" for a meaning.
json::Value OrNull(const std::string& text) {
  return text.empty() ? json::Value() : json::Value(text);
}

// `key`: "means" or "made_of".
json::Object ReportJsonRow(const std::string& name, const char* key, const std::string& what,
                           const FitError& error) {
  return {{"name", name},
          {key, OrNull(what)},
          {"rms_mm", error.rms_mm},
          {"max_mm", error.most_mm},
          {"moves_mm", error.shape_mm}};
}

json::List Shapes(const std::vector<ReportedShape>& shapes) {
  json::List list;
  for (const ReportedShape& shape : shapes)
    list.emplace_back(ReportJsonRow(shape.name, "means", shape.meaning, shape.error));
  return list;
}

}  // namespace

std::string JsonText(const Report& report) {
  json::List roles;
  for (const ReportedRole& role : report.roles)
    roles.emplace_back(ReportJsonRow(role.name, "made_of", role.made_of, role.error));
  const json::Object page{{"remarks", json::ListOf(report.remarks)},
                          {"doubts", json::ListOf(report.doubts)},
                          {"shapes", Shapes(report.shapes)},
                          {"roles", std::move(roles)},
                          {"shapes_on_show", Shapes(report.on_show)},
                          {"shapes_not_mapped", json::ListOf(UnmappedShapes(report))},
                          {"roles_not_mapped", json::ListOf(UnmappedRoles(report))}};
  return json::Write(page, 2) + "\n";
}

}  // namespace kaori::import
