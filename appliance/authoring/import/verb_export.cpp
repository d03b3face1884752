#include "appliance/authoring/import/verb_export.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/authoring/import/export_head.h"
#include "appliance/authoring/sculpt/sculpt.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// What `kaori-atelier export --help` prints below the usage.
constexpr const char* kExportPage = R"(
Writes a face of a show (a folder or a pack) as OBJ, with its eyeballs, for Blender and other tools. A head that is made of it
by moving vertices, and written as OBJ or glTF again, is a face of the show like every other, and is mixed with them:
  faces/NAME.toml   shape = "modelled"
                    mesh = "NAME.obj"
  --face     which face to begin with; the show's first one where nothing is said
)";

// Of a folder the shapes alone are made, which takes a moment.
Result<face::Cast> CastOf(const std::filesystem::path& place) {
  face::Cast cast;
  if (std::filesystem::is_directory(place)) {
    if (auto ok = sculpt::Sculpt(place, cast); !ok) return tl::unexpected(ok.error());
    return cast;
  }
  auto show = show::LoadPack(place);
  if (!show) return tl::unexpected(show.error());
  return std::move(show->cast);
}

// Errors: invalid_argument where the show has no such face.
Result<std::size_t> FaceOf(const face::Cast& cast, const Arguments& arguments) {
  const auto wanted = arguments.options.find("--face");
  if (wanted == arguments.options.end()) return std::size_t{0};
  const auto face = std::ranges::find(cast.faces, wanted->second, &face::Face::name);
  if (face != cast.faces.end()) return static_cast<std::size_t>(face - cast.faces.begin());
  // A name that was misspelt is easier to see among those that are there.
  std::vector<std::string> names;
  for (const face::Face& one : cast.faces) names.push_back(one.name);
  return FailInput(fmt::format("export: --face: the show has no face \"{}\"; it has {}", wanted->second,
                               fmt::join(names, ", ")));
}

// What was written goes to standard error, so that a script that reads standard output has nothing to skip.
// Errors: those of the show's files, of the face's name, and of writing.
Result<void> WriteExport(const Arguments& arguments) {
  const std::filesystem::path file = arguments.words[1];
  if (file.extension() != ".obj")
    return FailInput("export: " + file.string() + ": the file's name must end in .obj");
  const auto cast = CastOf(arguments.words[0]);
  if (!cast) return tl::unexpected(cast.error());
  const auto face = FaceOf(*cast, arguments);
  if (!face) return tl::unexpected(face.error());
  if (auto ok = WriteWholeFile(file, {AsBytes(import::ObjOfFace(*cast, *face))}); !ok) return ok;
  fmt::print(stderr, "wrote {}: the face {}\n", file.string(), cast->faces[*face].name);
  return {};
}

int RunExport(const Arguments& arguments) {
  const auto ok = WriteExport(arguments);
  return ok ? 0 : ExitWithError(ok.error());
}

}  // namespace

Verb ExportVerb() {
  return {.name = "export",
          .words = {"SHOW", "FILE"},
          .options = {{"--face", "NAME"}},
          .summary = "a face of a show, for a modelling tool",
          .page = kExportPage,
          .run = RunExport};
}

}  // namespace kaori::authoring
