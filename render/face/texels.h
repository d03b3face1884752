// The bytes of a texture: its own, or some that lie in a file and stay there for as long as a texture shows
// them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace kaori::face {

// Copying shares what lies elsewhere and copies what is its own.
class Texels {
 public:
  Texels() = default;
  // Takes the bytes over.
  Texels(std::vector<std::uint8_t> own) : own_(std::move(own)) {}
  Texels(std::initializer_list<std::uint8_t> own) : own_(own) {}
  // `there` holds while `keeper` lives. A page of a file is read when a texel on it is first looked at.
  Texels(std::span<const std::uint8_t> there, std::shared_ptr<const void> keeper)
      : there_(there), keeper_(std::move(keeper)) {}

  // Whichever of the two holds them.
  std::span<const std::uint8_t> bytes() const { return keeper_ ? there_ : std::span(own_); }
  const std::uint8_t* data() const { return bytes().data(); }
  std::size_t size() const { return bytes().size(); }
  std::uint8_t operator[](std::size_t at) const { return bytes()[at]; }

  // For changing them: they are copied first where they lie elsewhere. Holds until these texels are changed
  // or moved.
  std::vector<std::uint8_t>& own() {
    if (keeper_) *this = Texels(std::vector(there_.begin(), there_.end()));
    return own_;
  }

  friend bool operator==(const Texels& a, const Texels& b) {
    return std::ranges::equal(a.bytes(), b.bytes());
  }

 private:
  std::vector<std::uint8_t> own_;
  std::span<const std::uint8_t> there_;
  std::shared_ptr<const void> keeper_;
};

}  // namespace kaori::face
