#!/usr/bin/env -S python3 -B
"""Writes what shows that updates can be trusted: update_report.py BOOT.json TEST-UPDATE IMAGE.json BUNDLE FILE.json [--release]

BOOT.json holds the figures of the bench's long mode (kaori-bench --figures), TEST-UPDATE is the program of the update's tests,
IMAGE.json what the build says of the image in the folder beside
it, and BUNDLE an update of it. FILE gets one figure for each key of BOUNDS; ends with 1
where one of BOUNDS is missing or out of its bounds, and names it; what only a release measures may be missing without --release, and
with it cuts of the power count that were ten times as many, failing sticks four times, starts in years 25 times, and altered updates 250 times.

  log_points, log_points_wrong        sectors of a whole update at each of which the power may go, and what was wrong there
  good_slot_bytes_changed             of the slot that ran
  fat_sectors_written                 tables and folders of the boot partition
  altered                             updates that were changed or cut short
  altered_installed                   those of them that were taken, and those
  altered_wrote_a_byte                that wrote anything
  bad_slots, bad_slots_kept           systems that do badly, and those of them that stayed
  tries_to_return                     until the system before was back
  controls, controls_passed           faults that were made on purpose, and those of them that nobody found
  years_starts, years_wrong           starts of boxes that are updated for years in simulated time, with cuts of the power at any moment, and
                                      what went wrong there
  start_sectors_written               beside the data partition, by a whole start of a PC with UEFI: by firmware, loader, kernel or programs
  power_cycles, slot_flips            how often a PC was switched off at a random moment, and those after which another slot started
  variable_cuts, variable_cuts_dead   cuts between two writes of the firmware to its variables, and those after which no face came
  try_cuts, try_cuts_dead             cuts while the firmware keeps which slot is to be tried once, or strikes it, and those after which no face came
  bad_versions_booted                 bad versions that really started in a PC with UEFI, each of which was tried once and gave way
  data_cuts, data_cuts_wrong          cuts after which the data partition's disk had lost or torn what was not flushed, and those that left a
                                      file of it neither as before nor as after
  data_cuts_deciding                  of those cuts, between two states of what is kept
  sticks_failed                       sticks that were pulled while an update came, could not be read or were slow: each was named, and nothing
                                      of a part of an update waits
  boots_after_cut, boots_without_face cuts behind a write of a whole update in a PC with UEFI, and those after which no face came
  update_sectors_astray               that it wrote beside the data, the other slot with its kernel's file, and loader.conf's sector
  face_rate_while_installing          frames a second while an update comes in, over those before
  added_packed_mb                     of a download, which is there for updates alone: their program, units and keys
  bundle_mb, install_s                an update's size, and how long it takes to bring one in on an emulated machine
  sbom_files_unmatched                files of the image that belong to nothing that is listed
  stale_packages                      of which Debian had a newer version when the image was built
"""

import math
import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import bounded_report
import recorded

# The least and the most of each.
BOUNDS = {"log_points": (1000, math.inf), "log_points_wrong": (0, 0), "good_slot_bytes_changed": (0, 0), "fat_sectors_written": (0, 0),
          "altered": (200, math.inf), "altered_installed": (0, 0), "altered_wrote_a_byte": (0, 0), "bad_slots": (9, math.inf),
          "bad_slots_kept": (0, 0), "tries_to_return": (0, 1), "controls": (8, math.inf), "controls_passed": (0, 0),
          "years_starts": (3000, math.inf), "years_wrong": (0, 0), "start_sectors_written": (0, 0), "power_cycles": (20, math.inf), "slot_flips": (0, 0), "variable_cuts": (10, math.inf),
          "variable_cuts_dead": (0, 0), "try_cuts": (10, math.inf), "try_cuts_dead": (0, 0), "bad_versions_booted": (9, math.inf), "data_cuts": (2000, math.inf), "data_cuts_wrong": (0, 0),
          "data_cuts_deciding": (1, math.inf), "boots_after_cut": (10, math.inf), "boots_without_face": (0, 0), "update_sectors_astray": (0, 0), "sticks_failed": (6, math.inf),
          "face_rate_while_installing": (0.95, math.inf), "bundle_mb": (0, 95), "added_packed_mb": (0, 4), "install_s": (0, math.inf), "sbom_files_unmatched": (0, 0), "stale_packages": (0, 0)}
