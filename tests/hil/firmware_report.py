#!/usr/bin/env python3
"""Makes out/firmware.json of what the proofs measured, and holds it against the bars.

Usage: figures.py FIGURES SIZES OUT     FIGURES has lines "name value", SIZES is of images.py. Prints each figure with its bar and
                                        names those that nobody measured; exits 1 when a bar is not reached.
"""

import collections
import json
import pathlib
import sys

# name -> (how it is compared with the bar, the bar)
BARS = {
    "flash_bytes": ("<=", 49152), "ram_bytes": ("<=", 65536), "heap_bytes": ("<=", 0),
    "edges_tested": (">=", 10_000_000), "counts_lost": ("<=", 0), "double_steps_untold": ("<=", 0),
    "usb_requests": (">=", 60), "usb_fuzz_execs": (">=", 2_000_000),
    "update_cuts": (">=", 1000), "update_cuts_dead": ("<=", 0),
    "button_us": ("<=", 2500), "report_latency_cycles": ("<=", 12500), "lossless_edge_rate_hz": (">=", 20000),
    "emulated_is_shipped": (">=", 1), "controls_passed": ("<=", 0), "serial_false_values_after_gap": ("<=", 0),
    "box_update_cuts_dead": ("<=", 0),
}
SUMMED = ("edges_tested", "usb_requests")


def main():
    figures, sizes, out = map(pathlib.Path, sys.argv[1:])
    measured = collections.Counter()
    for line in figures.read_text(encoding="utf-8").splitlines():
        name, value = line.split()
        measured[name] = measured[name] + int(value) if name in SUMMED else int(value)
    # The largest of the images counts.
    for image in json.loads(sizes.read_text(encoding="utf-8")).values():
        for name, value in image.items():
            measured[name] = max(measured[name], value)
    out.write_text(json.dumps(measured, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    missed = []
    for name, (way, bar) in BARS.items():
        if name not in measured:
            print(f"{name}: not measured by this run (wanted {way} {bar})")
            continue
        reached = measured[name] <= bar if way == "<=" else measured[name] >= bar
        missed += [] if reached else [name]
        print(f"{name}: {measured[name]} (wanted {way} {bar}){'' if reached else ': MISSED'}")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
