#include "appliance/atelier/import/command.h"

#include <charconv>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "appliance/atelier/import/import.h"
#include "appliance/show/pack.h"

namespace kaori::import {
namespace {

struct Arguments {
  std::vector<std::filesystem::path> files;
  std::filesystem::path out;
  std::filesystem::path show;
  ImportOptions options;
};

bool ReadCount(std::string_view text, std::size_t& count) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  return error == std::errc() && end == text.data() + text.size() && count >= 10 && count <= 1000;
}

std::optional<Arguments> Parse(std::span<char*> args) {
  Arguments parsed;
  for (std::size_t i = 0; i < args.size(); ++i) {
    const std::string_view arg = args[i];
    if (!arg.starts_with("--")) {
      parsed.files.emplace_back(arg);
      continue;
    }
    if (++i == args.size()) return std::nullopt;
    if (arg == "--out") {
      parsed.out = args[i];
    } else if (arg == "--show") {
      parsed.show = args[i];
    } else if (arg != "--points" || !ReadCount(args[i], parsed.options.points.moving)) {
      return std::nullopt;
    }
  }
  return parsed.files.empty() || parsed.out.empty() ? std::nullopt : std::optional(parsed);
}

int Complain(const Error& error) {
  fmt::print(stderr, "kaori-atelier: {}\n", error.message());
  return 1;
}

Result<void> Save(const show::Show& show, const std::filesystem::path& file) {
  if (auto ok = show::SavePack(show, file); !ok) return ok;
  fmt::print("{}\n", file.string());
  return {};
}

Result<void> Write(const Imported& made, const std::filesystem::path& out) {
  if (out.extension() == ".kaori") return Save(made.heads, out);
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + out.string());
  if (auto ok = Save(made.heads, out / "heads.kaori"); !ok) return ok;
  if (made.on_show)
    if (auto ok = Save(*made.on_show, out / "show.kaori"); !ok) return ok;
  std::ofstream report(out / "report.txt");
  report << Text(made.report);
  if (!report.flush()) return Fail(std::errc::io_error, "write " + (out / "report.txt").string());
  fmt::print("{}\n", (out / "report.txt").string());
  return {};
}

}  // namespace

int ImportCommand(std::span<char*> args) {
  const auto parsed = Parse(args);
  if (!parsed) {
    fmt::print(stderr, "{}", kImportHelp);
    return 2;
  }
  std::optional<show::Show> show;
  if (!parsed->show.empty()) {
    auto loaded = show::LoadPack(parsed->show);
    if (!loaded) return Complain(loaded.error());
    show = std::move(*loaded);
  }
  const auto made = Import(parsed->files, show ? &*show : nullptr, parsed->options);
  if (!made) return Complain(made.error());
  fmt::print("{}", Text(made->report));
  if (const auto ok = Write(*made, parsed->out); !ok) return Complain(ok.error());
  return 0;
}

}  // namespace kaori::import
