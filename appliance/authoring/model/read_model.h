// Files of heads, read by their endings and checked.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "appliance/authoring/model/findings.h"
#include "appliance/authoring/model/model.h"

namespace kaori::model {

// Reads and checks one file by its ending: .glb, .gltf, .obj, in capitals or not. At most kMostFile_bytes are
// read, regular files only. Every fault goes to `findings`: a file that cannot be read, another ending, what
// the readers and CheckModel find. None where there was one.
std::optional<Model> ReadModel(const std::filesystem::path& file, Findings& findings);

// The same of several files that must have one topology, that of the first; those that could be read. Where
// `findings` has grown, the models are not to be imported.
std::vector<Model> ReadModels(const std::vector<std::filesystem::path>& files, Findings& findings);

}  // namespace kaori::model
