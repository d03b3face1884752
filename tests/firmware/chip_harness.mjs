// What the chip's tests have in common: the shipped images, a host's requests, and expectations that are counted.
//
// The folders are those that chip_test.mjs was called with. `effort` is KAORI_FIRMWARE_EFFORT, 1 without it; `proves` is true where
// figures are wanted, for out/firmware.json.
import { createHash } from "node:crypto";
import { appendFileSync, readFileSync } from "node:fs";
import path from "node:path";
import process from "node:process";
import { pathToFileURL } from "node:url";

import { Chip } from "../../hw-sim/chip/rp2040.mjs";

const [folder, images, header] = process.argv.slice(2);
export const rp2040js = await import(pathToFileURL(path.join(folder, "dist/esm/index.js")));
export const image = (name) => readFileSync(path.join(images, name));
export const shipped = image("dial-box.bin"), shippedPod = image("stick-pod.bin");
export const headerText = readFileSync(header, "utf8");
export const effort = Number(process.env.KAORI_FIRMWARE_EFFORT ?? 1);
export const proves = process.env.KAORI_FIRMWARE_FIGURES !== undefined;
export const MS = 1e6, US = 1e3, S = 1e9;

let failures = 0;
export const failed = () => failures;
export function expect(what, seen, wanted) {
  const same = JSON.stringify(seen) === JSON.stringify(wanted);
  if (!same) ++failures;
  if (!same) console.log(`  ${what}: ${JSON.stringify(seen)}, and not ${JSON.stringify(wanted)}`);
  return same;
}
export function figure(name, value) {
  console.log(`  ${name}: ${value}`);
  if (proves) appendFileSync(process.env.KAORI_FIRMWARE_FIGURES, `${name} ${value}\n`);
}
export function test(name, body) {
  const before = failures, began = Date.now();
  try {
    body();
  } catch (error) {
    ++failures;
    console.log(`  ${error.stack}`);
  }
  console.log(`${failures === before ? "passed" : "FAILED"}: ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
}

// A chip that a host has found. `options` are those of Chip.
export const start = (flash = shipped, options = {}) => {
  const chip = new Chip(rp2040js, flash, options);
  chip.enumerate();
  return chip;
};
export const u16 = (bytes, at) => bytes[at] | (bytes[at + 1] << 8);
export const i16 = (bytes, at) => (u16(bytes, at) << 16) >> 16;
export const u32 = (bytes, at) => (u16(bytes, at) | (u16(bytes, at + 2) << 16)) >>> 0;
export const status = (chip) => chip.control(0xa1, 1, 0x0300, 0, 64);
export const doubleSteps = (chip) => u32(status(chip), 16);
export const STATE = { plays: 0, updates: 1, tries: 2, ready: 3, refuses: 4 };
export const state = (chip) => status(chip)[11];
// What a host hears of the dials until nothing comes any more.
export function drain(chip, sums = new Array(8).fill(0)) {
  for (let quiet = 0; quiet < 3; chip.run(1 * MS)) {
    const report = chip.poll();
    quiet = report ? 0 : quiet + 1;
    for (let dial = 0; report && dial < 8; ++dial) sums[dial] += i16(report, 4 + 2 * dial);
  }
  return sums;
}
export function command(chip, operation, { number = 0, offset = 0, data = [] } = {}) {
  const bytes = new Uint8Array(64);
  bytes.set([operation, number, data.length & 0xff, data.length >> 8]);
  new DataView(bytes.buffer).setUint32(4, offset, true);
  bytes.set(data, 8);
  return chip.control(0x21, 9, 0x0300, 0, 64, [...bytes]) !== null;
}
export const LAMP_TEST = 1, BRIGHTNESS = 2, BEGIN = 4, DATA = 5, END = 6, KEEP = 7, RESTART = 8;
// Sends an update as the box does. `description` are the 44 bytes of SurfaceImage.
export function update(chip, description, image) {
  if (!command(chip, BEGIN, { data: [...description] })) return "begin refused";
  for (let at = 0; at < image.length; at += 56)
    if (!command(chip, DATA, { offset: at, data: [...image.subarray(at, at + 56)] })) return `data at ${at} refused`;
  return command(chip, END) ? "taken" : "end refused";
}
export function describe(image, version, product = 0x12090001) {
  const bytes = new Uint8Array(44), view = new DataView(bytes.buffer);
  view.setUint32(0, product, true);
  view.setUint32(4, image.length, true);
  view.setUint32(8, version, true);
  bytes.set(createHash("sha256").update(image).digest(), 12);
  return bytes;
}
export const shippedImage = image("dial-box.update").subarray(44);
