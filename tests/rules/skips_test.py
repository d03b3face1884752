#!/usr/bin/env python3
"""A test that a build machine skips without a reason is named: by what ctest itself writes of tests that pass, fail and skip."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))
import skips  # noqa: E402  The folder must be on the path first.

# As CMake writes it: a return code and a line of output that mean a skip.
TESTS = """
add_test("passes" "/bin/true")
add_test("fails" "/bin/false")
add_test("wants a browser" "/bin/sh" "-c" "exit 77")
set_tests_properties("wants a browser" PROPERTIES SKIP_RETURN_CODE 77)
add_test("wants a kernel" "/bin/echo" "[  SKIPPED ]")
set_tests_properties("wants a kernel" PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED")
add_test("contracts:Buses/BusContract.HasNone/Dials  # GetParam() = 8-byte object <43-F4>" "/bin/sh" "-c" "exit 77")
set_tests_properties("contracts:Buses/BusContract.HasNone/Dials  # GetParam() = 8-byte object <43-F4>" PROPERTIES SKIP_RETURN_CODE 77)
add_test("is switched off" "/bin/true")
set_tests_properties("is switched off" PROPERTIES DISABLED TRUE)
"""


class Skips(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.results = pathlib.Path(folder.name, "results.xml")
        pathlib.Path(folder.name, "CTestTestfile.cmake").write_text(TESTS, encoding="utf-8")
        subprocess.run(["ctest", "--output-junit", self.results], cwd=folder.name, capture_output=True, check=False)

    def test_without_a_reason_are_named_in_whatever_way_they_were_skipped(self):
        self.assertEqual([line.split(": ")[0] for line in skips.offences(self.results, ())], ["wants a browser", "wants a kernel", "contracts:Buses/BusContract.HasNone/Dials"])

    def test_on_the_list_pass_by_their_whole_names(self):
        found = list(skips.offences(self.results, ((r"wants a brow", "half a name"), (r"wants a k.*", "there is none"), (r"contracts:.*/Dials", "GoogleTest's parameter behind it does not count"))))
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith("wants a browser: was skipped"), found)

    def test_of_browsers_and_chips_are_on_no_list(self):
        self.assertFalse([pattern for pattern, _ in skips.ALLOWED if skips.re.fullmatch(pattern, "system:in Chromium")])


if __name__ == "__main__":
    unittest.main()
