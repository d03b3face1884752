#!/usr/bin/env python3
"""Writes what builds for other machines came to: cross_report.py ROOT BUILD TESTS.xml NODE_MODULES FILE.json

  programs_arm64      programs of the box and its tools in BUILD that are for 64-bit ARM
  programs_all        those that there should be
  tests_arm64         tests that ran in QEMU's user mode (TESTS.xml, of ctest)
  tests_arm64_failed  those of them that failed
  sdk_cases           cases of tests/rootfs/sdk_test.py, with Debian's cross compiler in the SDK's place
  sdk_cases_failed
  recipe_errors       what tests/rootfs/layer.py finds, grammar and kas's schema included
"""

import json
import re
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

import layer

PROGRAMS = ("kaori-boot", "kaori-data", "kaori-fdkeeper", "kaori-input", "kaori-lips", "kaori-power", "kaori-report", "kaori-shows", "kaori-stage",
            "kaori-surface", "kaori-desk", "kaori-status", "kaori-atelier", "kaori-sim", "kaori-rehearsal", "kaori-bench", "kaori-gadget")
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


def main():
    root, build, tests, modules, file = (Path(word).resolve() for word in sys.argv[1:6])
    ran = xml.etree.ElementTree.parse(tests).getroot()
    cases, failed = sdk_cases(root, root / "out/cross/arm64/sysroot")
    recipe = list(layer.offences(root, root / "out/build/release", modules))
    print("\n".join(recipe))
    figures = {
        "programs_arm64": sum(is_arm64(build / f"bin/{name}") for name in PROGRAMS), "programs_all": len(PROGRAMS),
        "tests_arm64": int(ran.get("tests")), "tests_arm64_failed": int(ran.get("failures")),
        "sdk_cases": cases, "sdk_cases_failed": failed, "recipe_errors": len(recipe),
    }
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(figures, indent=2) + "\n")
    print("\n".join(f"{name:20} {value}" for name, value in figures.items()))
    return 1 if failed or recipe or figures["programs_arm64"] < len(PROGRAMS) else 0


if __name__ == "__main__":
    sys.exit(main())
