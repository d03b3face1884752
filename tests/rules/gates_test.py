#!/usr/bin/env python3
"""Each gate names what was written wrong on purpose, and lets pass what is right."""

import contextlib
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import format  # noqa: A004, E402  The check of that name; the folder must be on the path first.
import report  # noqa: E402
import tidy  # noqa: E402
import unused  # noqa: E402
import words  # noqa: E402

REPOSITORY = pathlib.Path(__file__).parents[2]


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        subprocess.run(["git", "init", "-q", self.root], check=True)

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


class Words(Tree):
    def test_refused_in_names_are_named_with_what_to_say(self):
        for name in ("StickSeat", "stick_seat_", "kStrangers", "WardrobeLooks"):
            self.write("drivers/hid/a.cpp", f"int {name} = 0;\n")
            found = list(words.offences(self.root))
            self.assertEqual(len(found), 1, f"{name}: {found}")
            self.assertIn(f"drivers/hid/a.cpp:1: {name}: say ", found[0])

    def test_refused_as_verbs_are_functions_only(self):
        self.write("drivers/hid/a.cpp", "void TakeReport(int);\nvoid Take();\nstruct TakeRecorder {};\nint takes = 0;\n")
        self.assertEqual([line.split(":")[1] for line in words.offences(self.root)], ["1", "2"])

    def test_refused_in_comments_texts_and_pages_are_named(self):
        self.write("drivers/hid/a.cpp", '// A stranger was plugged in.\nconst char* kText = "the witness says";\n')
        self.write("docs/a.md", "When the frame comes to light.\n")
        found = list(words.offences(self.root))
        self.assertEqual(len(found), 3, found)

    def test_refused_in_the_name_of_a_file_are_named(self):
        self.write("drivers/hid/stick_seat.h", "// Nothing.\n")
        self.assertEqual(len(list(words.offences(self.root))), 1)

    def test_refused_in_their_folders_alone_pass_elsewhere(self):
        for path, count in (("drivers/scanout/a.cpp", 1), ("appliance/programs/monitor/a.cpp", 0)):
            with self.subTest(path):
                self.write(path, "int sheet_width = 0;\n")
                self.assertEqual(len([line for line in words.offences(self.root) if line.startswith(path)]), count)

    def test_refused_in_names_of_scripts_are_named_and_their_texts_are_not_taken_for_names(self):
        self.write("tests/a.py", "seat_of = 1\nkind = 'seats'\n")
        self.write("tests/a.sh", "seat=1  # no seat\necho ${#seat} 'a seat'\n")
        self.write("tests/a.mjs", "const seatOf = `seat`;  // a seat\n")
        self.assertEqual(sorted(line.split(": ")[0] for line in words.offences(self.root)), ["tests/a.mjs:1", "tests/a.py:1", "tests/a.sh:1", "tests/a.sh:2"])

    def test_of_the_glossarys_last_column_are_refused_but_for_those_that_it_leaves_to_readers(self):
        patterns = [pattern for pattern, _ in words.NAMES + words.PROSE] + [pattern for _, pattern, _ in words.WITHIN]
        rows = re.findall(r"(?m)^\| .* \| .* \| (.+) \|$", (REPOSITORY / "docs/glossary.md").read_text())
        listed = [word for row in rows if row not in ("not", "---") for word in row.split(", ")]
        self.assertGreater(len(listed), 15)
        for word in listed:
            with self.subTest(word):
                is_refused = any(re.fullmatch(pattern, word) for pattern in patterns)
                self.assertEqual(is_refused, not word.startswith("*"))

    def test_are_refused_in_names_of_files_that_are_plain_in_code(self):
        self.write("drivers/hid/frame_words.cpp", "int words = 0;\n")
        self.assertEqual([line.split(": ")[:2] for line in words.offences(self.root)], [["drivers/hid/frame_words.cpp", "the file's name"]])

    def test_are_refused_in_all_text_files_whatever_their_endings(self):
        for path in ("rootfs/a.conf", "rootfs/a.path", "rootfs/a.mount", "rootfs/a.rules", "rootfs/a.bb", "rootfs/a.yml", "docs/a.svg",
                     "rootfs/a.config", "tests/a.json", "rootfs/a.wks", "firmware/a.S", "tool"):
            with self.subTest(path):
                self.write(path, "# A stranger was plugged in.\n")
                self.assertEqual([line.split(": ")[0] for line in words.offences(self.root) if line.startswith(path)], [f"{path}:1"])

    def test_of_hands_are_refused_but_for_those_of_a_clock_or_a_body_and_for_the_verb(self):
        self.write("a.md", "Hands play it.\nThe layer under hands.\nIt stays in those hands.\n")
        self.assertEqual(len(list(words.offences(self.root))), 3)
        self.write("a.md", "The reader hands it on, and hands over the rest. Eight clock hands.\nThey have both in their hands. On the other hand.\n")
        self.assertEqual(list(words.offences(self.root)), [])

    def test_of_sticks_and_devices_that_are_dead_or_let_in_are_refused_and_other_dead_things_and_letting_pass(self):
        wrong = ("At the box a stick is dead.", "Sticks are dead again.", "It stays dead.", "udev lets sticks in by it.", "The kernel lets in every device.",
                 "What the kernel had let in.", "It lets no USB device in by itself.", "A profile that lets everything in.", "Each bus lets in none.")
        self.write("docs/a.md", "\n".join(wrong))
        self.assertEqual([line.split(":")[1] for line in words.offences(self.root)], [str(number + 1) for number in range(len(wrong))])
        self.write("docs/a.md", "The dial box is dead.\nIts dead zone and dead ends.\nA dead device is opened again.\n*Stop* lets it fade out in a second.\n"
                                "All lines are let go in the end.\nTests let time pass in steps.\nIt lets others in.\nLet it in the end go.\n")
        self.assertEqual(list(words.offences(self.root)), [])

    def test_that_are_plain_pass(self):
        self.write("drivers/hid/a.cpp", '// Takes the newest report; signs and lights as in "handle".\nint device_slot = 0;\n')
        self.assertEqual(list(words.offences(self.root)), [])


