// Numbers of a glTF buffer: floats and integers of 8, 16 and 32 bits, normalised, strided, sparse.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kaori::import {

using Bytes = std::span<const std::uint8_t>;

// The component types of glTF 2.0, section 3.6.2.2.
enum class Component : int {
  kInt8 = 5120,
  kUint8 = 5121,
  kInt16 = 5122,
  kUint16 = 5123,
  kUint32 = 5125,
  kFloat = 5126,
};

// Rows of numbers in a buffer. `stride_bytes` 0: tightly packed.
struct Rows {
  Bytes bytes;  // From the first row to the end of the view.
  std::size_t stride_bytes = 0;
  Component component = Component::kFloat;
  int columns = 1;
  std::size_t count = 0;
};

// Rows of `base` that are replaced.
struct Sparse {
  Rows at;      // One column of unsigned integers, ascending.
  Rows values;  // As many rows as `at`, of the type of the base.
};

struct Accessor {
  Rows base;  // Empty bytes: all zero.
  bool normalised = false;
  std::optional<Sparse> sparse;
};

// Row by row, columns beside each other. A reason instead where bytes are missing or a type is unknown.
struct Numbers {
  std::vector<float> values;
  std::string fault;
};
Numbers ReadNumbers(const Accessor& accessor);

// Unsigned integers of one column, for the corners of triangles.
struct Indices {
  std::vector<std::uint32_t> values;
  std::string fault;
};
Indices ReadIndices(const Rows& rows);

}  // namespace kaori::import