# The least that a release has tried, in so many rounds; ./box test --bench has one.
ROUNDS = {name: 10 for name in ("power_cycles", "variable_cuts", "try_cuts", "data_cuts", "boots_after_cut")} | {"sticks_failed": 4, "years_starts": 25}
# KAORI_UPDATE_EFFORT of a release: 100 000 altered updates in all.
RELEASE_ALTERED = 250
OF_A_RELEASE = {"bad_versions_booted": "./box test --release"}
# What of a root is there for updates alone.
ADDED = ("usr/bin/kaori-update", "usr/share/kaori/update-keys", *(f"usr/lib/systemd/system/kaori-{name}" for name in (
    "update.service", "update.service.d", "update.socket", "confirm.service", "confirm.service.d", "other.service",
    "other.service.d", "other.path", "other.timer", "trial.service", "trial.timer")))
TESTS = "UpdatePowerCut.*:UpdateInstallation.*:BadSlotTest.*:UpdateYears.*"
FROM_TESTS = ("log_points", "log_points_wrong", "good_slot_bytes_changed", "fat_sectors_written", "bad_slots", "bad_slots_kept",
              "tries_to_return", "years_starts", "years_wrong")


def of_tests(cases, passed):
    """The figures that tests recorded. A test that did not pass leaves its own figures, and none of the altered ones counts as
    refused then."""
    found = {name: next((int(case[name]) for case in cases if name in case), None) for name in FROM_TESTS}
    controls = [int(case["control_found"]) for case in cases if "control_found" in case]
    altered = [int(case["altered"]) for case in cases if "altered" in case]
    refused = 0 if passed else None
    return found | {"altered": sum(altered), "altered_installed": refused, "altered_wrote_a_byte": refused,
                    "controls": len(controls), "controls_passed": controls.count(0)}


def packed_mb(root):
    """How much of a download is there for updates alone, packed as an update is; None where the root has no updates."""
    names = [name for name in ADDED if (root / name).exists()]
    if ADDED[0] not in names:
        return None
    tar = subprocess.run(["tar", "-C", root, "-c", *names], stdout=subprocess.PIPE, check=True).stdout
    packed = subprocess.run(["zstd", "-q", "-19", "-c"], input=tar, stdout=subprocess.PIPE, check=True).stdout
    return round(len(packed) / 1e6, 2)


def bounds_of(is_release):
    """A release has cut the power as often as it was told to, and not as often as every run does."""
    more = {name: (BOUNDS[name][0] * rounds, BOUNDS[name][1]) for name, rounds in ROUNDS.items()}
    more["altered"] = (BOUNDS["altered"][0] * 2 * RELEASE_ALTERED, math.inf)  # Two tests each try so many.
    return BOUNDS | more if is_release else BOUNDS


def figures(cases, passed, seen, bundle_bytes):
    """One figure for each key; None where nothing measured it."""
    known = seen | of_tests(cases, passed) | {"install_s": seen.get("update_install_s"),
                                       "bundle_mb": bundle_bytes and round(bundle_bytes / 1e6, 1)}
    return {name: known.get(name) for name in BOUNDS}


def main():
    boot, program, image, bundle, file = (Path(word).resolve() for word in sys.argv[1:6])
    is_release = sys.argv[6:] == ["--release"]
    seen = bounded_report.read(image) | bounded_report.read(boot) | {"added_packed_mb": packed_mb(image.with_suffix("") / "root")}
    if is_release:
        os.environ["KAORI_UPDATE_EFFORT"] = str(RELEASE_ALTERED)
    found = figures(*recorded.cases(program, TESTS), seen, bundle.stat().st_size if bundle.is_file() else None)
    return bounded_report.write("update_report.py", found, bounds_of(is_release), file, runs=OF_A_RELEASE, is_whole=is_release)


if __name__ == "__main__":
    sys.exit(main())
