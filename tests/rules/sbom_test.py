#!/usr/bin/env python3
"""What is in an image is written down by origin: sbom_test.py REPOSITORY

The image is a small tree of files.
"""

import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY = Path(sys.argv.pop(1))
IMAGE = REPOSITORY / "rootfs/image"
sys.dont_write_bytecode = True
sys.path.insert(0, str(IMAGE))
import debs  # noqa: E402  The image's own, all of these.
import licences  # noqa: E402
import stale  # noqa: E402

LIBRARIES = "usr/lib/x86_64-linux-gnu"
STATUS = """Package: libdrm2
Source: libdrm (2.4.114-1)
Version: 2.4.114-1+b1
Architecture: amd64
Depends: libc6 (>= 2.33),
 libdrm-common (>= 2.4.114-1)
Status: install ok unpacked

Package: tool
Version: 1:3.0-1
Architecture: amd64
Status: install ok unpacked

Package: systemd-boot-efi
Source: systemd
Version: 252.39-1~deb12u2
Architecture: amd64
Status: install ok unpacked

"""
DEP5 = """Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/

Files: *
License: LGPL-2.1+ and Expat

Files: debian/*
License: GPL-2+ or Artistic
 On Debian systems the text is in /usr/share/common-licenses.
 .
 Both of them.
"""


def write(path, text=""):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


class SmallImage(unittest.TestCase):
    """A root with one file of each origin, all of which are where they should be."""

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        out, packages, overlay = (self.folder / name for name in ("image", "packages", "overlay"))
        self.root = out / "root"
        write(packages / "var/lib/dpkg/status", STATUS)
        # tool's file lies where Debian's usr was not yet one with the root.
        write(packages / "var/lib/dpkg/info/tool.list", "bin\nbin/tool\nusr/share/doc/tool/copyright\n")
        write(packages / "var/lib/dpkg/info/libdrm2.list", f"{LIBRARIES}/libdrm.so.2\n{LIBRARIES}/libdrm.so.2.4.0\n")
        write(packages / "var/lib/dpkg/info/systemd-boot-efi.list", "usr/lib/systemd/boot/efi/systemd-bootx64.efi\n")
        write(packages / "usr/share/doc/tool/copyright", "Copyright: somebody. Do as you like.\n")
        write(packages / "usr/share/doc/libdrm2/copyright", DEP5)
        for place, name in ((self.root, "usr/bin/tool"), (packages, "bin/tool")):
            write(place / name, "a tool")
        for place in (self.root, packages):
            write(place / LIBRARIES / "libdrm.so.2.4.0", "a library")
            (place / LIBRARIES / "libdrm.so.2").symlink_to("libdrm.so.2.4.0")
        for place, name in ((out, "boot/EFI/BOOT/BOOTX64.EFI"), (packages, "usr/lib/systemd/boot/efi/systemd-bootx64.efi")):
            write(place / name, "a loader")
        for place in (self.root, overlay):
            write(place / "etc/os-release", "ID=kaori\n")
        for name in ("usr/bin/kaori-stage", f"{LIBRARIES}/libz3.so.4", "usr/share/kaori/kaori.kaori", "usr/share/kaori/ahead"):
            write(self.root / name, name)
        write(out / "boot/EFI/Linux/kaori-a.efi", "a kernel")
        write(self.folder / "programs/kaori-stage", "with its symbols")
        write(self.folder / "stand_ins.txt", "# why\nlibz3.so.4\n")
        self.report = self.folder / "image.json"
        self.report.write_text('{"root_hash": "ab12"}')

    def run_sbom(self, *sysroot):
        command = [IMAGE / "sbom.py", "amd64", *(self.folder / name for name in ("image", "packages", "overlay", "stand_ins.txt", "programs")),
                   self.report, *sysroot]
        return subprocess.run(command, capture_output=True, text=True, check=False,
                              env=dict(os.environ, SOURCE_DATE_EPOCH="1767225600"))

    def listed(self, ending, *sysroot):
        done = self.run_sbom(*sysroot)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads((self.folder / f"image{ending}").read_text())


