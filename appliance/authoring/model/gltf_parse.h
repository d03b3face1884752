// The document of a glTF file, and its parts in plain values.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "appliance/authoring/model/accessor.h"
#include "appliance/authoring/model/gltf_file.h"
#include "appliance/authoring/model/tiny_gltf.h"

namespace kaori::model {

// Binary where the bytes begin with "glTF", else JSON. None where the file is no glTF or requires an
// extension that is not understood; the reason goes to `findings`. Pictures stay encoded: the
// library decodes none.
std::optional<tinygltf::Model> ParseGltf(const std::string& file, std::span<const std::uint8_t> bytes,
                                         const ReadBeside& beside, Findings& findings);

// The accessor's bytes; borrows the model. None where it names something that does not exist, or bytes beyond
// its buffer. Counts and strides are not checked here: ReadNumbers does.
std::optional<Accessor> FindAccessor(const tinygltf::Model& model, int index);

// A mesh as a node of the scene places it; `mesh` and `node` are indices that exist in the model.
struct PlacedMesh {
  // Indices into the document, and where the node places it: metres, the scene's axes.
  int mesh = 0;
  int node = 0;
  glm::mat4 to_world{1};
};
// In the order of a walk through the scenes, parents before children; a mesh that two nodes name comes twice.
// Where there is no scene, every node without a parent is a root. A node that is reached again, in a circle
// or by two parents, is left out, and so is all beyond 20 000 nodes.
std::vector<PlacedMesh> PlacedMeshes(const tinygltf::Model& model);

// The presets of VRM 0.x (extension VRM) and 1.0 (VRMC_vrm), those without a name or without a target that
// exists left out. Weights are brought to 0..1; VRM 0.x counts in percent.
std::vector<Preset> VrmPresets(const tinygltf::Model& model);

// The artist's names of a mesh's targets, from extras.targetNames as all tools write them; "target 3" where
// there is none. `count` names.
std::vector<std::string> TargetNames(const tinygltf::Mesh& mesh, std::size_t count);

}  // namespace kaori::model
