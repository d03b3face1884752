// The stick pod as it is shipped: axes, hat and buttons, also by way of the emulator's socket.
import { Chip } from "../../hw-sim/chip/rp2040.mjs";
import { Server } from "../../hw-sim/chip/serve.mjs";
import { expect, i16, MS, rp2040js, shippedPod, start, test } from "./chip_harness.mjs";

test("the stick pod's axes, hat and buttons are seen in its reports, and at rest it is silent", () => {
  const pod = new Chip(rp2040js, shippedPod, { registers: 2 });
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
  pod.switches = 0x3001;  // Button 1, and the hat's upper and right switch.
  expect("pushed to the right and away", settle(), [0xff, 0x7f, 0x01, 0x80, 0, 0, 0xff, 0xff, 0x11, 0]);
  pod.codes = [2047, 2047, 2047, 0];
  pod.switches = 0;
  expect("let go", settle(), [0, 0, 0, 0, 0, 0, 0, 0, 0x0f, 0]);
});

// What the bench's check does with it, by the same frames.
test("by its socket the pod is moved, pushed and polled, and at rest it says nothing", () => {
  const said = [];
  const server = new Server(start(shippedPod, { registers: 2 }), (frame) => said.push([...frame]));
  const send = (kind, ...bytes) => server.accept(Buffer.from([kind.charCodeAt(0), bytes.length, 0, ...bytes]));
  const reports = () => said.splice(0).filter((frame) => frame[0] === "I".charCodeAt(0)).map((frame) => frame.slice(3));
  send("H", 1);
  for (let n = 0; n < 60; ++n) server.play(1 * MS);
  reports();
  for (let n = 0; n < 60; ++n) server.play(1 * MS);
  expect("at rest", reports(), []);
  send("X", 0, 0xff, 0x0f);
  send("X", 1, 0, 0);
  send("P", 3);
  for (let n = 0; n < 40; ++n) server.play(1 * MS);
  const last = reports().at(-1);
  expect("to the right and away, button 4", [i16(last, 0), i16(last, 2), last[8] >> 4, last[9]], [32767, -32767, 8, 0]);
  send("X", 0, 0xff, 0x07);
  send("X", 1, 0xff, 0x07);
  send("R", 3);
  for (let n = 0; n < 40; ++n) server.play(1 * MS);
  expect("let go", reports().at(-1).slice(0, 4), [0, 0, 0, 0]);
});
