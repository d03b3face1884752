#!/usr/bin/env python3
"""Builds the firmware for the chip, brings the emulator, and runs chip_test.mjs.

Usage: chip.py ROOT FOLDER     FOLDER is for what is built. Exits 77, which ctest calls a skip, where a tool is missing; says which.
"""

import pathlib
import shutil
import subprocess
import sys

SKIP = 77
RP2040JS = "rp2040js@1.4.1"
TOOLS = {"arm-none-eabi-g++": "gcc-arm-none-eabi", "ninja": "ninja-build", "node": "nodejs", "npm": "npm"}


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIP)


def main():
    root, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    for tool, package in TOOLS.items():
        if not shutil.which(tool):
            skip(f"there is no {tool}; the package {package} has it")
    if not pathlib.Path("/usr/include/newlib/c++").exists():
        skip("there are no headers of C++ for the chip; the package libstdc++-arm-none-eabi-dev has them")
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["cmake", "-S", root / "firmware/board", "-B", folder / "build", "-G", "Ninja"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "--quiet", "-C", folder / "build"], check=True)
    subprocess.run([sys.executable, "-B", root / "firmware/images.py", folder / "build", folder], check=True)
    package = folder / "node_modules/rp2040js"
    if not package.exists():
        # A package.json of its own, or npm would look for one further up.
        (folder / "package.json").write_text('{"private": true}\n', encoding="utf-8")
        brought = subprocess.run(["npm", "install", "--no-audit", "--no-fund", RP2040JS], cwd=folder, capture_output=True, text=True,
                                 check=False)
        if brought.returncode != 0:
            skip(f"npm could not bring {RP2040JS}: {brought.stderr.strip().splitlines()[-1:]}")
    return subprocess.run(["node", root / "tests/firmware/chip_test.mjs", package, folder, root / "firmware/wire/dial_box.h"],
                          check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
