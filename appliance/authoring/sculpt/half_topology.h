// The mesh of one half of the head (x >= 0): a grid of columns and rows with an eye, a mouth and an ear cut
// in.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "render/face/topology.h"

namespace kaori::sculpt {

using face::Index;

// Grid columns run from the middle of the face (0) to the middle of the back (26), rows from the neck's end
// (0) to the crown (36). Row 36 lies on the plane x = 0, so the crown closes like a swimming cap, without a
// pole. Columns are narrow in the face and wide behind: 3 on each side of the nose, 8 over an eye.
inline constexpr int kColumns = 26;
inline constexpr int kRows = 36;

// Rows of the neck, from its end; the row over them lies under the chin, where a neck begins.
inline constexpr int kNeckRows = 5;

// A rectangle of cells that is cut out of the grid and filled with rings: corners in grid lines. Its border
// stays part of the grid.
struct Block {
  int column0, column1, row0, row1;
};
// Eye, mouth and ear. The corners of a block have five edges, about which shading is uneven; lids and lips
// lie some rings away.
inline constexpr Block kEyeBlock{3, 11, 20, 26};
inline constexpr Block kMouthBlock{0, 6, 11, 15};
inline constexpr Block kEarBlock{16, 20, 14, 22};

// Ring 0 is the block's rim in the grid; rims run clockwise seen from outside. Eye: rim positions j = 0
// (inner corner) .. 14 (outer) over the top, then back below; 5 is the lid's edge, 6 and 7 lie behind it. The
// lower partner of j is 28 - j. Mouth: j = 0 (middle, above) .. 8 (corner) .. 16 (middle, below); 3 is the
// lip's border, 6 where the lips meet, 7 .. 10 the bag. Ear: j like the eye's.
inline constexpr int kEyeRim = 28;
inline constexpr int kEyeRings = 7;
inline constexpr int kLidRing = 5;
// Not closed: it runs from the middle of the face above the mouth to the middle below.
inline constexpr int kMouthRim = 17;
inline constexpr int kMouthCorner = 8;
inline constexpr int kMouthRings = 10;
inline constexpr int kLipBorderRing = 3;
inline constexpr int kLipContactRing = 6;
inline constexpr int kEarRim = 24;
inline constexpr int kEarRings = 5;

// The order is that of HalfTopology::table.
enum class Region : std::uint8_t { kGrid, kEye, kMouth, kEar, kEarCap };

// A vertex's name: column and row on the grid and on the ear's cap, rim position and ring elsewhere. A vertex
// on a rim has its grid name.
struct Key {
  Region region = Region::kGrid;
  int a = 0;
  int b = 0;
};

// The vertex that files call "grid 3 17", "eye 7 5" or "mouth 8 6"; none where there is no such vertex. Ears
// have no names in files.
std::optional<Key> AsVertex(std::string_view name);

// An intersection of the grid's lines.
struct GridPoint {
  int column, row;
};

// Corners counter-clockwise seen from outside for x > 0. A triangle, as at the two ends of the crown and of
// the mouth's bag, repeats one corner.
using Quad = std::array<Index, 4>;

// Immutable once built. Vertices are numbered in the order in which BuildHalfTopology adds them: grid, eye,
// mouth, ear, ear's cap.
struct HalfTopology {
  std::vector<Key> keys;  // The name of each vertex.
  std::vector<Quad> quads;
  std::vector<GridPoint> eye_rim;    // kEyeRim points, upper lid first.
  std::vector<GridPoint> mouth_rim;  // kMouthRim points, from above the mouth to below it.
  std::vector<GridPoint> ear_rim;    // kEarRim points.

  // The vertex of that name; rim positions of closed rings wrap (also below zero), ring 0 is the rim itself,
  // the rim of the ear's cap is ring 5. The name must exist: asserted. Constant time.
  Index At(Region region, int a, int b) const;
  Index Grid(int column, int row) const { return At(Region::kGrid, column, row); }

  std::array<std::vector<Index>, 5> table;  // By region; At() reads it.
};

// The same each time; no file has a say in it.
HalfTopology BuildHalfTopology();

// Corners of a quad without the repeated one: 3 or 4.
std::vector<Index> Corners(const Quad& quad);

}  // namespace kaori::sculpt
