#!/usr/bin/env python3
"""The figures of a company's box come from where they were measured, and what was not is named: company_report_test.py"""

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

    def report(self):
        """What it says, and the file that it leaves."""
        said = subprocess.run([REPORT, self.out], capture_output=True, text=True, check=True).stdout
        return said, json.loads((self.out / "company.json").read_text())

    def test_of_a_figure_that_two_measured_the_boxs_counts(self):
        self.write("boot.json", {"support_file_kb": 12.5, "secure_boot_cases_failed": 0})
        self.write("company.json", {"shows_installed": 1, "support_file_kb": 99, "another": 5})
        _, figures = self.report()
        self.assertEqual((figures["support_file_kb"], figures["secure_boot_cases_failed"], figures["shows_installed"]), (12.5, 0, 1))
        self.assertEqual(figures["another"], 5, "others' figures stay")

    def test_what_was_not_measured_is_named_and_not_made_up(self):
        self.write("image.json", {"sbom_files_unmatched": 0})
        self.write("backup.json", {"restore_differs": 0})
        said, figures = self.report()
        self.assertEqual((figures["sbom_files_unmatched"], figures["restore_differs"]), (0, 0))
        self.assertIsNone(figures["clone_minutes"])
        missing = said.splitlines()[-1]
        self.assertIn("clone_minutes", missing)
        self.assertNotIn("restore_differs", missing)

    def test_nothing_at_all_is_no_error(self):
        said, figures = self.report()
        self.assertEqual(set(figures.values()), {None})
        self.assertTrue(said.startswith("not measured: "))


if __name__ == "__main__":
    unittest.main()
