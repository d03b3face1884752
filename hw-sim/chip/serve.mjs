// The emulated chip behind a socket: a USB device at the end of a cable, and an operator's hand on its dials, axes and buttons.
//
// Usage: node serve.mjs RP2040JS IMAGE SOCKET [REGISTERS]     RP2040JS is the package's folder, IMAGE the flash as it is shipped; listens
//                                                 at SOCKET for one peer (chip_usb.cpp), and ends with it. REGISTERS is how many
//                                                 74HC165 the surface has: 4 of a dial box, which is meant without it, 2 of a pod
//
// Each frame is a kind, its length in two bytes, the low one first, and so many bytes:
//   to the chip    B power goes and comes     S a setup of 8 bytes, and data        O a report to its OUT endpoint
//                  H 1: a host listens; 0     T dial, counts (i32), edges a second (u32)     P, R push and release a button
//                  X axis, code of 12 bits (u16)
//   from the chip  A 1 and an answer, or 0: it stalls     I a report     L lamps (u32), starts that nobody asked for (u32)
//
// The chip's time is that of the wall, or slower where this computer does not keep up.
import { readFileSync } from "node:fs";
import net from "node:net";
import path from "node:path";
import process from "node:process";
import { performance } from "node:perf_hooks";
import { pathToFileURL } from "node:url";

import { Chip } from "./rp2040.mjs";

const MS = 1e6;
const SLICE_NS = 1 * MS;            // Then frames are read again.
const POLL_NS = 1 * MS;             // As the endpoint's interval asks for.
const MOST_BEHIND_NS = 50 * MS;     // What is further behind the wall is given up.

export class Server {
  #waiting = Buffer.alloc(0);
  #listens = false;
  #polled = 0;
  #told = "";
  #asked = 1;  // Starts: the first, and each B.

  // `send` takes whole frames.
  constructor(chip, send) {
    this.chip = chip;
    this.send = send;
  }

  // Bytes as they came.
  accept(bytes) {
    this.#waiting = Buffer.concat([this.#waiting, bytes]);
    while (this.#waiting.length >= 3 && this.#waiting.length >= 3 + this.#waiting.readUInt16LE(1)) {
      const end = 3 + this.#waiting.readUInt16LE(1), frame = this.#waiting.subarray(0, end);
      this.#waiting = this.#waiting.subarray(end);
      this.#obey(String.fromCharCode(frame[0]), frame.subarray(3));
    }
  }

  // The chip plays for so long.
  play(nanos) {
    this.chip.run(nanos);
    this.#look();
  }

  #obey(kind, data) {
    const { chip } = this;
    if (kind === "B") {
      chip.boot();
      ++this.#asked;
      this.#listens = false;
      chip.enumerate();
    } else if (kind === "S") {
      const setup = [data[0], data[1], data.readUInt16LE(2), data.readUInt16LE(4), data.readUInt16LE(6)];
      const answer = chip.control(...setup, [...data.subarray(8)]);
      this.#say("A", answer === null ? [0] : [1, ...answer]);
    } else if (kind === "O") {
      chip.output([...data]);
    } else if (kind === "H") {
      this.#listens = data[0] === 1;
    } else if (kind === "T") {
      const counts = data.readInt32LE(1), rate = data.readUInt32LE(5);
      for (let n = 0; n < Math.abs(counts); ++n) {
        chip.turn(data[0], Math.sign(counts), rate);
        this.#look();
      }
    } else if (kind === "X") {
      chip.move(data[0], data.readUInt16LE(1));
    } else if (kind === "P") {
      chip.push(data[0]);
    } else if (kind === "R") {
      chip.release(data[0]);
    } else {
      throw new Error(`nobody knows a frame of the kind ${kind}`);
    }
    this.#look();
  }

  // A poll that is due, and lamps that changed.
  #look() {
    const { chip } = this;
    if (this.#listens && chip.now - this.#polled >= POLL_NS) {
      this.#polled = chip.now;
      const report = chip.poll();
      if (report) this.#say("I", report);
    }
    const words = Buffer.alloc(8);
    words.writeUInt32LE(chip.lamps, 0);
    words.writeUInt32LE(chip.boots - this.#asked, 4);
    if (words.toString("hex") === this.#told) return;
    this.#told = words.toString("hex");
    this.#say("L", words);
  }

  #say(kind, bytes) {
    const head = Buffer.alloc(3);
    head.write(kind, "latin1");
    head.writeUInt16LE(bytes.length, 1);
    this.send(Buffer.concat([head, Buffer.from(bytes)]));
  }
}

// Until the peer goes.
function attend(server, socket) {
  socket.on("data", (bytes) => server.accept(bytes));
  socket.on("close", () => process.exit(0));
  socket.on("error", () => process.exit(0));
  const { chip } = server;
  let ahead = chip.now - performance.now() * MS;
  const turn = () => {
    const behind = performance.now() * MS + ahead - chip.now;
    if (behind > MOST_BEHIND_NS) ahead -= behind - MOST_BEHIND_NS;
    if (behind > 0) server.play(SLICE_NS);
    setTimeout(turn, behind > SLICE_NS ? 0 : 1);
  };
  turn();
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [folder, image, place, registers = "4"] = process.argv.slice(2);
  const rp2040js = await import(pathToFileURL(path.join(folder, "dist/esm/index.js")));
  const chip = new Chip(rp2040js, readFileSync(image), { registers: Number(registers) });
  chip.enumerate();
  const listener = net.createServer((socket) => {
    listener.close();
    attend(new Server(chip, (frame) => socket.write(frame)), socket);
  });
  listener.listen(place);
}
