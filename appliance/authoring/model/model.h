// A head as a file from a modelling tool holds it: triangles, texture coordinates, and shapes given as dense
// offsets.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/topology.h"

namespace kaori::model {

using face::Index;
using face::Triangle;

// A shape that the artist gave by name (a morph target, blend shape): one offset for each vertex of the
// model, metres. Offsets of vertices that it leaves alone are zero.
struct Target {
  std::string name;
  std::vector<glm::vec3> offsets;
};

// Part of a preset: a target by name, and how much of it.
struct PresetPart {
  std::string target;
  float weight = 1;
};
// A sum of targets that the file itself names: VRM's expressions.
struct Preset {
  std::string name;
  std::vector<PresetPart> parts;
};

// Where a mesh of the file ended up in the model: vertices [first, first + count). Its name helps to tell
// teeth from tongue.
struct MeshRange {
  // In the artist's spelling; that of the node where the mesh has none.
  std::string name;
  Index first = 0;
  Index count = 0;

  bool Holds(Index vertex) const { return vertex >= first && vertex < first + count; }
};

// All meshes of a file in one list of vertices. Metres, +Y up, +Z out of the face, +X to its left (the glTF
// convention); triangles run counter-clockwise seen from outside, as glTF has them. The readers bring their
// formats to this and check every index; whether it is a usable head is for CheckModel.
struct Model {
  // The file's name without its folder, as findings show it.
  std::string file;
  // In the scene's frame: nodes have been applied.
  std::vector<glm::vec3> positions;
  // The artist's texture coordinates, which are also the parameter space; as many as positions, v up.
  std::vector<glm::vec2> uv;
  std::vector<Triangle> triangles;
  std::vector<MeshRange> meshes;
  // Names are unique.
  std::vector<Target> targets;
  std::vector<Preset> presets;
  // The first texture, still encoded as PNG or JPEG, and not looked at; empty: none.
  std::vector<std::uint8_t> picture;
};

// What a file may hold at most, so that a wrong one cannot ask for all memory.
inline constexpr std::size_t kMostFile_bytes = 512U << 20U;
// Of all meshes together.
inline constexpr std::size_t kMostVertices = 1'000'000;
inline constexpr std::size_t kMostTriangles = 2'000'000;
inline constexpr std::size_t kMostTargets = 1024;
// Vertices times targets; 768 MB as floats.
inline constexpr std::size_t kMostOffsets = 64'000'000;

}  // namespace kaori::model
