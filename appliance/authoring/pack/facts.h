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

struct Facts {
  std::string show;
  std::uint64_t file_bytes = 0;
  std::string signed_by;  // The public key in hexadecimal; empty: nobody.
  double load_ms = 0;     // Reading, checking and copying, as the stage does it; the quickest of three.

  std::size_t triangles_on_face = 0;  // Of the surface that is drawn.
  std::size_t triangles_of_cage = 0;
  std::size_t vertices_of_cage = 0;
  std::size_t control_points = 0;
  std::vector<std::string> faces;
  std::vector<std::string> expressions;   // Called by an operator,
  std::vector<std::string> mouth_shapes;  // and the two kinds that are played on top.
  std::vector<std::string> channels;
  std::size_t props = 0;
  std::size_t triangles_of_props = 0;
  std::size_t textures = 0;
  std::size_t motions = 0;
  std::size_t scenes = 0;

  inspect::Inspection looks;
};

// Loads the pack and looks at all its faces; some seconds. `progress` hears what it is doing. Errors: those
// of LoadPack.
Result<Facts> GatherFacts(const std::filesystem::path& file,
                          const std::function<void(const std::string&)>& progress);

// For people, and for programs.
std::string FactsPage(const Facts& facts);
std::string FactsJson(const Facts& facts);

}  // namespace kaori::authoring
