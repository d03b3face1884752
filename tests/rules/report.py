#!/usr/bin/env python3
"""Writes what can be counted about the sources, for people who follow it over time.

Usage: report.py ROOT BUILD FILE.json     FILE gets the figures, as they stand now.

  cycles            circles of folders that include each other
  refused_words     words that tests/rules/words.py refuses
  unformatted       sources that clang-format would write otherwise
  tidy_warnings     what clang-tidy found (tests/rules/tidy.py); null where it has not read all sources as they are now
  comment_percent   lines that are a comment, of all lines of the product's C++ (firmware, drivers, render, appliance, hw-sim)
  contract_suites   suites of tests/contracts
  product_lines     lines of the product's C++
  build_*_cpu_s     processor seconds of a build without compiler cache, where `./box bench --build` measured it; else null
  build_touched_s   seconds from one touched source to the end of its tests, likewise
"""

import json
import pathlib
import sys

import comments
import cycles
import format  # noqa: A004  The check of that name.
import tidy
import words

BUILD_FIGURES = ("build_demo_cpu_s", "build_test_cpu_s", "build_kernel_cpu_s", "build_touched_s")


def figures(root, build):
    measured = root / "out/build_cpu.json"
    known = json.loads(measured.read_text()) if measured.is_file() else {}
    return {
        "cycles": len(list(cycles.offences(root))),
        "refused_words": len(list(words.offences(root))),
        "unformatted": len(set(format.unformatted(root))),
        "tidy_warnings": tidy.count(root, build),
        "comment_percent": round(comments.percent(root), 1),
        "contract_suites": len(list((root / "tests/contracts").glob("*_contract.h"))),
        "product_lines": sum(lines for lines, _ in comments.of_folders(root).values()),
        **{name: known.get(name) for name in BUILD_FIGURES},
    }


def main():
    root, build, file = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    file.parent.mkdir(parents=True, exist_ok=True)
    found = figures(root, build)
    file.write_text(json.dumps(found, indent=2) + "\n")
    print("\n".join(f"{name:20} {value}" for name, value in found.items()))


if __name__ == "__main__":
    main()
