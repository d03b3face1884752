#include "firmware/surface/sha256.h"

#include <bit>

namespace kaori::surface {
namespace {

// FIPS 180-4, 4.2.2.
constexpr std::array<std::uint32_t, 64> kRounds{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

// The standard's words are big-endian, this core is not.
std::uint32_t BigEndian(std::span<const std::uint8_t, 4> bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
         bytes[3];
}

}  // namespace

// FIPS 180-4, 6.2.2, with the 16 newest words of the schedule alone.
void Sha256::Block() {
  std::array<std::uint32_t, 16> words;
  for (std::size_t n = 0; n < 16; ++n)
    words[n] = BigEndian(std::span<const std::uint8_t, 4>(&block_[4 * n], 4));
  auto [a, b, c, d, e, f, g, h] = state_;
  for (std::size_t n = 0; n < 64; ++n) {
    std::uint32_t& word = words[n % 16];
    if (n >= 16) {
      const std::uint32_t early = words[(n + 1) % 16];
      const std::uint32_t late = words[(n + 14) % 16];
      word += (std::rotr(early, 7) ^ std::rotr(early, 18) ^ early >> 3) + words[(n + 9) % 16] +
              (std::rotr(late, 17) ^ std::rotr(late, 19) ^ late >> 10);
    }
    const std::uint32_t one = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                              ((e & f) ^ (~e & g)) + kRounds[n] + word;
    const std::uint32_t two =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + one;
    d = c;
    c = b;
    b = a;
    a = one + two;
  }
  const std::array<std::uint32_t, 8> mixed{a, b, c, d, e, f, g, h};
  for (std::size_t n = 0; n < 8; ++n) state_[n] += mixed[n];
}

// In parts of any length, as pages of an image come: their hash is that of the whole.
Sha256& Sha256::Update(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    block_[bytes_ % 64] = byte;
    if (++bytes_ % 64 == 0) Block();
  }
  return *this;
}

// A one bit, zeros, and the length in bits fill the last block (FIPS 180-4, 5.1.1).
Sha256Digest Sha256::Digest() {
  const std::uint32_t bits = bytes_ * 8;
  const std::array<std::uint8_t, 1> one{0x80};
  const std::array<std::uint8_t, 1> zero{0};
  Update(one);
  while (bytes_ % 64 != 56) Update(zero);
  const std::array<std::uint8_t, 8> length{0,
                                           0,
                                           0,
                                           0,
                                           static_cast<std::uint8_t>(bits >> 24),
                                           static_cast<std::uint8_t>(bits >> 16),
                                           static_cast<std::uint8_t>(bits >> 8),
                                           static_cast<std::uint8_t>(bits)};
  Update(length);
  Sha256Digest digest;
  for (std::size_t n = 0; n < digest.size(); ++n)
    digest[n] = static_cast<std::uint8_t>(state_[n / 4] >> (24 - 8 * (n % 4)));
  return digest;
}

Sha256Digest Sha256Of(std::span<const std::uint8_t> bytes) {
  return Sha256().Update(bytes).Digest();
}

}  // namespace kaori::surface
