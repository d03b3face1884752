#!/usr/bin/env python3
"""guide.py names each fault of a guide that was written wrong on purpose, and none of a right one."""

import pathlib
import tempfile
import unittest

import guide

ATELIER = """#!/bin/sh
[ "$1" = pack ] || exit 2
echo "kaori-atelier pack FOLDER FILE [--sign KEYFILE] [--quick]: build the show"
"""
BOX = """#!/bin/sh
echo "  ./box demo [--port N]   play"
echo "            [--hz 60]"
echo "  ./box sheet [FOLDER]    pictures"
"""


class Guide(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "docs/guide/pictures").mkdir(parents=True)
        for name, text in (("kaori-atelier", ATELIER), ("box", BOX)):
            (self.root / name).write_text(text, encoding="utf-8")
            (self.root / name).chmod(0o755)
        guide.help_of.cache_clear()

    def faults(self, text):
        (self.root / "docs/guide/page.md").write_text(text, encoding="utf-8")
        return list(guide.offences(self.root, self.root))

    def test_a_right_page_has_no_fault(self):
        (self.root / "docs/guide/pictures/a.jpg").write_bytes(b"a")
        text = "![a](pictures/a.jpg)\n\n    kaori-atelier pack in out --sign key\n    ./box demo --hz 30\n`kaori-atelier pack`"
        self.assertEqual(self.faults(text), [])

    def test_each_wrong_thing_is_named_with_its_line(self):
        wrong = {
            "    kaori-atelier bake in out": "no verb bake",
            "    kaori-atelier pack in": "1 words where 2 are wanted",
            "    kaori-atelier pack in out more": "3 words where 2 are wanted",
            "    kaori-atelier pack in out --sing key": "no option --sing",
            "    kaori-atelier pack in out --sign": "--sign wants a value",
            "    ./box fly": "knows no fly",
            "    ./box sheet --hz 3": "has no --hz",
            "see [this](nothing.md)": "nothing.md is not there",
            "![this](pictures/none.jpg)": "none.jpg is not there",
        }
        for line, fault in wrong.items():
            found = self.faults("first\n" + line)
            self.assertTrue(found, line)
            self.assertIn("docs/guide/page.md:2: ", found[0])
            self.assertIn(fault, found[0])

    def test_pictures_that_no_page_shows_or_that_are_large_are_named(self):
        (self.root / "docs/guide/pictures/a.jpg").write_bytes(b"a" * (guide.MOST_PICTURES_BYTES + 1))
        found = self.faults("nothing")
        self.assertEqual(len(found), 2, found)


if __name__ == "__main__":
    unittest.main()
