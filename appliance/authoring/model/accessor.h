// Numbers of a glTF buffer: floats and integers of 8, 16 and 32 bits, normalised, strided, sparse.
//
// Everything here is pure: bytes in, numbers or one line of fault out. Nothing is trusted; every offset,
// stride and count of a file is checked against the bytes that are there before one of them is read. Numbers
// are little-endian, as glTF demands and as the machines are on which this runs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kaori::model {

// Borrowed: the buffer must outlive every Rows and Accessor that points into it.
using Bytes = std::span<const std::uint8_t>;

// The component types of glTF 2.0, section 3.6.2.2. The values are the file's own, so a number that is none
// of these may be cast to it; ReadNumbers and ReadIndices then answer with a fault.
enum class Component : int {
  kInt8 = 5120,
  kUint8 = 5121,
  kInt16 = 5122,
  kUint16 = 5123,
  kUint32 = 5125,
  kFloat = 5126,
};

// Rows of numbers in a buffer: `count` rows of `columns` numbers (1 to 4), `stride_bytes` from one row's
// first byte to the next one's. A stride of 0 means tightly packed; interleaved vertices have a larger one.
struct Rows {
  // From the first row's first byte to the end of the buffer view; may be longer than the rows need.
  Bytes bytes;
  std::size_t stride_bytes = 0;
  Component component = Component::kFloat;
  int columns = 1;
  std::size_t count = 0;
};

// Rows of `base` that are replaced (glTF 2.0, section 3.6.2.3): morph targets that move a part of the head
// are often written so.
struct Sparse {
  // Which rows: one column of unsigned integers. glTF wants them ascending; this is not relied on.
  Rows at;
  // What they become: as many rows as `at`, of the base's type and columns.
  Rows values;
};

// A glTF accessor in plain values.
struct Accessor {
  // Its bytes may be empty where there is a `sparse`: all rows are zero but those that it replaces.
  Rows base;
  // Integers stand for 0..1 or -1..1 instead of for themselves.
  bool normalised = false;
  std::optional<Sparse> sparse;
};

// `count` * `columns` numbers, row by row. Where `fault` is not empty, it says in words for people what is
// wrong (a row beyond the buffer, an unknown type, no rows or too many), and `values` must not be used.
struct Numbers {
  std::vector<float> values;
  std::string fault;
};
// At most 3 * kMostTriangles rows are read, so that a wrong count cannot ask for all memory. Floats that are
// no numbers pass; CheckModel finds those.
Numbers ReadNumbers(const Accessor& accessor);

// Unsigned integers of one column, for the corners of triangles; `fault` as in Numbers. Whether a vertex of
// that number exists is for the caller to check.
struct Indices {
  std::vector<std::uint32_t> values;
  std::string fault;
};
// Accepts components of 8, 16 and 32 bits without a sign; a fault for floats and signed integers.
Indices ReadIndices(const Rows& rows);

}  // namespace kaori::model
