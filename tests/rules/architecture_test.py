#!/usr/bin/env python3
"""Every section of the board and every program of the box stand in the page of the architecture and in its picture."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Sections of the same kind, by the one name of both.
SAME = {"stick left": "stick", "stick right": "stick", "calls of input": "calls", "calls of control": "calls"}
# Built and put into an image by its builder, where the system has two slots.
NOT_INSTALLED_BY_CMAKE = {"kaori-update"}
# Of what CMake installs, what is never on the box.
TOOLS = {"kaori-atelier"}


def sections(root=ROOT):
    """The names in appliance/core/board/layout.h, those of a kind once."""
    names = re.findall(r'\{"([a-z_ ]+)", ValueWords<', (root / "appliance/core/board/layout.h").read_text(encoding="utf-8"))
    return {SAME.get(name, name) for name in names}


def programs(root=ROOT):
    files = (root / "appliance").rglob("CMakeLists.txt")
    found = {name for file in files for name in re.findall(r"kaori_installed_program\(\s*(\S+)", file.read_text(encoding="utf-8"))}
    return (found | NOT_INSTALLED_BY_CMAKE) - TOOLS


def in_table(page, name):
    """Whether a row of a table of the page begins with it, perhaps beside others of its kind."""
    return re.search(rf"(?m)^\|[^|]*`{re.escape(name)}`[^|]*\|", page) is not None


def in_picture(picture, name):
    """Whether a text of the picture has it as a word; a text may say its plural."""
    return any(re.search(rf"(?<![\w-]){re.escape(name)}s?(?![\w-])", text) for text in re.findall(r"<text[^>]*>([^<]*)</text>", picture))


class Architecture(unittest.TestCase):
    def setUp(self):
        self.page = (ROOT / "docs/architecture.md").read_text(encoding="utf-8")
        self.picture = (ROOT / "docs/architecture.svg").read_text(encoding="utf-8")

    def test_has_names_to_look_for(self):
        self.assertLessEqual({"surface", "stick", "midi_heard", "shows_menu", "performance"}, sections())
        self.assertGreaterEqual(len(sections()), 20)
        self.assertLessEqual({"kaori-stage", "kaori-shows", "kaori-usb", "kaori-update"}, programs())

    def test_every_section_of_the_board_has_its_row(self):
        self.assertEqual([name for name in sorted(sections()) if not in_table(self.page, name)], [])

    def test_every_program_has_its_row(self):
        self.assertEqual([name for name in sorted(programs()) if not in_table(self.page, name)], [])

    def test_the_picture_shows_all_of_them(self):
        self.assertEqual([name for name in sorted(sections() | programs()) if not in_picture(self.picture, name)], [])

    def test_a_name_within_another_one_is_not_taken_for_it(self):
        self.assertFalse(in_table("| `kaori-shows-more` | |\n", "kaori-shows"))
        self.assertFalse(in_picture('<text x="1">lips_guide</text>', "lips"))
        self.assertTrue(in_picture('<text x="1">lips, sticks [2]</text>', "stick"))


if __name__ == "__main__":
    unittest.main()
