#!/usr/bin/env python3
"""What images for several processors have in common, and where they differ: architectures_test.py REPOSITORY"""

import sys
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))
sys.dont_write_bytecode = True
sys.path.insert(0, str(REPOSITORY / "rootfs/image"))
import architectures  # noqa: E402  The image's own.


class Architectures(unittest.TestCase):
    """One builder for all processors: what differs is in a row of a table and in two files."""

    IMAGE = REPOSITORY / "rootfs/image"

    def test_each_has_its_own_settings_of_the_kernel_and_its_own_files_of_debians(self):
        common = set(self.settings("box"))
        for name in architectures.NAMED:
            self.assertTrue((self.IMAGE / f"keep-{name}.txt").is_file())
            self.assertGreater(len(self.settings(name)), 5)
            twice = common & {line for line in self.settings(name) if line.endswith("=y")}
            self.assertEqual(twice, set(), "what all have stands in box.config alone")

    def test_what_all_of_them_have_names_none(self):
        self.assertFalse([line for line in self.settings("box") if line.startswith(("CONFIG_X86", "CONFIG_ARM"))])
        self.assertNotIn("x86_64", (self.IMAGE / "keep.txt").read_text())

    def test_a_tool_is_the_cross_compilers_where_files_are_another_processors(self):
        names = [arch.tool("objcopy") for arch in architectures.NAMED.values()]
        self.assertEqual(names, ["objcopy", "aarch64-linux-gnu-objcopy"])

    def settings(self, name):
        lines = (self.IMAGE / f"kernel/{name}.config").read_text().splitlines()
        return [line for line in lines if line.startswith("CONFIG_")]


if __name__ == "__main__":
    unittest.main()
