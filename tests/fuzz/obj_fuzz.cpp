// Any bytes as an OBJ file: a sound model within its bounds, or reasons that name the file.
#include <cstdint>

#include "appliance/authoring/model/mesh_check.h"
#include "appliance/authoring/model/obj_file.h"
#include "tests/fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  model::Findings findings;
  const auto model = model::ReadObj("input", {data, size}, findings);
  if (!model) {
    fuzz::Promise(!findings.empty(), "a refusal has a reason");
    fuzz::Promise(findings.lines()[0].starts_with("input: "), "a refusal names the file");
    return 0;
  }
  fuzz::Promise(model->positions.size() <= model::kMostVertices, "vertices are bounded");
  fuzz::Promise(model->uv.size() == model->positions.size(), "every vertex has its place");
  for (const auto& triangle : model->triangles)
    for (const auto corner : triangle) fuzz::Promise(corner < model->positions.size(), "a corner exists");
  model::CheckModel(*model, findings);
  model::CheckUnfolding(*model, model->triangles, findings);
  return 0;
}
