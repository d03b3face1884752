#include "appliance/authoring/sculpt/half_topology.h"

#include <algorithm>
#include <cassert>
#include <sstream>
#include <string>

namespace kaori::sculpt {
namespace {

// Marks names that no vertex has: places that a block has cut out.
constexpr Index kNobody = ~Index{0};
constexpr int kEarColumns = kEarBlock.column1 - kEarBlock.column0;
constexpr int kEarRows = kEarBlock.row1 - kEarBlock.row0;

// How many values a and b of a region's keys take, from 0 (the cap: from its block's corner).
struct Extent {
  int count_a, count_b;
  std::size_t count() const { return static_cast<std::size_t>(count_a) * static_cast<std::size_t>(count_b); }
};

// Regions with rings count their rim as ring 0.
constexpr Extent ExtentOf(Region region) {
  switch (region) {
    case Region::kGrid:
      return {kColumns + 1, kRows + 1};
    case Region::kEye:
      return {kEyeRim, kEyeRings + 1};
    case Region::kMouth:
      return {kMouthRim, kMouthRings + 1};
    case Region::kEar:
      return {kEarRim, kEarRings + 1};
    case Region::kEarCap:
      break;
  }
  return {kEarColumns + 1, kEarRows + 1};
}

// Where a key stands in its region's table. Rim positions of closed rings wrap, so that j - 1 and j + 1
// need no care.
std::size_t Slot(Region region, int a, int b) {
  const Extent extent = ExtentOf(region);
  if (region == Region::kEye || region == Region::kEar) a = (a + extent.count_a) % extent.count_a;
  if (region == Region::kEarCap) a -= kEarBlock.column0, b -= kEarBlock.row0;
  assert(a >= 0 && a < extent.count_a && b >= 0 && b < extent.count_b);
  return static_cast<std::size_t>(b) * static_cast<std::size_t>(extent.count_a) + static_cast<std::size_t>(a);
}

// Vertices strictly inside; those on the border stay in the grid.
bool IsInside(const Block& block, int column, int row) {
  return column > block.column0 && column < block.column1 && row > block.row0 && row < block.row1;
}

// Cells by their lower corner.
bool HasCell(const Block& block, int column, int row) {
  return column >= block.column0 && column < block.column1 && row >= block.row0 && row < block.row1;
}

// The mouth's block reaches the middle of the face: its inside includes column 0.
bool IsCutOut(int column, int row) {
  const Block mouth{-1, kMouthBlock.column1, kMouthBlock.row0, kMouthBlock.row1};
  return IsInside(kEyeBlock, column, row) || IsInside(kEarBlock, column, row) || IsInside(mouth, column, row);
}

// Clockwise from the middle of the block's inner side: up, over the top, down, back below.
std::vector<GridPoint> ClosedRim(const Block& block) {
  const int middle = (block.row0 + block.row1) / 2;
  std::vector<GridPoint> rim;
  for (int row = middle; row < block.row1; ++row) rim.push_back({block.column0, row});
  for (int column = block.column0; column < block.column1; ++column) rim.push_back({column, block.row1});
  for (int row = block.row1; row > block.row0; --row) rim.push_back({block.column1, row});
  for (int column = block.column1; column > block.column0; --column) rim.push_back({column, block.row0});
  for (int row = block.row0; row < middle; ++row) rim.push_back({block.column0, row});
  return rim;
}

// Clockwise from the middle of the face above the mouth to the middle below.
std::vector<GridPoint> OpenRim(const Block& block) {
  std::vector<GridPoint> rim;
  for (int column = block.column0; column < block.column1; ++column) rim.push_back({column, block.row1});
  for (int row = block.row1; row > block.row0; --row) rim.push_back({block.column1, row});
  for (int column = block.column1; column >= block.column0; --column) rim.push_back({column, block.row0});
  return rim;
}

// Adds vertices and cells region by region; the order of Build() numbers them, and a pack's indices follow
// from it: changing it makes all older packs different.
class Builder {
 public:
  // Rims before rings, since ring 0 is grid vertices.
  HalfTopology Build() {
    half_.eye_rim = ClosedRim(kEyeBlock);
    half_.mouth_rim = OpenRim(kMouthBlock);
    half_.ear_rim = ClosedRim(kEarBlock);
    for (Region region : {Region::kGrid, Region::kEye, Region::kMouth, Region::kEar, Region::kEarCap}) {
      Table(region).assign(ExtentOf(region).count(), kNobody);
    }
    AddGrid();
    AddGridCells();
    AddRings(Region::kEye, half_.eye_rim, kEyeRings, kEyeRim);
    AddRings(Region::kMouth, half_.mouth_rim, kMouthRings, kMouthRim - 1);
    ZipMouthBag();
    AddRings(Region::kEar, half_.ear_rim, kEarRings, kEarRim);
    AddEarCap();
    return std::move(half_);
  }

 private:
  // Index by key.
  std::vector<Index>& Table(Region region) { return half_.table[static_cast<std::size_t>(region)]; }

  void Add(Key key) {
    Table(key.region)[Slot(key.region, key.a, key.b)] = static_cast<Index>(half_.keys.size());
    half_.keys.push_back(key);
  }

  // The crown's row has no ends: the cells there are triangles.
  void AddGrid() {
    for (int row = 0; row <= kRows; ++row) {
      for (int column = 0; column <= kColumns; ++column) {
        const bool end_of_crown = row == kRows && (column == 0 || column == kColumns);
        if (!end_of_crown && !IsCutOut(column, row)) Add({Region::kGrid, column, row});
      }
    }
  }

