// What a chip starts, and what it refuses: updates, images that hang, the watchdog, chips that are too old.
import { Chip } from "../../hw-sim/chip/rp2040.mjs";
import {
  command, describe, drain, expect, KEEP, MS, RESTART, rp2040js, S, shipped, shippedImage, shippedPod, start, STATE, state, status, test,
  update,
} from "./chip_harness.mjs";

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

test("without an image it waits for one on USB", () => {
  const chip = new Chip(rp2040js, shipped.subarray(0, 0x10000));
  chip.run(1 * S, () => chip.inRomLoader);
  expect("in the ROM's loader", chip.inRomLoader, true);
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
  const pod = new Chip(rp2040js, shippedPod, { stepping: "B1", registers: 2 });
  pod.enumerate();
  pod.codes = [4095, 0, 0, 4095];
  pod.run(50 * MS);
  expect("a pod", [state(pod), pod.poll()], [STATE.refuses, null]);
  expect("a chip that is fit says what it is", status(start())[28], 3);
});
