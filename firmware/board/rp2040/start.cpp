// What the chip finds at the beginning of an image: the table of interrupts; and what the compiler expects to be there.
#include <cstddef>
#include <cstdint>

#include "firmware/board/rp2040/start.h"

extern "C" {
// Set by the linker script.
extern std::uint32_t stack_top;
extern std::uint32_t bss_begin;
extern std::uint32_t bss_end;

void Reset();
void Fault();
void Nothing();
}

namespace {

using Handler = void (*)();

// ARMv6-M, B1.5.3. External interrupts are none: the timer's look is all that interrupts.
struct VectorTable {
  std::uint32_t* stack;
  Handler handlers[15];
};
__attribute__((section(".vectors"), used)) constexpr VectorTable kVectors{
    &stack_top,
    {Reset, Nothing, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault,
     kaori::rp2040::Look}};

}  // namespace

extern "C" {

// The first stage has copied code and data here; what begins with zeros is cleared. There are no global constructors: the
// linker script refuses them.
void Reset() {
  for (std::uint32_t* word = &bss_begin; word < &bss_end; ++word) *word = 0;
  kaori::rp2040::Main();
}

// The watchdog ends it.
void Fault() {
  for (;;) {
  }
}
void Nothing() {}

// A pure function was called, which no program of ours does.
void __cxa_pure_virtual() {
  Fault();
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
