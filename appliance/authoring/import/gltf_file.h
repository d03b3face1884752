// Reads glTF 2.0: .glb, and .gltf with its buffers inside or beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "appliance/authoring/import/findings.h"
#include "appliance/authoring/import/model.h"

namespace kaori::import {

// Gives the bytes of a file that stands beside the one that is read; none where there is no such file.
using ReadBeside = std::function<std::optional<std::vector<std::uint8_t>>(const std::string& name)>;

// All triangle meshes of the scene, each as its node places it (a skinned mesh stays where it is). Offsets of
// targets are turned along; targets of equal name in several meshes are one. KHR_mesh_quantization is
// understood, other required extensions are not. VRM's presets (0.x and 1.0) become presets. None where the
// file cannot be read; every fault goes to `findings` under the name `file`.
std::optional<Model> ReadGltf(const std::string& file, std::span<const std::uint8_t> bytes,
                              const ReadBeside& beside, Findings& findings);

}  // namespace kaori::import
