#include "appliance/authoring/model/accessor.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "appliance/authoring/model/model.h"

namespace kaori::model {
namespace {

// The corners of kMostTriangles triangles: no accessor of a head that is accepted can need more rows.
constexpr std::size_t kMostRows = 3 * kMostTriangles;

// 0 for a number that is none of the file format's types: the enumeration is cast from the file.
std::size_t SizeOf_bytes(Component component) {
  switch (component) {
    case Component::kInt8:
    case Component::kUint8:
      return 1;
    case Component::kInt16:
    case Component::kUint16:
      return 2;
    case Component::kUint32:
    case Component::kFloat:
      return 4;
  }
  return 0;
}

// Bytes from one row's start to the next; rows without a stride stand directly behind each other.
std::size_t Stride_bytes(const Rows& rows) {
  const std::size_t tight = SizeOf_bytes(rows.component) * static_cast<std::size_t>(rows.columns);
  return rows.stride_bytes == 0 ? tight : rows.stride_bytes;
}

// Why these rows cannot be read; empty: they can. After this, CopyRow may read each row
// without another check.
std::string FaultOf(const Rows& rows) {
  const std::size_t size = SizeOf_bytes(rows.component);
  if (size == 0) return fmt::format("component type {} is unknown", static_cast<int>(rows.component));
  if (rows.columns < 1 || rows.columns > 4) return fmt::format("{} numbers a row", rows.columns);
  if (rows.count == 0) return "is empty";
  if (rows.count > kMostRows) return fmt::format("{} rows are more than {}", rows.count, kMostRows);
  const std::size_t row = size * static_cast<std::size_t>(rows.columns);
  const std::size_t stride = Stride_bytes(rows);
  // glTF 2.0 allows strides of 4 to 252; more is left to tools that write carelessly. The bound keeps the
  // product below from overflowing.
  if (stride < row || stride > 1024) return fmt::format("a stride of {} bytes", stride);
  // The last row need not be filled up to a whole stride.
  const std::size_t needed = (rows.count - 1) * stride + row;
  if (needed > rows.bytes.size())
    return fmt::format("{} bytes are needed, the buffer ends after {}", needed, rows.bytes.size());
  return {};
}

// Views begin at any byte of a file, so that a pointer of T could be misaligned.
template <class T>
T Load(const std::uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

// glTF 2.0, section 3.11: a normalised integer stands for -1..1 or 0..1. The most negative one would fall
// below -1 and is held there, as the specification's formula does: f = max(c / 127, -1).
float Value(const std::uint8_t* at, Component component, bool normalised) {
  const auto scaled = [normalised](auto value, float largest) {
    const auto number = static_cast<float>(value);
    return normalised ? std::max(number / largest, -1.0F) : number;
  };
  switch (component) {
    case Component::kInt8:
      return scaled(Load<std::int8_t>(at), 127);
    case Component::kUint8:
      return scaled(*at, 255);
    case Component::kInt16:
      return scaled(Load<std::int16_t>(at), 32767);
    case Component::kUint16:
      return scaled(Load<std::uint16_t>(at), 65535);
    case Component::kUint32:
      return static_cast<float>(Load<std::uint32_t>(at));
    case Component::kFloat:
      return Load<float>(at);
  }
  return 0;
}

void CopyRow(const Rows& rows, std::size_t row, bool normalised, float* out) {
  const std::uint8_t* at = rows.bytes.data() + row * Stride_bytes(rows);
  for (int c = 0; c < rows.columns; ++c, at += SizeOf_bytes(rows.component))
    out[c] = Value(at, rows.component, normalised);
}

// Writes sparse values over `numbers`. Returns the fault, or nothing.
std::string Replace(const Sparse& sparse, bool normalised, std::size_t rows, Numbers& numbers) {
  if (sparse.at.count != sparse.values.count) return "sparse: as many indices as values are expected";
  const Indices at = ReadIndices(sparse.at);
  if (!at.fault.empty()) return "sparse indices: " + at.fault;
  if (std::string fault = FaultOf(sparse.values); !fault.empty()) return "sparse values: " + fault;
  const auto columns = static_cast<std::size_t>(sparse.values.columns);
  for (std::size_t i = 0; i < at.values.size(); ++i) {
    if (at.values[i] >= rows) return fmt::format("sparse: row {} of {}", at.values[i], rows);
    CopyRow(sparse.values, i, normalised, numbers.values.data() + at.values[i] * columns);
  }
  return {};
}

}  // namespace

// The base's count and columns are judged first: they size the answer also where the base has no bytes.
Numbers ReadNumbers(const Accessor& accessor) {
  const Rows& base = accessor.base;
  Numbers numbers;
  if (base.count == 0 || base.count > kMostRows || base.columns < 1 || base.columns > 4) {
    numbers.fault = fmt::format("{} rows of {} numbers", base.count, base.columns);
    return numbers;
  }
  // Without a buffer view the base is all zero (glTF 2.0, section 3.6.2.3); `resize` has written the zeros.
  const bool all_zero = base.bytes.empty() && accessor.sparse.has_value();
  if (!all_zero) numbers.fault = FaultOf(base);
  if (!numbers.fault.empty()) return numbers;
  const auto columns = static_cast<std::size_t>(base.columns);
  numbers.values.resize(base.count * columns);
  for (std::size_t row = 0; row < base.count && !all_zero; ++row)
    CopyRow(base, row, accessor.normalised, numbers.values.data() + row * columns);
  if (accessor.sparse) numbers.fault = Replace(*accessor.sparse, accessor.normalised, base.count, numbers);
  return numbers;
}

// glTF allows no signed integers and no floats here.
Indices ReadIndices(const Rows& rows) {
  Indices indices;
  indices.fault = FaultOf(rows);
  if (indices.fault.empty() && rows.columns != 1) indices.fault = "one number a row is expected";
  if (!indices.fault.empty()) return indices;
  indices.values.reserve(rows.count);
  for (std::size_t row = 0; row < rows.count; ++row) {
    const std::uint8_t* at = rows.bytes.data() + row * Stride_bytes(rows);
    switch (rows.component) {
      case Component::kUint8:
        indices.values.push_back(*at);
        break;
      case Component::kUint16:
        indices.values.push_back(Load<std::uint16_t>(at));
        break;
      case Component::kUint32:
        indices.values.push_back(Load<std::uint32_t>(at));
        break;
      default:
        indices.fault = "indices are unsigned integers";
        return indices;
    }
  }
  return indices;
}

}  // namespace kaori::model
