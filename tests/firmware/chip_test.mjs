// The shipped images, bit for bit, in an emulated RP2040: each file of cases is run in turn.
//
// Usage: node chip_test.mjs RP2040JS IMAGES HEADER     RP2040JS is the package's folder, IMAGES that of the .bin files, HEADER
//                                                      firmware/wire/dial_box.h
import process from "node:process";

import { failed } from "./chip_harness.mjs";

for (const cases of ["dial_box", "start", "stick_pod"]) await import(`./chip_${cases}_cases.mjs`);
console.log(failed() === 0 ? "all of the chip's tests passed" : `${failed()} expectations of the chip's tests failed`);
process.exit(failed() === 0 ? 0 : 1);