class Listed(SmallImage):
    def test_every_file_belongs_to_a_package_or_to_the_project(self):
        document = self.listed(".spdx.json")
        names = {file["SPDXID"]: file["fileName"] for file in document["files"]}
        whose = {names[one["relatedSpdxElement"]]: one["spdxElementId"] for one in document["relationships"]
                 if one["relatedSpdxElement"] in names}
        self.assertEqual(whose, {
            "./boot/EFI/BOOT/BOOTX64.EFI": "SPDXRef-part-systemd-boot-efi", "./boot/EFI/Linux/kaori-a.efi": "SPDXRef-part-kaori-made",
            "./etc/os-release": "SPDXRef-part-kaori-box", "./usr/bin/kaori-stage": "SPDXRef-part-kaori-box",
            "./usr/bin/tool": "SPDXRef-part-tool", f"./{LIBRARIES}/libdrm.so.2.4.0": "SPDXRef-part-libdrm2",
            f"./{LIBRARIES}/libz3.so.4": "SPDXRef-part-kaori-stand-ins", "./usr/share/kaori/ahead": "SPDXRef-part-kaori-made",
            "./usr/share/kaori/kaori.kaori": "SPDXRef-part-kaori-show"})
        report = json.loads(self.report.read_text())
        self.assertEqual((report["root_hash"], report["sbom_files"], report["sbom_files_unmatched"]), ("ab12", 9, 0))

    def test_what_is_compiled_into_programs_for_another_processor_is_the_sysroots(self):
        write(self.folder / "sysroot/var/lib/dpkg/status", "Package: libglm-dev\nVersion: 0.1-of-the-sysroot\nArchitecture: all\n\n"
              "Package: libpng-dev\nVersion: 1\nArchitecture: arm64\n\n")
        versions = {package["name"]: package["versionInfo"] for package in self.listed(".spdx.json", self.folder / "sysroot")["packages"]}
        self.assertEqual(versions["libglm-dev"], "0.1-of-the-sysroot")
        self.assertIn("libc6-dev", versions, "what the sysroot has not is this machine's")
        self.assertNotIn("libpng-dev", versions, "it is compiled into nothing of the box")

    def test_a_package_is_named_with_version_source_licence_and_the_hashes_of_its_files(self):
        document = self.listed(".spdx.json")
        package = next(package for package in document["packages"] if package["name"] == "libdrm2")
        self.assertEqual(package["versionInfo"], "2.4.114-1+b1")
        self.assertEqual(package["sourceInfo"], "built of Debian's source libdrm 2.4.114-1")
        self.assertEqual(package["licenseDeclared"], "(GPL-2.0-or-later OR LicenseRef-libdrm-Artistic) AND (LGPL-2.1-or-later AND MIT)")
        self.assertEqual(package["externalRefs"][0]["referenceLocator"],
                         "pkg:deb/debian/libdrm2@2.4.114-1%2Bb1?arch=amd64&distro=bookworm&upstream=libdrm%402.4.114-1")
        file = next(file for file in document["files"] if file["fileName"].endswith("libdrm.so.2.4.0"))
        hashed = {kind: hashlib.new(kind, b"a library").hexdigest() for kind in ("sha1", "sha256")}
        self.assertEqual([one["checksumValue"] for one in file["checksums"]], [hashed["sha1"], hashed["sha256"]])
        self.assertEqual(package["packageVerificationCode"]["packageVerificationCodeValue"],
                         hashlib.sha1(hashed["sha1"].encode()).hexdigest())

    def test_both_forms_name_the_same_parts_and_every_licence_that_is_referred_to_has_its_text(self):
        spdx, cyclonedx = self.listed(".spdx.json"), json.loads((self.folder / "image.cdx.json").read_text())
        names = [package["name"] for package in spdx["packages"][1:]]
        self.assertEqual([part["name"] for part in cyclonedx["components"]], names)
        self.assertEqual(len(set(names)), len(names))
        self.assertLessEqual(set(debs.installed(stale.lines_of(stale.COMPILED_IN))), set(names), "what is compiled in is missing")
        said = {word for package in spdx["packages"] for word in re.findall(r"LicenseRef-[\w.-]+", package["licenseDeclared"])}
        texts = {one["licenseId"]: one["extractedText"] for one in spdx["hasExtractedLicensingInfos"]}
        self.assertEqual(said, set(texts))
        self.assertEqual(texts["LicenseRef-tool-copyright"], "Copyright: somebody. Do as you like.")
        self.assertIn("Do as you like.", (self.folder / "image.licences.txt").read_text())

    def test_files_of_graphics_cards_makers_and_keys_are_parts_of_their_own(self):
        write(self.root / "usr/lib/firmware/amdgpu/polaris10_mc.bin", "of its maker")
        write(self.folder / "image/boot/loader/keys/auto/PK.auth", "a key")
        document = self.listed(".spdx.json")
        names = {file["SPDXID"]: file["fileName"] for file in document["files"]}
        whose = {names[one["relatedSpdxElement"]]: one["spdxElementId"] for one in document["relationships"]
                 if one["relatedSpdxElement"] in names}
        self.assertEqual(whose["./usr/lib/firmware/amdgpu/polaris10_mc.bin"], "SPDXRef-part-gpu-firmware")
        self.assertEqual(whose["./boot/loader/keys/auto/PK.auth"], "SPDXRef-part-kaori-keys")

    def test_the_same_image_gives_the_same_bits(self):
        self.run_sbom()
        first = [(self.folder / f"image{ending}").read_bytes() for ending in (".spdx.json", ".cdx.json", ".licences.txt")]
        self.run_sbom()
        self.assertEqual(first, [(self.folder / f"image{ending}").read_bytes() for ending in (".spdx.json", ".cdx.json", ".licences.txt")])


