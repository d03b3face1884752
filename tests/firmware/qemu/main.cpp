// The proofs of the surface's core, compiled as for the chip, on the Cortex-M of QEMU: microbit has an M0, mps2-an385 an M3. Talks
// by semihosting (Arm's semihosting specification, 2.0): prints figures, and its exit status is the verdict.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "tests/firmware/proof/proofs.h"

namespace {

constexpr int kWrite = 0x04, kExit = 0x18;
constexpr std::uintptr_t kExitedWell = 0x20026, kExitedBadly = 0x20023;
constexpr std::uint64_t kEdges = 10'000'000;

void Call(int operation, std::uintptr_t argument) {
  asm volatile(
      "mov r0, %0\n"
      "mov r1, %1\n"
      "bkpt 0xab\n"
      :
      : "r"(operation), "r"(argument)
      : "r0", "r1", "memory");
}

void Print(const char* text) {
  Call(kWrite, reinterpret_cast<std::uintptr_t>(text));
}

// Prints "name value" and a line's end.
void Print(const char* name, std::uint64_t value) {
  std::array<char, 24> digits{};
  std::size_t at = digits.size() - 1;
  do {
    digits[--at] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  Print(name);
  Print(&digits[at]);
  Print("\n");
}

bool Prove() {
  using namespace kaori::proof;
  const auto dials = ProveDials(kEdges, 1);
  Print("edges_tested ", dials.edges);
  Print("counts_lost ", dials.counts_lost);
  Print("double_steps_untold ", dials.double_steps_untold);
  const auto buttons = ProveButtons(200, 8, 2);
  Print("buttons wrong ", buttons.wrong);
  const auto reports = ProveReports(200'000, 4);
  Print("reports wrong ", reports.wrong);
  return dials.counts_lost + dials.double_steps_untold + buttons.wrong + reports.wrong == 0;
}

}  // namespace

extern "C" {
// Set by the linker script.
extern std::uint32_t stack_top;
extern std::uint32_t bss_begin;
extern std::uint32_t bss_end;

[[noreturn]] void Reset() {
  for (std::uint32_t* word = &bss_begin; word < &bss_end; ++word) *word = 0;
  Call(kExit, Prove() ? kExitedWell : kExitedBadly);
  for (;;) {
  }
}
[[noreturn]] void Fault() {
  Print("the processor faulted\n");
  Call(kExit, kExitedBadly);
  for (;;) {
  }
}
}

namespace {
using Handler = void (*)();
struct VectorTable {
  std::uint32_t* stack;
  std::array<Handler, 15> handlers;
};
__attribute__((section(".vectors"), used)) constexpr VectorTable kVectors{
    &stack_top,
    {Reset, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault, Fault,
     Fault}};
}  // namespace
