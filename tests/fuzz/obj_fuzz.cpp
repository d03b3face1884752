// Any bytes as an OBJ file: a sound model within its bounds, or reasons that name the file.
#include <cstdint>

#include "appliance/authoring/import/mesh_check.h"
#include "appliance/authoring/import/obj_file.h"
#include "tests/fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  import::Findings findings;
  const auto model = import::ReadObj("input", {data, size}, findings);
  if (!model) {
    fuzz::Promise(!findings.empty(), "a refusal has a reason");
    fuzz::Promise(findings.lines()[0].starts_with("input: "), "a refusal names the file");
    return 0;
  }
  fuzz::Promise(model->positions.size() <= import::kMostVertices, "vertices are bounded");
  fuzz::Promise(model->uv.size() == model->positions.size(), "every vertex has its place");
  for (const auto& triangle : model->triangles)
    for (const auto corner : triangle) fuzz::Promise(corner < model->positions.size(), "a corner exists");
  import::CheckModel(*model, findings);
  import::CheckUnfolding(*model, model->triangles, findings);
  return 0;
}
