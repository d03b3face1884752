#!/usr/bin/env python3
"""Completes what is measured of the look: look_report.py BIN FILE.json [--bench NOW.json [--before BEFORE.json]]

The tests of tests/look write most figures into FILE themselves; those of a performance come from programs in BIN, and
those of speed from what kaori-benchmark --only frame --json wrote: of this build, and of the build before it, run on
the same machine at the same time. A figure that is not measured now stays as it was; one that never was is null.

  expressions_confused      of all pairs of expressions, those that are not told apart in a picture of 96 pixels
  lean_collar_crossings     places where the neck stands before the collar, over all faces and leans
  morph_garment_overlap_px  pixels to which two garments contribute, over all pairs of faces
  morph_shoulder_notch_px   how far shoulders of two faces step back below a garment that stands off them, of 120
  morph_garment_hanging_px  pixels of garments of two faces that hang in the air before their necks
  morph_hair_afloat_px      pixels of a figure between two faces that are joined to the rest of it by nothing
  morph_hair_horn_px        how much farther than either's hair that of two faces stands off the head, of 180
  smile_cheek_rise_mm       of the cheeks, from rest to a smile, of whom it is least
  gaze_hold_error_deg       how far her eyes leave their goal while a stick turns the head
  life_repeat_s             after so long she does for 20 s what she did before; where she never did, how long was looked at
  look_fps_960x540          frames a second of the default look, drawn by the processor
  look_over_bare            of its processor time, over that of a bare draw of as many lit triangles, the worse of two sizes
  look_cpu_over_today       processor time of its frame over that of the build before, the worse of two sizes
"""

import argparse
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import recorded

# At least so much, or at most.
AT_LEAST = {"smile_cheek_rise_mm": 2.5, "life_repeat_s": 600, "look_fps_960x540": 45}
AT_MOST = {"expressions_confused": 0, "lean_collar_crossings": 0, "morph_garment_overlap_px": 0, "morph_shoulder_notch_px": 2,
           "morph_garment_hanging_px": 6, "morph_hair_afloat_px": 16, "morph_hair_horn_px": 5, "gaze_hold_error_deg": 1,
           "look_cpu_over_today": 1, "look_over_bare": 2.0}
FROM_TESTS = ("gaze_hold_error_deg", "life_repeat_s")
SIZES = ("960x540", "1920x1080")


def medians(file):
    return {metric["name"]: metric["median"] for metric in json.loads(Path(file).read_text())["metrics"]}


def of_speed(now, before):
    """What the two benchmarks say, as far as they say it."""
    figures = {}
    if now:
        figures["look_fps_960x540"] = round(1000 / now["frame.default.960x540.wall_ms"], 1)
        figures["look_over_bare"] = round(max(now[f"frame.default_over_lit_triangles.{size}.cpu"] for size in SIZES), 2)
    if now and before:
        figures["look_cpu_over_today"] = round(max(now[f"frame.default.{size}.cpu_ms"] / before[f"frame.default.{size}.cpu_ms"]
                                                   for size in SIZES), 3)
    return figures


def within(name, value):
    return value is not None and (value >= AT_LEAST[name] if name in AT_LEAST else value <= AT_MOST[name])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bin", type=Path)
    parser.add_argument("file", type=Path)
    parser.add_argument("--bench")
    parser.add_argument("--before")
    args = parser.parse_args()
    cases, passed = recorded.cases((args.bin / "test-performance").resolve(), "Gaze.Holds*:LifeInTime.*")
    report = json.loads(args.file.read_text()) if args.file.is_file() else {}
    report.update((name, float(case[name])) for case in cases for name in FROM_TESTS if name in case)
    report.update(of_speed(args.bench and medians(args.bench), args.before and medians(args.before)))
    report = {name: report.get(name) for name in sorted({*report, *AT_LEAST, *AT_MOST})}
    args.file.parent.mkdir(parents=True, exist_ok=True)
    args.file.write_text(json.dumps(report, indent=1) + "\n")
    for name in (*AT_LEAST, *AT_MOST):
        bar = f">= {AT_LEAST[name]}" if name in AT_LEAST else f"<= {AT_MOST[name]}"
        print(f"{name:26} {report[name]}  ({bar}{'' if within(name, report[name]) else ': not met'})")
    wrong = [name for name in (*AT_LEAST, *AT_MOST) if report[name] is not None and not within(name, report[name])]
    return 0 if passed and not wrong and all(report[name] is not None for name in FROM_TESTS) else 1


if __name__ == "__main__":
    sys.exit(main())
