#!/usr/bin/env python3
"""What an image for a board refuses, and how its disk is laid out, with files of other content in place of the firmware's:
boards_test.py REPOSITORY"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))
sys.dont_write_bytecode = True
sys.path.insert(0, str(REPOSITORY / "rootfs/image"))
import boards  # noqa: E402  The image's own, all of these.
import fat  # noqa: E402
import first_picture  # noqa: E402
import pack  # noqa: E402
import pi_boot  # noqa: E402
import sbom  # noqa: E402
import sizes  # noqa: E402

PI = boards.NAMED["rpi4"]
FILES = {"start4.elf": b"started" * 9000, "fixup4.dat": b"mended" * 700, "LICENCE.broadcom": b"for Raspberry Pis alone\n"}
KERNEL, TREE = b"a kernel" * 300_000, b"a device tree" * 3000
LINES = {"a": "root=a rauc.slot=A\n", "b": "root=b rauc.slot=B\n"}


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder, self.firmware = Path(folder.name), Path(folder.name) / "firmware"
        self.firmware.mkdir()
        for name, content in FILES.items():
            (self.firmware / name).write_bytes(content)
        os.environ["SOURCE_DATE_EPOCH"] = "1767225600"


class Refusals(WithFolder):
    """One line that names what is missing, whose it is, and its licence."""

    def refusal(self, *words):
        build = REPOSITORY / "rootfs/image/build"
        done = subprocess.run([build, "--out", self.folder / "out", "--programs", self.folder, *words], capture_output=True, text=True,
                              check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        return done.stderr

    def of_pi(self, *words):
        return self.refusal("--arch", "arm64", "--board", "rpi4", *words)

    def test_without_the_firmware_no_image_is_built_and_it_is_said_whose_that_is(self):
        said = self.of_pi()
        for word in ("--board rpi4 wants --board-firmware FOLDER", "start4.elf and fixup4.dat", "not ours and go on no image without",
                     "LICENCE.broadcom", "github.com/raspberrypi/firmware"):
            self.assertIn(word, said)

    def test_a_folder_that_lacks_a_file_is_named_with_it(self):
        for name in FILES:
            (self.firmware / name).rename(self.folder / name)
            self.assertIn(f"{self.firmware} has no {name}; the Raspberry Pi 4", self.of_pi("--board-firmware", self.firmware))
            (self.folder / name).rename(self.firmware / name)
        (self.firmware / "fixup4.dat").write_bytes(b"")
        self.assertIn(f"{self.firmware}/fixup4.dat is empty", self.of_pi("--board-firmware", self.firmware))
        self.assertIn(f"there is no folder {self.folder}/none", self.of_pi("--board-firmware", self.folder / "none"))

    def test_options_that_do_not_go_together_are_named(self):
        given = ("--board-firmware", self.firmware)
        self.assertIn("there is no board rpi9; expected rpi4", self.refusal("--arch", "arm64", "--board", "rpi9", *given))
        self.assertIn("--board rpi4 wants --arch arm64, not amd64", self.refusal("--board", "rpi4", *given))
        self.assertIn("--board-firmware wants --board", self.refusal(*given))
        self.assertIn("--secure-boot is for machines with UEFI", self.of_pi(*given, "--secure-boot", self.folder))

    def test_a_kernel_that_outgrows_its_slot_is_refused(self):
        folder = self.folder / "slot"
        folder.mkdir()
        (folder / "kernel.img").write_bytes(b"")
        self.assertIsNone(pi_boot.room_fault(folder))
        os.truncate(folder / "kernel.img", 24 << 20)
        self.assertIn("a slot has room for", pi_boot.room_fault(folder))


class Autoboot(unittest.TestCase):
    def test_names_a_partition_for_each_slot_and_the_other_one_for_a_try(self):
        self.assertEqual(pi_boot.autoboot("a"), "[all]\ntryboot_a_b=1\nboot_partition=2\n[tryboot]\nboot_partition=3\n")
        self.assertEqual(pi_boot.autoboot("b"), "[all]\ntryboot_a_b=1\nboot_partition=3\n[tryboot]\nboot_partition=2\n")
        self.assertLessEqual(len(pi_boot.autoboot("a")), 512)

    def test_is_what_the_box_expects_to_find(self):
        source = (REPOSITORY / "drivers/loader/tryboot.cpp").read_text()
        first, second = re.findall(r'"((?:\\n)?\[[a-z]+\]\\n[^"]*boot_partition=)"', source)
        header = (REPOSITORY / "drivers/loader/tryboot.h").read_text()
        a, b = re.search(r"kPartitionOfA = '(\d)', kPartitionOfB = '(\d)'", header).groups()
        self.assertEqual(pi_boot.autoboot("a"), f"{first}{a}{second}{b}\n".replace("\\n", "\n"))

    def test_a_slots_partition_is_as_large_as_the_box_takes_it(self):
        header = (REPOSITORY / "drivers/loader/boot_partition.h").read_text()
        self.assertIn(f"kKernel_bytes = std::uint64_t{{{pi_boot.SLOT_MIB}}} << 20U", header)


@unittest.skipUnless(all(map(shutil.which, ("mkfs.vfat", "mcopy", "sgdisk"))), "dosfstools, mtools or gdisk is not there")
class Disk(WithFolder):
    """The partitions that the firmware reads, and the table in which it counts them."""

    def setUp(self):
        super().setUp()
        (self.folder / "Image").write_bytes(KERNEL)
        (self.folder / pi_boot.TREE).write_bytes(TREE)

    def made(self):
        return pi_boot.make(self.folder, PI, self.firmware, self.folder / "Image", LINES)

    def content(self, image, name):
        return subprocess.run(["mtype", "-i", image, f"::/{name}"], capture_output=True, check=True).stdout

    def test_each_slot_has_the_firmware_the_kernel_and_its_own_command_line(self):
        made = self.made()
        for slot in pi_boot.SLOTS:
            image = made[f"boot-{slot}"]
            self.assertEqual(image.stat().st_size, 24 << 20)
            for name, content in (*FILES.items(), ("kernel.img", KERNEL), ("bcm2711-rpi-4-b.dtb", TREE), ("cmdline.txt", LINES[slot].encode())):
                self.assertEqual(self.content(image, name), content, name)
            config = self.content(image, "config.txt").decode().splitlines()
            self.assertIn("kernel=kernel.img", config)
            self.assertIn("arm_64bit=1", config)
            self.assertLessEqual(max(map(len, config)), 98, "the firmware reads no more of a line")

    def test_slot_a_starts_by_itself_by_one_sector(self):
        image = self.made()["boot"]
        with open(image, "rb") as file:
            sectors, size = fat.find(file, "AUTOBOOT.TXT")
        self.assertEqual(len(sectors), 1)
        self.assertEqual(image.read_bytes()[sectors[0] * 512:][:size].decode(), pi_boot.autoboot("a"))

    def test_the_kernel_of_a_board_keeps_memory_for_pictures_and_that_of_a_pc_does_not(self):
        with tempfile.NamedTemporaryFile() as root:
            root.write(bytes(pack.BLOCK))
            root.flush()
            board, pc = (pack.command_line(Path(root.name), "ab12", "a", board=name).split() for name in ("rpi4", None))
        self.assertEqual(set(board) ^ set(pc), {"cma=256M"})

    def test_made_again_is_the_same(self):
        first = {name: path.read_bytes() for name, path in self.made().items()}
        self.assertEqual({name: path.read_bytes() for name, path in self.made().items()}, first)

    def test_the_table_has_the_firmwares_partitions_first_and_by_their_numbers(self):
        layout = pack.laid_out(None, PI)
        self.assertEqual([name for name, _, _, _ in layout],
                         ["boot", "boot-a", "boot-b", "root-a", "verity-a", "root-b", "verity-b", "data"])
        self.assertEqual(len({uuid for _, _, _, uuid in layout}), len(layout))
        pack.write_disk(self.folder, layout, self.made())
        shown = subprocess.run(["sgdisk", "-p", self.folder / "kaori.disk"], capture_output=True, text=True, check=True).stdout
        rows = [line.split() for line in shown.splitlines() if re.match(r" +\d+ ", line)]
        self.assertEqual([(row[0], row[5], row[6]) for row in rows[:4]],
                         [("1", "0700", "boot"), ("2", "0700", "boot-a"), ("3", "0700", "boot-b"), ("4", "8304", "root-a")])
        first = int(rows[2][1]) * 512
        with open(self.folder / "kaori.disk", "rb") as disk:
            disk.seek(first)
            self.assertEqual(disk.read(24 << 20), (self.folder / "boot-b.vfat").read_bytes())

    def test_a_pc_has_the_layout_that_it_had(self):
        self.assertEqual(pack.laid_out(None), pack.LAYOUT)

    def test_the_data_get_what_the_others_leave(self):
        others = sum(size for name, size, _, _ in pack.laid_out(None, PI) if name != "data")
        self.assertEqual(dict((name, size) for name, size, _, _ in pack.laid_out(2000, PI))["data"], 2000 - 2 - others)


class Listed(WithFolder):
    """Whose each file of an image for a board is."""

    def owners(self, *paths):
        places = sbom.Places(None, self.folder / "image", None, None, (), None, None, PI, self.folder / "mesa")
        return [sbom.owner_on_board(places, path) for path in paths]

    def test_what_the_firmware_reads_is_the_makers_ours_or_made(self):
        self.assertEqual(self.owners("boot/a/start4.elf", "boot/b/LICENCE.broadcom", "boot/a/config.txt", "boot/chooser/autoboot.txt",
                                     "boot/a/kernel.img", "boot/b/bcm2711-rpi-4-b.dtb", "boot/a/start.elf"),
                         ["board-firmware", "board-firmware", "own", "own", "made", "made", None])

    def test_mesa_is_that_which_was_built(self):
        driver = "usr/lib/aarch64-linux-gnu/dri/v3d_dri.so"
        for place, content in (("mesa/root", "v3d"), ("image/root", "v3d")):
            (self.folder / place / driver).parent.mkdir(parents=True)
            (self.folder / place / driver).write_text(content)
        self.assertEqual(self.owners(driver, "usr/lib/aarch64-linux-gnu/libc.so.6"), ["mesa", None])
        (self.folder / "image/root" / driver).write_text("another")
        self.assertEqual(self.owners(driver), [None])


class FirstPicture(unittest.TestCase):
    """PNG's five ways to tell a line by its neighbours."""

    def test_lines_come_back_from_what_is_stored_of_them(self):
        before, line = bytearray([10, 20, 5, 40]), bytearray([15, 25, 200, 7])
        for kind, stored in ((0, line), (1, [15, 25, 185, 238]), (2, [5, 5, 195, 223]), (3, [10, 15, 190, 231]), (4, [5, 5, 190, 223])):
            self.assertEqual(first_picture.unfiltered(kind, bytes(stored), before, 2), line, f"filter {kind}")

    def test_another_file_is_refused(self):
        with self.assertRaises(ValueError):
            first_picture.as_ppm(b"GIF89a")


class Sizes(unittest.TestCase):
    def test_a_file_counts_once_for_the_part_that_it_belongs_to(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name in ("usr/lib/aarch64-linux-gnu/dri/v3d_dri.so", "usr/lib/aarch64-linux-gnu/libc.so.6", "usr/bin/kaori-stage"):
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(name)
            os.link(root / "usr/lib/aarch64-linux-gnu/dri/v3d_dri.so", root / "usr/lib/aarch64-linux-gnu/dri/vc4_dri.so")
            found = sizes.parts(root, {"kernel": []})
        self.assertEqual({name: len(files) for name, files in found.items()}, {"kernel": 0, "mesa": 1, "programs": 1, "system": 1})


if __name__ == "__main__":
    unittest.main()
