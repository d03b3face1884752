#!/usr/bin/env -S python3 -B
"""Gathers what is measured of a company that has a box of its own into OUT/company.json: company_report.py OUT [--whole]

Each figure is taken from where it was measured, or it is null, and named with the run that measures it: none is made up. Ends
with 1 where one is out of its bounds, and with --whole, after a run that measures all of them, where one is null.

  shows_installed, bad_shows_refused   by the test "system: company", which writes them itself, of bad_shows that it tries
  commands_to_own_show                 of the guide, by the same test
  support_file_kb                      as a real stick got it from a box, else by the same test
  install_under_play_rate              frames a second while a show is installed, over those before
  journal_kept_mb                      of two evenings, on the data partition
  first_face_over_stock                the time to the first face over that of a usual Debian
  secure_boot_cases_failed             disks that start or do not start as their signatures say
  sbom_files_unmatched                 files of the image of which nobody knows whence they are
  restore_differs                      files that are not the same after a backup is brought back
  clone_minutes                        from one box to a second one like it: as two boxes did it by a stick, else by their disks
"""

import json
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import bounded_report

MEASURED_BY_BENCH = ("support_file_kb", "install_under_play_rate", "journal_kept_mb", "first_face_over_stock", "secure_boot_cases_failed",
                     "clone_minutes")
OF_TEST = ("shows_installed", "bad_shows", "bad_shows_refused", "commands_to_own_show", "support_file_kb")
# File in OUT, which figures it has, and the run that writes it; of a figure that two have the first counts.
SOURCES = (("boot.json", MEASURED_BY_BENCH, "./box test --bench"),
           ("image.json", ("sbom_files_unmatched",), "./box image"),
           ("backup.json", ("restore_differs", "clone_minutes"), "./box test"),
           ("company.json", OF_TEST, "./box test"))
# The least and the most of each. How many of the bad shows are to be refused is in the figures: all.
BOUNDS = {"shows_installed": (1, math.inf), "bad_shows": (1, math.inf), "bad_shows_refused": (1, math.inf),
          "commands_to_own_show": (1, math.inf), "support_file_kb": (1, 5 * 1024), "install_under_play_rate": (0.95, math.inf),
          "journal_kept_mb": (0, 16.78),  # SystemMaxUse= of the box's journald.conf.
          "first_face_over_stock": (0, 0.35), "secure_boot_cases_failed": (0, 0), "sbom_files_unmatched": (0, 0),
          "restore_differs": (0, 0), "clone_minutes": (0, 2)}


def gathered(out):
    """{figure: what was measured, or None}."""
    figures = dict.fromkeys(BOUNDS)
    for name, its, _ in SOURCES:
        found = bounded_report.read(out / name)
        for figure in its:
            if figures[figure] is None:
                figures[figure] = found.get(figure)
    return figures


def runs():
    """{figure: the run that measures it}; of several the first."""
    return {figure: run for _, its, run in reversed(SOURCES) for figure in its}


def bounds_of(figures):
    all_bad = figures["bad_shows"]
    return BOUNDS | ({"bad_shows_refused": (all_bad, all_bad)} if all_bad else {})


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--whole"]):
        sys.exit(__doc__)
    file = Path(sys.argv[1]) / "company.json"
    figures = gathered(file.parent)
    written = json.loads(file.read_text()) | figures if file.is_file() else figures
    return bounded_report.write("company_report.py", written, bounds_of(figures), file, runs=runs(), is_whole="--whole" in sys.argv)


if __name__ == "__main__":
    sys.exit(main())
