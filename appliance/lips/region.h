// The painted mouth in a picture: runs of paint, joined into regions, of which the mouth is the largest.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "appliance/lips/paint_key.h"
#include "drivers/camera/planes.h"

namespace kaori::lips {

// Chroma samples; `right` and `bottom` are exclusive.
struct Region {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  int area = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

struct Found {
  Region mouth;
  int painted = 0;  // Samples of paint in the whole picture, single ones left out.
};

// Keeps its memory from frame to frame: once it has seen a busy picture it allocates nothing.
class RegionFinder {
 public:
  // The largest region of paint with what belongs to it: the other lip, where an open mouth splits the paint.
  // Nothing where no paint is, or where the picture is all noise.
  std::optional<Found> Find(const camera::Planes& planes, const PaintKey& key);

 private:
  struct Run {
    int begin = 0;
    int end = 0;  // Exclusive.
    std::size_t region = 0;
  };
  struct Joined {
    Region region;
    std::size_t into = 0;  // Its own index, or the region that took it in.
  };

  void KeyRow(const camera::Planes& planes, int row, const PaintKey& key);
  bool CutRuns(int row);
  void JoinAbove();
  std::size_t RootOf(std::size_t region);
  void Unite(std::size_t a, std::size_t b);
  std::optional<Found> Choose();

  std::vector<std::uint8_t> mask_;  // One row.
  std::vector<Run> above_;
  std::vector<Run> runs_;
  std::vector<Joined> regions_;
};

}  // namespace kaori::lips
