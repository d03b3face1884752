#!/usr/bin/env python3
"""./box check on PCs that are folders: what each lacks is said, and nothing else: check_pc_test.py ROOT"""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1))
sys.path.insert(0, str(ROOT / "rootfs/check"))
import check_pc  # noqa: E402
import graphics_cards  # noqa: E402

CPU = "processor\t: {}\nmodel name\t: A Processor\nflags\t\t: fpu lm avx2\n\n"


class Pc:
    """A good PC as /sys and /proc show it; tests take away or change."""

    def __init__(self, root):
        self.root = Path(root)
        self.write("proc/cpuinfo", CPU.format(0) + CPU.format(1))
        self.write("proc/meminfo", "MemTotal:        8000000 kB\n")
        self.write("proc/asound/cards", " 0 [PCH            ]: HDA-Intel - HDA Intel PCH\n                      HDA at 0xf\n")
        self.write("sys/firmware/efi/fw_platform_size", "64\n")
        self.secure_boot(False)
        self.graphics("0x8086", "0x5916")
        self.wired("0x8086", "0x15f3", "igc")
        self.write("sys/class/drm/card0-HDMI-A-1/status", "connected\n")
        self.write("sys/class/drm/card0-HDMI-A-1/modes", "1920x1080\n1280x720\n")
        self.disk("nvme0n1", "devices/pci0000:00/nvme/nvme0", 500_000_000_000)
        self.write("sys/class/hidraw/hidraw0/device/uevent", "DRIVER=hid-generic\nHID_NAME=A Stick\n")
        self.write("sys/class/watchdog/watchdog0/identity", "iTCO_wdt\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text if isinstance(text, bytes) else text.encode())

    def remove(self, path):
        target = self.root / path
        if target.is_dir() and not target.is_symlink():
            for child in target.iterdir():
                self.remove(child.relative_to(self.root))
            target.rmdir()
        else:
            target.unlink()

    def secure_boot(self, on):
        self.write(check_pc.SECURE_BOOT, b"\6\0\0\0" + bytes([on]))

    def graphics(self, vendor, device):
        for name, value in (("class", "0x030000"), ("vendor", vendor), ("device", device)):
            self.write(f"sys/bus/pci/devices/0000:00:02.0/{name}", value + "\n")

    def wired(self, vendor, device, driver):
        at = "sys/bus/pci/devices/0000:03:00.0"
        for name, value in (("class", "0x020000"), ("vendor", vendor), ("device", device)):
            self.write(f"{at}/{name}", value + "\n")
        (self.root / at / "driver").unlink(missing_ok=True)
        if driver:
            self.write(f"sys/bus/pci/drivers/{driver}/bind", "")
            (self.root / at / "driver").symlink_to(self.root / f"sys/bus/pci/drivers/{driver}")

    def disk(self, name, device, size):
        self.write(f"sys/block/{name}/size", f"{size // 512}\n")
        folder = self.root / "sys" / device
        folder.mkdir(parents=True, exist_ok=True)
        (self.root / f"sys/block/{name}/device").symlink_to(folder)

    def said(self):
        findings = check_pc.Findings()
        for check in check_pc.CHECKS:
            check(self.root, findings)
        return findings.lines

    def verdicts(self, *of):
        return [(verdict, thing) for verdict, thing, _ in self.said() if verdict in of]


class CheckPc(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.pc = Pc(folder.name)

    def sentence(self, thing):
        return next(said for _, name, said in self.pc.said() if name == thing)

    def test_a_good_pc_lacks_nothing_but_a_camera(self):
        self.assertEqual(self.pc.verdicts("NO", "note"), [("note", "camera")])
        self.assertEqual(check_pc.verdict_of(self.pc.said()), "This computer will do, with limits: camera.")

    def test_a_pc_without_uefi_will_not_do(self):
        self.pc.remove("sys/firmware/efi")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "firmware")])

    def test_secure_boot_must_be_off(self):
        self.pc.secure_boot(True)
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "Secure Boot")])
        self.assertIn("switch it off", self.sentence("Secure Boot"))

    def test_a_pc_without_keys_takes_those_of_an_image(self):
        self.assertEqual(self.sentence("Secure Boot"), "off")
        self.pc.write(check_pc.SETUP_MODE, b"\6\0\0\0\1")
        self.assertIn("takes the keys", self.sentence("Secure Boot"))

    def test_32_bits_will_not_do(self):
        self.pc.write("proc/cpuinfo", "processor\t: 0\nflags\t: fpu\n")
        self.pc.write("sys/firmware/efi/fw_platform_size", "32\n")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "processor"), ("NO", "firmware")])

    def test_too_little_memory_will_not_do(self):
        self.pc.write("proc/meminfo", "MemTotal:        120000 kB\n")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "memory")])

    def test_a_usb_disk_alone_wants_an_image_made_for_it(self):
        self.pc.remove("sys/block/nvme0n1")
        self.pc.disk("sda", "devices/pci0000:00/usb1/1-1/host0", 64_000_000_000)
        self.assertEqual(self.pc.verdicts("NO"), [])
        self.assertIn("--medium usb", self.sentence("disk"))

    def test_emmc_will_do(self):
        self.pc.remove("sys/block/nvme0n1")
        self.pc.disk("mmcblk0", "devices/pci0000:00/0000:00:1c.0/mmc_host/mmc0/mmc0:0001", 32_000_000_000)
        self.assertEqual(self.pc.verdicts("NO", "note"), [("note", "camera")])

    def test_graphics_that_are_too_old_will_not_do(self):
        self.pc.graphics("0x8086", "0x2a42")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "graphics")])

    def test_a_disk_that_is_too_small_will_not_do(self):
        self.pc.remove("sys/block/nvme0n1")
        self.pc.disk("sda", "devices/pci0000:00/ata1/host0", 500_000_000)
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "disk")])
        self.assertIn("too small", self.sentence("disk"))

    def test_a_card_is_named_by_its_kind_and_its_driver_of_mesa_and_by_which_image_it_draws(self):
        cards = (("0x8086", "0x5916", "ok", "Kaby Lake to Comet Lake, Mesa's iris", "as it is"),
                 ("0x8086", "0x0166", "ok", "Sandy Bridge, Ivy Bridge, Mesa's crocus", "as it is"),
                 ("0x8086", "0x46a6", "note", "Alder Lake-N, Mesa's iris", "--graphics intel or all"),
                 ("0x8086", "0x7d55", "NO", "Meteor Lake", "too old"),
                 ("0x8086", "0x2772", "NO", "Mesa's i915", "too old to draw"),
                 ("0x1002", "0x1636", "note", "Renoir, Mesa's radeonsi", "--graphics amd or all"),
                 ("0x1002", "0x67df", "note", "Arctic Islands, Mesa's radeonsi", "--graphics amd or all"),
                 ("0x1002", "0x730f", "note", "Arctic Islands, Mesa's radeonsi", "--graphics amd or all"),
                 ("0x1002", "0x6779", "note", "Mesa's r600", "--graphics does not help"),
                 ("0x1002", "0x6898", "note", "Mesa's r600", "up to 2011"),
                 ("0x1002", "0x7187", "note", "Mesa's r300", "up to 2011"),
                 ("0x1002", "0x150e", "note", "a card that this program does not know", "the processor draws"),
                 ("0x10de", "0x1cb3", "note", "Mesa's nouveau", "--graphics does not help"),
                 ("0x1af4", "0x1050", "ok", "Mesa's virgl", "virtual machine"),
                 ("0x1a03", "0x2000", "note", "ASPEED", "the processor draws"))
        for vendor, device, verdict, *words in cards:
            with self.subTest(device):
                self.pc.graphics(vendor, device)
                self.assertIn((verdict, "graphics"), self.pc.verdicts(verdict))
                for word in words:
                    self.assertIn(word, self.sentence("graphics"))

    def test_a_card_draws_by_the_drivers_that_the_image_has_and_no_other(self):
        kept = (ROOT / "rootfs/image/keep-amd64.txt").read_text()
        for family in graphics_cards.FAMILIES:
            with self.subTest(family.name):
                driver = {"virgl": "virtio_gpu"}.get(family.mesa, family.mesa)
                draws = family.draws not in (graphics_cards.NEVER, graphics_cards.NOT_AT_ALL) and family.mesa
                self.assertTrue(f"/{driver}_dri.so" in kept if draws else True)
                if family.draws == graphics_cards.NEVER and family.mesa:
                    self.assertNotIn(f"/{driver}_dri.so", kept)

    def test_a_wired_card_is_judged_by_the_drivers_of_the_images_kernel(self):
        config = (ROOT / "rootfs/image/kernel/box.config").read_text().splitlines()
        for driver, setting in check_pc.WIRED.items():
            self.assertIn(f"{setting}=y", config)
            self.pc.wired("0x8086", "0x1533", driver)
            self.assertIn("its driver is in the image", self.sentence("network"))
        self.pc.wired("0x10ec", "0x8168", "r8168")
        self.assertIn("(r8169): its driver is in the image", self.sentence("network"))
        for vendor, device, driver in (("0x14e4", "0x1682", "tg3"), ("0x8086", "0x100e", "e1000"), ("0x1d6a", "0x07b1", None)):
            self.pc.wired(vendor, device, driver)
            self.assertEqual(self.pc.verdicts("note"), [("note", "network")] * 2 + [("note", "camera")])
            self.assertIn("has no driver for it", self.sentence("network"))

    def test_a_pc_without_a_wired_card_plays_without_the_desk(self):
        self.pc.remove("sys/bus/pci/devices/0000:03:00.0")
        self.assertEqual(self.pc.verdicts("NO", "note"), [("note", "network"), ("note", "camera")])
        self.assertIn("the desk cannot be reached", self.sentence("network"))

    def test_sound_by_a_processor_of_signals_is_named(self):
        self.pc.write("proc/asound/cards", " 0 [sofhdadsp      ]: sof-hda-dsp - sof-hda-dsp\n")
        self.assertIn("no driver for it", self.sentence("sound"))

    def test_a_camera_is_judged_by_its_modes(self):
        self.pc.write("sys/class/video4linux/video0/name", "A Camera\n")
        real, modes = check_pc.video_modes.modes_of, []
        self.addCleanup(setattr, check_pc.video_modes, "modes_of", real)
        check_pc.video_modes.modes_of = lambda path: modes
        modes += [("MJPG", 1280, 720, 30.0), ("YUYV", 640, 480, 15.0)]
        self.assertIn("has no 640x480 at 30", self.sentence("camera"))
        self.assertTrue(self.sentence("camera").endswith("its modes: MJPG 1280x720 at 30; YUYV 640x480 at 15"))
        modes.append(("YUYV", 640, 480, 30.0))
        self.assertEqual(self.pc.verdicts("NO", "note"), [])
        self.assertEqual(check_pc.verdict_of(self.pc.said()), "This computer will do.")
        modes += [("YUYV", 320, 240, 7.5), ("YUYV", 320, 240, 30.0)]
        self.assertIn("YUYV 640x480 at 15 30, 320x240 at 7.5 30", self.sentence("camera"))

    def test_a_pc_of_which_nothing_can_be_read_is_refused_without_an_exception(self):
        with tempfile.TemporaryDirectory() as nothing:
            self.pc.root = Path(nothing)
            self.assertEqual([thing for _, thing in self.pc.verdicts("NO")], ["processor", "memory", "firmware", "disk"])


if __name__ == "__main__":
    unittest.main()
