// The default show's first head as a file from a modelling tool: dense shapes named as ARKit names them,
// balls for eyes, standing where a whole figure would.
#pragma once

#include <filesystem>

#include "appliance/authoring/import/import.h"
#include "appliance/authoring/model/model.h"
#include "appliance/core/show/show.h"

namespace kaori::import {

using model::Model;

// A folder for the files of one test; gone with it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// The head in the file, 1.2 times as large as the show's and 1.5 m above the floor.
inline constexpr float kHeadScale = 1.2F;
Model ExportedHead();

void WriteGlb(const std::filesystem::path& file, const Model& model);

// The default cast as a show with one scene.
const show::Show& DefaultShow();

}  // namespace kaori::import
