// The parts of a control surface's board around the emulated chip: flash, shift registers, converter; and what the chip says of its
// own making. Each is wired to an RP2040 that has just been made.

// What a chip says of its making: the register CHIP_ID (2.20.2), and the version of its ROM (2.8.3). The emulator itself says B1.
export const STEPPINGS = {
  B0: { chipId: 0x10002927, rom: 1 }, B1: { chipId: 0x10002927, rom: 2 }, B2: { chipId: 0x20002927, rom: 3 },
};

function wireStepping(chip) {
  const sysinfo = chip.mcu.peripherals[0x40000], read = sysinfo.readUint32.bind(sysinfo);
  sysinfo.readUint32 = (offset) => (offset === 0 ? chip.stepping.chipId : read(offset));
}

// Command 4Bh, by which the flash tells its number: four bytes that count for nothing, and eight.
function wireFlash(chip) {
  const ssi = chip.mcu.peripherals[0x18000];
  const write = ssi.writeUint32.bind(ssi), read = ssi.readUint32.bind(ssi);
  let sent = [];
  ssi.writeUint32 = (offset, value) => {
    if (offset !== 0x60) return write(offset, value);
    if (sent.length === 0 && value !== 0x4b) return write(offset, value);
    sent.push(value);
  };
  ssi.readUint32 = (offset) => {
    if (offset !== 0x60 || sent.length === 0) return read(offset);
    const place = sent.length - 6;
    if (place === 7) sent = [];
    return place >= 0 ? chip.uniqueId[place] : 0;
  };
}

// SPI0 goes through four 74HC595 and back through the 74HC165; GPIO 17 is the strobe of both. What is clocked in behind the
// switches is high, as the input of the first register.
function wireShiftRegisters(chip) {
  let out = 0, sampled = 0;
  const behind = 32 - 8 * chip.registers;
  const open = () => ((~chip.switches << behind) | (2 ** behind - 1)) >>> 0;  // Open lines are high.
  chip.mcu.gpio[17].addListener((state) => {
    if (state === chip.rp2040js.GPIOPinState.Low) sampled = open();
    if (state === chip.rp2040js.GPIOPinState.High) chip.lamps = out;
  });
  chip.mcu.spi[0].onTransmit = (value) => {
    out = ((out << 8) | value) >>> 0;
    const answer = sampled >>> 24;
    sampled = (sampled << 8) >>> 0;
    chip.mcu.spi[0].completeTransmit(answer);
  };
}

// SPI1, selected by GPIO 13: three bytes, of which the first two name the channel, and the last two have its code.
function wireConverter(chip) {
  let asked = [];
  chip.mcu.gpio[13].addListener((state) => {
    if (state === chip.rp2040js.GPIOPinState.Low) asked = [];
  });
  chip.mcu.spi[1].onTransmit = (value) => {
    asked.push(value);
    const code = chip.codes[((asked[0] & 1) << 2) | (asked[1] >> 6)];
    chip.mcu.spi[1].completeTransmit(asked.length === 2 ? code >> 8 : asked.length === 3 ? code & 0xff : 0xff);
  };
}

// `chip` is of the class Chip (rp2040.mjs): its number, switches, lamps and codes are read and written as they are then.
export function wireParts(chip) {
  for (const wire of [wireStepping, wireFlash, wireShiftRegisters, wireConverter]) wire(chip);
}
