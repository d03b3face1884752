#!/usr/bin/env -S python3 -B
"""Writes what shows that the control surfaces are right: firmware_report.py FIGURES SIZES BOOT.json FUZZ.log TEST-INPUT OUT.json

FIGURES has lines "name value" of the proofs (tests/firmware/figures.h), SIZES is of images.py, BOOT.json holds the figures of the
bench's long mode, FUZZ.log is what the fuzzer of the USB machine said, TEST-INPUT is the program of kaori-input's tests. OUT gets
one figure for each key of BOUNDS; ends with 1 where one is out of its bounds or one that this run measures is missing. Those of
runs of their own (ELSEWHERE) are named where nobody measured them.

  flash_bytes, ram_bytes, heap_bytes   of the larger image
  edges_tested, counts_lost            of dials, against an ideal hand; double_steps_untold: that the firmware did not tell of
  usb_requests, usb_fuzz_execs         of chapter 9 and HID; inputs of the fuzzer
  update_cuts, update_cuts_dead        the power is cut at each step of an update; boxes that did not start afterwards
  box_update_cuts_dead                 the same of updates that a box brings
  button_us, report_latency_cycles     in the emulated chip, the worst: a press to its report, an edge to its armed report
  report_latency_edges, button_presses of how many those are the worst
  lossless_edge_rate_hz                of all eight dials at once
  emulated_is_shipped                  1: the image in the emulator is the one that is shipped, bit for bit
  controls_passed                      builds that are wrong on purpose and were not found out
  serial_false_values_after_gap        values that a spoilt serial line made pass after a silence
  twins_played                         surfaces of other makers that play by their twins in kaori-input's tests
  surfaces_played                      of those, before the box's own kernel
  chip_plays_box                       1: the shipped image in its emulated chip moves the face of the box in the virtual machine
  chip_plays_pod                       1: the same of the stick pod's image, which moves head and gaze
  serial_boxes_played, gpio_edges      serial boxes behind an adapter, edges of dials on GPIO lines, in the virtual machine
"""

import collections
import json
import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import recorded

# The least and the most of each.
BOUNDS = {"flash_bytes": (1, 49152), "ram_bytes": (1, 65536), "heap_bytes": (0, 0),
          "edges_tested": (100_000_000, math.inf), "counts_lost": (0, 0), "double_steps_untold": (0, 0),
          "usb_requests": (60, math.inf), "usb_fuzz_execs": (2_000_000, math.inf),
          "update_cuts": (1000, math.inf), "update_cuts_dead": (0, 0), "box_update_cuts_dead": (0, 0),
          "button_us": (0, 2500), "report_latency_cycles": (0, 12500), "lossless_edge_rate_hz": (20000, math.inf),
          "emulated_is_shipped": (1, 1), "controls_passed": (0, 0), "serial_false_values_after_gap": (0, 0),
          "twins_played": (14, math.inf), "surfaces_played": (11, math.inf), "serial_boxes_played": (3, math.inf),
          "gpio_edges": (1000, math.inf), "chip_plays_box": (1, 1), "chip_plays_pod": (1, 1),
          "report_latency_edges": (10_000, math.inf), "button_presses": (1000, math.inf)}
# What measures a figure that is not of this run.
ELSEWHERE = {"chip_plays_box": "./box test --bench", "chip_plays_pod": "./box test --bench", "surfaces_played": "./box test --bench", "serial_boxes_played": "./box test --bench",
             "gpio_edges": "./box test --bench"}
SUMMED = ("edges_tested", "usb_requests")
TWINS = "*Owned*:*MidiSurfaces*:*Deck*:*SerialBox*"


def proved(lines):
    """Of the lines that the proofs wrote; what several of them counted is added up."""
    found = collections.Counter()
    for line in lines:
        name, value = line.split()
        found[name] = found[name] + int(value) if name in SUMMED else int(value)
    return dict(found)


def largest(sizes):
    """The largest of the images counts."""
    names = {name for image in sizes.values() for name in image}
    return {name: max(image.get(name, 0) for image in sizes.values()) for name in names}


def twins(cases, passed):
    """How many different twins the tests recorded that they played; none where a test did not pass."""
    return {"twins_played": len({case["twin"] for case in cases if "twin" in case})} if passed else {}


def fuzzed(text):
    """libFuzzer's last word on how many inputs it tried."""
    found = re.findall(r"stat::number_of_executed_units:\s*(\d+)", text)
    return {"usb_fuzz_execs": int(found[-1])} if found else {}


def figures(*parts):
    """One figure for each key; None where nobody measured it."""
    known = {name: value for part in parts for name, value in part.items()}
    return {name: known.get(name) for name in BOUNDS}


def missing(found):
    """A line for each figure of another run that is not there."""
    return [f"{name} was not measured; {ELSEWHERE[name]} does" for name in ELSEWHERE if found[name] is None]


def faults(found):
    """A line for each figure that this run should have measured, or that is out of its bounds."""
    for name, (least, most) in BOUNDS.items():
        value = found[name]
        if value is None and name not in ELSEWHERE:
            yield f"{name} was not measured"
        elif value is not None and not least <= value <= most:
            yield f"{name} is {value:g}, and {least:g} to {most:g} is wanted"


def text_of(file):
    return Path(file).read_text() if Path(file).is_file() else ""


def main():
    lines, sizes, boot, fuzz, program, file = sys.argv[1:7]
    found = figures(proved(text_of(lines).splitlines()), largest(json.loads(text_of(sizes) or "{}")),
                    json.loads(text_of(boot) or "{}"), fuzzed(text_of(fuzz)), twins(*recorded.cases(program, TWINS)))
    Path(file).write_text(json.dumps(found, indent=2) + "\n")
    print("\n".join(f"{name:30} {value}" for name, value in found.items()))
    wrong = list(faults(found))
    for line in missing(found) + wrong:
        print(f"firmware_report.py: {line}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
