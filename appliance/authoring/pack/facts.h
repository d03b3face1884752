// What there is to know about a pack: what it holds, what it needs, and how its faces look.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "appliance/authoring/inspect/inspect.h"
#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// Counts, names and measurements of one pack.
struct Facts {
  // The show's name.
  std::string show;
  std::uint64_t file_bytes = 0;
  std::string signed_by;  // The public key in hexadecimal; empty: nobody.
  // Reading, checking and copying, as the stage does it; the quickest of three.
  double load_ms = 0;

  // Of the surface that is drawn: the fine mesh, or the cage where there is none.
  std::size_t triangles_on_face = 0;
  // The mesh that expressions move.
  std::size_t triangles_of_cage = 0;
  std::size_t vertices_of_cage = 0;
  std::size_t control_points = 0;
  std::vector<std::string> faces;
  // Those that an operator calls; `mouth_shapes` and `channels` are the two kinds that are played on top.
  std::vector<std::string> expressions;
  std::vector<std::string> mouth_shapes;
  std::vector<std::string> channels;
  std::size_t props = 0;
  // Hair, clothes and gear of all faces together.
  std::size_t triangles_of_props = 0;
  std::size_t textures = 0;
  std::size_t motions = 0;
  std::size_t scenes = 0;

  // In all poses.
  inspect::Inspection looks;
};

// Loads the pack and looks at all its faces; some seconds, on all processors. `progress` hears what it is
// doing, from one thread at a time. A signature is told, not judged: whose key is trusted is the stage's
// matter. Errors: those of LoadPack.
Result<Facts> GatherFacts(const std::filesystem::path& file,
                          const std::function<void(const std::string&)>& progress);

// For people: a line for each fact, and the first twenty findings.
std::string FactsPage(const Facts& facts);
// For programs: one object with the same, every finding, and the names of all items under "names".
// `signed_by` is null where nobody signed.
std::string FactsJson(const Facts& facts);

}  // namespace kaori::authoring
