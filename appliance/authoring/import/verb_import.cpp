#include "appliance/authoring/import/verb_import.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "appliance/authoring/author.h"
#include "appliance/authoring/import/import.h"
#include "appliance/authoring/pack/progress.h"
#include "appliance/authoring/sheet/sheet.h"
#include "appliance/core/show/pack.h"
#include "drivers/base/number.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// What `kaori-atelier import --help` prints below the usage.
constexpr const char* kPage = R"(
Reads glTF 2.0 (.glb, .gltf) and OBJ with texture coordinates. The first FILE has the shapes (morph targets); all files
have its vertices in its order, and become the faces of one cast, named as the files. A file without shapes that comes
alone wears the show's expressions: its features are found by its form.

  --out      a pack (NAME.kaori) with the heads, or a folder: heads.kaori, report.txt, report.json and, with --show,
             show.kaori
  --show     a pack or a show's folder: its expressions are carried to the heads, the artist's shapes to its faces
  --like     faces of the show, separated by commas: the first head is painted, combed and dressed as the first of
             them, and so on; all as the show's first face where nothing is said
  --points   control points at most, 10 to 1000; 180 where nothing is said
  --sheets   contact sheets too, in the folder's heads and show
  --json     prints the report as JSON

Shapes are known by the names of ARKit, VRM, lip-sync visemes, or plain words. The report tells what was mapped and
what not, and how many millimetres control points alone miss; the rest is kept beside them.
)";

// A whole number from 10 to 1000; fewer points cannot say a mouth, more make the fit slow, whose time grows
// with their fourth power.
std::optional<std::size_t> Count(std::string_view text) {
  const auto count = ParseNumber<std::size_t>(text);
  return count && *count >= 10 && *count <= 1000 ? count : std::nullopt;
}

// "kaori,granny" as two names.
std::vector<std::string> Names(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    if (end > 0) names.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return names;
}

// Errors: invalid_argument where --points is no number within its bounds.
Result<import::ImportOptions> OptionsOf(const Arguments& arguments) {
  import::ImportOptions options;
  if (const auto points = arguments.options.find("--points"); points != arguments.options.end()) {
    const auto count = Count(points->second);
    if (!count) return FailInput("import: --points wants a number from 10 to 1000");
    options.points.moving = *count;
  }
  if (const auto like = arguments.options.find("--like"); like != arguments.options.end())
    options.like = Names(like->second);
  return options;
}

// A pack, or what a folder describes, which takes as long as `pack` does.
Result<show::Show> OpenShow(const std::filesystem::path& place, ProgressLine& progress) {
  if (!std::filesystem::is_directory(place)) return show::LoadPack(place);
  return AuthorShow(place, [&](std::string_view what) { progress.Step(what); });
}

// What an import writes, and where: one pack, or a folder with packs and reports. Remembers the files, for
// the last lines that people see. Borrows the progress line.
class Writing {
 public:
  Writing(std::filesystem::path out, ProgressLine& progress) : out_(std::move(out)), progress_(progress) {}

  // One pack where --out names one; else packs and reports into the folder, each file whole.
  Result<void> Packs(const import::Imported& made) {
    if (is_pack()) return Save(made.heads, out_);
    // Folders above it, too, are made where they are missing.
    std::error_code error;
    std::filesystem::create_directories(out_, error);
    if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + out_.string());
    if (auto ok = Save(made.heads, out_ / "heads.kaori"); !ok) return ok;
    if (made.on_show)
      if (auto ok = Save(*made.on_show, out_ / "show.kaori"); !ok) return ok;
    if (auto ok = Save(import::Text(made.report), out_ / "report.txt"); !ok) return ok;
    return Save(import::JsonText(made.report), out_ / "report.json");
  }

  // Contact sheets need a GL context; Studio::Open says where there is none.
  Result<void> Sheets(import::Imported made) {
    if (auto ok = Draw(std::move(made.heads), out_ / "heads"); !ok) return ok;
    return made.on_show ? Draw(std::move(*made.on_show), out_ / "show") : Result<void>();
  }

  bool is_pack() const { return out_.extension() == ".kaori"; }
  const std::vector<std::string>& written() const { return written_; }

 private:
  Result<void> Save(const show::Show& show, const std::filesystem::path& file) {
    written_.push_back(file.string());
    return show::SavePack(show, file);
  }

  Result<void> Save(const std::string& text, const std::filesystem::path& file) {
    written_.push_back(file.string());
    return WriteWholeFile(file, {AsBytes(text)});
  }

  Result<void> Draw(show::Show show, const std::filesystem::path& folder) {
    const auto studio = stage::Studio::Open(std::move(show));
    if (!studio) return tl::unexpected(studio.error());
    const auto wrote = [&](std::string_view file) { written_.emplace_back(file); };
    return DrawSheets(**studio, folder, {.inspects = false}, wrote,
                      [&](std::string_view what) { progress_.Step(what); });
  }

  std::filesystem::path out_;
  ProgressLine& progress_;
  std::vector<std::string> written_;
};

// Options are judged before a show is opened, which takes seconds.
Result<void> RunImport(const Arguments& arguments) {
  const auto out = arguments.options.find("--out");
  if (out == arguments.options.end()) return FailInput("import: --out is missing");
  ProgressLine progress;
  Writing writing(out->second, progress);
  if (arguments.Has("--sheets") && writing.is_pack())
    return FailInput("import: --sheets wants --out to be a folder");
  const auto options = OptionsOf(arguments);
  if (!options) return tl::unexpected(options.error());
  std::optional<show::Show> show;
  if (const auto place = arguments.options.find("--show"); place != arguments.options.end()) {
    auto opened = OpenShow(place->second, progress);
    if (!opened) return tl::unexpected(opened.error());
    show = std::move(*opened);
  }
  progress.Step("importing");
  const std::vector<std::filesystem::path> files(arguments.words.begin(), arguments.words.end());
  auto made = import::Import(files, show ? &*show : nullptr, *options);
  if (!made) return tl::unexpected(made.error());
  if (auto ok = writing.Packs(*made); !ok) return ok;
  const std::string report =
      arguments.Has("--json") ? import::JsonText(made->report) : import::Text(made->report);
  // Sheets take the shows away; doubts are said last, where nobody overlooks them.
  const std::vector<std::string> doubts = made->report.doubts;
  if (arguments.Has("--sheets"))
    if (auto ok = writing.Sheets(std::move(*made)); !ok) return ok;
  // The report is all that standard output gets, so that --json can be piped.
  fmt::print("{}", report);
  for (const std::string& file : writing.written()) fmt::print(stderr, "wrote {}\n", file);
  for (const std::string& doubt : doubts)
    fmt::print(stderr, "kaori-atelier: not fit for a stage yet: {}\n", doubt);
  return {};
}

int Run(const Arguments& arguments) {
  const auto ok = RunImport(arguments);
  return ok ? 0 : ExitWithError(ok.error());
}

}  // namespace

Verb ImportVerb() {
  return {.name = "import",
          .words = {"FILE..."},
          .options = {{"--out", "FOLDER_OR_PACK"},
                      {"--show", "PACK_OR_FOLDER"},
                      {"--like", "FACES"},
                      {"--points", "N"},
                      {"--sheets", ""},
                      {"--json", ""}},
          .summary = "faces made in modelling tools become a show",
          .page = kPage,
          .run = Run};
}

}  // namespace kaori::authoring
