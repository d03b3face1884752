#!/usr/bin/env -S python3 -B
"""Draws a show's first moment on this machine, for an image whose stage is not tried in QEMU: first_picture.py REHEARSAL PACK OUT
Result: OUT/still.ppm, which a box shows on its screens before the stage runs.

REHEARSAL is the program kaori-rehearsal, which plays the whole system without a screen.
"""

import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

SIZE = "960x540"
NOTHING = "at 1s scene end\n"  # A scenario in which nobody does anything.
MARK, EIGHT_BITS, COLOURS, NOT_INTERLACED = b"\x89PNG\r\n\x1a\n", 8, {2: 3, 6: 4}, 0


def chunks(content):
    """(kind, data) of each part of a PNG (W3C's specification, section 5)."""
    at = len(MARK)
    while at < len(content):
        length, kind = struct.unpack(">I4s", content[at:at + 8])
        yield kind, content[at + 8:at + 8 + length]
        at += 12 + length


def nearest(left, above, corner):
    """Paeth's guess: of the three neighbours the one that is next to left + above - corner (section 9.4)."""
    guess = left + above - corner
    return min((left, above, corner), key=lambda value: abs(guess - value))


def unfiltered(kind, line, before, step):
    """A line's bytes from what is stored of them: each was told by its difference to a guess from its neighbours (section 9)."""
    done = bytearray()
    for n, value in enumerate(line):
        left, above = (done[n - step] if n >= step else 0), before[n]
        corner = before[n - step] if n >= step else 0
        done.append((value + (0, left, above, (left + above) // 2, nearest(left, above, corner))[kind]) & 0xFF)
    return done


def as_ppm(content):
    """A PNG of eight bits to the colour as a PPM, without what shines through."""
    parts = list(chunks(content)) if content.startswith(MARK) else []
    if not parts:
        raise ValueError("it is no PNG")
    width, height, bits, colours, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    if (bits, interlaced) != (EIGHT_BITS, NOT_INTERLACED) or colours not in COLOURS:
        raise ValueError("it is a PNG of another kind than kaori-rehearsal writes")
    step = COLOURS[colours]
    stored = zlib.decompress(b"".join(data for kind, data in parts if kind == b"IDAT"))
    length, before, pixels = 1 + width * step, bytearray(width * step), bytearray()
    for at in range(0, length * height, length):
        before = unfiltered(stored[at], stored[at + 1:at + length], before, step)
        for first in range(0, len(before), step):
            pixels += before[first:first + 3]
    return f"P6\n{width} {height}\n255\n".encode() + bytes(pixels)


def main():
    rehearsal, pack, out = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        scenario = Path(folder) / "nothing.play"
        scenario.write_text(NOTHING)
        done = subprocess.run([rehearsal, "--pack", pack, "--play", scenario, "--pictures", folder, "--size", SIZE, "--hz", "10"],
                              capture_output=True, text=True, check=False)
        pictures = sorted(Path(folder).glob("*.png"))
        if done.returncode or not pictures:
            sys.exit(f"image: the show's first moment could not be drawn: {(done.stderr.strip().splitlines() or ['no picture came'])[-1]}")
        (Path(out) / "still.ppm").write_bytes(as_ppm(pictures[0].read_bytes()))


if __name__ == "__main__":
    main()
