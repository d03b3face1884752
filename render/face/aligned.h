// A fixed block of floats for the vector units: aligned and padded to a cache line, zero at first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <span>

#include <glm/vec3.hpp>

namespace kaori::face {

// Of all processors that the box runs on, and no less than the widest vector.
inline constexpr std::size_t kCacheLine_bytes = 64;
inline constexpr std::size_t kLineFloats = kCacheLine_bytes / sizeof(float);

// Rounds up to whole cache lines, in floats: Blend reads and writes nothing smaller.
constexpr std::size_t Padded(std::size_t floats) {
  return (floats + kLineFloats - 1) / kLineFloats * kLineFloats;
}

// Owns its memory; moves, and does not copy. Pointers into it hold until it is moved from or dropped.
class AlignedFloats {
 public:
  AlignedFloats() = default;
  // Holds `floats` and at least one more, so that four floats can be loaded at the last vertex.
  explicit AlignedFloats(std::size_t floats) : size_(Padded(floats + 1)), values_(Allocate(size_)) {
    std::fill_n(values_.get(), size_, 0.0F);
  }

  float* data() { return values_.get(); }
  const float* data() const { return values_.get(); }
  // In floats, padding included.
  std::size_t size() const { return size_; }
  // The first `count` vertices; three floats each, packed.
  std::span<glm::vec3> vertices(std::size_t count) { return {reinterpret_cast<glm::vec3*>(data()), count}; }
  std::span<const glm::vec3> vertices(std::size_t count) const {
    return {reinterpret_cast<const glm::vec3*>(data()), count};
  }

 private:
  struct Free {
    void operator()(float* p) const { ::operator delete[](p, std::align_val_t{kCacheLine_bytes}); }
  };
  // Throws bad_alloc; nothing is allocated after a show has begun.
  static float* Allocate(std::size_t floats) {
    return static_cast<float*>(::operator new[](floats * sizeof(float), std::align_val_t{kCacheLine_bytes}));
  }

  std::size_t size_ = 0;
  std::unique_ptr<float[], Free> values_;
};

}  // namespace kaori::face
