#!/usr/bin/env python3
"""Seeds each wrong include in a tree of its own, and sees the checkers name it."""

import contextlib
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import cycles  # noqa: E402  The folder must be on the path first.
import direction  # noqa: E402
import shape  # noqa: E402
import table  # noqa: E402
import tidy  # noqa: E402
import unused  # noqa: E402
import words  # noqa: E402

HEADER = "// A header that says what it is for.\n#pragma once\n"

# (file, what it includes, a part of the rule that must be named)
AGAINST = (
    ("firmware/wire/a.h", '"drivers/base/result.h"', "firmware/wire/ may include only"),
    ("firmware/wire/a.h", "<vector>", "freestanding"),
    ("firmware/wire/a.cpp", "<unistd.h>", "freestanding"),
    ("firmware/surface/a.h", '"drivers/base/result.h"', "firmware/surface/ may include only"),
    ("firmware/board/a.h", '"drivers/base/result.h"', "firmware/board/ may include only"),
    ("firmware/first/a.cpp", '"drivers/base/result.h"', "firmware/first/ may include only"),
    ("drivers/base/a.h", '"drivers/ports/camera.h"', "drivers/base/ may include only"),
    ("drivers/ports/a.h", '"drivers/decode/keyboard.h"', "drivers/ports/ may include only"),
    ("drivers/hid/a.cpp", '"drivers/gpio/lines.h"', "drivers/hid/ may include only"),
    ("drivers/decode/a.cpp", '"drivers/hid/local_bus.h"', "drivers/decode/ may include only"),
    ("drivers/gpio/a.cpp", '"drivers/hid/local_bus.h"', "drivers/gpio/ may include only"),
    ("drivers/serial/a.cpp", '"drivers/hid/local_bus.h"', "drivers/serial/ may include only"),
    ("drivers/midi/a.cpp", '"drivers/serial/serial_bus.h"', "drivers/midi/ may include only"),
    ("drivers/loader/a.cpp", '"drivers/scanout/kms.h"', "drivers/loader/ may include only"),
    ("drivers/camera/a.cpp", '"drivers/scanout/kms.h"', "drivers/camera/ may include only"),
    ("drivers/audio/a.cpp", '"drivers/camera/v4l2.h"', "drivers/audio/ may include only"),
    ("drivers/scanout/a.cpp", '"render/scene/scene.h"', "drivers/scanout/ may include only"),
    ("drivers/hid/a.cpp", '"appliance/core/board/board.h"', "drivers/hid/ may include only"),
    ("drivers/hid/a.cpp", '"hw-sim/devices/dial_box.h"', "nothing of the product includes hw-sim"),
    ("render/face/a.h", '"render/scene/scene.h"', "render/face/ may include only"),
    ("render/scene/a.h", '"render/gl/shader.h"', "render/scene/ may include only"),
    ("render/image/a.h", '"render/scene/scene.h"', "render/image/ may include only"),
    ("render/gl/a.cpp", '"render/passes/body.h"', "render/gl/ may include only"),
    ("render/passes/a.cpp", '"drivers/ports/scanout.h"', "render/passes/ may include only"),
    ("drivers/web/a.cpp", '"drivers/ports/camera.h"', "drivers/web/ may include only"),
    ("appliance/programs/desk/a.cpp", '"appliance/programs/lips/lip_reader.h"', "appliance/programs/desk/ may include only"),
    ("render/passes/a.cpp", '"drivers/scanout/kms.h"', "render/passes/ may include only"),
    ("render/passes/a.cpp", '"appliance/core/show/show.h"', "render/passes/ may include only"),
    ("appliance/core/board/a.h", '"render/scene/scene.h"', "appliance/core/board/ may include only"),
    ("appliance/core/last_face/a.h", '"appliance/core/board/board.h"', "appliance/core/last_face/ may include only"),
    ("appliance/core/linecheck/a.h", '"appliance/programs/stage/stage.h"', "appliance/core/linecheck/ may include only"),
    ("appliance/core/report/a.h", '"appliance/authoring/takes/take.h"', "appliance/core/report/ may include only"),
    ("appliance/programs/report/a.h", '"appliance/programs/stage/stage.h"', "appliance/programs/report/ may include only"),
    ("appliance/core/showlog/a.h", '"appliance/programs/stage/stage.h"', "appliance/core/showlog/ may include only"),
    ("appliance/core/store/a.h", '"appliance/core/show/pack.h"', "appliance/core/store/ may include only"),
    ("appliance/core/restore/a.h", '"appliance/core/backup/reader.h"', "appliance/core/restore/ may include only"),
    ("appliance/core/backup/a.h", '"appliance/programs/shows/stick.h"', "appliance/core/backup/ may include only"),
    ("appliance/core/update/a.h", '"appliance/core/board/board.h"', "appliance/core/update/ may include only"),
    ("appliance/programs/update/a.h", '"appliance/programs/shows/stick.h"', "appliance/programs/update/ may include only"),
    ("appliance/programs/update/a.cpp", "<zstd.h>", "only appliance/core/update/ includes"),
    ("appliance/core/roles/a.h", '"appliance/core/board/board.h"', "appliance/core/roles/ may include only"),
    ("appliance/core/show/a.h", '"appliance/core/board/board.h"', "appliance/core/show/ may include only"),
    ("appliance/core/performance/a.h", '"drivers/ports/hid_channel.h"', "appliance/core/performance/ may include only"),
    ("appliance/authoring/keys/a.h", '"appliance/programs/input/input.h"', "appliance/authoring/keys/ may include only"),
    ("appliance/authoring/a.h", '"appliance/programs/input/input.h"', "appliance/authoring/ may include only"),
    ("appliance/programs/input/a.h", '"drivers/hid/local_bus.h"', "only a program's main.cpp names a driver"),
    ("render/passes/a.h", '"drivers/decode/dial_box.h"', "render/passes/ may include only"),
    ("appliance/programs/boot/a.h", '"appliance/core/board/board.h"', "appliance/programs/boot/ may include only"),
    ("appliance/programs/data/a.h", '"appliance/programs/boot/boot.h"', "appliance/programs/data/ may include only"),
    ("appliance/programs/shows/a.h", '"appliance/programs/stage/stage.h"', "appliance/programs/shows/ may include only"),
    ("appliance/programs/power/a.h", '"appliance/programs/data/mend.h"', "appliance/programs/power/ may include only"),
    ("appliance/programs/usb/a.h", '"appliance/core/board/board.h"', "appliance/programs/usb/ may include only"),
    ("appliance/programs/fdkeeper/a.h", '"drivers/ports/camera.h"', "appliance/programs/fdkeeper/ may include only"),
    ("appliance/programs/surface/a.h", '"appliance/programs/input/input.h"', "appliance/programs/surface/ may include only"),
    ("appliance/programs/editor/a.h", '"appliance/programs/stage/stage.h"', "appliance/programs/editor/ may include only"),
    ("appliance/programs/monitor/a.h", '"appliance/programs/stage/stage.h"', "appliance/programs/monitor/ may include only"),
    ("appliance/programs/status/a.h", '"appliance/programs/stage/stage.h"', "appliance/programs/status/ may include only"),
    ("appliance/programs/lips/protocol/a.h", '"appliance/programs/lips/lip_reader.h"', "appliance/programs/lips/protocol/ may include only"),
    ("appliance/programs/shows/protocol/a.h", '"appliance/programs/shows/menu.h"', "appliance/programs/shows/protocol/ may include only"),
    ("appliance/programs/lips/a.h", '"appliance/programs/input/input.h"', "appliance/programs/lips/ may include only"),
    ("appliance/programs/stage/a.cpp", '"appliance/programs/input/input.h"', "appliance/programs/stage/ may include only"),
    ("appliance/programs/stage/a.cpp", '"drivers/scanout/kms.h"', "only a program's main.cpp names a driver"),
    ("appliance/programs/stage/main.cpp", '"hw-sim/devices/screen.h"', "nothing of the product includes hw-sim"),
    ("hw-sim/devices/a.cpp", '"drivers/decode/dial_box.h"', "hw-sim/devices/ may include only"),
    ("hw-sim/console/a.cpp", '"appliance/core/show/show.h"', "hw-sim/console/ may include only"),
    ("hw-sim/devices/a.cpp", '"hw-sim/rehearsal/film.h"', "hw-sim/devices/ may include only"),
    ("hw-sim/chip/a.cpp", '"hw-sim/links/usbredir/usb_rig.h"', "hw-sim/chip/ may include only"),
    ("hw-sim/links/a.cpp", '"hw-sim/scenario/player.h"', "hw-sim/links/ may include only"),
    ("hw-sim/scenario/a.cpp", '"hw-sim/console/console.h"', "hw-sim/scenario/ may include only"),
    ("hw-sim/hil/a.cpp", '"hw-sim/rehearsal/film.h"', "hw-sim/hil/ may include only"),
    ("hw-sim/monitor/a.cpp", '"hw-sim/console/console.h"', "hw-sim/monitor/ may include only"),
    ("hw-sim/main.cpp", '"appliance/core/board/board.h"', "hw-sim/main.cpp may include only"),
    ("appliance/programs/stage/a.cpp", '"stage.h"', "starts at the root"),
    ("appliance/programs/stage/a.cpp", '"appliance/programs/stage/../../hw-sim/devices/screen.h"', "starts at the root"),
    ("render/passes/a.cpp", "<GLES3/gl3.h>", "only render/gl/ includes"),
    ("appliance/programs/stage/a.cpp", "<EGL/egl.h>", "only render/gl/ includes"),
    ("appliance/programs/input/a.cpp", "<gpiod.h>", "only drivers/gpio/ includes"),
    ("appliance/programs/input/a.cpp", "<termios.h>", "only drivers/serial/, hw-sim/links/serial/ includes"),
    ("appliance/programs/input/a.cpp", "<libusb-1.0/libusb.h>", "only drivers/hid/ includes"),
    ("appliance/programs/lips/a.cpp", "<linux/videodev2.h>", "only drivers/camera/ includes"),
    ("appliance/programs/stage/a.cpp", "<xf86drmMode.h>", "only drivers/scanout/, render/gl/, appliance/programs/boot/ includes"),
    ("appliance/programs/input/a.cpp", "<alsa/asoundlib.h>", "only drivers/audio/, appliance/programs/desk/ includes"),
    ("appliance/core/toml/a.cpp", '"appliance/core/show/show.h"', "appliance/core/toml/ may include only"),
    ("appliance/core/show/a.cpp", "<toml++/toml.h>", "only appliance/core/toml/value.cpp includes"),
    ("render/face/a.cpp", "<libqhull_r/libqhull_r.h>", "only appliance/authoring/ includes"),
    ("render/gl/a.cpp", "<meshoptimizer.h>", "only appliance/authoring/ includes"),
    ("appliance/programs/stage/a.cpp", "<microhttpd.h>", "only drivers/web/ includes"),
    ("appliance/programs/lips/a.cpp", "<gnutls/x509.h>", "only appliance/programs/desk/ includes"),
    ("appliance/programs/stage/a.cpp", "<nlohmann/json.hpp>", "includes <nlohmann/"),
    ("drivers/decode/stream_deck.cpp", "<turbojpeg.h>", "only drivers/decode/planes.cpp, drivers/web/, appliance/authoring/import/, hw-sim/devices/ includes"),
    ("hw-sim/devices/a.cpp", "<usbredirparser.h>", "only hw-sim/links/ includes"),
)

