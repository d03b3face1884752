#!/usr/bin/env -S python3 -B
"""A box whose root was changed does not play it: verity.py IMAGE_FOLDER

One byte is flipped in the root's first block, then in the stage's program; each time the kernel must name the block
and no face may come. The undamaged image is the control: its face must come.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from machine import FACE, Machine

ROOT_STARTS = 65 << 20  # Behind the table and the boot partition.
REFUSED = r"data block \d+ is corrupted"
LONGEST_S = 150


def damaged(image, folder, offset):
    disk = Path(folder) / "damaged.disk"
    subprocess.run(["cp", "--sparse=always", image / "kaori.disk", disk], check=True)
    with open(disk, "r+b") as file:
        file.seek(ROOT_STARTS + offset)
        byte = file.read(1)[0]
        file.seek(ROOT_STARTS + offset)
        file.write(bytes((byte ^ 1,)))
    return disk


def stage_at(image):
    """Where the stage's program lies in the root: its first block is looked for."""
    program = (image / "root/usr/bin/kaori-stage").read_bytes()[:4096]
    return (image / "root.erofs").read_bytes().index(program)


def is_refused(image, offset):
    with tempfile.TemporaryDirectory(dir=image) as folder, Machine(image, damaged(image, folder, offset)) as box:
        refused = box.wait_for(REFUSED, LONGEST_S)
        played = box.wait_for(FACE, 5) if refused else True
        return refused and not played


def main():
    image = Path(sys.argv[1])
    failed = 0
    for name, offset in (("the root's first block", 1024 + 64), ("the stage's program", stage_at(image) + 100)):
        refused = is_refused(image, offset)
        failed += not refused
        print(f"{'ok  ' if refused else 'FAIL'}  a flipped bit in {name} is refused", flush=True)
    with Machine(image) as box:
        plays = box.wait_for(FACE, LONGEST_S)
    print(f"{'ok  ' if plays else 'FAIL'}  the undamaged root plays", flush=True)
    sys.exit(failed + (not plays))


main()
