#!/usr/bin/env python3
"""Writes what is measured of a performance, in simulated time but for the kills: show_report.py BIN FILE.json

Each figure comes from a test of one of PROGRAMS in BIN, which bounds it too; FILE gets them as they are on this machine now.

  jump_states_differ       of `jumps` between all pairs of cues, of the default list and of a small one, those whose state is
                           not that of the run through the list
  go_to_light_frames       pictures that were begun after a GO until the one that has its cue; 1: the very next (99 of 100 GOs)
  go_to_light_ms           from the push of a GO until that picture is presented, at 60 Hz (99 of 100 GOs)
  go_lost_over_kills       GOs of `go_kills` that were not played, each pressed while the stage was killed
  panic_twice_frames       pictures until the panic scene is there when PANIC is called twice
  takeover_jumps           of `takeovers` random ones, those where a level moved by more than its owner's hand and 2 % of its range
  handover_step_percent    of its range, the most that a level moves in a 60th of a second while it passes on
  blinks_per_min_rest, blinks_per_min_speaking
  blinks_on_held_lids      blinks that began on lids that a key, a motion or an expression holds
  saccade_error_ms         how far a frame shows the eyes from where they are at its presentation
  gaze_target_error_deg    of each eye, from whom she looks at
  solo_still_s             the longest time in which nothing moves that an audience could see, nobody touching a control
  replay_bits_differ       frames of a show log that do not show, played again, what they showed
  log_kb_per_min           of a show log, while four operators, lips and voice move at once
  take_replay_error        between a take that is played and what the operator did, in radians
  load_ms_200_cues         of processor time, to load the default show with a list of 200 cues: the median of five
  faulty_files             files of a show, each with a mistake of its own, of which
  faulty_files_named       so many are refused with file, line and reason
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import recorded

# Of these each test counts its own.
COUNTS = ("jumps", "jump_states_differ", "faulty_files", "faulty_files_named")
FIGURES = (*COUNTS, "go_to_light_frames", "go_to_light_ms", "go_kills", "go_lost_over_kills", "panic_twice_frames",
           "takeovers", "takeover_jumps", "handover_step_percent", "blinks_per_min_rest", "blinks_per_min_speaking",
           "blinks_on_held_lids", "saccade_error_ms", "gaze_target_error_deg", "solo_still_s", "replay_bits_differ",
           "log_kb_per_min", "take_replay_error", "load_ms_200_cues")
PROGRAMS = {"test-performance": "*Jump*:*PanicCalls*:*RandomTakeOvers*:*HandOver*:LifeOfBlinks.*:Gaze.*",
            "test-core": "*PlaysAgainToTheBit:*FewBytesForAMinute",
            "test-script": "*PlaysWhatTheOperatorDid:*AWrongTake.*",
            "test-pack-authoring": "*AMistake.*",
            "test-cue-lists": "*",
            "test-system": "GoOverKills.*"}


def measured(program, tests):
    """(what the tests of one program recorded, as pairs of a figure and a number; whether all of them passed)."""
    cases, passed = recorded.cases(program, tests)
    return [(name, float(case[name])) for case in cases for name in FIGURES if name in case], passed


def main():
    bin_folder, file = (Path(word).resolve() for word in sys.argv[1:3])
    by_name, passed = {}, True
    for program, tests in PROGRAMS.items():
        found, all_passed = measured(bin_folder / program, tests)
        for name, value in found:
            by_name[name] = value + (by_name.get(name, 0) if name in COUNTS else 0)
        passed = passed and all_passed
    figures = {name: by_name.get(name) for name in FIGURES}
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(figures, indent=2) + "\n")
    print("\n".join(f"{name:24} {value}" for name, value in figures.items()))
    missing = [name for name, value in figures.items() if value is None]
    if missing:
        print(f"show_report.py: no test recorded {', '.join(missing)}", file=sys.stderr)
    return 0 if passed and not missing else 1


if __name__ == "__main__":
    sys.exit(main())
