#!/usr/bin/env -S python3 -B
"""Gathers what is measured of a company that has a box of its own into OUT/company.json: company_report.py OUT

Each figure is taken from where it was measured, or it is null, and named: none is made up.

  shows_installed, bad_shows_refused   by the test "system: company", which writes them itself
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
import sys
from pathlib import Path

MEASURED_BY_BENCH = ("support_file_kb", "install_under_play_rate", "journal_kept_mb", "first_face_over_stock", "secure_boot_cases_failed",
                     "clone_minutes")
# File in OUT, and which figures it has; of a figure that two have the first counts.
SOURCES = (("boot.json", MEASURED_BY_BENCH),
           ("image.json", ("sbom_files_unmatched",)),
           ("backup.json", ("restore_differs", "clone_minutes")),
           ("company.json", ("shows_installed", "bad_shows_refused", "commands_to_own_show", "support_file_kb")))


def read(file):
    """An object; an empty one where there is no such file."""
    return json.loads(file.read_text()) if file.is_file() else {}


def gathered(out):
    """{figure: what was measured, or None}."""
    figures = {}
    for name, its in SOURCES:
        found = read(out / name)
        for figure in its:
            if figures.get(figure) is None:
                figures[figure] = found.get(figure)
    return figures


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    out = Path(sys.argv[1])
    figures = gathered(out)
    (out / "company.json").write_text(json.dumps(read(out / "company.json") | figures, indent=2) + "\n")
    for name, value in figures.items():
        if value is not None:
            print(f"{name:24} {value}")
    missing = [name for name, value in figures.items() if value is None]
    if missing:
        print(f"not measured: {', '.join(missing)}")


if __name__ == "__main__":
    main()
