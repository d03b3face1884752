// The document of a glTF file, and its parts in plain values.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "appliance/authoring/import/accessor.h"
#include "appliance/authoring/import/gltf_file.h"
#include "appliance/authoring/import/tiny_gltf.h"

namespace kaori::import {

// None where the file is no glTF; what is wrong with it goes to `findings`.
std::optional<tinygltf::Model> ParseGltf(const std::string& file, std::span<const std::uint8_t> bytes,
                                         const ReadBeside& beside, Findings& findings);

// The accessor's bytes; borrows the model. None where it names something that does not exist.
std::optional<Accessor> FindAccessor(const tinygltf::Model& model, int index);

// A mesh as a node of the scene places it.
struct PlacedMesh {
  int mesh = 0;
  int node = 0;
  glm::mat4 to_world{1};
};
std::vector<PlacedMesh> PlacedMeshes(const tinygltf::Model& model);

// The presets of VRM 0.x and 1.0.
std::vector<Preset> VrmPresets(const tinygltf::Model& model);

// The artist's names of a mesh's targets; "target 3" where there is none.
std::vector<std::string> TargetNames(const tinygltf::Mesh& mesh, std::size_t count);

}  // namespace kaori::import
