// What the chip finds at the beginning of an image: the table of interrupts.
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

// The first stage has copied code and data here; what begins with zeros is cleared. There are no global
// constructors: the linker script refuses them.
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
}
