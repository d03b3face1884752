// Any bytes as a glTF file: a sound model within its bounds, or reasons that name the file.
#include <cstdint>
#include <optional>
#include <span>

#include "appliance/authoring/model/gltf_file.h"
#include "appliance/authoring/model/mesh_check.h"
#include "tests/fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  model::Findings findings;
  const model::ReadBeside nothing = [](const std::string&) { return std::nullopt; };
  const auto model = model::ReadGltf("input", {data, size}, nothing, findings);
  if (!model) {
    fuzz::Promise(!findings.empty(), "a refusal has a reason");
    fuzz::Promise(findings.lines()[0].starts_with("input: "), "a refusal names the file");
    return 0;
  }
  fuzz::Promise(model->positions.size() <= model::kMostVertices, "vertices are bounded");
  fuzz::Promise(model->uv.size() == model->positions.size(), "every vertex has its place");
  for (const auto& triangle : model->triangles)
    for (const auto corner : triangle) fuzz::Promise(corner < model->positions.size(), "a corner exists");
  for (const auto& target : model->targets)
    fuzz::Promise(target.offsets.size() == model->positions.size(), "a target moves every vertex");
  model::CheckModel(*model, findings);
  model::CheckUnfolding(*model, model->triangles, findings);
  return 0;
}
