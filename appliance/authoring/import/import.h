// Faces made in modelling tools become a show: read, checked, split into parts, fitted, and exchanged with a
// show's own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "appliance/authoring/import/findings.h"
#include "appliance/authoring/import/model.h"
#include "appliance/authoring/import/point_choice.h"
#include "appliance/authoring/import/report.h"
#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::import {

// Reads and checks one file by its ending: .glb, .gltf, .obj. Every fault goes to `findings`; none where
// there was one.
std::optional<Model> ReadModel(const std::filesystem::path& file, Findings& findings);

// The same of several files that must have one topology; those that could be read.
std::vector<Model> ReadModels(const std::vector<std::filesystem::path>& files, Findings& findings);

struct ImportOptions {
  PointOptions points;
  std::vector<std::string>
      like;  // Faces of the show whose look the heads take, one by one; the last for the rest.
};

struct Imported {
  show::Show heads;                   // The imported heads with their own expressions, and the show's.
  std::optional<show::Show> on_show;  // The show given, with the artist's shapes added.
  Report report;
};

// The first file has the shapes; all have one topology and become the faces, named as their files. With a
// `show`, its expressions are carried to the heads, where an artist's shape does not fill the role already;
// its buttons, motions and scenes are kept as far as the heads go; and the artist's shapes are carried to the
// show's own faces; the heads are painted, combed and dressed as the faces that `options.like` names, or as
// the first. Takes seconds. Errors: invalid_argument; the attempt lists every fault, one a line: file, item,
// reason.
Result<Imported> Import(const std::vector<std::filesystem::path>& files, const show::Show* show,
                        const ImportOptions& options);

}  // namespace kaori::import
