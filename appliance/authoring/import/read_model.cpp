#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "appliance/authoring/import/gltf_file.h"
#include "appliance/authoring/import/import.h"
#include "appliance/authoring/import/mesh_check.h"
#include "appliance/authoring/import/obj_file.h"

namespace kaori::import {
namespace {

std::optional<std::vector<std::uint8_t>> ReadBytes(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error || size > kMostFile_bytes) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  return in.gcount() == static_cast<std::streamsize>(size) ? std::optional(std::move(bytes)) : std::nullopt;
}

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

std::optional<Model> Decode(const std::filesystem::path& file, const std::vector<std::uint8_t>& bytes,
                            Findings& findings) {
  const std::string name = file.filename().string();
  const std::string ending = Ending(file);
  if (ending == ".obj") return ReadObj(name, bytes, findings);
  const ReadBeside beside = [&](const std::string& other) -> std::optional<std::vector<std::uint8_t>> {
    if (!StaysBeside(other)) return std::nullopt;
    return ReadBytes(file.parent_path() / other);
  };
  if (ending == ".glb" || ending == ".gltf") return ReadGltf(name, bytes, beside, findings);
  findings.Add(name, "", "is none of .glb, .gltf, .obj");
  return std::nullopt;
}

}  // namespace

std::optional<Model> ReadModel(const std::filesystem::path& file, Findings& findings) {
  const auto bytes = ReadBytes(file);
  if (!bytes) {
    findings.Add(file.string(), "",
                 fmt::format("cannot be read, or is larger than {} MiB", kMostFile_bytes >> 20U));
    return std::nullopt;
  }
  const std::size_t before = findings.size();
  auto model = Decode(file, *bytes, findings);
  if (model) CheckModel(*model, findings);
  return findings.size() == before ? std::move(model) : std::nullopt;
}

std::vector<Model> ReadModels(const std::vector<std::filesystem::path>& files, Findings& findings) {
  std::vector<Model> models;
  for (const auto& file : files)
    if (auto model = ReadModel(file, findings)) models.push_back(std::move(*model));
  for (std::size_t i = 1; i < models.size(); ++i) CheckSameTopology(models.front(), models[i], findings);
  return models;
}

}  // namespace kaori::import
