// Faces made in modelling tools become a show: read, checked, split into parts, fitted, and exchanged with a
// show's own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "appliance/authoring/import/point_choice.h"
#include "appliance/authoring/import/report.h"
#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::import {

// What an author may choose; `points` says how many control points the cast gets at most.
struct ImportOptions {
  PointOptions points;
  // Faces of the show whose look the heads take, one by one; the last one for the rest. Empty:
  // the first face.
  std::vector<std::string> like;
};

// What Import made. Both shows have passed show::CheckShow and can be saved as packs.
struct Imported {
  show::Show heads;                   // The imported heads with their own expressions, and the show's.
  std::optional<show::Show> on_show;  // The show given, with the artist's shapes added.
  Report report;
};

// The first file has the shapes; all have one topology and become the faces of one cast, named as their
// files. With a `show` (borrowed during the call; null: none), its expressions are carried to the heads,
// where an artist's shape does not fill the role already; its buttons, motions and scenes are kept as far as
// the heads go; and the artist's shapes are carried to the show's own faces; the heads are painted, combed
// and dressed as the faces that `options.like` names, or as the first.
//
// The order of expressions is: the show's, by the show's indices, so that its buttons and motions still fit;
// the show's own once more under "NAME (show)" where the artist's took the role; what was found by form;
// further roles; the artist's shapes one by one, as channels. Takes seconds.
//
// Errors: invalid_argument; the attempt lists every fault, one a line: file, item, reason.
Result<Imported> Import(const std::vector<std::filesystem::path>& files, const show::Show* show,
                        const ImportOptions& options);

}  // namespace kaori::import
