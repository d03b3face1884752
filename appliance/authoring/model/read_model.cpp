#include "appliance/authoring/model/read_model.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "appliance/authoring/model/gltf_file.h"
#include "appliance/authoring/model/mesh_check.h"
#include "appliance/authoring/model/obj_file.h"
#include "drivers/base/read_file.h"

namespace kaori::model {
namespace {

// Errors as ReadFile's: not there, not a regular file, larger than kMostFile_bytes.
Result<std::vector<std::uint8_t>> ReadBytes(const std::filesystem::path& file) {
  return ReadFile(file, {.most_bytes = kMostFile_bytes}).map([](const std::string& bytes) {
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  });
}

// In small letters, since some tools write .GLB and .OBJ.
std::string Ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

// A name from within a file may lead to its own folder and below it, nowhere else.
bool StaysBeside(const std::filesystem::path& name) {
  return name.is_relative() && std::ranges::find(name, std::filesystem::path("..")) == name.end();
}

// By the ending alone; the content is checked by each reader.
std::optional<Model> Decode(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes,
                            Findings& findings) {
  const std::string name = file.filename().string();
  const std::string ending = Ending(file);
  if (ending == ".obj") return ReadObj(name, bytes, findings);
  const ReadBeside beside = [&](const std::string& other) -> std::optional<std::vector<std::uint8_t>> {
    if (!StaysBeside(other)) return std::nullopt;
    auto read = ReadBytes(file.parent_path() / other);
    return read ? std::optional(std::move(*read)) : std::nullopt;
  };
  if (ending == ".glb" || ending == ".gltf") return ReadGltf(name, bytes, beside, findings);
  findings.Add(name, "", "is none of .glb, .gltf, .obj");
  return std::nullopt;
}

}  // namespace

// The error's own text names the path again, so only its cause is told.
std::optional<Model> ReadModel(const std::filesystem::path& file, Findings& findings) {
  const auto bytes = ReadBytes(file);
  if (!bytes) {
    const Error& error = bytes.error();
    findings.Add(file.string(), "", "cannot be read: " + std::make_error_code(error.cause).message());
    return std::nullopt;
  }
  // Findings may hold faults of other files.
  const std::size_t before = findings.size();
  auto model = Decode(file, *bytes, findings);
  if (model) CheckModel(*model, findings);
  return findings.size() == before ? std::move(model) : std::nullopt;
}

// Every file is read, whatever is wrong with the first, so that an artist hears of all faults at once. The
// topology is compared among those that could be read.
std::vector<Model> ReadModels(const std::vector<std::filesystem::path>& files, Findings& findings) {
  std::vector<Model> models;
  for (const auto& file : files)
    if (auto model = ReadModel(file, findings)) models.push_back(std::move(*model));
  for (std::size_t i = 1; i < models.size(); ++i) CheckSameTopology(models.front(), models[i], findings);
  return models;
}

}  // namespace kaori::model
