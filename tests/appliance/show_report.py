#!/usr/bin/env python3
"""Writes what is measured of a performance: show_report.py BIN FILE.json

Each figure comes from a test of BIN/test-performance or another of PROGRAMS; FILE gets them as they are on this machine now. All
of them are of simulated time but load_ms_200_cues. One beyond its bound (BOUNDS) is named, and the report fails then.

  jump_states_differ       jumps between cues whose state is not that of the run through the list
  go_to_light_frames       pictures that begin to be shown after a GO by the foot switch and before the one that shows it,
                           of 99 in 100 GOs at any moment
  go_lost_over_kills       GOs that are neither played nor refused, of 80 around 40 ends of the stage
  takeover_jumps           of `takeovers` random ones, those where a level moved by more than its owner's hand and 2 % of its range
  handover_step_percent    of its range, the most that a level moves in a 60th of a second while it passes on
  panic_twice_frames       from the second PANIC to the panic scene as a whole
  load_ms_200_cues         of the default show's pack with 200 cues; the fastest of five, by this machine's clock
  faulty_files             files of a show with one mistake each, and in faulty_files_named those that are refused with file,
                           line and reason
  blinks_per_min_rest, blinks_per_min_speaking
  blinks_on_held_lids      blinks that began on lids that a key, a motion or an expression holds
  saccade_error_ms         how far a frame shows the eyes from where they are at its presentation
  gaze_target_error_deg    of each eye, from whom she looks at
  solo_still_s             the longest time in which nothing moves that an audience could see, nobody touching a control
  replay_bits_differ       frames of a show log that do not show, played again, what they showed
  log_kb_per_min           of a show log, while four operators, lips and voice move at once
  take_replay_error        between a take that is played and what the operator did, in radians
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

# The least and the most that each may be.
BOUNDS = {"jump_states_differ": (0, 0), "go_to_light_frames": (0, 1), "go_lost_over_kills": (0, 0),
          "takeovers": (100_000, None), "takeover_jumps": (0, 0), "handover_step_percent": (0, 2), "panic_twice_frames": (0, 1),
          "load_ms_200_cues": (0, 150), "blinks_per_min_rest": (14, 20), "blinks_per_min_speaking": (22, 30),
          "blinks_on_held_lids": (0, 0), "saccade_error_ms": (0, 1), "gaze_target_error_deg": (0, 0.5), "solo_still_s": (0, 2),
          "replay_bits_differ": (0, 0), "log_kb_per_min": (0, 300), "take_replay_error": (0, 1e-4)}
PROGRAMS = {"test-performance": "*Jump*:*SecondOneIsAtOnce:*RandomTakeOvers*:*HandOver*:LifeOfBlinks.*:Gaze.*",
            "test-core": "*PlaysAgainToTheBit:*FewBytesForAMinute",
            "test-scenario": "AShowInTheWholeSystem.*",
            "test-script": "*PlaysWhatTheOperatorDid"}
# Each test of these is of one file that is wrong in one way.
FAULTY = {"test-pack-authoring": "*/AMistake.*:*/AMissingFile.*", "test-script": "*/AWrongScript.*:*/AWrongTake.*:*/AWrongWave.*"}


def run(program, tests):
    """(the cases of a program's tests, whether all of them passed)."""
    with tempfile.TemporaryDirectory() as folder:
        said = Path(folder) / "said.json"
        done = subprocess.run([program, f"--gtest_filter={tests}", f"--gtest_output=json:{said}"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            print(done.stdout, file=sys.stderr)
        suites = json.loads(said.read_text())["testsuites"] if said.exists() else []
    return [case for suite in suites for case in suite["testsuite"]], done.returncode == 0


def beyond(name, value):
    """What is wrong with a figure, or nothing."""
    least, most = BOUNDS[name]
    if value is None:
        return f"no test recorded {name}"
    if value < least or (most is not None and value > most):
        return f"{name} is {value}, not within {least} to {'any' if most is None else most}"
    return None


def main():
    bin_folder, file = (Path(word).resolve() for word in sys.argv[1:3])
    recorded, passed = {}, True
    for program, tests in PROGRAMS.items():
        cases, all_passed = run(bin_folder / program, tests)
        recorded |= {name: float(case[name]) for case in cases for name in BOUNDS if name in case}
        passed = passed and all_passed
    figures = {name: recorded.get(name) for name in BOUNDS}
    faulty = [case for program, tests in FAULTY.items() for case in run(bin_folder / program, tests)[0]]
    figures["faulty_files"] = len(faulty)
    figures["faulty_files_named"] = sum("failures" not in case for case in faulty)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(figures, indent=2) + "\n")
    print("\n".join(f"{name:24} {value}" for name, value in figures.items()))
    wrong = [said for name in BOUNDS if (said := beyond(name, figures[name]))]
    if not faulty or figures["faulty_files_named"] != len(faulty):
        wrong.append(f"{figures['faulty_files_named']} of {len(faulty)} faulty files are named")
    for said in wrong:
        print(f"show_report.py: {said}", file=sys.stderr)
    return 0 if passed and not wrong else 1


if __name__ == "__main__":
    sys.exit(main())