  void AddGridCells() {
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        const bool cut = HasCell(kEyeBlock, column, row) || HasCell(kMouthBlock, column, row) ||
                         HasCell(kEarBlock, column, row);
        if (!cut) AddGridCell(column, row);
      }
    }
  }

  // The two end cells of the crown are triangles.
  void AddGridCell(int column, int row) {
    const bool crown = row == kRows - 1;
    const int above0 = crown && column == 0 ? 1 : column;
    const int above1 = crown && column == kColumns - 1 ? column : column + 1;
    half_.quads.push_back({half_.Grid(column, row), half_.Grid(column + 1, row), half_.Grid(above1, row + 1),
                           half_.Grid(above0, row + 1)});
  }

  // Rims run clockwise, so ring quads are listed from the inner ring outwards.
  void AddRings(Region region, const std::vector<GridPoint>& rim, int rings, int steps) {
    for (std::size_t j = 0; j < rim.size(); ++j) {
      Table(region)[Slot(region, static_cast<int>(j), 0)] = half_.Grid(rim[j].column, rim[j].row);
    }
    for (int k = 1; k <= rings; ++k) {
      for (std::size_t j = 0; j < rim.size(); ++j) Add({region, static_cast<int>(j), k});
    }
    for (int k = 0; k < rings; ++k) {
      for (int j = 0; j < steps; ++j) {
        half_.quads.push_back({half_.At(region, j, k + 1), half_.At(region, j + 1, k + 1),
                               half_.At(region, j + 1, k), half_.At(region, j, k)});
      }
    }
  }

  // Closes the bag's last ring: its upper half is sewn to its lower half, quad by quad, from the middle of
  // the face to the corner.
  void ZipMouthBag() {
    const auto end = [this](int j) { return half_.At(Region::kMouth, j, kMouthRings); };
    const int last = kMouthRim - 1;
    for (int j = 0; j < kMouthCorner; ++j) {
      half_.quads.push_back({end(last - j), end(last - 1 - j), end(j + 1), end(j)});
    }
  }

  // A block of cells like the one that was cut out, its rim the innermost ring. Seen from outside it is wound
  // like the grid.
  void AddEarCap() {
    for (std::size_t j = 0; j < half_.ear_rim.size(); ++j) {
      const GridPoint p = half_.ear_rim[j];
      Table(Region::kEarCap)[Slot(Region::kEarCap, p.column, p.row)] =
          half_.At(Region::kEar, static_cast<int>(j), kEarRings);
    }
    for (int row = kEarBlock.row0 + 1; row < kEarBlock.row1; ++row) {
      for (int column = kEarBlock.column0 + 1; column < kEarBlock.column1; ++column) {
        Add({Region::kEarCap, column, row});
      }
    }
    const auto cap = [this](int column, int row) { return half_.At(Region::kEarCap, column, row); };
    for (int row = kEarBlock.row0; row < kEarBlock.row1; ++row) {
      for (int column = kEarBlock.column0; column < kEarBlock.column1; ++column) {
        half_.quads.push_back(
            {cap(column, row), cap(column + 1, row), cap(column + 1, row + 1), cap(column, row + 1)});
      }
    }
  }

  HalfTopology half_;
};

// What IsCutOut and AddGrid say, for a key that a person wrote: any numbers may stand there.
bool IsGridVertex(const Key& key) {
  const bool end_of_crown = key.b == kRows && (key.a == 0 || key.a == kColumns);
  const auto inside = [&key](const Block& b, int column0) {
    return key.a > column0 && key.a < b.column1 && key.b > b.row0 && key.b < b.row1;
  };
  return key.a >= 0 && key.a <= kColumns && key.b >= 0 && key.b <= kRows && !end_of_crown &&
         !inside(kEyeBlock, kEyeBlock.column0) && !inside(kEarBlock, kEarBlock.column0) &&
         !inside(kMouthBlock, -1);
}

bool IsOnRings(const Key& key, int rim, int rings) {
  return key.a >= 0 && key.a < rim && key.b >= 0 && key.b <= rings;
}

}  // namespace

// Three words, and none behind them.
std::optional<Key> AsVertex(std::string_view name) {
  std::istringstream words{std::string(name)};
  std::string region;
  Key key;
  std::string rest;
  if (!(words >> region >> key.a >> key.b) || (words >> rest)) return std::nullopt;
  if (region == "grid" && IsGridVertex(key)) return key;
  if (region == "eye" && IsOnRings(key, kEyeRim, kEyeRings)) return Key{Region::kEye, key.a, key.b};
  if (region == "mouth" && IsOnRings(key, kMouthRim, kMouthRings)) return Key{Region::kMouth, key.a, key.b};
  return std::nullopt;
}

// Wraps and shifts as Slot says; asserts that the vertex is there.
Index HalfTopology::At(Region region, int a, int b) const {
  const Index vertex = table[static_cast<std::size_t>(region)][Slot(region, a, b)];
  assert(vertex != kNobody);
  return vertex;
}

HalfTopology BuildHalfTopology() {
  return Builder().Build();
}

// In the quad's order, from its first corner.
std::vector<Index> Corners(const Quad& quad) {
  std::vector<Index> corners;
  for (Index corner : quad) {
    if (std::find(corners.begin(), corners.end(), corner) == corners.end()) corners.push_back(corner);
  }
  return corners;
}

}  // namespace kaori::sculpt
