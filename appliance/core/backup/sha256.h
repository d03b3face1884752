// SHA-256, by which a backup's files are compared: sha256sum(1) on any computer gives the same.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace kaori::backup {

// Adds up piece by piece, in any cut of the pieces. After Finish it is used up.
class Sha256 {
 public:
  Sha256();
  void Add(std::span<const std::uint8_t> bytes);
  // 64 hexadecimal digits in lower case.
  std::string Finish();

 private:
  // libsodium's, opaque.
  alignas(16) std::array<std::uint8_t, 128> state_;
};

}  // namespace kaori::backup