class Unused(Tree):
    HEADER = "// A header.\n#pragma once\nint Doubled(int value);\n"

    def setUp(self):
        super().setUp()
        self.write("drivers/base/a.h", self.HEADER)
        self.write("drivers/base/a.cpp", '#include "drivers/base/a.h"\nint Doubled(int value) {\n  return 2 * value;\n}\n')

    def found(self, exempt=()):
        return list(unused.offences(self.root, exempt))

    def test_names_what_only_tests_use(self):
        self.write("tests/drivers/a_test.cpp", "int x = Doubled(2);\n")
        self.assertEqual(self.found(), ["drivers/base/a.h:3: Doubled: only tests use it, or nobody"])

    def test_names_an_accessor_that_only_tests_use(self):
        self.write("drivers/base/b.h", "// A header.\n#pragma once\nclass B {\n public:\n  int triangle_count() const { return 1; }\n"
                                       "  std::size_t bytes() const;\n};\n")
        self.write("drivers/base/b.cpp", "std::size_t B::bytes() const {\n  return Doubled(2);\n}\n")
        self.write("tests/drivers/b_test.cpp", "int x = B().triangle_count() + B().bytes();\n")
        self.assertEqual([line.split(": ")[1] for line in self.found()], ["bytes", "triangle_count"])

    def test_names_an_exemption_that_is_needed_no_longer(self):
        self.assertEqual(self.found({"Doubled": "for tests"}), [])
        self.write("drivers/hid/b.cpp", "int x = Doubled(2);\n")
        self.assertEqual([line.split(": ")[1] for line in self.found({"Doubled": "for tests", "Halved": "is gone"})], ["Doubled", "Halved"])

    def test_does_not_count_comments(self):
        self.write("drivers/hid/b.cpp", "// See Doubled(2).\n")
        self.assertEqual(len(self.found()), 1)

    def test_lets_pass_what_the_product_uses(self):
        self.write("drivers/hid/b.cpp", "int x = Doubled(2);\n")
        self.assertEqual(self.found(), [])


