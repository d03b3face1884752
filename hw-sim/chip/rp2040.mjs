// A control surface's chip, emulated: the image as it is shipped runs in rp2040js, instruction by instruction. Around it stand
// what the emulator has not: a ROM whose functions work on the flash, the parts of the board (parts.mjs), the operator's
// switches, and a USB host that polls when it likes.
//
//   const chip = new Chip(await import("rp2040js"), flashBytes);
//   chip.enumerate(); chip.turn(0, 64); chip.poll();
//
// Time is the chip's own, in nanoseconds; nothing here waits for a clock on a wall.

import { STEPPINGS, wireParts } from "./parts.mjs";

const RAM_STAGE2 = 0x20041f00;  // Where the ROM copies the first 256 bytes of the flash to (RP2040 datasheet, 2.8.1.3).
const RAM_END = 0x20042000;
const CYCLE_NS = 8;  // 125 MHz.
const SETTLE_NS = 100_000;

// Functions of the ROM that the firmware calls (2.8.3): the code, and the number of its breakpoint.
const ROM_FUNCTIONS = ["IF", "EX", "RE", "RP", "FC", "CX", "UB"];
const ERASE_NS = 45_000_000, PROGRAM_NS = 700_000;  // A sector and a page of a W25Q16, typically.

// CRC-32 as the ROM counts it: highest bit first, begun with ones, not inverted.
export function romChecksum(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte << 24;
    for (let bit = 0; bit < 8; ++bit) sum = sum & 0x80000000 ? (sum << 1) ^ 0x04c11db7 : sum << 1;
  }
  return sum >>> 0;
}

export class Chip {
  constructor(rp2040js, flash, { uniqueId = [1, 2, 3, 4, 5, 6, 7, 8], stepping = "B2", registers = 4 } = {}) {
    this.rp2040js = rp2040js;
    this.flash = new Uint8Array(2 * 1024 * 1024).fill(0xff);
    this.flash.set(flash);
    this.uniqueId = uniqueId;
    this.stepping = STEPPINGS[stepping];
    this.registers = registers;  // 74HC165, each with eight switches.
    this.switches = 0;  // Bit n: switch n is closed.
    this.lamps = 0;     // As the 74HC595 put them out.
    this.codes = new Array(8).fill(2047);  // Of the stick's converter, an MCP3208.
    this.dials = new Int32Array(8);
    this.boots = 0;
    this.flashOperations = 0;
    this.inRomLoader = false;
    this.before = 0;  // Nanoseconds until the last start.
    this.boot();
  }

  get now() {
    return this.before + this.mcu.clock.nanos;
  }

  // Power on, or the watchdog.
  boot() {
    if (this.mcu) this.before = this.now;
    ++this.boots;
    this.mcu = new this.rp2040js.RP2040();
    this.mcu.logger = { debug() {}, info() {}, warn() {}, error: (part, text) => { throw new Error(`${part}: ${text}`); } };
    this.mcu.flash.set(this.flash);
    this.restarts = this.commandMode = false;
    this.busyUntil = 0;
    // It would go off again at the same moment, for ever.
    const watchdog = this.mcu.peripherals[0x40058];
    watchdog.onWatchdogTrigger = () => {
      this.restarts = true;
      watchdog.timer.enable = false;
    };
    this.#makeRom();
    wireParts(this);
    this.#wireUsb();
    this.#showDials();
    const stage2 = this.mcu.flash.slice(0, 256);
    const said = new DataView(stage2.buffer).getUint32(252, true);
    if (romChecksum(stage2.subarray(0, 252)) !== said) throw new Error("the ROM refuses the second stage: its checksum is wrong");
    this.mcu.sram.set(stage2, RAM_STAGE2 - 0x20000000);
    this.mcu.core.SP = RAM_END;
    this.mcu.core.PC = RAM_STAGE2;
  }

