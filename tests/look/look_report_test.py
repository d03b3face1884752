#!/usr/bin/env python3
"""The report of the look keeps what others measured, takes what is measured now, and names what misses its bar: look_report_test.py"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPORT = Path(__file__).with_name("look_report.py")

# Stands for test-performance: records what it is told to, as GoogleTest writes it.
PROGRAM = """#!/bin/sh
for word in "$@"; do case $word in --gtest_output=json:*) file=${word#--gtest_output=json:} ;; esac; done
printf '{"testsuites": [{"testsuite": [{"gaze_hold_error_deg": "%s"}, {"life_repeat_s": "%s"}]}]}' HELD REPEATS >"$file"
"""


class Completed(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = Path(folder.name)

    def bench(self, name, small_ms, large_ms):
        metrics = [{"name": f"frame.default.{size}.{clock}_ms", "median": ms}
                   for size, ms in (("960x540", small_ms), ("1920x1080", large_ms)) for clock in ("cpu", "wall")]
        metrics += [{"name": f"frame.default_over_lit_triangles.{size}.cpu", "median": over} for size, over in (("960x540", 1.9), ("1920x1080", 2.6))]
        (self.out / name).write_text(json.dumps({"metrics": metrics}))
        return str(self.out / name)

    def report(self, *options, held="0.3", repeats="900"):
        program = self.out / "test-performance"
        program.write_text(PROGRAM.replace("HELD", held).replace("REPEATS", repeats))
        program.chmod(0o755)
        done = subprocess.run([sys.executable, "-B", REPORT, self.out, self.out / "look.json", *options], capture_output=True, text=True, check=False)
        return done, json.loads((self.out / "look.json").read_text())

    def test_what_was_never_measured_is_null_and_the_rest_stays(self):
        (self.out / "look.json").write_text('{"smile_cheek_rise_mm": 5.9, "look_horns_mm": 27}')
        done, figures = self.report()
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual((figures["gaze_hold_error_deg"], figures["life_repeat_s"], figures["smile_cheek_rise_mm"]), (0.3, 900, 5.9))
        self.assertEqual(figures["look_horns_mm"], 27)
        self.assertIsNone(figures["look_fps_960x540"])

    def test_speed_is_of_the_worse_size_beside_the_build_before(self):
        _, figures = self.report("--bench", self.bench("now.json", 20, 36), "--before", self.bench("before.json", 25, 40))
        self.assertEqual((figures["look_fps_960x540"], figures["look_cpu_over_today"], figures["look_over_bare"]), (50, 0.9, 2.6))

    def test_a_frame_of_more_than_two_bare_ones_fails(self):
        done, _ = self.report("--bench", self.bench("now.json", 20, 36))
        self.assertEqual(done.returncode, 1)
        self.assertIn("look_over_bare             2.6  (<= 2.0: not met)", done.stdout)

    def test_what_misses_its_bar_fails_and_is_named(self):
        done, _ = self.report(repeats="431")
        self.assertEqual(done.returncode, 1)
        self.assertIn("life_repeat_s              431.0  (>= 600: not met)", done.stdout)


if __name__ == "__main__":
    unittest.main()