class Format(Tree):
    def setUp(self):
        super().setUp()
        shutil.copy(REPOSITORY / ".clang-format", self.root)

    def test_names_a_source_that_is_not_formatted(self):
        self.write("drivers/a.cpp", "int   x  =  1;\n")
        self.write("drivers/b.cpp", "int x = 1;\n")
        self.assertEqual(list(format.offences(self.root)), ["drivers/a.cpp: is not formatted; ./box format does it"])

    def test_names_a_configuration_that_clang_format_cannot_read(self):
        self.write(".clang-format", "BasedOnStyle: Nobodys\n")
        self.write("drivers/a.cpp", "int   x  =  1;\n")
        found = list(format.offences(self.root))
        self.assertEqual(len(found), 1, found)
        self.assertIn("clang-format ended with 1: ", found[0])

    def test_names_faults_of_scripts_with_and_without_an_ending(self):
        self.write("a.sh", "#!/usr/bin/env bash\nlocal x=$(ls)\n")
        self.write("tool", "#!/usr/bin/env bash\nx=(--a $1)\necho \"${x[@]}\"\n")
        self.write("plain", "#!/bin/sh\nx=$1\nlocal y=1\n")
        self.write("part", "# shellcheck shell=bash\nx=(--a $1)\necho \"${x[@]}\"\n")
        found = "\n".join(format.offences(self.root))
        for file in ("a.sh:2", "tool:2", "plain:3", "part:2"):
            self.assertIn(file, found)

    def test_names_faults_of_python(self):
        self.write("a.py", "import os\n")
        self.assertIn("'os' imported but unused", "\n".join(format.offences(self.root)))


class Tidy(Tree):
    def setUp(self):
        super().setUp()
        shutil.copy(REPOSITORY / ".clang-tidy", self.root)
        (self.root / "build").mkdir()
        (self.root / "build/build.ninja").write_text("")

    def found(self, *files, **options):
        entries = []
        for file in files:
            command = f"/usr/bin/c++ -I{self.root} -DKAORI_NAME='\"{file}\"' -o CMakeFiles/{file}.o -c {self.root}/{file}"
            entries.append({"directory": str(self.root / "build"), "file": f"{self.root}/{file}", "command": command})
        (self.root / "build/compile_commands.json").write_text(json.dumps(entries))
        with contextlib.redirect_stderr(io.StringIO()):
            return tidy.offences(self.root, self.root / "build", **options)

    def test_names_a_warning_until_it_is_mended(self):
        self.write("drivers/a.cpp", "int Nothing(int a) { if (a > 0) return 1; else return 1; }\n")
        for _ in range(2):
            found = self.found("drivers/a.cpp")
            self.assertEqual(len(found), 1, found)
            self.assertTrue(found[0].startswith("drivers/a.cpp:1:"), found)
            self.assertIn("bugprone-branch-clone", found[0])
            self.assertEqual(tidy.count(self.root, self.root / "build"), 1)
        self.write("drivers/a.cpp", "int Nothing(int a) { return a; }\n")
        self.assertIsNone(tidy.count(self.root, self.root / "build"))
        self.assertEqual(self.found("drivers/a.cpp"), [])
        self.assertEqual(tidy.count(self.root, self.root / "build"), 0)
        self.assertEqual(self.found("drivers/a.cpp"), [])

    def test_does_not_pass_what_does_not_compile(self):
        self.write("drivers/a.cpp", "int Broken( {\n")
        self.assertTrue(self.found("drivers/a.cpp"))

    def test_names_a_warning_of_a_header_each_time(self):
        self.write("drivers/a.h", "#pragma once\ninline int Nothing(int a) { if (a > 0) return 1; else return 1; }\n")
        self.write("drivers/a.cpp", '#include "drivers/a.h"\n')
        for _ in range(2):
            found = self.found("drivers/a.cpp")
            self.assertEqual([line.split(":")[0] for line in found], ["drivers/a.h"], found)

    def test_reads_sources_together_that_have_names_in_common(self):
        wrong = "int Nothing(int a) { if (a > 0) return 1; else return 1; }\n"
        self.write("drivers/a.cpp", "namespace {\nint Size() {\n  return 1;\n}\n}  // namespace\nint a = Size();\n")
        self.write("drivers/b.cpp", "namespace {\nint Size() {\n  return 2;\n}\n}  // namespace\nint b = Size();\n" + wrong)
        self.write("drivers/c.cpp", "namespace b { int Of(); }\n" + wrong.replace("Nothing", "Other"))  # A name of b.cpp.
        for name in ("d", "e"):
            self.write(f"drivers/{name}.cpp", f"const char* {name} = KAORI_NAME;\nint main() {{ return *{name}; }}\n")
        found = self.found(*(f"drivers/{name}.cpp" for name in "abcde"))
        self.assertEqual([line.split(":")[0] for line in found], ["drivers/b.cpp", "drivers/c.cpp"], found)

    def test_finds_with_the_analyzer_what_only_it_finds(self):
        self.write("drivers/a.cpp", "int Divide(int by) {\n  if (by == 0) return 1 / by;\n  return by;\n}\n")
        self.assertEqual(self.found("drivers/a.cpp"), [])
        self.assertIn("clang-analyzer-core.DivideZero", "".join(self.found("drivers/a.cpp", analyze=True)))


