// How open every point of a figure is to the light around it: ambient occlusion by depth pictures taken from
// many sides.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/topology.h"

namespace kaori::appearance {

// Everything that throws shade, in metres; triangles of either winding.
struct Shell {
  std::vector<glm::vec3> positions;
  std::vector<face::Triangle> triangles;
};

// A point that is shaded: its surface looks along `normal` (a unit vector).
struct Probe {
  glm::vec3 position{};
  glm::vec3 normal{};
  // Lifted off its own surface by this much; as much again is forgiven. Smaller lifts leave the picture's
  // pixels as stripes on the surface, larger ones lose the shade of what lies close.
  float lift_m = 0.0035F;
};

// How closely is measured. The box holds a head and its shoulders, in metres of the cast's frame (+x the
// character's left, +y up, +z forwards).
struct OcclusionSettings {
  // Each is one depth picture; probes see about half of them.
  int directions = 72;
  // Of a side of each depth picture; a pixel is about 3 mm.
  int picture_px = 192;
  // What lies outside this box throws no shade.
  glm::vec3 low_m{-0.16F, -0.24F, -0.16F};
  glm::vec3 high_m{0.16F, 0.20F, 0.20F};
};

// One value for each probe: 0 shut in .. 1 open to all sides; cosine-weighted. Takes time in proportion to
// directions times (triangles + probes). Borrows nothing.
std::vector<float> MeasureOpenness(const Shell& shell, const std::vector<Probe>& probes,
                                   const OcclusionSettings& settings);

// Evens values out over a mesh: `steps` times half-way to the mean of a vertex's neighbours. One value for
// each vertex; those of no triangle stay.
void SmoothOver(const std::vector<face::Triangle>& triangles, int steps, std::vector<float>& values);

// Smooth unit normals of a mesh, weighted by area, outwards where triangles run counter-clockwise; +Z at a
// vertex without any.
std::vector<glm::vec3> VertexNormals(const std::vector<glm::vec3>& positions,
                                     const std::vector<face::Triangle>& triangles);

}  // namespace kaori::appearance
