#include <algorithm>
#include <string_view>
#include <utility>

#include "appliance/authoring/model/gltf_parse.h"

namespace kaori::model {
namespace {

// VRM 0.x says weights as 0..100.
constexpr float kPercent = 0.01F;

// These readers of untyped values take null and wrong types for what is not there: extensions are not checked
// by the library.
const tinygltf::Value* Member(const tinygltf::Value* value, const char* name) {
  return value != nullptr && value->Has(name) ? &value->Get(name) : nullptr;
}

std::string Text(const tinygltf::Value* value) {
  return value != nullptr && value->IsString() ? value->Get<std::string>() : std::string();
}

float Number(const tinygltf::Value* value, float otherwise) {
  return value != nullptr && value->IsNumber() ? static_cast<float>(value->GetNumberAsDouble()) : otherwise;
}

// -1, which is no index, where there is no whole number.
int Whole(const tinygltf::Value* value) {
  return value != nullptr && value->IsInt() ? value->Get<int>() : -1;
}

template <class Use>
void ForEach(const tinygltf::Value* array, Use use) {
  for (std::size_t i = 0; array != nullptr && i < array->ArrayLen(); ++i)
    use(array->Get(static_cast<int>(i)));
}

// The name that ReadGltf gives the target; empty for an index that is none.
std::string TargetName(const tinygltf::Model& model, int mesh, int target) {
  if (mesh < 0 || static_cast<std::size_t>(mesh) >= model.meshes.size() || target < 0) return {};
  const tinygltf::Mesh& from = model.meshes[static_cast<std::size_t>(mesh)];
  if (from.primitives.empty()) return {};
  const std::size_t count = from.primitives.front().targets.size();
  const auto index = static_cast<std::size_t>(target);
  return index < count ? TargetNames(from, count)[index] : std::string();
}

// Meshes that share a target's name are one shape here, so a second bind to it is the same part.
void AddPart(const std::string& target, float weight, Preset& preset) {
  if (target.empty()) return;
  const auto same = std::ranges::find(preset.parts, target, &PresetPart::target);
  if (same == preset.parts.end()) preset.parts.push_back({target, weight});
}

// VRM 0.x, blendShapeGroups: groups with binds of mesh, index and a weight in percent. "unknown" is what VRM
// calls a group of the artist's own.
Preset Group(const tinygltf::Model& model, const tinygltf::Value& group) {
  Preset preset{Text(Member(&group, "presetName")), {}};
  if (preset.name.empty() || preset.name == "unknown") preset.name = Text(Member(&group, "name"));
  ForEach(Member(&group, "binds"), [&](const tinygltf::Value& bind) {
    const std::string target = TargetName(model, Whole(Member(&bind, "mesh")), Whole(Member(&bind, "index")));
    AddPart(target, kPercent * Number(Member(&bind, "weight"), 100), preset);
  });
  return preset;
}

// VRM 1.0, expressions: an object by name, morphTargetBinds of node, index and a weight of 0..1. Material and
// texture binds are left out.
Preset Expression(const tinygltf::Model& model, std::string name, const tinygltf::Value& expression) {
  Preset preset{std::move(name), {}};
  ForEach(Member(&expression, "morphTargetBinds"), [&](const tinygltf::Value& bind) {
    const int node = Whole(Member(&bind, "node"));
    const bool exists = node >= 0 && static_cast<std::size_t>(node) < model.nodes.size();
    const int mesh = exists ? model.nodes[static_cast<std::size_t>(node)].mesh : -1;
    AddPart(TargetName(model, mesh, Whole(Member(&bind, "index"))), Number(Member(&bind, "weight"), 1),
            preset);
  });
  return preset;
}

}  // namespace

// A file has one of the two extensions; both are read where a tool wrote both.
std::vector<Preset> VrmPresets(const tinygltf::Model& model) {
  std::vector<Preset> presets;
  if (const auto vrm = model.extensions.find("VRM"); vrm != model.extensions.end()) {
    ForEach(Member(Member(&vrm->second, "blendShapeMaster"), "blendShapeGroups"),
            [&](const tinygltf::Value& group) { presets.push_back(Group(model, group)); });
  }
  if (const auto vrm = model.extensions.find("VRMC_vrm"); vrm != model.extensions.end()) {
    const tinygltf::Value* expressions = Member(&vrm->second, "expressions");
    // "preset" are the standard's names, "custom" the artist's.
    for (const char* kind : {"preset", "custom"}) {
      const tinygltf::Value* named = Member(expressions, kind);
      if (named == nullptr) continue;
      for (const std::string& name : named->Keys())
        presets.push_back(Expression(model, name, named->Get(name)));
    }
  }
  std::erase_if(presets, [](const Preset& preset) { return preset.name.empty() || preset.parts.empty(); });
  return presets;
}

}  // namespace kaori::model
