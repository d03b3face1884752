#!/usr/bin/env python3
"""Builds the firmware for the chip, and proves it without one.

Usage: chip.py ROOT FOLDER emulator     brings rp2040js, and runs chip_test.mjs over the image as it is shipped
       chip.py ROOT FOLDER bring        lays the shipped images and rp2040js into FOLDER, for kaori-bench --chip
       chip.py ROOT FOLDER qemu         runs the proofs of the core on the Cortex-M0 and the Cortex-M3 of QEMU

FOLDER is for what is built. Exits 77, which ctest calls a skip, where a tool is missing; says which.
"""

import pathlib
import shutil
import subprocess
import sys

SKIP = 77
RP2040JS = "rp2040js@1.4.1"
BUILDING = {"arm-none-eabi-g++": "gcc-arm-none-eabi", "ninja": "ninja-build"}
TOOLS = {"emulator": {"node": "nodejs", "npm": "npm"}, "bring": {"node": "nodejs", "npm": "npm"}, "qemu": {"qemu-system-arm": "qemu-system-arm"}}
MACHINES = ("microbit", "mps2-an385")  # A Cortex-M0, and an M3.


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIP)


def build(root, folder, *targets):
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["cmake", "-S", root / "firmware/board", "-B", folder / "build", "-G", "Ninja"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "--quiet", "-C", folder / "build", *targets], check=True)


def bring_emulator(folder):
    package = folder / "node_modules/rp2040js"
    if not package.exists():
        # A package.json of its own, or npm would look for one further up.
        (folder / "package.json").write_text('{"private": true}\n', encoding="utf-8")
        brought = subprocess.run(["npm", "install", "--no-audit", "--no-fund", RP2040JS], cwd=folder, capture_output=True,
                                 text=True, check=False)
        if brought.returncode != 0:
            skip(f"npm could not bring {RP2040JS}: {' '.join(brought.stderr.split())[-200:]}")
    return package


def bring(root, folder):
    """Makes the images, and returns the emulator's folder."""
    build(root, folder)
    subprocess.run([sys.executable, "-B", root / "firmware/images.py", folder / "build", folder], check=True)
    return bring_emulator(folder)


def emulate(root, folder):
    package = bring(root, folder)
    return subprocess.run(["node", root / "tests/firmware/chip_test.mjs", package, folder, root / "firmware/wire/dial_box.h"],
                          check=False).returncode


def prove_in_qemu(root, folder):
    build(root, folder, "proofs")
    for machine in MACHINES:
        print(f"{machine}:", flush=True)
        done = subprocess.run(["qemu-system-arm", "-M", machine, "-nographic", "-monitor", "none", "-serial", "none",
                               "-semihosting-config", "enable=on,target=native", "-kernel", folder / "build/proofs.elf"],
                              timeout=300, check=False)
        if done.returncode != 0:
            return done.returncode
    return 0


def main():
    root, folder, what = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
    for tool, package in {**BUILDING, **TOOLS[what]}.items():
        if not shutil.which(tool):
            skip(f"there is no {tool}; the package {package} has it")
    if not pathlib.Path("/usr/include/newlib/c++").exists():
        skip("there are no headers of C++ for the chip; the package libstdc++-arm-none-eabi-dev has them")
    if what == "bring":
        bring(root, folder)
        return 0
    return emulate(root, folder) if what == "emulator" else prove_in_qemu(root, folder)


if __name__ == "__main__":
    sys.exit(main())
