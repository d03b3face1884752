#!/usr/bin/env -S python3 -B
"""The boards that images are built for by their own name, since no UEFI starts them: boards.py NAME FIELD prints one value for shell
scripts; boards.py NAME firmware FOLDER says whether the folder has the firmware's files.

Another board is another row here, its settings of the kernel in kernel/NAME.config, and its files of Debian's in keep-NAME.txt. What its
firmware wants on the disk is laid out by a file of its own (pi_boot.py).
"""

import sys
from pathlib import Path
from typing import NamedTuple


class Board(NamedTuple):
    """One kind of board."""

    name: str
    what: str  # As people call it.
    arch: str  # Of architectures.py.
    drivers: str  # Mesa's Gallium drivers, with commas; swrast draws by the processor where its own does not come up.
    opened: str  # The driver that the stage opens, below the folder of libraries.
    command_line: str  # Of the kernel, besides what all images have.
    device_tree: str  # In the kernel's source, below arch/.../boot/dts.
    firmware: tuple  # Files of the maker's without which it does not start.
    licence: str  # Of these files, beside them.
    source: str  # Where people get them.


NAMED = {row.name: row for row in (
    # Its device tree keeps 64 MB for pictures, of which a screen of 3840 x 2160 needs three of 33 and textures besides.
    Board("rpi4", "Raspberry Pi 4", "arm64", "v3d,vc4,swrast", "dri/vc4_dri.so", "cma=256M", "broadcom/bcm2711-rpi-4-b.dtb",
          ("start4.elf", "fixup4.dat"), "LICENCE.broadcom", "the folder boot of https://github.com/raspberrypi/firmware"),
)}


def firmware_fault(board, folder):
    """Why a board cannot be started by the files in this folder, in one line; None where it can."""
    why = f"the {board.what} starts by files of its maker's, {' and '.join(board.firmware)}, which are not ours and go on no image " \
          f"without --board-firmware: take {board.source}, and read its licence {board.licence}"
    if not folder:
        return f"--board {board.name} wants --board-firmware FOLDER; {why}"
    if not Path(folder).is_dir():
        return f"there is no folder {folder}; {why}"
    lacking = [name for name in (*board.firmware, board.licence) if not (Path(folder) / name).is_file()]
    if lacking:
        return f"{folder} has no {lacking[0]}; {why}"
    empty = [name for name in board.firmware if not (Path(folder) / name).stat().st_size]
    return f"{folder}/{empty[0]} is empty; {why}" if empty else None


def main():
    name, field, *folder = sys.argv[1:]
    if name not in NAMED:
        sys.exit(f"image: there is no board {name}; expected {' or '.join(NAMED)}")
    if folder:
        fault = firmware_fault(NAMED[name], folder[0])
        sys.exit(f"image: {fault}" if fault else 0)
    print(getattr(NAMED[name], field))


if __name__ == "__main__":
    main()
