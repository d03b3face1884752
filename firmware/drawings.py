#!/usr/bin/env python3
"""Draws the surfaces' panels and cases, and lists every pin of their circuits.

Usage: drawings.py DOCS      writes surface_dial_box.svg, surface_stick_pod.svg and surface_nets.md into the folder
       drawings.py --check DOCS     exits 1 where one of them is another

The drawings are to scale, one unit a millimetre: printed at 100 % they are drilling templates. How many dials, buttons and lamps
there are is read from firmware/wire, and which GPIO has which line from the firmware's own table.
"""

import pathlib
import re
import sys

import images

MARGIN = 12.0
DIAL_PITCH = 38.0
SHAFT, KNOB = 9.6, 30.0  # An encoder's bush with its thread; the knob above it.
BUTTON, CAP = 16.2, 18.0  # A push button of 16 mm, and its bezel.
SCREW = 3.2
PLATE = 2.0  # Aluminium.


def svg(width, height, title, parts):
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" viewBox="0 0 {width:g} {height:g}"'
        f' font-family="sans-serif" font-size="4" fill="none" stroke="#000" stroke-width="0.25">',
        f"<title>{title}</title>", '<rect width="100%" height="100%" fill="#fff" stroke="none"/>', *parts, "</svg>", ""])


def hole(x, y, size):
    return (f'<circle cx="{x:g}" cy="{y:g}" r="{size / 2:g}"/>'
            f'<path d="M{x - size / 2 - 1:g} {y:g}h{size + 2:g}M{x:g} {y - size / 2 - 1:g}v{size + 2:g}" stroke-width="0.1"/>')


def around(x, y, size):
    return f'<circle cx="{x:g}" cy="{y:g}" r="{size / 2:g}" stroke="#888" stroke-dasharray="2 1"/>'


def words(x, y, text, anchor="middle"):
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}" fill="#000" stroke="none">{text}</text>'


def plate(x, y, width, height):
    """A plate with a screw in each corner, and its size."""
    screws = [hole(x + dx, y + dy, SCREW) for dx in (6, width - 6) for dy in (6, height - 6)]
    return [f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" rx="3"/>', *screws,
            words(x + width / 2, y - 3, f"{width:g} mm"), words(x - 2, y + height / 2, f"{height:g} mm", "end")]


def case(x, y, depth, back, front, cable):
    """The case from its left side: higher at the back, with the cable's hole in the back wall."""
    return [f'<path d="M{x:g} {y + back:g}v{-back:g}l{depth:g} {back - front:g}v{front:g}z"/>',
            f'<path d="M{x:g} {y + PLATE:g}l{depth:g} {back - front:g}"/>',
            f'<path d="M{x - 2:g} {y + back - 12 - cable / 2:g}h4v{cable:g}h-4z"/>',
            words(x - 4, y + back - 11, f"cable, {cable:g}", "end"), words(x - 4, y + 4, f"{back:g} mm", "end"),
            words(x + depth + 2, y + back - front / 2, f"{front:g} mm", "start"),
            words(x + depth / 2, y + back + 6, f"{depth:g} mm deep; aluminium of {PLATE:g} mm above, the circuit on the floor")]


