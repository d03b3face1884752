#!/usr/bin/env python3
"""What the image's builder refuses, in one line, before it has built anything, how it lays out the slots, and how it keeps compiled shaders:
image_test.py REPOSITORY"""

import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))
sys.dont_write_bytecode = True
sys.path.insert(0, str(REPOSITORY / "rootfs/image"))
import architectures  # noqa: E402  The image's own, all of these.
import esp  # noqa: E402
import fat  # noqa: E402
import gpu_firmware  # noqa: E402
import pack  # noqa: E402
import secure_boot  # noqa: E402
import shader_store  # noqa: E402


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
            self.assertIn(f"there is no update of a surface in {folder}", refusal(build, *usual, "--firmware", folder))
            self.assertIn("there is no show at", refusal(build, *usual[:4], "--pack", f"{folder}/none"))
            self.assertIn("--medium tape: expected usb or disk", refusal(build, *usual, "--medium", "tape"))
            self.assertIn("--graphics voodoo: expected intel, amd or all", refusal(build, *usual, "--graphics", "voodoo"))
            self.assertIn("--gpu-firmware wants --graphics", refusal(build, *usual, "--gpu-firmware", folder))
            self.assertIn("has no db.key; ./box keys makes keys", refusal(build, *usual, "--secure-boot", folder))
            self.assertEqual(refusal(build, *usual, "--arch", "pdp11"),
                             "image: there is no architecture pdp11; expected amd64 or arm64")
            self.assertIn("--graphics is for PCs", refusal(build, *usual, "--arch", "arm64", "--graphics", "amd"))


class Medium(unittest.TestCase):
    def test_only_an_image_for_usb_lets_the_kernel_look_there(self):
        with tempfile.NamedTemporaryFile() as root:
            root.write(bytes(pack.BLOCK))
            root.flush()
            disk, usb = (pack.command_line(Path(root.name), "ab12", "a", medium).split() for medium in (pack.DISK, pack.USB))
        self.assertEqual([pair for pair in zip(disk, usb) if pair[0] != pair[1]],
                         [("usbcore.authorized_default=0", "usbcore.authorized_default=1")])


class GpuFirmware(unittest.TestCase):
    """Files that whoever builds the image has; of them those that a driver asks for."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        os.environ["SOURCE_DATE_EPOCH"] = "1767225600"
        for name in ("lib/firmware/amdgpu/a_mc.bin", "i915/b_guc.bin", "lib/firmware/iwlwifi.ucode"):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(name)

    def test_is_taken_by_name_from_a_folder_or_an_unpacked_package(self):
        found = gpu_firmware.chosen(self.folder, ["amdgpu/a_mc.bin", "amdgpu/none.bin", "i915/b_guc.bin"])
        self.assertEqual(found, {"amdgpu/a_mc.bin": self.folder / "lib/firmware/amdgpu/a_mc.bin",
                                 "i915/b_guc.bin": self.folder / "i915/b_guc.bin"})

    def test_becomes_an_archive_that_cpio_unpacks_to_the_same(self):
        files = gpu_firmware.chosen(self.folder, ["amdgpu/a_mc.bin", "i915/b_guc.bin"])
        packed = gpu_firmware.archive(files)
        self.assertEqual(packed, gpu_firmware.archive(files), "made again it is another")
        listed = subprocess.run(["python3", "-c", UNPACK], input=packed, capture_output=True, check=True).stdout.decode().splitlines()
        self.assertEqual(listed, ["lib", "lib/firmware", "lib/firmware/amdgpu", "lib/firmware/i915",
                                  "lib/firmware/amdgpu/a_mc.bin lib/firmware/amdgpu/a_mc.bin", "lib/firmware/i915/b_guc.bin i915/b_guc.bin"])

    def test_that_no_driver_asks_for_is_refused(self):
        names = self.folder / "names"
        names.write_text("amdgpu/other.bin\n")
        said = refusal(REPOSITORY / "rootfs/image/gpu_firmware.py", self.folder, names, self.folder / "out")
        self.assertIn("has no file that a driver of this kernel asks for", said)


# A reader of cpio's form "newc" by its description: folders by their names, files with what is in them.
UNPACK = """
import sys
data, at = sys.stdin.buffer.read(), 0
while data[at:at + 6] == b"070701":
    mode, size, name_size = (int(data[at + 6 + 8 * n:at + 14 + 8 * n], 16) for n in (1, 6, 11))
    name = data[at + 110:at + 109 + name_size].decode()
    body = at + (110 + name_size + 3) // 4 * 4
    if name == "TRAILER!!!":
        break
    print(name, data[body:body + size].decode()) if mode & 0o100000 else print(name)
    at = body + (size + 3) // 4 * 4
