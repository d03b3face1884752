#!/usr/bin/env python3
"""Writes what builds for other machines came to: cross_report.py ROOT BUILD TESTS.xml NODE_MODULES FILE.json

  programs_arm64      programs of the box and its tools in BUILD that are for 64-bit ARM
  programs_all        those that there should be
  tests_arm64         tests that ran in QEMU's user mode (TESTS.xml, of ctest)
  tests_arm64_failed  those of them that failed
  sdk_cases           cases of tests/rootfs/sdk_test.py, with Debian's cross compiler in the SDK's place
  sdk_cases_failed
  recipe_errors       what tests/rootfs/layer.py finds, grammar and kas's schema included
  boots_arm64         1: the image's disk starts by UEFI in QEMU's virt, and the face moves; 0: it does not
  face_arm64          1: the face is on the screen of a box whose kernel QEMU loads; 0: it is not
  first_face_arm64_s  from power to the first frames there, emulated
  checks_arm64        checks of the bench that passed on that image
  checks_arm64_failed
  image_no_llvm_mb    the image for a board with a driver of its own, compressed, without LLVM and without the kernel
  image_no_llvm_parts_mb  the same by part, each compressed by itself, with the kernel

What nobody measured is null: the last two where ./box image --board rpi4 did not run (image-rpi4.json beside FILE.json); those before
where ./box test --bench --arch arm64 did not run (bench-arm64/report.xml and boot-arm64.json there); the tests where TESTS.xml is not
there.
"""

import json
import re
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

import layer

PROGRAMS = ("kaori-boot", "kaori-data", "kaori-fdkeeper", "kaori-input", "kaori-lips", "kaori-power", "kaori-report", "kaori-shows", "kaori-stage",
            "kaori-surface", "kaori-update", "kaori-usb", "kaori-desk", "kaori-status", "kaori-atelier", "kaori-sim", "kaori-rehearsal",
            "kaori-evening", "kaori-bench", "kaori-gadget")
AARCH64 = 183  # e_machine of an ELF file.


def is_arm64(program):
    return program.is_file() and int.from_bytes(program.read_bytes()[18:20], "little") == AARCH64


def sdk_cases(root, sysroot):
    """(cases, failed ones)."""
    done = subprocess.run([sys.executable, "-B", root / "tests/rootfs/sdk_test.py", root, root / "out/build/release/bin", "--cross", sysroot],
                          capture_output=True, text=True, check=False)
    cases = int(re.search(r"Ran (\d+) test", done.stderr)[1])
    failed = sum(int(number) for number in re.findall(r"(?:failures|errors)=(\d+)", done.stderr))
    if failed:
        print(done.stderr)
    return cases, failed


def of_the_bench(out):
    """What ./box test --bench --arch arm64 left in the folder `out`; null where it did not run."""
    report, figures = out / "bench-arm64/report.xml", out / "boot-arm64.json"
    passed = None
    if report.is_file():
        cases = xml.etree.ElementTree.parse(report).getroot().iter("testcase")
        passed = {case.get("name").split(":")[0]: case.find("failure") is None for case in cases if case.find("skipped") is None}
    measured = json.loads(figures.read_text()) if figures.is_file() else {}

    def verdict(check):
        return None if passed is None or check not in passed else int(passed[check])

    return {"boots_arm64": verdict("uefi"), "face_arm64": verdict("face"), "first_face_arm64_s": measured.get("first_frames_s"),
            "checks_arm64": None if passed is None else sum(passed.values()),
            "checks_arm64_failed": None if passed is None else len(passed) - sum(passed.values())}


def of_boards(out):
    """What the builder of images wrote down of one for a board in the folder `out`; null where none was built."""
    report = out / "image-rpi4.json"
    measured = json.loads(report.read_text()) if report.is_file() else {}
    return {"image_no_llvm_mb": measured.get("image_no_llvm_mb"), "image_no_llvm_parts_mb": measured.get("compressed_parts_mb")}


def of_tests(file):
    """Of the unit tests in user-mode emulation; null where they did not run."""
    ran = xml.etree.ElementTree.parse(file).getroot() if file.is_file() else {}
    return {name: int(ran.get(key)) if ran.get(key) else None for name, key in (("tests_arm64", "tests"), ("tests_arm64_failed", "failures"))}


def main():
    root, build, tests, modules, file = (Path(word).resolve() for word in sys.argv[1:6])
    cases, failed = sdk_cases(root, root / "out/cross/arm64/sysroot")
    recipe = list(layer.offences(root, root / "out/build/release", modules))
    print("\n".join(recipe))
    figures = {
        "programs_arm64": sum(is_arm64(build / f"bin/{name}") for name in PROGRAMS), "programs_all": len(PROGRAMS),
        **of_tests(tests),
        "sdk_cases": cases, "sdk_cases_failed": failed, "recipe_errors": len(recipe),
        **of_the_bench(file.parent),
        **of_boards(file.parent),
    }
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(figures, indent=2) + "\n")
    print("\n".join(f"{name:20} {value}" for name, value in figures.items()))
    return 1 if failed or recipe or figures["programs_arm64"] < len(PROGRAMS) else 0


if __name__ == "__main__":
    sys.exit(main())
