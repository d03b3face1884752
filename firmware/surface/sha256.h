// SHA-256, of which an image's hash and every check in flash are made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kaori::surface {

using Sha256Digest = std::array<std::uint8_t, 32>;

// FIPS 180-4, for messages of less than 512 MiB. The tests compare it with the standard's examples and with
// libsodium's. One side.
class Sha256 {
 public:
  Sha256& Update(std::span<const std::uint8_t> bytes);
  // Ends the message. Nothing may follow.
  Sha256Digest Digest();

 private:
  void Block();

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::uint32_t bytes_ = 0;
};

// Of one message.
Sha256Digest Sha256Of(std::span<const std::uint8_t> bytes);

}  // namespace kaori::surface
