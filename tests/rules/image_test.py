#!/usr/bin/env python3
"""What the image's builder refuses, in one line, before it has built anything: image_test.py REPOSITORY"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))


def refusal(*command):
    """What a program says as it gives up; it has to say it in one line."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    assert done.returncode != 0, f"{command} was not refused"
    assert done.stderr.count("\n") == 1, done.stderr
    return done.stderr.strip()


class Image(unittest.TestCase):
    def test_a_disk_without_room_for_data_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            said = refusal(REPOSITORY / "rootfs/image/pack.py", folder, folder, f"{folder}/report.json", 800)
            self.assertEqual(said, "image: a disk of 800 MiB has no room for data; 866 are needed")
            self.assertEqual(list(Path(folder).iterdir()), [])

    def test_options_that_make_no_sense_are_named(self):
        build = REPOSITORY / "rootfs/image/build"
        with tempfile.TemporaryDirectory() as folder:
            show = Path(folder) / "a.kaori"
            show.touch()
            usual = ("--out", f"{folder}/out", "--programs", folder, "--pack", show)
            self.assertIn("--disk many", refusal(build, *usual, "--disk", "many"))
            self.assertIn("there is no option --dusk", refusal(build, "--dusk", 1))
            self.assertIn("--out wants a value", refusal(build, "--out"))
            self.assertIn("there is no show at", refusal(build, *usual[:4], "--pack", f"{folder}/none"))


if __name__ == "__main__":
    unittest.main()
