#!/usr/bin/env python3
"""Every section of the board and every program stand in the page of the architecture and in its picture, with writers, readers and rate."""

import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import board_users  # noqa: E402  The folder must be on the path first.

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


def programs_of_no_image(root=ROOT):
    """What the project builds besides: tools, the simulator, the bench."""
    files = [file for room in ("appliance", "hw-sim", "tests") for file in (root / room).rglob("CMakeLists.txt")]
    found = {name for file in files for name in re.findall(r"kaori_program\(\s*(kaori-\S+)", file.read_text(encoding="utf-8"))}
    return (found | TOOLS) - NOT_INSTALLED_BY_CMAKE


def rows(page):
    """Section -> its row's cells behind the name: writer, how often, readers, what."""
    found = {}
    for line in re.findall(r"(?m)^\| `[a-z_]+`.*$", page.split("## The board")[1]):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        for name in re.findall(r"`([a-z_]+)`", cells[0]):
            found[name] = cells[1:]
    return found


def wrong_rows(page, root=ROOT):
    """Lines "section: what is wrong" of the page's rows, by the code and by the comments of the sections."""
    used = board_users.users(root)
    names = {program.removeprefix("kaori-") for program in programs(root)}
    comments, table = board_users.commented(root, names), rows(page)
    for section, (writers, readers) in sorted(used.items()):
        writer, rate, reader = (*table.get(section, ()), "", "", "")[:3]
        for place, (said_writers, said_readers) in (("comment", comments[section][:2]),
                                                    ("row", (board_users.named(writer, names), board_users.named(reader, names)))):
            if said_writers != writers:
                yield f"{section}: its {place} has the writers {sorted(said_writers)}; the code has {sorted(writers)}"
            if said_readers != readers:
                yield f"{section}: its {place} has the readers {sorted(said_readers)}; the code has {sorted(readers)}"
        if len(rate.split()) < 2 or rate not in comments[section][2]:
            yield f"{section}: its row says \"{rate}\"; its comment says {comments[section][2]}"


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

    def test_every_section_has_its_writers_readers_and_rate(self):
        self.assertEqual(list(wrong_rows(self.page)), [])

    def test_a_reader_too_many_and_one_too_few_are_named_and_so_are_a_wrong_writer_and_rate(self):
        row = next(line for line in self.page.split("\n") if line.startswith("| `lips_guide`"))
        for wrong, said in ((row.replace("| stage, shows", "| stage, status, shows"), "readers"), (row.replace("stage, ", ""), "readers"),
                            (row.replace("kaori-lips", "kaori-input"), "writers"), (row.replace("every 25 ms", "every 50 ms"), "every 50 ms")):
            found = list(wrong_rows(self.page.replace(row, wrong)))
            self.assertEqual(len(found), 1, found)
            self.assertTrue(found[0].startswith("lips_guide: ") and said in found[0], found)

    def test_readers_are_found_through_snapshots_the_status_and_functions_of_the_board(self):
        used = board_users.users(ROOT)
        self.assertIn("desk", used["sound"][1], "by status::Look")
        self.assertIn("update", used["stage_status"][1], "by PaceByBoardAt")
        self.assertIn("power", used["lines"][1], "by IsServiceKeyOnAt")
        self.assertIn("stage", used["voice"][1], "by a snapshot")
        self.assertNotIn("lips", used["pointer"][1], "its snapshots are not looked at for that")

    def test_names_who_looks_after_the_board_and_no_other(self):
        after = {program for program in programs()
                 if re.search(r"\bboard::Watch\(", board_users.text_of(ROOT / "appliance/programs" / program.removeprefix("kaori-")))}
        said = re.search(r"Four times a second (.*?) look whether", self.page, re.DOTALL)
        self.assertEqual(set(re.findall(r"kaori-\w+", said[1])), after)

    def test_names_every_program_that_is_in_no_image(self):
        said = re.search(r"In no box's image: (.*?)\n\n", self.page, re.DOTALL)
        self.assertEqual(set(re.findall(r"`(kaori-[\w-]+)`", said[1])), programs_of_no_image())

    def test_the_picture_shows_all_of_them(self):
        self.assertEqual([name for name in sorted(sections() | programs()) if not in_picture(self.picture, name)], [])

    def test_a_name_within_another_one_is_not_taken_for_it(self):
        self.assertFalse(in_table("| `kaori-shows-more` | |\n", "kaori-shows"))
        self.assertFalse(in_picture('<text x="1">lips_guide</text>', "lips"))
        self.assertTrue(in_picture('<text x="1">lips, sticks [2]</text>', "stick"))


if __name__ == "__main__":
    unittest.main()
