// What the chip's ROM starts: 252 bytes that it has copied to RAM, and their CRC-32 (RP2040 datasheet, 2.8.1.3.1). Has the
// flash read as memory by the command that every flash knows (03h), and copies the first stage to RAM. Independent of where
// it lies.
  .syntax unified
  .cpu cortex-m0plus
  .thumb
  .section .stage2, "ax"
  .global Stage2
  .thumb_func
Stage2:
  ldr r3, =0x18000000   // The flash's controller (4.10.13).
  movs r0, #0
  str r0, [r3, #0x08]   // Off, to be set up.
  movs r0, #4
  str r0, [r3, #0x14]   // A quarter of the system's clock: 31 MHz at most.
  ldr r0, =0x001F0300   // Words of 32 bits, read after a command.
  str r0, [r3, #0x00]
  movs r0, #0
  str r0, [r3, #0x04]   // One at a time.
  ldr r0, =0x03000218   // Command 03h of 8 bits, address of 24 bits, on one line.
  ldr r1, =0x180000F4
  str r0, [r1]
  movs r0, #1
  str r0, [r3, #0x08]

  ldr r0, =0x10000100
  ldr r1, =0x2003C000
  ldr r2, =0x10004000   // kFirstStageBytes of firmware/surface/flash.h.
copy:
  ldmia r0!, {r4-r7}
  stmia r1!, {r4-r7}
  cmp r0, r2
  blo copy

  ldr r0, =0x2003C000   // Where its stack begins, and where it does.
  ldr r1, [r0, #0]
  ldr r2, [r0, #4]
  msr msp, r1
  bx r2
  .pool