ALONG = (
    ("drivers/hid/a.cpp", '"firmware/wire/link.h"'),
    ("drivers/hid/a.cpp", '"drivers/hid/descriptor.h"'),
    ("render/gl/a.cpp", "<EGL/egl.h>"),
    ("appliance/programs/stage/main.cpp", '"drivers/scanout/local.h"'),
    ("appliance/core/toml/value.cpp", "<toml++/toml.h>"),
    ("appliance/programs/input/a.h", '"drivers/decode/dial_box.h"'),
    ("hw-sim/rehearsal/a.cpp", '"appliance/programs/stage/stage.h"'),
    ("tests/system/a.cpp", '"hw-sim/rehearsal/film.h"'),
)


@contextlib.contextmanager
def tree(path, text):
    """A tree of one file, in a folder that goes away."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / path
        file.parent.mkdir(parents=True)
        file.write_text(text, encoding="utf-8")
        yield pathlib.Path(folder)


def against_direction(path, text):
    with tree(path, text) as root:
        return list(direction.offences(root))


def against_shape(path, text):
    with tree(path, text) as root:
        return list(shape.offences(root))


class Direction(unittest.TestCase):
    def test_names_file_line_include_and_rule_of_each_wrong_include(self):
        for path, target, rule in AGAINST:
            with self.subTest(path=path, target=target):
                found = against_direction(path, f"{HEADER}\n#include {target}\n")
                self.assertEqual(len(found), 1, found)
                self.assertTrue(found[0].startswith(f"{path}:4: {target[1:-1]}: "), found)
                self.assertIn(rule, found[0])

    def test_lets_pass_what_runs_with_the_direction(self):
        for path, target in ALONG:
            with self.subTest(path=path, target=target):
                self.assertEqual(against_direction(path, f"#include {target}\n"), [])

    def test_sees_an_include_written_with_spaces(self):
        found = against_direction("drivers/base/a.h", '  #  include  "render/gl/x.h"\n')
        self.assertEqual(len(found), 1)

    def test_has_a_seeded_include_for_every_row_of_libraries(self):
        seeded = [target[1:-1] for _, target, _ in AGAINST]
        for beginnings, _ in table.LIBRARIES:
            self.assertTrue(any(target.startswith(beginnings) for target in seeded), beginnings)

    def test_has_a_seeded_include_for_every_room_with_a_limit(self):
        limited = [room for room, allowed in table.MAY_INCLUDE if allowed is not table.EVERYTHING]
        for room in limited:
            self.assertTrue(any(path.startswith(room) for path, _, _ in AGAINST), room)


    def test_does_not_pass_a_folder_without_sources(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertRaises(SystemExit, lambda: list(direction.sources(pathlib.Path(folder))))


class Cycles(unittest.TestCase):
    def circles(self, files):
        with tempfile.TemporaryDirectory() as folder:
            for path, target in files:
                file = pathlib.Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(f'#include "{target}"\n', encoding="utf-8")
            return list(cycles.offences(pathlib.Path(folder)))

    def test_between_folders_are_named_at_every_depth(self):
        self.assertEqual(self.circles([("render/gl/a.h", "drivers/base/a.h"), ("drivers/base/a.h", "render/gl/b.h")]),
                         ["drivers <-> render", "drivers/base <-> render/gl"])
        self.assertEqual(self.circles([("drivers/hid/a.h", "drivers/gpio/a.h"), ("drivers/gpio/b.h", "drivers/hid/a.h")]),
                         ["drivers/gpio <-> drivers/hid"])
        self.assertEqual(self.circles([("appliance/programs/a/x/a.h", "appliance/programs/a/y/a.h"),
                                       ("appliance/programs/a/y/a.h", "appliance/programs/a/z/a.h"),
                                       ("appliance/programs/a/z/a.h", "appliance/programs/a/x/a.h")]),
                         ["appliance/programs/a/x <-> appliance/programs/a/y <-> appliance/programs/a/z"])

    def test_through_the_main_of_a_program_are_none(self):
        self.assertEqual(self.circles([("appliance/programs/lips/main.cpp", "appliance/programs/lips/service/a.h"),
                                       ("appliance/programs/lips/service/a.h", "appliance/programs/lips/b.h")]), [])

    def test_are_not_seen_where_folders_stand_one_above_the_other(self):
        self.assertEqual(self.circles([("render/gl/a.h", "drivers/base/a.h"), ("appliance/core/a.h", "render/gl/a.h")]), [])


class Rooms(unittest.TestCase):
    ROOT = pathlib.Path(__file__).parents[2]

    @classmethod
    def setUpClass(cls):
        cls.paths = [path for path, _ in words.files(cls.ROOT)]

    def gone(self, beginnings):
        """Those that begin the path of no file."""
        return [begin for begin in beginnings if not any(path.startswith(begin) for path in self.paths)]

    def test_of_the_tables_are_all_there(self):
        for name, beginnings in (("MAY_INCLUDE", {room for row in table.MAY_INCLUDE for room in (row[0], *row[1])}),
                                 ("LIBRARIES", {room for _, rooms in table.LIBRARIES for room in rooms}),
                                 ("PURE_ROOMS", table.PURE_ROOMS), ("FREESTANDING_ROOMS", table.FREESTANDING_ROOMS),
                                 ("FOR_TESTS_TOO", table.FOR_TESTS_TOO), ("PRODUCT", unused.PRODUCT),
                                 ("WITHIN", [begin for begin, _, _ in words.WITHIN]), ("EXEMPT", [begin for begin, _, _ in words.EXEMPT]),
                                 ("PARTS", tidy.PARTS)):
            with self.subTest(name):
                self.assertEqual(self.gone(sorted(beginnings)), [])

    def test_that_are_gone_are_named(self):
        self.assertEqual(self.gone(["drivers/decode/", "drivers/decoders/", "docs/needles.", "docs/needle."]), ["drivers/decoders/", "docs/needle."])

    def test_of_bytes_to_values_call_no_system(self):
        for room in table.PURE_ROOMS:
            for header in table.SYSTEM_HEADERS:
                with self.subTest(room=room, header=header):
                    found = against_direction(f"{room}a.cpp", f"#include <array>\n#include <{header}>\n")
                    self.assertEqual(len(found), 1, found)
                    self.assertIn(f"{room}a.cpp:2: {header}: bytes to values, and nothing else", found[0])
        self.assertEqual(against_direction("drivers/hid/a.cpp", "#include <unistd.h>\n"), [])


class Shape(unittest.TestCase):
    def test_lets_a_good_header_pass(self):
        self.assertEqual(against_shape("drivers/base/a.h", HEADER), [])

    def test_names_a_header_that_does_not_say_what_it_is_for(self):
        found = against_shape("drivers/base/a.h", "#pragma once\n")
        self.assertEqual(len(found), 1)
        self.assertIn("drivers/base/a.h: a header says on its first line", found[0])

    def test_lets_a_purpose_run_over_into_the_second_line(self):
        self.assertEqual(against_shape("drivers/base/a.h", "// A header\n// in two lines.\n#pragma once\n"), [])
        self.assertEqual(len(against_shape("drivers/base/a.h", "// A header\n// without\n// end.\n#pragma once\n")), 1)

    def test_names_a_header_without_pragma_once(self):
        found = against_shape("drivers/base/a.h", "// A header.\n#ifndef A\n#endif\n")
        self.assertEqual(found, ["drivers/base/a.h: a header has #pragma once"])

    def test_names_files_of_a_test_that_other_tests_have_too(self):
        for place in ("::testing::TempDir() + ", "std::filesystem::temp_directory_path() /\n    "):
            found = against_shape("tests/drivers/a_test.cpp", f'const auto file = {place}"kaori-starts";\n')
            self.assertEqual(len(found), 1, place)
            self.assertIn("process id", found[0])
            own = f'const auto file = {place}("starts-" + std::to_string(::getpid()));\n'
            self.assertEqual(against_shape("tests/drivers/a_test.cpp", own), [])

    def test_names_an_error_that_is_read_from_errno_after_a_stream(self):
        wrong = 'int A() {\n  std::ifstream file(path);\n  if (!file) return FailErrno("read");\n}\n'
        self.assertEqual(against_shape("hw-sim/a.cpp", wrong),
                         ["hw-sim/a.cpp: line 3: FailErrno after a stream, which leaves no cause in errno; use Fail, or open(2)"])
        self.assertEqual(len(against_shape("hw-sim/a.cpp", 'int A() {\n  if (!std::ofstream(file)) return FailErrno("write");\n}\n')), 1)
        before = '#include <fstream>\nint A() {\n  if (!fd.valid()) return FailErrno("open");\n  std::ifstream file(path);\n}\n'
        other = 'int B() {\n  return FailErrno("open");\n}\n'
        self.assertEqual(against_shape("hw-sim/a.cpp", before + other), [])

    def test_names_a_line_that_is_torn_off_a_comments_sentence(self):
        full = "// " + "It writes every property that the output needs, whatever state it is in. " * 2 + "It does so after its link"
        for torn in ("// failed. `mode` is\n// the blob.\n", "// failed\n//   twice, with an entry\n", "// 14 of\n// them.\n"):
            found = against_shape("render/gl/a.cpp", f"int x = 0;\n{full}\n{torn}")
            self.assertEqual(len(found), 1, (torn, found))
            self.assertTrue(found[0].startswith("render/gl/a.cpp: line 3: a short line in mid-sentence"), found)

    def test_lets_short_lines_pass_that_end_a_sentence_or_an_entry_or_are_a_row(self):
        full = "// " + "It writes every property that the output needs, whatever state it is in. " * 2
        for right in (full + "It does\n// so.\n// Then it ends.\n", full.strip() + "\n// And so\n// it ends.\n", full + "It does\n// so\nint x = 0;\n",
                      "//   name    " + full[3:] + "it\n//           says\n//   other   it was none\n",
                      "//   0  u8   " + full[3:] + "it\n//   1  u8   0\n//   2  u16  the rest\n"):
            self.assertEqual(against_shape("render/gl/a.cpp", right), [], right)

    def test_names_a_file_that_is_too_long(self):
        found = against_shape("render/gl/a.cpp", "\n" * 301)
        self.assertEqual(len(found), 1)
        self.assertIn("301 lines", found[0])
        self.assertEqual(against_shape("render/gl/a.cpp", "\n" * 300), [])


if __name__ == "__main__":
    unittest.main()
