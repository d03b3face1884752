#!/usr/bin/env python3
"""Builds the surface's core with one thing wrong at a time, and expects the proofs to say so.

Usage: controls.py ROOT COMPILER FOLDER     exits 1 when a wrong build passes, or the right one does not.

The number of wrong builds that passed is appended as "controls_passed N" to the file that KAORI_FIRMWARE_FIGURES names.
"""

import os
import pathlib
import shutil
import subprocess
import sys

SURFACE = "firmware/surface"
# (what is wrong, file, what stands there, what stands there then)
CONTROLS = (
    ("one sign of the dials' table", "dials.cpp", "{-1, 0, kDouble, +1}", "{-1, 0, kDouble, -1}"),
    ("double steps are guessed", "dials.cpp", "Add(double_steps_, 1);", "Add(dials_[dial].position, 2);"),
    ("released after no look", "buttons.h", "kLooksToRelease = 20", "kLooksToRelease = 1"),
    ("pressed after one look", "buttons.h", "kLooksToPress = 3", "kLooksToPress = 1"),
    ("an edge that waits is wiped out", "button_log.cpp", "if (again && hosted", "if (!again && hosted"),
    ("a turn is told twice", "dial_box.cpp", "told_[n] += static_cast<std::uint32_t>(turned);", ""),
    ("no rest in the middle of an axis", "axis.cpp", "if (beyond <= 0) return 0;", ""),
    ("an axis beyond its ends", "axis.cpp", "(away < 0 ? -away : away) - rest, way - rest)", "(away < 0 ? -away : away) - rest, 2 * way)"),
    ("no hash of the image", "slots.cpp", "return Sha256Of(Image(flash, slot, image)) == image.sha256;", "return true;"),
    ("no check of the header", "slots.cpp", "return std::nullopt;\n  const SlotHeader", "(void)0;\n  const SlotHeader"),
    ("one copy of what is stored", "flash_store.cpp", "CopyAt(last ? 1 - newer : 0)", "CopyAt(newer)"),
    ("no check of what is stored", "flash_store.cpp", "std::span(check).first(kTailBytes)))\n    return std::nullopt;",
     "std::span(check).first(kTailBytes)))\n    (void)0;"),
    ("a spike of the converter passes", "axis.cpp", "std::uint32_t{Median(sums_[0], sums_[1], sums_[2])}", "std::uint32_t{sums_[2]}"),
    ("a tremble is a movement", "axis.cpp", "kLeastFromRest = 20", "kLeastFromRest = 8"),
    ("a slow turn goes by coarse steps", "axis.cpp", "kLeastMove = 4", "kLeastMove = 20"),
    ("the first look counts", "dials.cpp", "    before_ = lines;\n    looked_ = true;", "    looked_ = true;"),
    ("data of an update out of order", "updater.cpp", "|| offset != taken_) return false", ") return false"),
    ("an image is taken without its hash", "updater.cpp", "  if (!HasItsHash(flash_, slot, image_)) return false;\n", ""),
    ("an image that nobody confirmed erases the one before", "updater.cpp", "if (!IsKept(flash_, running_.slot)) return false;", ""),
    ("a try is not written down", "slots.cpp", "      Clear(flash, one.slot, used);\n", ""),
    ("an update goes into the slot that runs", "updater.cpp", "flash_.Erase(At(Other(running_.slot)))", "flash_.Erase(At(running_.slot))"),
)
FLAGS = ("-std=c++20", "-O1", "-w")


def proofs_pass(root, compiler, folder, wrong=None):
    """Whether the proofs pass over a copy of the core in which one thing was made wrong."""
    copy = folder / SURFACE
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(root / SURFACE, copy)
    if wrong:
        what, name, before, after = wrong
        text = (copy / name).read_text(encoding="utf-8")
        if text.count(before) != 1:
            sys.exit(f"{what}: {name} has {text.count(before)} places to make wrong, and should have one: {before}")
        (copy / name).write_text(text.replace(before, after), encoding="utf-8")
    # All in one unit: it compiles in a second or two.
    sources = [*sorted(copy.glob("*.cpp")), *sorted((root / "tests/firmware/proof").glob("*.cpp"))]
    unit, program = folder / "all.cpp", folder / "proofs"
    unit.write_text("".join(f'#include "{source}"\n' for source in sources), encoding="utf-8")
    subprocess.run([compiler, *FLAGS, f"-I{folder}", f"-I{root}", unit, "-o", program], check=True)
    done = subprocess.run([program], capture_output=True, text=True, timeout=60, check=False)
    print(f"{wrong[0] if wrong else 'nothing is wrong'}: {done.stdout.strip() or f'it crashed ({done.returncode})'}")
    return done.returncode == 0


def main():
    root, compiler, folder = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], pathlib.Path(sys.argv[3])
    if not proofs_pass(root, compiler, folder):
        sys.exit("the proofs fail where nothing is wrong")
    passed = [wrong[0] for wrong in CONTROLS if proofs_pass(root, compiler, folder, wrong)]
    if figures := os.environ.get("KAORI_FIRMWARE_FIGURES"):
        with open(figures, "a", encoding="utf-8") as file:
            file.write(f"controls_passed {len(passed)}\n")
    for what in passed:
        print(f"nobody noticed: {what}")
    return 1 if passed else 0


if __name__ == "__main__":
    sys.exit(main())
