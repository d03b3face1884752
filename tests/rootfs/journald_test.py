#!/usr/bin/env python3
"""The journal of a box is bounded, in memory and on its disk, and so is what one program may say: journald_test.py JOURNALD.CONF

The room that the journal takes on the disk is measured on the bench (check "journal"), against the same 16 MiB."""

import configparser
import sys
import unittest
from pathlib import Path

FILE = Path(sys.argv[1])
UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20, "G": 1 << 30}  # journald.conf(5).
MOST_ON_DISK, MOST_IN_MEMORY = 16 << 20, 4 << 20
LEAST_FREE = 16 << 20  # For what the box keeps besides: without it a full journal would have no room for a setting.
LEAST_FILES = 4  # The oldest file goes first, so that of a ring of fewer ones a large part is lost at once.
MOST_BURST = 1000  # Lines of one program in RateLimitIntervalSec=, 30 s where nothing else is said.
MOST_LOST_S = 15  # By a power cut, of lines that are no worse than errors.


def settings():
    parser = configparser.ConfigParser(interpolation=None, strict=True)
    parser.optionxform = str  # Names keep their capitals.
    parser.read_string(FILE.read_text())
    return parser["Journal"]


def bytes_of(text):
    return int(text.rstrip("KMG")) * UNITS[text.lstrip("0123456789")]


class Journal(unittest.TestCase):
    def test_is_a_bounded_ring_on_the_disk(self):
        most = bytes_of(settings()["SystemMaxUse"])
        self.assertLessEqual(most, MOST_ON_DISK)
        self.assertLessEqual(bytes_of(settings()["SystemMaxFileSize"]) * LEAST_FILES, most)
        self.assertGreaterEqual(bytes_of(settings()["SystemKeepFree"]), LEAST_FREE)

    def test_is_bounded_in_memory_where_there_is_no_disk(self):
        self.assertEqual(settings()["Storage"], "auto")
        self.assertLessEqual(bytes_of(settings()["RuntimeMaxUse"]), MOST_IN_MEMORY)

    def test_hears_no_program_without_end(self):
        self.assertTrue(1 <= int(settings()["RateLimitBurst"]) <= MOST_BURST, "0 would switch the limit off")
        self.assertNotEqual(settings().get("RateLimitIntervalSec", "30s"), "0")

    def test_is_written_before_a_power_cut_takes_much(self):
        self.assertLessEqual(int(settings()["SyncIntervalSec"].removesuffix("s")), MOST_LOST_S)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