  // A table of codes and pointers, and behind each pointer a breakpoint and a return.
  #makeRom() {
    const rom = new DataView(this.mcu.bootrom.buffer);
    const table = 0x100, code = 0x200;
    rom.setUint8(0x13, this.stepping.rom);
    rom.setUint16(0x14, table, true);
    ROM_FUNCTIONS.forEach((name, n) => {
      rom.setUint16(table + 4 * n, name.charCodeAt(0) | (name.charCodeAt(1) << 8), true);
      rom.setUint16(table + 4 * n + 2, (code + 4 * n) | 1, true);
      rom.setUint16(code + 4 * n, 0xbe00 | n, true);      // BKPT n
      rom.setUint16(code + 4 * n + 2, 0x4770, true);      // BX LR
    });
    this.mcu.onBreak = (n) => this.#romCall(ROM_FUNCTIONS[n]);
  }

  #romCall(name) {
    const [at, bytes, count] = this.mcu.core.registers;
    const flash = this.mcu.flash;
    if (name === "IF" || name === "EX") this.commandMode = true;
    if (name === "CX") this.commandMode = false;
    if (name === "UB") this.inRomLoader = true;
    if (name !== "RE" && name !== "RP") return;
    if (!this.commandMode) throw new Error("the flash is written while it is memory");
    ++this.flashOperations;
    if (name === "RE") {
      if (at % 4096 || bytes % 4096) throw new Error(`erasing ${bytes} bytes at ${at} is not whole sectors`);
      flash.fill(0xff, at, at + bytes);
      this.#spend(ERASE_NS * (bytes / 4096));
    } else {
      if (at % 256 || count % 256) throw new Error(`programming ${count} bytes at ${at} is not whole pages`);
      for (let n = 0; n < count; ++n) flash[at + n] &= this.mcu.readUint8(bytes + n);
      this.#spend(PROGRAM_NS * (count / 256));
    }
    this.flash.set(flash.subarray(0, this.flash.length));
  }

  // The core is in the ROM for so long; its interrupts go on.
  #spend(nanos) {
    this.busyUntil = this.mcu.clock.nanos + nanos;
  }

  // Runs until the chip's clock stands at `nanos` or `until` is true; returns whether it was.
  run(nanos, until = () => false) {
    const end = this.now + nanos;
    while (this.now < end) {
      if (until()) return true;
      if (this.restarts) this.boot();
      const { core, clock } = this.mcu;
      for (let n = 0; n < 25 && !this.restarts; ++n) {
        if (core.waiting && !core.interruptsUpdated) {
          const left = end - this.now;
          const next = Math.min(clock.nextAlarm ? clock.nanosToNextAlarm : left, left);
          clock.tick(Math.max(next, 1));
          if (next >= left) break;
        } else {
          clock.tick(core.executeInstruction() * CYCLE_NS);
          // A ROM's function keeps the core, but not the timers.
          while (this.busyUntil > clock.nanos && !this.restarts)
            clock.tick(Math.min(this.busyUntil - clock.nanos, 1_000_000));
        }
        if (this.inRomLoader) return until();
      }
    }
    return until();
  }

  // The operator's side. Clockwise is positive; the angle follows edge by edge, `edgesPerSecond` apart.
  turn(dial, counts, edgesPerSecond = 2000) {
    for (let n = 0; n < Math.abs(counts); ++n) {
      this.dials[dial] += Math.sign(counts);
      this.#showDials();
      this.run(1e9 / edgesPerSecond);
    }
  }
  // Several dials at once, one edge each.
  turnAll(counts, edgesPerSecond) {
    for (let n = 0; n < counts; ++n) {
      for (let dial = 0; dial < 8; ++dial) this.dials[dial] += dial % 2 ? -1 : 1;
      this.#showDials();
      this.run(1e9 / edgesPerSecond);
    }
  }
  #showDials() {
    this.dials.forEach((angle, dial) => {
      const quarter = angle & 3;
      this.mcu.gpio[2 * dial].setInputValue(quarter === 1 || quarter === 2);
      this.mcu.gpio[2 * dial + 1].setInputValue(quarter === 2 || quarter === 3);
    });
  }
  // A channel of the converter, from 0 to 3 of a stick: a code of 12 bits.
  move(axis, code) { this.codes[axis] = Math.min(Math.max(Math.round(code), 0), 4095); }
  push(button) { this.switches = (this.switches | (1 << button)) >>> 0; }
  release(button) { this.switches = (this.switches & ~(1 << button)) >>> 0; }

  // The host's side. The emulator takes a packet the moment it is armed; here it waits until the host polls.
  #wireUsb() {
    const usb = this.mcu.usbCtrl;
    this.armed = {};  // "0in", "0out", "1in", "1out" -> the buffer word.
    this.stalled = {};
    usb.DPRAMUpdated = (offset, word) => {
      if (offset < 0x80 || offset > 0x8c) return;
      const key = `${(offset - 0x80) >> 3}${offset & 4 ? "out" : "in"}`;
      this.stalled[key] = (word & 0x800) !== 0;
      if (word & 0x400) this.armed[key] = { offset, word };
      else delete this.armed[key];
    };
    usb.onUSBEnabled = () => { this.connected = true; };
    this.connected = false;
    this.odd = {};
  }

  #data(endpoint, out) {
    return this.mcu.usbCtrl.getEndpointBufferOffset(endpoint, out);
  }
  #expectToggle(key, word) {
    const odd = (word & 0x2000) !== 0;
    if (odd !== this.odd[key]) throw new Error(`endpoint ${key} has DATA${odd ? 1 : 0}, and the host awaits the other`);
    this.odd[key] = !odd;
  }

  // Fetches a packet that is armed.
  #fetch(endpoint) {
    const key = `${endpoint}in`, { offset, word } = this.armed[key];
    this.#expectToggle(key, word);
    delete this.armed[key];
    const at = this.#data(endpoint, false);
    const packet = this.mcu.usbDPRAM.slice(at, at + (word & 0x3ff));
    this.mcu.usbDPRAMView.setUint32(offset, word & ~0x8400, true);
    this.mcu.usbCtrl.indicateBufferReady(endpoint, false);
    return packet;
  }
  #send(endpoint, packet) {
    const key = `${endpoint}out`, { offset, word } = this.armed[key];
    this.#expectToggle(key, word);
    delete this.armed[key];
    this.mcu.usbDPRAMView.setUint32(offset, word & ~0x400, true);
    this.mcu.usbCtrl.finishRead(endpoint, Uint8Array.from(packet));
  }
  #await(key, nanos = 2_000_000_000) {
    this.run(nanos, () => this.armed[key] !== undefined || this.stalled[key]);
    if (this.stalled[key]) return false;
    if (this.armed[key] === undefined)
      throw new Error(`endpoint ${key} is not armed after ${nanos / 1e6} ms; the chip started ${this.boots} times`);
    return true;
  }

  // A whole control transfer: the answer, empty for one without data, or null where it stalls.
  control(type, request, value, index, length, data = []) {
    const low = (word) => word & 0xff, high = (word) => word >> 8;
    // A SETUP ends a stall of endpoint 0, and the first packets after it are DATA1.
    this.stalled["0in"] = this.stalled["0out"] = false;
    this.odd["0in"] = this.odd["0out"] = true;
    this.mcu.usbCtrl.sendSetupPacket(
      Uint8Array.of(type, request, low(value), high(value), low(index), high(index), low(length), high(length)));
    this.run(2_000_000_000, () => (this.mcu.usbCtrl.sieStatus & (1 << 17)) === 0);
    this.run(SETTLE_NS);  // What the device does with it.
    const answer = this.#stages(type, length, data);
    this.run(SETTLE_NS);
    return answer;
  }
  #stages(type, length, data) {
    const answer = [];
    if (type & 0x80) {
      for (;;) {
        if (!this.#await("0in")) return null;
        const packet = this.#fetch(0);
        answer.push(...packet);
        if (packet.length < 64 || answer.length >= length) break;
      }
      if (!this.#await("0out")) return null;
      this.#send(0, []);
    } else {
      for (let at = 0; at < length; at += 64) {
        if (!this.#await("0out")) return null;
        this.#send(0, data.slice(at, at + 64));
      }
      if (!this.#await("0in")) return null;
      if (this.#fetch(0).length !== 0) throw new Error("the status of a transfer is an empty packet");
    }
    return answer;
  }

  // As a host that finds a device: reset, address, configuration. Throws where it does not connect.
  enumerate() {
    if (!this.run(1_000_000_000, () => this.connected)) throw new Error("the device did not connect within a second");
    this.mcu.usbCtrl.resetDevice();
    this.run(21_000_000);  // The reset takes 10 ms.
    if (this.control(0x00, 5, 7, 0, 0) === null) throw new Error("SET_ADDRESS stalled");
    if (this.control(0x00, 9, 1, 0, 0) === null) throw new Error("SET_CONFIGURATION stalled");
    this.odd["1in"] = this.odd["1out"] = false;
  }
  // One poll of the interrupt endpoint: a report, or null.
  poll() {
    return this.armed["1in"] ? this.#fetch(1) : null;
  }
  // A report to the OUT endpoint.
  output(report) {
    if (!this.#await("1out")) throw new Error("the OUT endpoint is halted");
    this.#send(1, report);
    this.run(SETTLE_NS);
  }
}
