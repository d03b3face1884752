// The shipped image, bit for bit, in an emulated RP2040: it enumerates, turns, presses, lights lamps, is updated, and is
// restarted where it hangs.
//
// Usage: node chip_test.mjs RP2040JS IMAGES HEADER     RP2040JS is the package's folder, IMAGES that of the .bin files, HEADER
//                                                      firmware/wire/dial_box.h
import { createHash } from "node:crypto";
import { appendFileSync, readFileSync } from "node:fs";
import path from "node:path";
import process from "node:process";
import { pathToFileURL } from "node:url";

import { Chip } from "../../hw-sim/chip/rp2040.mjs";

const [folder, images, header] = process.argv.slice(2);
const rp2040js = await import(pathToFileURL(path.join(folder, "dist/esm/index.js")));
const shipped = readFileSync(path.join(images, "dial-box.bin"));
const effort = Number(process.env.KAORI_FIRMWARE_EFFORT ?? 1);
const MS = 1e6, US = 1e3, S = 1e9;

let failures = 0;
function expect(what, seen, wanted) {
  const same = JSON.stringify(seen) === JSON.stringify(wanted);
  if (!same) ++failures;
  if (!same) console.log(`  ${what}: ${JSON.stringify(seen)}, and not ${JSON.stringify(wanted)}`);
  return same;
}
function figure(name, value) {
  console.log(`  ${name}: ${value}`);
  if (process.env.KAORI_FIRMWARE_FIGURES) appendFileSync(process.env.KAORI_FIRMWARE_FIGURES, `${name} ${value}\n`);
}
function test(name, body) {
  const before = failures, began = Date.now();
  try {
    body();
  } catch (error) {
    ++failures;
    console.log(`  ${error.stack}`);
  }
  console.log(`${failures === before ? "passed" : "FAILED"}: ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
}

const start = () => {
  const chip = new Chip(rp2040js, shipped);
  chip.enumerate();
  return chip;
};
const u16 = (bytes, at) => bytes[at] | (bytes[at + 1] << 8);
const i16 = (bytes, at) => (u16(bytes, at) << 16) >> 16;
const u32 = (bytes, at) => (u16(bytes, at) | (u16(bytes, at + 2) << 16)) >>> 0;
const status = (chip) => chip.control(0xa1, 1, 0x0300, 0, 64);
const doubleSteps = (chip) => u32(status(chip), 16);
const STATE = { plays: 0, updates: 1, tries: 2, ready: 3, refuses: 4 };
const state = (chip) => status(chip)[11];
// What a host hears of the dials until nothing comes any more.
function drain(chip, sums = new Array(8).fill(0)) {
  for (let quiet = 0; quiet < 3; chip.run(1 * MS)) {
    const report = chip.poll();
    quiet = report ? 0 : quiet + 1;
    for (let dial = 0; report && dial < 8; ++dial) sums[dial] += i16(report, 4 + 2 * dial);
  }
  return sums;
}
function command(chip, operation, { number = 0, offset = 0, data = [] } = {}) {
  const bytes = new Uint8Array(64);
  bytes.set([operation, number, data.length & 0xff, data.length >> 8]);
  new DataView(bytes.buffer).setUint32(4, offset, true);
  bytes.set(data, 8);
  return chip.control(0x21, 9, 0x0300, 0, 64, [...bytes]) !== null;
}
const LAMP_TEST = 1, BRIGHTNESS = 2, BEGIN = 4, DATA = 5, END = 6, KEEP = 7, RESTART = 8;
// Sends an update as the box does. `description` are the 44 bytes of SurfaceImage.
function update(chip, description, image) {
  if (!command(chip, BEGIN, { data: [...description] })) return "begin refused";
  for (let at = 0; at < image.length; at += 56)
    if (!command(chip, DATA, { offset: at, data: [...image.subarray(at, at + 56)] })) return `data at ${at} refused`;
  return command(chip, END) ? "taken" : "end refused";
}
function describe(image, version, product = 0x12090001) {
  const bytes = new Uint8Array(44), view = new DataView(bytes.buffer);
  view.setUint32(0, product, true);
  view.setUint32(4, image.length, true);
  view.setUint32(8, version, true);
  bytes.set(createHash("sha256").update(image).digest(), 12);
  return bytes;
}
const shippedImage = readFileSync(path.join(images, "dial-box.update")).subarray(44);

test("what is emulated is what is shipped", () => {
  const flash = new Uint8Array(2 * 1024 * 1024).fill(0xff), uf2 = readFileSync(path.join(images, "dial-box.uf2"));
  for (let at = 0; at < uf2.length; at += 512)
    flash.set(uf2.subarray(at + 32, at + 288), uf2.readUInt32LE(at + 12) - 0x10000000);
  const hash = (bytes) => createHash("sha256").update(bytes).digest("hex");
  const chip = new Chip(rp2040js, shipped);
  const same = expect("flash of the emulator", hash(chip.flash), hash(flash));
  expect("the image in the flash", hash(chip.flash.subarray(0x11000, 0x11000 + shippedImage.length)), hash(shippedImage));
  figure("emulated_is_shipped", same ? 1 : 0);
});

test("it enumerates and says who it is", () => {
  const chip = start();
  expect("device", chip.control(0x80, 6, 0x0100, 0, 64), [18, 1, 0, 2, 0, 0, 0, 64, 0x09, 0x12, 1, 0, 0, 1, 1, 2, 3, 1]);
  const text = readFileSync(header, "utf8"), begin = text.indexOf("kDialBoxDescriptor");
  const bytes = [...text.slice(begin, text.indexOf("});", begin)).matchAll(/0x([0-9A-F]{2})/g)].map((match) => parseInt(match[1], 16));
  expect("report descriptor", chip.control(0x81, 6, 0x2200, 0, 1024), bytes);
  const serial = chip.control(0x80, 6, 0x0303, 0x0409, 255).slice(2).filter((letter) => letter).map((letter) => String.fromCharCode(letter));
  expect("serial number", serial.join(""), "0102030405060708");
  expect("an unknown request", chip.control(0x80, 6, 0x0600, 0, 10), null);
  expect("the next one", chip.control(0x80, 8, 0, 0, 1), [1]);
  expect("version", status(chip).slice(0, 4), [1, 0, 0, 0]);
  expect("state", state(chip), STATE.plays);
});

test("a turned dial is seen in its reports, and at 20 000 edges a second on all eight nothing is lost", () => {
  const chip = start();
  chip.turn(2, 64);
  chip.turn(5, -300);
  expect("one dial after the other", drain(chip), [0, 0, 64, 0, 0, -300, 0, 0]);
  let lossless = 0;
  for (const rate of [20_000, 36_000]) {
    const edges = 500 * effort, wanted = [1, -1, 1, -1, 1, -1, 1, -1].map((way) => way * edges), told = doubleSteps(chip);
    chip.turnAll(edges, rate);
    if (expect(`at ${rate} edges/s`, drain(chip), wanted) && doubleSteps(chip) === told) lossless = rate;
  }
  figure("lossless_edge_rate_hz", lossless);
  const told = doubleSteps(chip);
  chip.turnAll(200, 60_000);
  expect("faster than it can see, it says so", doubleSteps(chip) > told, true);
});

test("a button is told in time, once each way", () => {
  const chip = start();
  let worst = 0, reports = 0;
  for (let n = 0; n < 20 * effort; ++n) {
    const button = n % 32, mask = (1 << button) >>> 0;
    chip.run(10 * MS + ((n * 37) % 250) * US);
    const pushed = chip.now;
    chip.push(button);
    if (!chip.run(5 * MS, () => chip.armed["1in"])) throw new Error(`button ${button} is not told`);
    worst = Math.max(worst, chip.now - pushed);
    expect("pressed", u32(chip.poll(), 0), mask);
    chip.release(button);
    chip.run(8 * MS);
    expect("released", u32(chip.poll(), 0), 0);
    reports += chip.poll() ? 1 : 0;
  }
  expect("reports too many", reports, 0);
  figure("button_us", Math.ceil(worst / US));
  if (worst > 2500 * US) expect("a press is told within 2.5 ms", worst, "less");
});

test("an edge arms its report in time", () => {
  const chip = start();
  drain(chip);
  let worst = 0;
  const edges = 100 * effort;
  for (let n = 0; n < edges; ++n) {
    chip.run(100 * US + ((n * 7919) % 25_000));
    const turned = chip.now;
    chip.turn(n % 8, 1, 1e9);
    if (!chip.run(1 * MS, () => chip.armed["1in"])) throw new Error(`edge ${n} is not told`);
    worst = Math.max(worst, chip.now - turned);
    chip.poll();
  }
  figure("report_latency_cycles", Math.ceil(worst / 8));
  figure("report_latency_edges", edges);
  if (worst / 8 > 12_500) expect("an edge arms its report within 12 500 cycles", worst / 8, "less");
});

test("lamps are lit both ways, as bright as was asked for, and dark 2 s after the host went", () => {
  const chip = start();
  const share = () => {
    let on = 0;
    for (let n = 0; n < 150; ++n) chip.run(250 * US), on += chip.lamps === 0 ? 0 : 1;
    return on / 10;
  };
  chip.output([0x0f, 0, 0, 0x80]);
  chip.run(1 * MS);
  expect("by the OUT endpoint", chip.lamps, 0x8000000f);
  expect("by SET_REPORT", chip.control(0x21, 9, 0x0200, 0, 4, [1, 0, 0, 0]), []);
  chip.run(1 * MS);
  expect("lamps", chip.lamps, 1);
  expect("brightness", command(chip, BRIGHTNESS, { number: 5 }), true);
  expect("share of the ticks", Math.round(share()), 5);
  expect("brightness that there is not", command(chip, BRIGHTNESS, { number: 16 }), false);
  command(chip, LAMP_TEST, { number: 1 });
  chip.run(1 * MS);
  expect("lamp test", chip.lamps, 0xffffffff);
  command(chip, LAMP_TEST, { number: 0 });
  expect("configuration 0", chip.control(0x00, 9, 0, 0, 0), []);
  chip.run(1.9 * S);
  expect("still there", Math.round(share()), 5);
  chip.run(0.2 * S);
  expect("dark", share(), 0);
});

test("an update is taken, tried, confirmed, and stays", () => {
  const chip = start();
  const image = Buffer.concat([shippedImage, Buffer.from("another image")]);
  expect("another product's", update(chip, describe(image, 0x10001, 0x12090002), image), "begin refused");
  expect("too old", update(chip, describe(image, 0xffff), image), "begin refused");
  const wrong = describe(image, 0x10001);
  wrong[20] ^= 1;
  expect("a wrong hash", update(chip, wrong, image), "end refused");
  expect("update", update(chip, describe(image, 0x10001), image), "taken");
  expect("state", state(chip), STATE.ready);
  chip.turn(1, 10);
  expect("it plays on meanwhile", drain(chip)[1], 10);
  expect("restart", command(chip, RESTART), true);
  chip.run(200 * MS);
  expect("starts", chip.boots, 2);
  chip.enumerate();
  expect("slot B is tried", [chip.flash[0x50100], state(chip)], [0, STATE.tries]);
  expect("another update before this one is confirmed", update(chip, describe(shippedImage, 0x10002), shippedImage), "begin refused");
  expect("confirmed", command(chip, KEEP), true);
  expect("state", state(chip), STATE.plays);
  chip.turn(3, 7);
  expect("it turns", drain(chip)[3], 7);
});

test("an image that hangs is tried three times, and then the one before plays again", () => {
  const chip = start();
  const hang = new Uint8Array(64), view = new DataView(hang.buffer);
  view.setUint32(0, 0x20001000, true);
  view.setUint32(4, 0x20000011, true);
  view.setUint16(16, 0xbf30, true);  // WFI
  view.setUint16(18, 0xe7fd, true);  // and again.
  expect("update", update(chip, describe(hang, 0x10001), hang), "taken");
  command(chip, RESTART);
  chip.run(40 * S, () => chip.boots === 5 && chip.connected);
  expect("starts: the first, three tries, and the one before", chip.boots, 5);
  chip.enumerate();
  expect("it plays", [...chip.flash.subarray(0x50100, 0x50104), state(chip)], [0, 0, 0, 0xff, STATE.plays]);
});

test("where the looks stand still the watchdog restarts it, and it comes back", () => {
  const chip = start();
  chip.run(300 * MS);
  expect("starts", chip.boots, 1);
  chip.mcu.ppb.writeUint32(0x10, 0);  // The timer is switched off.
  chip.run(150 * MS);
  expect("starts", chip.boots, 2);
  chip.enumerate();
  chip.turn(0, 3);
  expect("it turns", drain(chip)[0], 3);
});

test("the stick pod's axes, hat and buttons are seen in its reports, and at rest it is silent", () => {
  const pod = new Chip(rp2040js, readFileSync(path.join(images, "stick-pod.bin")));
  pod.codes[3] = 0;
  pod.enumerate();
  expect("device", pod.control(0x80, 6, 0x0100, 0, 64).slice(8, 12), [0x09, 0x12, 2, 0]);
  pod.run(30 * MS);
  while (pod.poll()) pod.run(2 * MS);
  pod.run(50 * MS);
  expect("at rest", pod.poll(), null);
  let last = null;
  const settle = () => {
    for (let n = 0; n < 30; ++n, pod.run(1 * MS)) last = pod.poll() ?? last;
    return [...last];
  };
  pod.codes = [4095, 0, 2047, 4095];
  pod.switches = 0x3001 << 16 >>> 0;  // Button 1, and the hat's upper and right switch; of two registers alone.
  expect("pushed to the right and away", settle(), [0xff, 0x7f, 0x01, 0x80, 0, 0, 0xff, 0xff, 0x11, 0]);
  pod.codes = [2047, 2047, 2047, 0];
  pod.switches = 0;
  expect("let go", settle(), [0, 0, 0, 0, 0, 0, 0, 0, 0x0f, 0]);
});

test("a chip older than B2 refuses to play, and says so by its name, its feature report and its lamps", () => {
  const old = new Chip(rp2040js, shipped, { stepping: "B0" });
  old.enumerate();
  expect("state and stepping of a B0", [state(old), status(old)[28]], [STATE.refuses, 1]);
  const chip = new Chip(rp2040js, shipped, { stepping: "B1" });
  chip.enumerate();
  const name = chip.control(0x80, 6, 0x0302, 0x0409, 255).slice(2).filter((letter) => letter);
  expect("name", String.fromCharCode(...name), "RP2040 older than B2: refused");
  expect("its report descriptor has no input", chip.control(0x81, 6, 0x2200, 0, 1024).slice(0, 5), [0x06, 0, 0xff, 0x09, 0x42]);
  expect("state and stepping of a B1", [state(chip), status(chip)[28]], [STATE.refuses, 2]);
  expect("an update", update(chip, describe(shippedImage, 0x10001), shippedImage), "begin refused");
  chip.push(3);
  chip.turn(1, 40);
  expect("no report", chip.armed["1in"], undefined);
  const seen = new Set();
  for (let n = 0; n < 11; ++n) chip.run(100 * MS), seen.add(chip.lamps);
  expect("lamps in turn", [...seen].sort((one, other) => one - other), [0x55555555, 0xaaaaaaaa]);
  expect("it was not restarted meanwhile", chip.boots, 1);
  command(chip, RESTART);
  chip.run(200 * MS);
  expect("it restarts where it is told to", chip.boots, 2);
  const pod = new Chip(rp2040js, readFileSync(path.join(images, "stick-pod.bin")), { stepping: "B1" });
  pod.enumerate();
  pod.codes = [4095, 0, 0, 4095];
  pod.run(50 * MS);
  expect("a pod", [state(pod), pod.poll()], [STATE.refuses, null]);
  expect("a chip that is fit says what it is", status(start())[28], 3);
});

test("without an image it waits for one on USB", () => {
  const chip = new Chip(rp2040js, shipped.subarray(0, 0x10000));
  chip.run(1 * S, () => chip.inRomLoader);
  expect("in the ROM's loader", chip.inRomLoader, true);
});

console.log(failures === 0 ? "all of the chip's tests passed" : `${failures} expectations of the chip's tests failed`);
process.exit(failures === 0 ? 0 : 1);
