#!/usr/bin/env python3
"""A kernel that lacks the driver of a device that it needs, or a setting of hardware that its authors have, is named: kernel_test.py
REPOSITORY"""

import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))
KERNEL = REPOSITORY / "rootfs/image/kernel"
sys.dont_write_bytecode = True
sys.path.insert(0, str(KERNEL))
import device_tree  # noqa: E402  The kernel's build's own, both.
import lost  # noqa: E402


def padded(content):
    return content + bytes(-len(content) % 4)


def blob(top):
    """A device tree's blob of {name: cells, words or a node}, as dtc writes it."""
    names = bytearray()

    def key(name):
        at = len(names)
        names.extend(name.encode() + b"\0")
        return at

    def content(value):
        if isinstance(value, str):
            return value.encode() + b"\0"
        return b"".join(struct.pack(">I", cell) if isinstance(cell, int) else content(cell) for cell in value)

    def node(name, inside):
        out = struct.pack(">I", 1) + padded(name.encode() + b"\0")
        for each, value in inside.items():
            if not isinstance(value, dict):
                out += struct.pack(">3I", 3, len(content(value)), key(each)) + padded(content(value))
        out += struct.pack(">I", 4)  # Which says nothing.
        return out + b"".join(node(each, value) for each, value in inside.items() if isinstance(value, dict)) + struct.pack(">I", 2)

    body = node("", top) + struct.pack(">I", 9)
    return struct.pack(">10I", 0xD00DFEED, 40 + len(body) + len(names), 40, 40 + len(body), 0, 17, 16, 0, len(names), len(body)) + body + bytes(names)


def kernel(*compatibles):
    """A file with tables as the kernel's, among other bytes."""
    return b"\x7fcode" + b"".join(bytes(64) + name.encode().ljust(128, b"\0") + b"\1" * 8 for name in compatibles) + b"code"


def board():
    """A card with a clock, wires of a pin controller and a voltage; a screen with an interrupt; and radio."""
    return {
        "compatible": "maker,board", "interrupt-parent": [1],
        "gic": {"compatible": "arm,gic", "phandle": [1], "#interrupt-cells": [3]},
        "clocks": {"compatible": "maker,clocks", "phandle": [2], "#clock-cells": [1]},
        "pins": {"compatible": ["maker,pins-2", "maker,pins"], "phandle": [3], "#gpio-cells": [2], "card": {"phandle": [4]}},
        "power": {"compatible": "regulator-fixed", "phandle": [5]},
        "l2": {"compatible": "maker,l2", "phandle": [6], "#interrupt-cells": [1], "interrupts": [0, 5, 4]},
        "card": {"compatible": "maker,card", "clocks": [2, 7], "pinctrl-0": [4], "vmmc-supply": [5], "interrupts": [0, 9, 4]},
        "screen": {"compatible": "maker,screen", "interrupts-extended": [6, 3, 6, 4], "hpd-gpios": [3, 2, 0], "clocks": [2, 1, 2, 2]},
        "radio": {"compatible": "maker,radio", "clocks": [2, 9]},
        "asleep": {"compatible": "maker,asleep", "status": "disabled", "inside": {"compatible": "maker,inside"}},
    }


ALL = ("arm,gic", "maker,clocks", "maker,pins", "regulator-fixed", "maker,l2", "maker,card", "maker,screen")
GAPS = {"maker,radio": "nobody listens"}


