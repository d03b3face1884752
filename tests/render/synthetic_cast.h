// A small cast made by formulas: heads of four shapes with lids, a mouth slit, a seam at the back and a fine
// mesh. For tests that need a whole cast but no beauty.
#pragma once

#include "render/face/cast.h"

namespace kaori::tests {

struct SyntheticSize {
  int columns = 32;  // Of the grid round the head; even.
  int rows = 24;
  int faces = 4;        // The four shapes again and again.
  int expressions = 6;  // See below, again and again with other strengths.
};

// Faces: 0 "reference", 1 "round" (wider), 2 "turned" (turned by 30 degrees about Y and 1.3 times as large),
// 3 "long" (deep and tall, like a dog's head).
// Expressions: 0 "neutral"; 1 "smile" with half-shut lids; 2 "surprised"; 3 "a", a mouth shape that takes the
// lower lip 1.5 cm down; 4 "brow_up", a channel; 5 "wide", a mouth shape.
// Control points include UC, LC (lips), MC.l, MC.r (corners), B2.l, B2.r (brows), C2.l, C2.r (over the lids).
face::Cast MakeSyntheticCast(const SyntheticSize& size = {});

// The column of an expression or a point of that name; asserts that it is there.
std::uint16_t ExpressionNamed(const face::Cast& cast, const char* name);
std::size_t PointNamed(const face::Cast& cast, const char* name);

}  // namespace kaori::tests
