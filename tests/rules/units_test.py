#!/usr/bin/env python3
"""What the box's units say to systemd: units_test.py REPOSITORY"""

import re
import sys
import unittest
from pathlib import Path

UNITS = Path(sys.argv.pop(1)) / "rootfs/overlay/usr/lib/systemd/system"


def starts_again_at_once(unit):
    """Whether the text of a unit says so; systemd's own pause is 100 ms where it says nothing (systemd.service(5))."""
    return re.search(r"^RestartSec=0+(\.0*)?(us|ms|s|sec|min)?\s*$", unit, re.M) is not None


class Restarts(unittest.TestCase):
    """Without a pause the next start of a program that fails at each start is queued before systemd starts anything that is
    ordered after it: a stage that could read no show once kept udev and the try of the other system from starting at all."""

    def test_no_unit_starts_again_without_a_pause(self):
        units = sorted(UNITS.glob("*.service"))
        self.assertGreater(len(units), 10)
        self.assertEqual([unit.name for unit in units if starts_again_at_once(unit.read_text())], [])

    def test_a_unit_without_a_pause_is_seen(self):
        for pause in ("0", "0s", "0ms", "0.0"):
            self.assertTrue(starts_again_at_once(f"[Service]\nRestart=always\nRestartSec={pause}\n"))
        for pause in ("20ms", "0.5", "10"):
            self.assertFalse(starts_again_at_once(f"[Service]\nRestart=always\nRestartSec={pause}\n"))


if __name__ == "__main__":
    unittest.main()
