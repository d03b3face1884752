#include "render/gl/shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace kaori::gl {
namespace {

const ShaderFile* FindFile(std::span<const ShaderFile> library, std::string_view name) {
  const auto at = std::ranges::find(library, name, &ShaderFile::name);
  return at == library.end() ? nullptr : &*at;
}

// The name in an #include "name" line.
std::optional<std::string_view> IncludedName(std::string_view line) {
  constexpr std::string_view kStart = "#include \"";
  if (!line.starts_with(kStart)) return std::nullopt;
  line.remove_prefix(kStart.size());
  return line.substr(0, line.find('"'));
}

// Appends a file and, where they stand, those that it includes. Files are numbered as they come; a file that
// is there is left out, so circles end.
Result<void> Append(std::span<const ShaderFile> library, std::string_view name, WholeText& whole) {
  if (std::ranges::find(whole.files, name) != whole.files.end()) return {};
  const ShaderFile* file = FindFile(library, name);
  if (file == nullptr) {
    return Fail(std::errc::no_such_file_or_directory, fmt::format("include shader {}", name));
  }
  // GLSL ES numbers source strings, and names no files.
  const std::size_t number = whole.files.size();
  whole.files.push_back(file->name);
  whole.text += fmt::format("#line 1 {}\n", number);
  int line_number = 0;
  // Line by line. After an included file a #line mark brings the count back to this one.
  for (std::string_view rest = file->text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++line_number;
    const auto included = IncludedName(line);
    if (!included) {
      whole.text.append(line).append("\n");
      continue;
    }
    if (auto done = Append(library, *included, whole); !done) return done;
    whole.text += fmt::format("#line {} {}\n", line_number + 1, number);
  }
  return {};
}

// "3:12..." at the start of `text`, or "3(12) :..." as NVIDIA's driver writes it -> "body.vert:12...". Text that begins
// otherwise is left as it is.
std::string NameFile(std::string_view text, std::span<const std::string_view> files) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || number >= files.size()) return std::string(text);
  const std::string_view rest = text.substr(static_cast<std::size_t>(end - text.data()));
  if (rest.starts_with(':')) return std::string(files[number]).append(rest);
  const std::size_t closed = rest.find(") :");
  if (!rest.starts_with('(') || closed == rest.npos) return std::string(text);
  return fmt::format("{}:{}{}", files[number], rest.substr(1, closed - 1), rest.substr(closed + 2));
}

}  // namespace

Result<WholeText> Assemble(const ProgramSource& source, std::string_view file) {
  WholeText whole;
  // #version must be the first line. GLES has no default precision for floats in fragment shaders, and low
  // precision for samplers; high is what positions in metres and light need.
  whole.text = source.reads_samples ? "#version 310 es\n" : "#version 300 es\n";
  whole.text += "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
  if (source.reads_samples) whole.text += "precision highp sampler2DMS;\n";
  whole.text += source.defines;
  if (auto done = Append(source.library, file, whole); !done) return tl::unexpected(done.error());
  return whole;
}

// Line by line; lines that are not understood pass as they are.
std::string NameFiles(std::string_view log, std::span<const std::string_view> files) {
  constexpr std::string_view kPrefix = "ERROR: ";
  std::string named;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    std::string_view line = log.substr(0, end);
    log.remove_prefix(std::min(end + 1, log.size()));
    if (line.starts_with(kPrefix)) line.remove_prefix(kPrefix.size());
    if (!named.empty()) named += "; ";
    named += NameFile(line, files);
  }
  return named;
}

}  // namespace kaori::gl
