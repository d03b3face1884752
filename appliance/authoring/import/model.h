// A head as a file from a modelling tool holds it: triangles, texture coordinates, and shapes given as dense
// offsets.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/topology.h"

namespace kaori::import {

using face::Index;
using face::Triangle;

// A shape that the artist gave by name: one offset for each vertex of the model, metres.
struct Target {
  std::string name;
  std::vector<glm::vec3> offsets;
};

// Part of a target, or of another: what a preset of a file is the sum of.
struct PresetPart {
  std::string target;
  float weight = 1;
};
struct Preset {
  std::string name;
  std::vector<PresetPart> parts;
};

// Where a mesh of the file ended up in the model: vertices [first, first + count).
struct MeshRange {
  std::string name;
  Index first = 0;
  Index count = 0;
};

// All meshes of a file in one list of vertices. Metres, +Y up, +Z out of the face, +X to its left.
struct Model {
  std::string file;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> uv;  // As many as positions; v up.
  std::vector<Triangle> triangles;
  std::vector<MeshRange> meshes;
  std::vector<Target> targets;
  std::vector<Preset> presets;
  std::vector<std::uint8_t> picture;      // The first texture, encoded as PNG or JPEG; empty: none.
  glm::vec3 colour{0.72F, 0.50F, 0.40F};  // Linear; of the first material without a picture.
};

// What a file may hold at most, so that a wrong one cannot ask for all memory.
inline constexpr std::size_t kMostFile_bytes = 512U << 20U;
inline constexpr std::size_t kMostVertices = 1'000'000;
inline constexpr std::size_t kMostTriangles = 2'000'000;
inline constexpr std::size_t kMostTargets = 1024;
inline constexpr std::size_t kMostOffsets = 64'000'000;  // Vertices times targets.

}  // namespace kaori::import