def dial_box():
    wire = images.constants("wire/dial_box.h")
    dials, buttons = wire["kDials"], wire["kDialBoxButtons"]
    columns = dials
    rows = -(-buttons // columns)
    width = columns * DIAL_PITCH + 2 * MARGIN
    height = 52 + rows * 30 + 2 * MARGIN
    left, top = 24.0, 12.0
    parts = plate(left, top, width, height)
    for n in range(dials):
        x, y = left + MARGIN + DIAL_PITCH * (n + 0.5), top + MARGIN + 22
        parts += [hole(x, y, SHAFT), around(x, y, KNOB), words(x, y + 22, f"dial {n + 1}")]
    for n in range(buttons):
        x = left + MARGIN + DIAL_PITCH * (n % columns + 0.5)
        y = top + MARGIN + 52 + 30 * (n // columns) + 12
        parts += [hole(x, y, BUTTON), around(x, y, CAP), words(x, y + 14.5, f"{n + 1}")]
    parts += case(left + 20, top + height + 14, height, 70, 45, 12)
    return svg(left + width + 16, top + height + 100, f"The dial and button box: {dials} dials, {buttons} buttons", parts)


def stick_pod():
    buttons = images.constants("wire/stick_pod.h")["kStickPodButtons"]
    left, top, width, height = 24.0, 12.0, 160.0, 220.0
    x, y = left + 80, top + 62
    parts = plate(left, top, width, height)
    parts += [hole(x, y, 62), around(x, y, 78), words(x, y + 46, "stick with twist, and the hat on its grip"),
              *(hole(x + dx, y + dy, 4.2) for dx in (-30, 30) for dy in (-30, 30)),
              f'<rect x="{left + 140:g}" y="{top + 28:g}" width="3" height="66"/>', words(left + 141.5, top + 102, "slider"),
              hole(left + 141.5, top + 21, SCREW), hole(left + 141.5, top + 108.5, SCREW)]
    for n in range(buttons):
        bx, by = left + 29 + 34 * (n % 4), top + 134 + 30 * (n // 4)
        parts += [hole(bx, by, BUTTON), around(bx, by, CAP), words(bx, by + 14.5, f"{n + 1}")]
    parts += case(left + 20, top + height + 14, height, 80, 60, 12)
    return svg(left + width + 90, top + height + 110, f"The stick pod: a stick, a slider, {buttons} buttons", parts)


# Pins of the parts, from 1 on, by their makers' data sheets.
HC165 = ["SH/LD", "CLK", "E", "F", "G", "H", "/QH", "GND", "QH", "SER", "A", "B", "C", "D", "CLK INH", "VCC"]
HC595 = ["QB", "QC", "QD", "QE", "QF", "QG", "QH", "GND", "QH'", "SRCLR", "SRCLK", "RCLK", "OE", "SER", "QA", "VCC"]
MCP3208 = ["CH0", "CH1", "CH2", "CH3", "CH4", "CH5", "CH6", "CH7", "DGND", "CS", "DIN", "DOUT", "CLK", "AGND", "VREF", "VDD"]
SUPPLY = {"GND": "ground", "DGND": "ground", "AGND": "ground", "VCC": "3.3 V", "VDD": "3.3 V", "VREF": "3.3 V",
          "OE": "ground", "SRCLR": "3.3 V", "CLK INH": "ground", "/QH": "open"}


def gpio_of(product):
    """The lines of a product as {line: "GPIO n"}, of the firmware's own table."""
    rows = re.findall(r"^\| (\d+) \| ([^|]+) \|", images.pins(product), re.M)
    return {line: f"GPIO {gpio}" for gpio, line in rows}


def part(name, kind, pins, nets):
    rows = [f"{number} {pin}: {nets.get(pin) or SUPPLY.get(pin) or 'open'}" for number, pin in enumerate(pins, 1)]
    return f"| {name} | {kind} | {'; '.join(rows)} |"


def switches(number, last, contacts, gpio):
    """A 74HC165 of a chain of `last`: number 1 is the farthest from the chip."""
    return part(f"U{number}", "74HC165", HC165, {
        **{"ABCDEFGH"[n]: f"{what} (to ground), and 10 kOhm to 3.3 V" for n, what in enumerate(contacts)},
        "SH/LD": gpio["strobe"], "CLK": gpio["clock"], "SER": "3.3 V" if number == 1 else f"U{number - 1} QH",
        "QH": gpio.get("buttons in") or gpio["switches in"] if number == last else f"U{number + 1} SER"})


def nets():
    wire = images.constants("wire/dial_box.h")
    chips = wire["kDialBoxButtons"] // 8
    box, pod = gpio_of("dial-box"), gpio_of("stick-pod")
    head = ["| part | kind | pin by pin |", "| --- | --- | --- |"]
    rows = list(head)
    for chip in range(1, chips + 1):
        rows.append(switches(chip, chips, [f"button {8 * (chip - 1) + n + 1}" for n in range(8)], box))
    for chip in range(chips + 1, 2 * chips + 1):
        first = 8 * (chip - chips - 1) + 1
        rows.append(part(f"U{chip}", "74HC595", HC595, {
            **{f"Q{'ABCDEFGH'[n]}": f"270 Ohm, lamp {first + n}, ground" for n in range(8)},
            "SRCLK": box["clock"], "RCLK": box["strobe"], "SER": box["lamps out"] if chip == chips + 1 else f"U{chip - 1} QH'",
            "QH'": "open" if chip == 2 * chips else f"U{chip + 1} SER"}))
    encoders = [f"| encoder {n + 1} | optical, 64 lines | A: {box[f'dial {n + 1} A']}; B: {box[f'dial {n + 1} B']}; supply: 5 V of the "
                f"cable; ground |" for n in range(wire["kDials"])]
    pod_rows = head + [
        switches(1, 2, [f"button {n + 1}" for n in range(8)], pod),
        switches(2, 2, [f"button {n}" for n in range(9, 13)] + [f"hat {way}" for way in ("up", "right", "down", "left")], pod),
        part("U3", "MCP3208", MCP3208, {
            **{f"CH{n}": f"wiper of {what}, and 100 nF to ground" for n, what in
               enumerate(("X (to the right)", "Y (towards the operator)", "twist (clockwise)", "the slider (upwards)"))},
            **{f"CH{n}": "ground" for n in range(4, 8)},
            "CS": pod["converter select"], "DIN": pod["converter in"], "DOUT": pod["converter out"], "CLK": pod["converter clock"]})]
    return "\n".join([
        "# Circuits of the surfaces, pin by pin", "",
        "Made by `firmware/drawings.py` of the firmware's own tables. Every part has 100 nF between its supply and ground. The board is"
        " one with an RP2040 of stepping B2 or later and 2 MB of flash; its 3.3 V feeds the parts, the 5 V of the cable the encoders."
        " What an encoder drives above 3.3 V needs a divider or a buffer.", "",
        "## Dial and button box", "", *rows, *encoders, "", "![Panel and case](surface_dial_box.svg)", "",
        "## Stick pod", "", *pod_rows, "", "![Panel and case](surface_stick_pod.svg)", "",
        "The drawings are to scale: printed at 100 % they are drilling templates. Holes are drawn full, knobs and bezels dashed.", ""])


def main():
    check = sys.argv[1] == "--check"
    docs = pathlib.Path(sys.argv[-1])
    faults = 0
    for name, make in {"surface_dial_box.svg": dial_box, "surface_stick_pod.svg": stick_pod, "surface_nets.md": nets}.items():
        if not check:
            (docs / name).write_text(make(), encoding="utf-8")
        elif (docs / name).read_text(encoding="utf-8") != make():
            print(f"{docs / name} is not what firmware/drawings.py makes; run: firmware/drawings.py docs")
            faults += 1
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
