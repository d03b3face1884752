#!/usr/bin/env -S python3 -B
"""Writes what shows that a box can be trusted: trust_report.py BOOT.json TEST-DESK FILE.json

BOOT.json holds the figures of the bench's long mode (kaori-bench --figures), TEST-DESK is the program of the desk's tests. FILE
gets one figure for each key of BOUNDS; ends with 1 where one is missing or out of its bounds, and names it.

  fat_images, fat_images_hung    damaged file systems of sticks that were mounted, and those on which the kernel hung
  usb_liars, usb_liars_let_in    USB devices that are not what they say, and those of them that were authorised
  hung_program_back_s            until a program of the box that hangs is replaced and delivers again; the goal is 2, an emulated
                                 machine reaches 2.5, and more than 3 is a fault
  silent_clients_wait_ms         until a visitor is answered behind a thousand connections that say nothing
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import bounded_report
import recorded

# The least and the most of each.
BOUNDS = {"fat_images": (10_000, math.inf), "fat_images_hung": (0, 0), "usb_liars": (21, math.inf), "usb_liars_let_in": (0, 0),
          "hung_program_back_s": (0, 3), "silent_clients_wait_ms": (0, 1000)}
GOALS = {"hung_program_back_s": 2}  # The most.
HUNG = ("hung_input_back_s", "hung_lips_back_s")
CROWD = "*DoNotWaitForAThousandWhoSayNothingOrHalfAWord"


def wait_of_visitor(program):
    """What the test of the desk recorded; None where it did not pass."""
    cases, passed = recorded.cases(program, CROWD)
    if not passed:
        return None
    return next((float(case["silent_clients_wait_ms"]) for case in cases if "silent_clients_wait_ms" in case), None)


def figures(seen, wait_ms):
    """One figure for each key; None where the bench or the test did not measure it."""
    hung = [seen[name] for name in HUNG if name in seen]
    known = seen | {"silent_clients_wait_ms": wait_ms,
                    "hung_program_back_s": max(hung) if len(hung) == len(HUNG) else None}
    return {name: known.get(name) for name in BOUNDS}


def faults(found):
    return bounded_report.faults(found, BOUNDS)


def main():
    boot, program, file = (Path(word).resolve() for word in sys.argv[1:4])
    found = figures(bounded_report.read(boot), wait_of_visitor(program))
    return bounded_report.write("trust_report.py", found, BOUNDS, file, goals=GOALS)


if __name__ == "__main__":
    sys.exit(main())
