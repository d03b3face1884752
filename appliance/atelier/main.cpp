// kaori-atelier: makes shows.
#include <cstdio>
#include <fstream>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "appliance/atelier/author.h"
#include "appliance/atelier/script/labels.h"
#include "appliance/atelier/sheet/sheet.h"
#include "appliance/show/pack.h"
#include "drivers/base/clock.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-atelier: makes shows

  kaori-atelier pack FOLDER FILE   build the show that FOLDER describes and write it as one pack
  kaori-atelier info FILE          what a pack holds
  kaori-atelier sheet FILE FOLDER  pictures of every face with every expression, and a page that shows them
  kaori-atelier labels FILE JSON   what the show writes on the operators' controls, for kaori-sim's page
  kaori-atelier --help

Every fault of the authoring files is named with file, item and reason; a pack is written whole or not at all.
)";

int Complain(const kaori::Error& error) {
  fmt::print(stderr, "kaori-atelier: {}\n", error.message());
  return 1;
}

int Pack(const char* folder, const char* file) {
  const kaori::SteadyClock clock;
  const auto begun = clock.now();
  const auto progress = [&](std::string_view step) {
    fmt::print("[{:5.1f} s] {}\n", kaori::Seconds(clock.now() - begun), step);
    std::fflush(stdout);
  };
  const auto show = kaori::atelier::AuthorShow(folder, progress);
  if (!show) return Complain(show.error());
  progress(fmt::format("writing {}", file));
  if (const auto ok = kaori::show::SavePack(*show, file); !ok) return Complain(ok.error());
  progress("done");
  return 0;
}

int Info(const char* file) {
  const auto show = kaori::show::LoadPack(file);
  if (!show) return Complain(show.error());
  const auto& cast = show->cast;
  fmt::print("show         {}\n", show->name);
  fmt::print("cage         {} vertices ({} move), {} triangles\n", cast.topology.vertex_count,
             cast.topology.moving_count, cast.topology.triangles.size());
  fmt::print("fine mesh    {} vertices, {} triangles\n", cast.topology.fine.from_cage.rows(),
             cast.topology.fine.triangles.size());
  fmt::print("net          {} control points\n", cast.net.points.size());
  fmt::print("faces        {}:", cast.faces.size());
  for (const auto& face : cast.faces) fmt::print(" {}", face.name);
  fmt::print("\nexpressions  {}:", cast.expressions.size());
  for (const auto& expression : cast.expressions) fmt::print(" {}", expression.name);
  fmt::print("\nprops        {}:", cast.props.size());
  for (const auto& prop : cast.props) fmt::print(" {} ({} triangles)", prop.name, prop.triangles.size());
  fmt::print("\ntakes        {}\nscenes       {}\n", show->takes.size(), show->scenes.size());
  return 0;
}

int Labels(const char* file, const char* json) {
  const auto show = kaori::show::LoadPack(file);
  if (!show) return Complain(show.error());
  std::ofstream out(json);
  out << kaori::atelier::LabelsJson(*show);
  if (out.flush()) return 0;
  const auto fault = kaori::FailErrno(fmt::format("write {}", json));
  return Complain(fault.value());
}

int Sheet(const char* file, const char* folder) {
  auto show = kaori::show::LoadPack(file);
  if (!show) return Complain(show.error());
  const auto studio = kaori::stage::Studio::Open(std::move(*show));
  if (!studio) return Complain(studio.error());
  const auto wrote = [](std::string_view name) {
    fmt::print("{}\n", name);
    std::fflush(stdout);
  };
  if (const auto ok = kaori::atelier::DrawSheets(**studio, folder, {}, wrote); !ok)
    return Complain(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> args(argv, static_cast<std::size_t>(argc));
  const std::string_view verb = argc > 1 ? args[1] : "--help";
  if (verb == "pack" && argc == 4) return Pack(args[2], args[3]);
  if (verb == "info" && argc == 3) return Info(args[2]);
  if (verb == "labels" && argc == 4) return Labels(args[2], args[3]);
  if (verb == "sheet" && argc == 4) return Sheet(args[2], args[3]);
  fmt::print(verb == "--help" ? stdout : stderr, "{}", kHelp);
  return verb == "--help" ? 0 : 2;
}
