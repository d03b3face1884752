#!/usr/bin/env -S python3 -B
"""The report on updates names what is missing and what is out of its bounds."""

import update_report

CASES = [{"log_points": "1800", "log_points_wrong": "0", "good_slot_bytes_changed": "0", "fat_sectors_written": "0"},
         {"altered": "200"}, {"altered": "200"}, {"bad_slots": "10", "bad_slots_kept": "0", "tries_to_return": "1"},
         *({"control_found": "1"} for _ in range(8)),
         {"years_starts": "3120", "years_wrong": "0"}]
SEEN = {"update_install_s": 300.0, "sticks_failed": 6, "start_sectors_written": 0, "power_cycles": 20, "slot_flips": 0, "variable_cuts": 10,
        "variable_cuts_dead": 0, "try_cuts": 10, "try_cuts_dead": 0, "bad_versions_booted": 9, "data_cuts": 2000, "data_cuts_wrong": 0, "data_cuts_deciding": 1, "boots_after_cut": 10, "boots_without_face": 0, "update_sectors_astray": 0,
        "face_rate_while_installing": 0.97, "added_packed_mb": 0.5, "sbom_files_unmatched": 0, "stale_packages": 0}


MANY = SEEN | {"sticks_failed": 24, "power_cycles": 200, "variable_cuts": 100, "try_cuts": 100, "data_cuts": 20000, "boots_after_cut": 100}


OF_RELEASE = [{"altered": "99600"}, {"years_starts": "78000"}]  # In place of and beside those of CASES.


def faults(*more, passed=True, seen=MANY, bundle_bytes=80_000_000, is_release=True):
    found = update_report.figures([*more, *(OF_RELEASE if is_release else []), *CASES], passed, seen, bundle_bytes)
    bounds = update_report.bounds_of(is_release)
    return list(update_report.bounded_report.faults(found, bounds, update_report.OF_A_RELEASE, is_release))


def main():
    assert faults() == [], faults()
    assert update_report.figures(CASES, True, SEEN, 1)["altered"] == 400
    for wrong in ({"log_points_wrong": "1"}, {"bad_slots_kept": "1"}, {"tries_to_return": "2"}, {"control_found": "0"}):
        assert len(faults(wrong)) == 1, wrong
    assert faults(passed=False) == ["altered_installed was not measured", "altered_wrote_a_byte was not measured"]
    assert len(faults(seen={})) == 20
    usual = {name: figure for name, figure in SEEN.items() if name != "bad_versions_booted"}
    assert len(faults(seen=SEEN)) == 6, "a release cuts the power more often"
    assert faults(seen={name: figure for name, figure in MANY.items() if name != "bad_versions_booted"}) == ["bad_versions_booted was not measured; ./box test --release does"]
    assert faults(seen=usual, is_release=False) == []
    few = update_report.figures(CASES, True, MANY, 1)
    bounds = update_report.bounds_of(True)
    assert list(update_report.bounded_report.faults(few, bounds, {}, True)) == [
        "altered is 400, and 100000 to inf is wanted", "years_starts is 3120, and 75000 to inf is wanted"]
    assert faults(seen=MANY | {"stale_packages": 2}) == ["stale_packages is 2, and 0 to 0 is wanted"]
    assert faults(bundle_bytes=None) == ["bundle_mb was not measured"]
    assert len(faults(bundle_bytes=96_000_000)) == 1
    assert faults(seen=MANY | {"face_rate_while_installing": 0.9}) == ["face_rate_while_installing is 0.9, and 0.95 to inf is wanted"]


if __name__ == "__main__":
    main()
