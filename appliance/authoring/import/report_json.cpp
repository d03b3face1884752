#include <nlohmann/json.hpp>

#include "appliance/authoring/import/report.h"

namespace kaori::import {
namespace {

using Json = nlohmann::ordered_json;

Json OrNull(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json ReportJsonRow(const std::string& name, const char* key, const std::string& what, const FitError& error) {
  return {{"name", name},
          {key, OrNull(what)},
          {"rms_mm", error.rms_mm},
          {"max_mm", error.most_mm},
          {"moves_mm", error.shape_mm}};
}

Json Shapes(const std::vector<ReportedShape>& shapes) {
  Json list = Json::array();
  for (const ReportedShape& shape : shapes)
    list.push_back(ReportJsonRow(shape.name, "means", shape.meaning, shape.error));
  return list;
}

}  // namespace

std::string JsonText(const Report& report) {
  Json roles = Json::array();
  for (const ReportedRole& role : report.roles)
    roles.push_back(ReportJsonRow(role.name, "made_of", role.made_of, role.error));
  const Json json{{"remarks", report.remarks},
                  {"shapes", Shapes(report.shapes)},
                  {"roles", std::move(roles)},
                  {"shapes_on_show", Shapes(report.on_show)},
                  {"shapes_not_mapped", UnmappedShapes(report)},
                  {"roles_not_mapped", UnmappedRoles(report)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kaori::import
