// Reads glTF 2.0: .glb, and .gltf with its buffers inside or beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "appliance/authoring/model/findings.h"
#include "appliance/authoring/model/model.h"

namespace kaori::model {

// Gives the bytes of a file that stands beside the one that is read; none where there is no such file, or it
// must not be read. The name comes from within the file and is not to be trusted; ReadModel's answers only
// names within the file's own folder.
using ReadBeside = std::function<std::optional<std::vector<std::uint8_t>>(const std::string& name)>;

// All triangle meshes of the scene in one list of vertices, each as its node places it (a skinned mesh stays
// where it is, as glTF 2.0, section 3.7.3, says). Offsets of targets are turned along; targets of equal name
// in several meshes are one. A mesh that a node mirrors has its triangles turned back. KHR_mesh_quantization
// is understood; other extensions that the file calls required, and that are not in the list of
// gltf_parse.cpp, are not. VRM's presets (0.x and 1.0) become presets.
//
// None where there was a fault; every one goes to `findings` under the name `file`: no glTF, no triangle, a
// mesh without positions or texture coordinates, numbers that the buffer does not hold, counts that do not
// fit each other, more than model.h allows. A texture that is missing is a fault, too. Normals, materials
// beyond the first texture, skins and animations are left out. `bytes` are borrowed during the call.
std::optional<Model> ReadGltf(const std::string& file, std::span<const std::uint8_t> bytes,
                              const ReadBeside& beside, Findings& findings);

}  // namespace kaori::model
