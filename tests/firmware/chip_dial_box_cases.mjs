// The dial box as it is shipped: it enumerates, turns, presses and lights its lamps.
import { createHash } from "node:crypto";

import { Chip } from "../../hw-sim/chip/rp2040.mjs";
import {
  BRIGHTNESS, command, doubleSteps, drain, effort, expect, figure, headerText, image, LAMP_TEST, MS, proves, rp2040js, S, shipped,
  shippedPod, start, STATE, state, status, test, u32, US,
} from "./chip_harness.mjs";

test("what is emulated is what is shipped", () => {
  const hash = (bytes) => createHash("sha256").update(bytes).digest("hex");
  const isShipped = (name, flash) => {
    const burnt = new Uint8Array(2 * 1024 * 1024).fill(0xff), uf2 = image(`${name}.uf2`), update = image(`${name}.update`).subarray(44);
    for (let at = 0; at < uf2.length; at += 512)
      burnt.set(uf2.subarray(at + 32, at + 288), uf2.readUInt32LE(at + 12) - 0x10000000);
    const chip = new Chip(rp2040js, flash);
    const same = expect(`flash of the emulator, ${name}`, hash(chip.flash), hash(burnt));
    return expect("the image in the flash", hash(chip.flash.subarray(0x11000, 0x11000 + update.length)), hash(update)) && same;
  };
  const all = [isShipped("dial-box", shipped), isShipped("stick-pod", shippedPod)];
  figure("emulated_is_shipped", all.every((same) => same) ? 1 : 0);
});

test("it enumerates and says who it is", () => {
  const chip = start();
  expect("device", chip.control(0x80, 6, 0x0100, 0, 64), [18, 1, 0, 2, 0, 0, 0, 64, 0x09, 0x12, 1, 0, 1, 1, 1, 2, 3, 1]);
  const text = headerText, begin = text.indexOf("kDialBoxDescriptor");
  const bytes = [...text.slice(begin, text.indexOf("});", begin)).matchAll(/0x([0-9A-F]{2})/g)].map((match) => parseInt(match[1], 16));
  expect("report descriptor", chip.control(0x81, 6, 0x2200, 0, 1024), bytes);
  const serial = chip.control(0x80, 6, 0x0303, 0x0409, 255).slice(2).filter((letter) => letter).map((letter) => String.fromCharCode(letter));
  expect("serial number", serial.join(""), "0102030405060708");
  expect("an unknown request", chip.control(0x80, 6, 0x0600, 0, 10), null);
  expect("the next one", chip.control(0x80, 8, 0, 0, 1), [1]);
  expect("version", status(chip).slice(0, 4), [1, 0, 1, 0]);
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
  const presses = proves ? 1000 * effort : 20;
  for (let n = 0; n < presses; ++n) {
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
  figure("button_presses", presses);
  if (worst > 2500 * US) expect("a press is told within 2.5 ms", worst, "less");
});

test("an edge arms its report in time", () => {
  const chip = start();
  drain(chip);
  let worst = 0;
  const edges = 10_000 * effort;
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