class Unmatched(SmallImage):
    def assert_named(self, *paths):
        done = self.run_sbom()
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.splitlines(), [f"sbom: {path}: belongs to no package and to nothing of the project" for path in paths])
        self.assertFalse((self.folder / "image.spdx.json").exists())

    def test_a_file_that_nobody_brought_is_named(self):
        write(self.root / "usr/bin/miner", "what is this?")
        write(self.root / "usr/share/kaori/keys/secret", "no public key")
        self.assert_named("usr/bin/miner", "usr/share/kaori/keys/secret")

    def test_a_file_that_differs_from_its_package_is_named(self):
        (self.root / "usr/bin/tool").write_text("another tool")
        self.assert_named("usr/bin/tool")

    def test_a_link_that_points_elsewhere_is_named(self):
        link = self.root / LIBRARIES / "libdrm.so.2"
        link.unlink()
        link.symlink_to("/tmp/libdrm.so.2")
        self.assert_named(f"{LIBRARIES}/libdrm.so.2")

    def test_a_loader_that_is_not_debians_is_named(self):
        (self.folder / "image/boot/EFI/BOOT/BOOTX64.EFI").write_text("another loader")
        self.assert_named("boot/EFI/BOOT/BOOTX64.EFI")

    def test_a_unit_that_was_changed_after_it_was_laid_down_is_named(self):
        (self.root / "etc/os-release").write_text("ID=other\n")
        self.assert_named("etc/os-release")


class LicenceNames(unittest.TestCase):
    def test_debians_short_names_become_those_of_spdx(self):
        for debians, expected in (("GPL-2", "GPL-2.0-only"), ("GPL-2.0+", "GPL-2.0-or-later"), ("LGPL-2.1+", "LGPL-2.1-or-later"),
                                  ("LGPL-1", None), ("gpl", None), ("Expat", "MIT"), ("BSD-3-Clause", "BSD-3-Clause"), ("public-domain", None)):
            self.assertEqual(licences.spdx_name(debians), expected, debians)

    def test_a_licence_with_words_of_its_own_keeps_its_text(self):
        found = licences.of_copyright("a b", "Format: https://x/copyright-format/1.0\n\nFiles: *\nLicense: odd one\n First.\n .\n Second.\n")
        self.assertEqual(found, ("LicenseRef-a-b-odd-one", {"LicenseRef-a-b-odd-one": "First.\n\nSecond."}))


if __name__ == "__main__":
    unittest.main()
