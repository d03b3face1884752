// Packs: how soon a show is read, how soon it can be played, and what the largest one takes.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// `pack` is the show to load; its file lies in the cache. Gives:
//   pack.load_ms         LoadPack: read, checksum, checks, copy
//   pack.load.cpu_ms     the same in CPU time of this process
//   pack.compose_ms      all composites of the cast
//   pack.open_ms         Studio::Open: driver, shaders, composites, textures
//   pack.large.load_ms   the same for a made-up show: 100 000 triangles, 16 faces, 40 expressions
//   pack.large.open_ms
//   pack.large.frame_ms  a frame of 960x540 of it
//   pack.large.rss_mb    what it adds to this process's memory while it plays
std::vector<Metric> MeasurePacks(const std::string& pack, bool quick);

}  // namespace kaori::benchmark