class Drivers(unittest.TestCase):
    """What is enabled in a device tree has a driver, or stands among the gaps and is waited for by nobody."""

    def faults(self, *compatibles, gaps=None, tree=None):
        return device_tree.faults(device_tree.read_tree(blob(tree or board())), kernel(*compatibles), GAPS if gaps is None else gaps)

    def test_a_kernel_with_all_of_them_has_no_fault(self):
        self.assertEqual(self.faults(*ALL), [])

    def test_each_that_is_lost_is_named_with_those_that_wait_for_it(self):
        waits = {"arm,gic": ["/l2", "/card"], "maker,clocks": ["/card", "/screen"], "maker,pins": ["/card", "/screen"], "regulator-fixed": ["/card"],
                 "maker,l2": ["/screen"], "maker,card": [], "maker,screen": []}
        for gone, waiting in waits.items():
            found = self.faults(*(name for name in ALL if name != gone))
            self.assertEqual([line.split()[0] for line in found if " waits by " in line], waiting, gone)
            self.assertEqual(len([line for line in found if " waits by " not in line]), 1, gone)

    def test_a_gap_does_not_let_off_what_a_driven_device_waits_for(self):
        found = self.faults(*(name for name in ALL if name != "maker,clocks"), gaps={**GAPS, "maker,clocks": "who wants time"})
        self.assertEqual(found, ["/card (maker,card) waits by `clocks` for /clocks (maker,clocks), which has no driver",
                                 "/screen (maker,screen) waits by `clocks` for /clocks (maker,clocks), which has no driver"])

    def test_a_gap_may_wait_in_vain_itself(self):
        lacking = [name for name in ALL if name != "maker,l2"]
        gaps = {**GAPS, "maker,l2": "nobody looks", "maker,screen": "nobody looks"}
        self.assertEqual(self.faults(*lacking, gaps=gaps), [])

    def test_what_is_off_is_no_driver_and_one_device_may_do_without_it(self):
        tree = board()
        tree["clocks"]["status"] = "disabled"
        self.assertEqual(len(self.faults(*ALL, tree=tree)), 2)
        found = self.faults(*ALL, tree=tree, gaps={**GAPS, "maker,card>maker,clocks": "it has one of its own"})
        self.assertEqual(found, ["/screen (maker,screen) waits by `clocks` for /clocks (maker,clocks), which has no driver"])

    def test_a_gap_that_is_none_is_named(self):
        self.assertEqual(self.faults(*ALL, gaps={**GAPS, "maker,card": "?", "maker,gone": "?"}),
                         ["maker,card need not be let off: it has a driver, or is not there",
                          "maker,gone need not be let off: it has a driver, or is not there"])

    def test_words_of_a_driver_are_no_table(self):
        words = b"\0maker,card\0" + b"maker,clocks-2\0"
        tree = device_tree.read_tree(blob(board()))
        self.assertIn("/card (maker,card) has no driver",
                      device_tree.faults(tree, kernel(*(name for name in ALL if name != "maker,card")) + words, GAPS))

    def test_the_gaps_of_each_board_have_reasons(self):
        files = list(KERNEL.glob("*.gaps"))
        self.assertTrue(files)
        for file in files:
            self.assertTrue(all(len(why.split()) > 2 for why in device_tree.read_gaps(file.read_text()).values()), file.name)

    def test_the_program_ends_with_1_where_it_names_one(self):
        with tempfile.TemporaryDirectory() as folder:
            tree, image, gaps = (Path(folder) / name for name in ("a.dtb", "Image", "a.gaps"))
            tree.write_bytes(blob(board()))
            gaps.write_text("# Of a test.\nmaker,radio  nobody listens\n")
            for names, status in ((ALL, 0), (ALL[:-1], 1)):
                image.write_bytes(kernel(*names))
                done = subprocess.run([KERNEL / "device_tree.py", tree, image, gaps], capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stdout.count("\n")), (status, status), done.stderr)


class Settings(unittest.TestCase):
    """A setting that is on for whoever has the rest is lost where everything is off first."""

    KCONFIG = {
        "drivers/clk/Kconfig": 'config CLK_CHIP\n\tbool "Clocks of the chip"\n\tdefault y\n\nconfig CLK_HELPER\n\tbool\n',
        "drivers/sound/Kconfig": 'config SOUND_EXTRA\n\tbool "Extra"\n',
        "mm/Kconfig": 'config ZONE_DMA\n\tbool "Support DMA zone" if ARCH_HAS_ZONE_DMA_SET\n\nconfig SLAB_MERGE\n\tbool "Merge"\n',
        "arch/arm64/Kconfig": 'config CHIP_ERRATUM_1\n\tbool "Work round it"\n',
        "arch/x86/Kconfig": 'config OTHER_ERRATUM_1\n\tbool "Of another processor"\n',
    }
    EVERY = "".join(f"CONFIG_{name}=y\n" for name in ("CLK_CHIP", "CLK_HELPER", "SOUND_EXTRA", "ZONE_DMA", "SLAB_MERGE", "CHIP_ERRATUM_1"))

    def hardware(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in self.KCONFIG.items():
                (Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
                (Path(folder) / name).write_text(text)
            return lost.of_hardware(Path(folder), "arm64")

    def test_those_of_hardware_are_looked_at(self):
        self.assertEqual(self.hardware(), {"CLK_CHIP", "ZONE_DMA", "CHIP_ERRATUM_1"})

    def test_each_that_nobody_named_is(self):
        self.assertEqual(lost.lost(self.hardware(), "", "# CONFIG_CLK_CHIP is not set\n", self.EVERY), ["CHIP_ERRATUM_1", "CLK_CHIP", "ZONE_DMA"])

    def test_what_is_on_or_was_thought_of_is_not(self):
        self.assertEqual(lost.lost(self.hardware(), "CONFIG_CHIP_ERRATUM_1=n\n", "CONFIG_ZONE_DMA=y\n", self.EVERY), ["CLK_CHIP"])


if __name__ == "__main__":
    unittest.main()
