#!/usr/bin/env python3
"""Writes what builds for other machines came to: cross_report.py ROOT BUILD TESTS.xml NODE_MODULES FILE.json [--whole]

  programs_arm64      programs in BUILD that are for 64-bit ARM
  programs_all        those that there should be: every kaori_program of the tree's CMakeLists.txt
  tests_arm64         tests that ran in QEMU's user mode (TESTS.xml, of ctest)
  tests_arm64_failed  those of them that failed
  sdk_cases           cases of tests/rootfs/sdk_test.py, with Debian's cross compiler in the SDK's place
  sdk_cases_failed
  recipe_errors       what tests/rootfs/layer.py finds, grammar and kas's schema included
  boots_arm64         1: the image's disk starts by UEFI in QEMU's virt, and the face moves; 0: it does not
  face_arm64          1: the face is on the screen of a box whose kernel QEMU loads; 0: it is not
  first_face_arm64_s  from power to the first frames there, emulated
  dial_edges_arm64    edges of dials on the machine's own GPIO controller there, each counted once
  checks_arm64        checks of the bench that passed on that image
  checks_arm64_failed
  image_no_llvm_mb    the image for a board with a driver of its own, compressed, without LLVM and without the kernel: the goal is 20
  image_no_llvm_parts_mb  the same by part, each compressed by itself, with the kernel

What nobody measured is null: the last two where ./box image --board rpi4 did not run (image-rpi4.json beside FILE.json); those before
where ./box test --bench --arch arm64 did not run (bench-arm64/report.xml and boot-arm64.json there); the tests where TESTS.xml is not
there. Ends with 1 where a figure is out of its bounds or one of this run's own is null; with --whole, where any is.
"""

import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import bounded_report
import layer

# The least and the most of each; all programs are to be there.
BOUNDS = {"programs_arm64": (1, math.inf), "tests_arm64": (1, math.inf), "tests_arm64_failed": (0, 0), "sdk_cases": (1, math.inf),
          "sdk_cases_failed": (0, 0), "recipe_errors": (0, 0), "boots_arm64": (1, 1), "face_arm64": (1, 1),
          "first_face_arm64_s": (0, math.inf), "dial_edges_arm64": (1, math.inf), "checks_arm64": (1, math.inf), "checks_arm64_failed": (0, 0),
          "image_no_llvm_mb": (0, math.inf)}
GOALS = {"image_no_llvm_mb": 20}  # The most.
# What measures a figure that is not of this run.
RUNS = {**dict.fromkeys(("boots_arm64", "face_arm64", "first_face_arm64_s", "dial_edges_arm64", "checks_arm64", "checks_arm64_failed"),
                        "./box test --bench --arch arm64"), "image_no_llvm_mb": "./box image --arch arm64 --board rpi4 --board-firmware FOLDER"}
AARCH64 = 183  # e_machine of an ELF file.


def programs(root):
    """Names of all programs that the tree builds; folders of builds have CMakeLists.txt too, of others."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "-co", "--exclude-standard", "*CMakeLists.txt"], capture_output=True, text=True, check=True)
    texts = [(root / path).read_text() for path in listed.stdout.splitlines()]
    return sorted({name for text in texts for name in re.findall(r"(?m)^ *kaori_(?:installed_)?program\((kaori-[\w-]+)", text)})


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
            "dial_edges_arm64": measured.get("pl061_edges"),
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


def bounds_of(figures):
    return BOUNDS | {"programs_arm64": (figures["programs_all"], figures["programs_all"])}


def main():
    root, build, tests, modules, file = (Path(word).resolve() for word in sys.argv[1:6])
    cases, failed = sdk_cases(root, root / "out/cross/arm64/sysroot")
    recipe = list(layer.offences(root, root / "out/build/release", modules))
    print("\n".join(recipe))
    wanted = programs(root)
    missing = [name for name in wanted if not is_arm64(build / f"bin/{name}")]
    if missing:
        print(f"not built for 64-bit ARM: {', '.join(missing)}")
    figures = {
        "programs_arm64": len(wanted) - len(missing), "programs_all": len(wanted),
        **of_tests(tests),
        "sdk_cases": cases, "sdk_cases_failed": failed, "recipe_errors": len(recipe),
        **of_the_bench(file.parent),
        **of_boards(file.parent),
    }
    return bounded_report.write("cross_report.py", figures, bounds_of(figures), file, runs=RUNS, goals=GOALS, is_whole="--whole" in sys.argv)


if __name__ == "__main__":
    sys.exit(main())