class Comments(Tree):
    """A product with too few comments is refused, and the folder that lacks them is named."""

    def run_gate(self):
        return subprocess.run([sys.executable, "-B", REPOSITORY / "tests/rules/comments.py", self.root], check=False,
                              capture_output=True, text=True)

    def test_fifteen_of_a_hundred_are_enough(self):
        self.write("render/a.cpp", "// Why.\n" * 3 + "int a;\n" * 17)
        self.assertEqual(self.run_gate().returncode, 0)

    def test_fewer_are_refused_and_tests_do_not_count(self):
        self.write("render/a.cpp", "// Why.\n" * 2 + "int a;\n" * 18)
        self.write("tests/a.cpp", "// Why.\n" * 100)
        found = self.run_gate()
        self.assertEqual(found.returncode, 1)
        self.assertIn("render: 1 lines of comment are missing", found.stdout)


class Report(Tree):
    """Every figure of out/house.json is counted, and none is a constant."""

    def setUp(self):
        super().setUp()
        for name in (".clang-format", ".clang-tidy"):
            shutil.copy(REPOSITORY / name, self.root)
        self.build = self.root / "build"
        self.build.mkdir()
        (self.build / "build.ninja").write_text("")
        (self.build / "compile_commands.json").write_text("[]")
        self.write("drivers/base/a.h", "// A header.\n#pragma once\nint a();\nint b();  // Not a line of comment.\n")

    def test_says_nothing_of_what_was_not_measured(self):
        found = report.figures(self.root, self.build)
        self.assertEqual(found, {"cycles": 0, "refused_words": 0, "unformatted": 0, "tidy_warnings": 0, "comment_percent": 25.0,
                                 "contract_suites": 0, "product_lines": 4, "build_demo_cpu_s": None, "build_test_cpu_s": None,
                                 "build_kernel_cpu_s": None, "build_touched_s": None})

    def test_counts_what_is_wrong_and_what_is_there(self):
        self.write("drivers/base/b.h", '#include "drivers/hid/b.h"\nint seat;\n')
        self.write("drivers/hid/b.h", '#include "drivers/base/b.h"\nint   x;\n')
        self.write("tests/contracts/camera_contract.h", "// A suite.\n")
        self.write("out/build_cpu.json", '{"build_demo_cpu_s": 1.5, "build_test_cpu_s": 2.5, "build_kernel_cpu_s": 3.5, '
                                          '"build_touched_s": 4.5}')
        found = report.figures(self.root, self.build)
        self.assertEqual(found, {"cycles": 1, "refused_words": 1, "unformatted": 1, "tidy_warnings": 0, "comment_percent": 12.5,
                                 "contract_suites": 1, "product_lines": 8, "build_demo_cpu_s": 1.5, "build_test_cpu_s": 2.5,
                                 "build_kernel_cpu_s": 3.5, "build_touched_s": 4.5})


if __name__ == "__main__":
    unittest.main()
