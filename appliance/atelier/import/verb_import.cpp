#include "appliance/atelier/import/verb_import.h"

#include <charconv>
#include <fstream>
#include <optional>

#include <fmt/format.h>

#include "appliance/atelier/import/import.h"
#include "appliance/show/pack.h"

namespace kaori::atelier {
namespace {

constexpr const char* kPage = R"(
Reads glTF 2.0 (.glb, .gltf) and OBJ with texture coordinates. The first FILE has the shapes (morph targets); all files
have its vertices in its order, and become the faces of one cast, named as the files.

  --out      a pack (NAME.kaori) with the heads, or a folder: heads.kaori, report.txt and, with --show, show.kaori
  --show     a pack: its expressions are carried to the heads, and the artist's shapes to its faces
  --points   control points at most, 10 to 1000; 180 where nothing is said

Shapes are known by the names of ARKit, VRM, lip-sync visemes, or plain words. The report tells what was mapped and
what not, and how many millimetres control points alone miss; the rest is kept beside them.
)";

std::optional<std::size_t> Count(std::string_view text) {
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && count >= 10 && count <= 1000 ? std::optional(count) : std::nullopt;
}

Result<void> Save(const show::Show& show, const std::filesystem::path& file) {
  if (auto ok = show::SavePack(show, file); !ok) return ok;
  fmt::print("{}\n", file.string());
  return {};
}

Result<void> WriteAll(const import::Imported& made, const std::filesystem::path& out) {
  if (out.extension() == ".kaori") return Save(made.heads, out);
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + out.string());
  if (auto ok = Save(made.heads, out / "heads.kaori"); !ok) return ok;
  if (made.on_show)
    if (auto ok = Save(*made.on_show, out / "show.kaori"); !ok) return ok;
  std::ofstream report(out / "report.txt");
  report << import::Text(made.report);
  if (!report.flush()) return Fail(std::errc::io_error, "write " + (out / "report.txt").string());
  fmt::print("{}\n", (out / "report.txt").string());
  return {};
}

Result<void> RunImport(const Arguments& arguments) {
  const auto out = arguments.options.find("--out");
  if (out == arguments.options.end()) return FailInput("import: --out is missing");
  import::ImportOptions options;
  if (const auto points = arguments.options.find("--points"); points != arguments.options.end()) {
    const auto count = Count(points->second);
    if (!count) return FailInput("import: --points wants a number from 10 to 1000");
    options.points.moving = *count;
  }
  std::optional<show::Show> show;
  if (const auto pack = arguments.options.find("--show"); pack != arguments.options.end()) {
    auto loaded = show::LoadPack(pack->second);
    if (!loaded) return tl::unexpected(loaded.error());
    show = std::move(*loaded);
  }
  const std::vector<std::filesystem::path> files(arguments.words.begin(), arguments.words.end());
  const auto made = import::Import(files, show ? &*show : nullptr, options);
  if (!made) return tl::unexpected(made.error());
  fmt::print("{}", import::Text(made->report));
  return WriteAll(*made, out->second);
}

int Run(const Arguments& arguments) {
  const auto ok = RunImport(arguments);
  return ok ? 0 : Complain(ok.error());
}

}  // namespace

Verb ImportVerb() {
  return {.name = "import",
          .words = {"FILE..."},
          .options = {{"--out", "FOLDER_OR_PACK"}, {"--show", "PACK"}, {"--points", "N"}},
          .summary = "faces made in modelling tools become a show",
          .page = kPage,
          .run = Run};
}

}  // namespace kaori::atelier