"""


def efi_program(code):
    """A program for UEFI of one section (Microsoft's PE/COFF specification), as long as a whole number of its alignments."""
    aligned, head, at = 512, 1024, 0x1000
    size = -(-len(code) // aligned) * aligned
    coff = struct.pack("<4sHHIIIHH", b"PE", 0x8664, 1, 0, 0, 0, 240, 0x22E)
    optional = struct.pack("<HBBIIIII", 0x20B, 1, 0, size, 0, 0, at, at) + \
        struct.pack("<QIIHHHHHHIIIIHHQQQQII", 0, 0x1000, aligned, 0, 0, 0, 0, 0, 0, 0, at + size, head, 0, 10, 0, 0, 0, 0, 0, 0, 16) + bytes(128)
    section = struct.pack("<8sIIIIIIHHI", b".text", len(code), at, size, head, 0, 0, 0, 0, 0x60000020)
    return (b"MZ" + bytes(58) + struct.pack("<I", 64) + coff + optional + section).ljust(head, b"\0") + code.ljust(size, b"\0")


@unittest.skipUnless(all(map(shutil.which, ("openssl", "sbsign", "cert-to-efi-sig-list"))), "openssl, sbsigntool or efitools is not there")
class SecureBoot(unittest.TestCase):
    """A small program in place of loader and kernel."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.keys = cls.folder / "keys"
        secure_boot.make_keys(cls.keys)
        cls.program = cls.folder / "program.efi"
        cls.program.write_bytes(efi_program(bytes(range(256)) * 8))
        cls.signed = cls.folder / "signed.efi"
        shutil.copyfile(cls.program, cls.signed)
        secure_boot.sign(cls.signed, cls.keys)

    def test_keys_are_whole_and_made_once(self):
        self.assertIsNone(secure_boot.missing(self.keys))
        self.assertEqual((self.keys / "db.key").stat().st_mode & 0o77, 0, "others may read a secret key")
        self.assertIn("keys are made once", refusal(REPOSITORY / "rootfs/image/secure_boot.py", "keys", self.keys))

    def test_a_signature_is_as_long_as_was_said(self):
        room = secure_boot.signature_bytes(self.program, self.keys)
        self.assertEqual(self.signed.stat().st_size, -(-self.program.stat().st_size // 8) * 8 + room)

    def test_what_is_signed_is_still_the_same_program(self):
        self.assertTrue(secure_boot.is_signed(self.signed, self.program))
        self.assertFalse(secure_boot.is_signed(self.program, self.program), "it has no signature")
        content = bytearray(self.signed.read_bytes())
        content[len(content) // 4] ^= 1
        changed = self.folder / "changed.efi"
        changed.write_bytes(content)
        self.assertFalse(secure_boot.is_signed(changed, self.program))

    def test_the_loaders_settings_name_enrolling_where_there_are_keys(self):
        self.assertIn("secure-boot-enroll manual\n", esp.settings("a", signed=True))
        self.assertEqual(len(esp.settings("a", signed=True)), 512)
        self.assertNotIn("secure-boot-enroll", esp.settings("a"))


class Slots(unittest.TestCase):
    """Two systems on one disk, of which an update overwrites one without writing to a table or a folder."""

    def test_command_lines_differ_in_the_slot_alone(self):
        with tempfile.NamedTemporaryFile() as root:
            root.write(bytes(2 * pack.BLOCK))
            root.flush()
            one, other = (pack.command_line(Path(root.name), "ab12", slot).split() for slot in esp.SLOTS)
        ids = {name: uuid for name, _, _, uuid in pack.LAYOUT}
        for part in ("root", "verity"):
            one = [word.replace(ids[f"{part}-a"], ids[f"{part}-b"]) for word in one]
        self.assertEqual([pair for pair in zip(one, other) if pair[0] != pair[1]], [("rauc.slot=A", "rauc.slot=B")])
        self.assertEqual(len(one), len(other))

    def test_the_loaders_settings_are_one_sector_and_name_the_slot_by_one_letter(self):
        one, other = (esp.settings(slot).encode() for slot in esp.SLOTS)
        self.assertEqual((len(one), len(other)), (512, 512))
        self.assertEqual([chr(a) + chr(b) for a, b in zip(one, other) if a != b], ["ab"])
        self.assertIn(b"\ndefault kaori-a.efi\n#", one)
        self.assertTrue(one.endswith(b"#\n"))

    def laid_out(self, folder, name, arch=architectures.PC):
        files = Path(folder) / "boot"
        for path in esp.FOLDERS:
            (files / path).mkdir(parents=True, exist_ok=True)
        for number, slot in enumerate(esp.SLOTS):
            kernel = files / f"EFI/Linux/kaori-{slot}.efi"
            kernel.write_bytes(bytes([0x4D + number]) * esp.KERNEL_BYTES)
            os.utime(kernel, (1767225600, 1767225600))
        for path, text in ((f"EFI/BOOT/{arch.loader}", "a loader" * 9000), ("loader/loader.conf", esp.settings("a"))):
            (files / path).write_text(text)
            os.utime(files / path, (1767225600, 1767225600))
        os.environ["SOURCE_DATE_EPOCH"] = "1767225600"
        esp.lay_out(Path(folder) / name, files, 64, arch)
        return Path(folder) / name

    def test_kernels_lie_in_one_piece_on_whole_mib_of_the_disk(self):
        with tempfile.TemporaryDirectory() as folder:
            image = self.laid_out(folder, "boot.vfat")
            content = image.read_bytes()
            with open(image, "rb") as file:
                for number, slot in enumerate(esp.SLOTS):
                    sectors, size = fat.find(file, "EFI", "Linux", f"kaori-{slot}.efi")
                    first = sectors[0] * 512
                    self.assertEqual((first % esp.MIB, size), (0, 24 * esp.MIB))
                    self.assertEqual(sectors, list(range(sectors[0], sectors[0] + size // 512)))
                    self.assertEqual(set(content[first:first + size]), {0x4D + number}, "another file lies in it")
                sectors, size = fat.find(file, "loader", "LOADER~1.CON")
            self.assertEqual(content[sectors[0] * 512:][:size], esp.settings("a").encode())
            self.assertEqual(self.laid_out(folder, "again.vfat").read_bytes(), content, "made again it is another")

    def test_a_firmware_finds_the_loader_by_the_name_for_its_processor(self):
        with tempfile.TemporaryDirectory() as folder, open(self.laid_out(folder, "a", architectures.NAMED["arm64"]), "rb") as file:
            self.assertEqual(fat.find(file, "EFI", "BOOT", "BOOTAA64.EFI")[1], len("a loader" * 9000))

    def test_a_kernel_with_a_hole_or_beside_a_whole_mib_is_seen(self):
        count = esp.KERNEL_BYTES // 512
        whole = list(range(2048, 2048 + count))
        self.assertTrue(esp.in_one_piece(whole, esp.KERNEL_BYTES))
        self.assertFalse(esp.in_one_piece(whole, esp.KERNEL_BYTES - 1))
        self.assertFalse(esp.in_one_piece(whole[:-1] + [whole[-1] + 1], esp.KERNEL_BYTES))
        self.assertFalse(esp.in_one_piece(whole[:-1], esp.KERNEL_BYTES))
        self.assertFalse(esp.in_one_piece([sector + 1 for sector in whole], esp.KERNEL_BYTES))


class Progress(unittest.TestCase):
    """A kernel and Mesa build for minutes; rootfs/image/progress says how far it is."""

    def said(self, lines, total, line_s=0):
        """What stands there of a build whose lines take so long each, by the clock of the program's shell."""
        file = REPOSITORY / "rootfs/image/progress"
        slow = f'read() {{ builtin read "$@" || return; SECONDS=$((SECONDS + {line_s})); }}; source {file}'
        done = subprocess.run(["bash", "-c", slow, file, "objects", str(total)], input="".join(f"{line}\n" for line in lines),
                              capture_output=True, text=True, check=True)
        return [line.strip() for line in done.stdout.splitlines()]

    def test_comes_with_each_tenth_of_what_is_to_be_compiled(self):
        lines = ["make: entering", "  CC      a.o", "  LD      a"] + ["  CC      b.o"] * 18 + ["  AS      c.o"]
        self.assertEqual(self.said(lines, 20), [f"{count} of 20 objects" for count in range(2, 21, 2)])

    def test_is_counted_where_the_end_is_not_known(self):
        self.assertEqual(self.said(["  CC a.o"] * 250, 0), ["100 objects", "200 objects"])

    def test_comes_after_ten_seconds_without_a_tenth(self):
        self.assertEqual(self.said(["  CC a.o"] * 5, 1000, line_s=6), ["2 of 1000 objects", "4 of 1000 objects"])
        self.assertEqual(self.said(["  CC a.o"] * 3, 0, line_s=10), ["1 objects", "2 objects", "3 objects"])

    def test_is_read_off_the_lines_of_ninja_too_which_say_the_end_themselves(self):
        lines = ["ninja: Entering directory", *(f"[{step}/20] Compiling a.c" for step in range(1, 21)), "a warning"]
        self.assertEqual(self.said(lines, 0), [f"{count} of 20 objects" for count in range(2, 21, 2)])


def stored(shaders):
    """A store as Mesa writes it, in the order in which shaders were compiled, and its index."""
    store = index = shader_store.MARK
    for key, payload in shaders:
        index += key + struct.pack("<4IQ", 8, 1, 0, 8, len(store) + len(key))
        store += key + struct.pack("<4I", len(payload), 1, 77, len(payload)) + payload
    return store, index


class ShaderStore(unittest.TestCase):
    EYES, HAIR = (b"e" * 40, b"eyes, compiled"), (b"a" * 40, b"hair")

    def test_the_order_of_compiling_leaves_no_trace(self):
        one, other = stored((self.EYES, self.HAIR)), stored((self.HAIR, self.EYES))
        self.assertNotEqual(one, other)
        self.assertEqual(shader_store.in_order(one[0]), other)
        self.assertEqual(shader_store.in_order(other[0]), other)

    def test_what_was_not_written_to_its_end_is_not_whole(self):
        store, index = stored((self.EYES, self.HAIR))
        self.assertTrue(shader_store.is_whole(store, index))
        self.assertFalse(shader_store.is_whole(store[:-1], index))
        self.assertFalse(shader_store.is_whole(store, index[:-64]))
        self.assertFalse(shader_store.is_whole(store, index[:-64] + bytes(64)), "a block that the disk never got")
        self.assertFalse(shader_store.is_whole(store + b"e", index))
        self.assertFalse(shader_store.is_whole(b"", b""))


if __name__ == "__main__":
    unittest.main()
