#!/usr/bin/env python3
"""The figures of a company's box come from where they were measured, and what was not, or is out of its bounds, is named:
company_report_test.py"""

import json
import subprocess
import tempfile
import unittest
from pathlib import Path

REPORT = Path(__file__).with_name("company_report.py")


class Gathered(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = Path(folder.name)

    def write(self, name, figures):
        (self.out / name).write_text(json.dumps(figures))

    def report(self, *options):
        """Its exit status, what it says to people, and the file that it leaves."""
        done = subprocess.run([REPORT, self.out, *options], capture_output=True, text=True, check=False)
        return done.returncode, done.stderr, json.loads((self.out / "company.json").read_text())

    def write_good(self):
        """As all runs together leave it."""
        self.write("boot.json", {"support_file_kb": 2000, "install_under_play_rate": 0.97, "journal_kept_mb": 8.4, "first_face_over_stock": 0.33,
                                 "secure_boot_cases_failed": 0, "clone_minutes": 1.4})
        self.write("image.json", {"sbom_files_unmatched": 0})
        self.write("backup.json", {"restore_differs": 0, "clone_minutes": 0.4})
        self.write("company.json", {"shows_installed": 1, "bad_shows": 7, "bad_shows_refused": 7, "commands_to_own_show": 5})

    def test_of_a_figure_that_two_measured_the_boxs_counts(self):
        self.write("boot.json", {"support_file_kb": 12.5, "secure_boot_cases_failed": 0})
        self.write("company.json", {"shows_installed": 1, "support_file_kb": 99, "another": 5})
        _, _, figures = self.report()
        self.assertEqual((figures["support_file_kb"], figures["secure_boot_cases_failed"], figures["shows_installed"]), (12.5, 0, 1))
        self.assertEqual(figures["another"], 5, "others' figures stay")

    def test_what_was_not_measured_is_named_with_the_run_that_does_and_not_made_up(self):
        self.write("image.json", {"sbom_files_unmatched": 0})
        self.write("backup.json", {"restore_differs": 0})
        status, said, figures = self.report()
        self.assertEqual((figures["sbom_files_unmatched"], figures["restore_differs"]), (0, 0))
        self.assertIsNone(figures["clone_minutes"])
        self.assertIn("clone_minutes was not measured; ./box test --bench does", said)
        self.assertIn("shows_installed was not measured; ./box test does", said)
        self.assertNotIn("restore_differs", said)
        self.assertEqual(status, 0, "another run measures them")

    def test_in_a_whole_run_nothing_may_be_missing(self):
        self.write_good()
        status, said, _ = self.report("--whole")
        self.assertEqual((status, said), (0, ""))
        self.write("image.json", {})
        status, said, _ = self.report("--whole")
        self.assertEqual((status, said), (1, "company_report.py: sbom_files_unmatched was not measured; ./box image does\n"))

    def test_what_is_out_of_its_bounds_fails_in_each_run(self):
        wrong = (("boot.json", "clone_minutes", 2.1), ("company.json", "bad_shows_refused", 6), ("backup.json", "restore_differs", 1),
                 ("boot.json", "install_under_play_rate", 0.94), ("image.json", "sbom_files_unmatched", 1),
                 ("boot.json", "secure_boot_cases_failed", 1), ("boot.json", "first_face_over_stock", 0.36),
                 ("boot.json", "journal_kept_mb", 17.1))
        for name, figure, value in wrong:
            with self.subTest(figure):
                self.write_good()
                self.write(name, json.loads((self.out / name).read_text()) | {figure: value})
                status, said, _ = self.report()
                self.assertEqual(status, 1)
                self.assertEqual(len(said.splitlines()), 1, said)
                self.assertIn(f"{figure} is {value}", said)

    def test_nothing_at_all_is_no_error(self):
        status, said, figures = self.report()
        self.assertEqual((status, set(figures.values())), (0, {None}))
        self.assertEqual(len(said.splitlines()), len(figures))


if __name__ == "__main__":
    unittest.main()
