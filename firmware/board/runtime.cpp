// What the compiler expects to be there on every chip, without a library.
#include <cstddef>
#include <cstdint>

extern "C" {

// A pure function was called, which no program of ours does.
void __cxa_pure_virtual() {
  for (;;) {
  }
}  // NOLINT(bugprone-reserved-identifier)

// The compiler makes calls of these. Optimised as others are, they would be made calls of themselves.
#pragma GCC optimize("no-tree-loop-distribute-patterns")
void* memcpy(void* to, const void* from, std::size_t bytes) {
  auto* out = static_cast<std::uint8_t*>(to);
  const auto* in = static_cast<const std::uint8_t*>(from);
  while (bytes-- != 0) *out++ = *in++;
  return to;
}
void* memset(void* to, int value, std::size_t bytes) {
  auto* out = static_cast<std::uint8_t*>(to);
  while (bytes-- != 0) *out++ = static_cast<std::uint8_t>(value);
  return to;
}
// Relies on the memcpy above, which goes forwards: that is right where the target lies in front.
void* memmove(void* to, const void* from, std::size_t bytes) {
  auto* out = static_cast<std::uint8_t*>(to);
  const auto* in = static_cast<const std::uint8_t*>(from);
  if (out <= in) return memcpy(to, from, bytes);
  while (bytes-- != 0) out[bytes] = in[bytes];
  return to;
}
int memcmp(const void* one, const void* other, std::size_t bytes) {
  const auto* left = static_cast<const std::uint8_t*>(one);
  const auto* right = static_cast<const std::uint8_t*>(other);
  for (; bytes != 0; --bytes, ++left, ++right)
    if (*left != *right) return *left < *right ? -1 : 1;
  return 0;
}
}
