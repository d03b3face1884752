#!/usr/bin/env python3
"""What the box's units say to systemd: units_test.py REPOSITORY"""

import re
import sys
import unittest
from pathlib import Path

ROOTFS = Path(sys.argv.pop(1)) / "rootfs"
UNITS = ROOTFS / "overlay/usr/lib/systemd/system"


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


class Programs(unittest.TestCase):
    """What units and udev's rules start is in the image: a rule whose program is missing keeps every device out."""

    @staticmethod
    def started():
        texts = [file.read_text() for file in (ROOTFS / "overlay").rglob("*") if file.is_file() and file.suffix in (".service", ".rules")]
        return {name for text in texts for name in re.findall(r"/usr/bin/kaori-([a-z]+)", text)}

    def test_all_that_are_started_are_in_the_image(self):
        there = re.search(r"^readonly ON_BOX=.*kaori-\{([a-z,]+)\}", (ROOTFS / "image/build").read_text(), re.M)[1].split(",")
        self.assertGreater(len(self.started()), 10)
        self.assertEqual(self.started() - set(there), set())


class Waiting(unittest.TestCase):
    """systemd starts what is ordered after a unit when that has started, or its job is given up, and no sooner."""

    def test_nobody_waits_long_for_a_stage_that_hangs_in_its_start(self):
        waits = [unit.name for unit in UNITS.glob("*.service") if re.search(r"^After=.*kaori-stage", unit.read_text(), re.M)]
        self.assertIn("kaori-input.service", waits)
        given_up = re.search(r"^JobRunningTimeoutSec=(\d+)s$", (UNITS / "kaori-stage.service").read_text(), re.M)
        self.assertIsNotNone(given_up)
        self.assertLessEqual(int(given_up[1]), 30)

    def test_a_path_unit_does_not_start_what_fails_without_end(self):
        for path in UNITS.glob("*.path"):
            text = (UNITS / f"{path.stem}.service").read_text()
            ends = "RemainAfterExit=yes" in text and "ExecStart=-" in text and not re.search(r"^(Requires|BindsTo|RequiresMountsFor)=", text, re.M)
            restarts = re.search(r"^Restart=", text, re.M) is not None
            self.assertTrue(ends or restarts, f"{path.name} starts {path.stem}.service again as long as its file is there")


if __name__ == "__main__":
    unittest.main()
