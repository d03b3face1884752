#include "appliance/authoring/pack/facts.h"
#include "drivers/base/json.h"

namespace kaori::authoring {
namespace {

// Numbers for programs, and the line for people.
// What `measure` is in depends on the finding's kind; `says` has its unit.
json::List Findings(const inspect::Inspection& looks) {
  json::List list;
  for (const inspect::Finding& finding : looks.findings)
    list.push_back(json::Object{{"face", finding.face},
                                {"pose", finding.pose},
                                {"count", finding.count},
                                {"measure", finding.measure},
                                {"says", Say(finding)}});
  return list;
}

}  // namespace

// Times are milliseconds, lengths of files bytes. `signed_by` is null where nobody signed.
// The keys are the names of the fields of Facts, and of its inspection.
std::string FactsJson(const Facts& f) {
  const json::Object page{{"show", f.show},
                          {"file_bytes", f.file_bytes},
                          {"signed_by", f.signed_by.empty() ? json::Value() : json::Value(f.signed_by)},
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
                          // Counts stand above under the same keys.
                          {"names", json::Object{{"faces", json::ListOf(f.faces)},
                                                 {"expressions", json::ListOf(f.expressions)},
                                                 {"mouth_shapes", json::ListOf(f.mouth_shapes)},
                                                 {"channels", json::ListOf(f.channels)}}},
                          {"findings", Findings(f.looks)}};
  // The indentation of 1 keeps the page readable; the newline ends the last line for tools that read lines.
  return json::Write(page, 1) + "\n";
}

}  // namespace kaori::authoring
