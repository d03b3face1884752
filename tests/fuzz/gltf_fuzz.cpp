// Any bytes as a glTF file: a sound model within its bounds, or reasons that name the file.
#include <cstdint>
#include <optional>
#include <span>

#include "appliance/authoring/import/gltf_file.h"
#include "appliance/authoring/import/mesh_check.h"
#include "tests/fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  import::Findings findings;
  const import::ReadBeside nothing = [](const std::string&) { return std::nullopt; };
  const auto model = import::ReadGltf("input", {data, size}, nothing, findings);
  if (!model) {
    fuzz::Promise(!findings.empty(), "a refusal has a reason");
    fuzz::Promise(findings.lines()[0].starts_with("input: "), "a refusal names the file");
    return 0;
  }
  fuzz::Promise(model->positions.size() <= import::kMostVertices, "vertices are bounded");
  fuzz::Promise(model->uv.size() == model->positions.size(), "every vertex has its place");
  for (const auto& triangle : model->triangles)
    for (const auto corner : triangle) fuzz::Promise(corner < model->positions.size(), "a corner exists");
  for (const auto& target : model->targets)
    fuzz::Promise(target.offsets.size() == model->positions.size(), "a target moves every vertex");
  import::CheckModel(*model, findings);
  import::CheckUnfolding(*model, model->triangles, findings);
  return 0;
}
