#include <nlohmann/json.hpp>

#include "appliance/authoring/pack/facts.h"

namespace kaori::authoring {
namespace {

using Json = nlohmann::ordered_json;

Json Findings(const inspect::Inspection& looks) {
  Json list = Json::array();
  for (const inspect::Finding& finding : looks.findings)
    list.push_back({{"face", finding.face},
                    {"pose", finding.pose},
                    {"count", finding.count},
                    {"measure", finding.measure},
                    {"says", Say(finding)}});
  return list;
}

}  // namespace

std::string FactsJson(const Facts& f) {
  const Json json{{"show", f.show},
                  {"file_bytes", f.file_bytes},
                  {"signed_by", f.signed_by.empty() ? Json(nullptr) : Json(f.signed_by)},
                  {"load_ms", f.load_ms},
                  {"triangles_on_face", f.triangles_on_face},
                  {"triangles_of_cage", f.triangles_of_cage},
                  {"vertices_of_cage", f.vertices_of_cage},
                  {"control_points", f.control_points},
                  {"faces", f.faces.size()},
                  {"expressions", f.expressions.size()},
                  {"mouth_shapes", f.mouth_shapes.size()},
                  {"channels", f.channels.size()},
                  {"props", f.props},
                  {"triangles_of_props", f.triangles_of_props},
                  {"textures", f.textures},
                  {"motions", f.motions},
                  {"scenes", f.scenes},
                  {"folds", f.looks.folds},
                  {"lid_gaps", f.looks.lid_gaps},
                  {"teeth_through_lips", f.looks.teeth_through_lips},
                  {"names",
                   {{"faces", f.faces},
                    {"expressions", f.expressions},
                    {"mouth_shapes", f.mouth_shapes},
                    {"channels", f.channels}}},
                  {"findings", Findings(f.looks)}};
  return json.dump(1) + "\n";
}

}  // namespace kaori::authoring
