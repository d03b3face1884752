#!/usr/bin/env python3
"""What apt has newer of an image's packages is named: stale_test.py REPOSITORY

Apt is the real one, with lists of its own that name three packages.
"""

import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

IMAGE = Path(sys.argv.pop(1)) / "rootfs/image"
STATUS = """Package: libdrm2
Version: 2.4.114-1+b1
Architecture: amd64
Status: install ok unpacked

Package: tool
Version: 1:3.0-1
Architecture: amd64
Status: install ok unpacked

Package: systemd-boot-efi
Version: 252.39-1~deb12u2
Architecture: amd64
Status: install ok unpacked

"""


def write(path, text=""):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


class Apt:
    """Lists of apt's own, of one server that has these versions for a release: {suite: {name: version}}."""

    def __init__(self, folder, suites):
        self.folder = folder
        for place in ("state/lists/partial", "cache/archives/partial", "etc"):
            (folder / place).mkdir(parents=True)
        write(folder / "state/status")
        sources = ""
        for suite, versions in suites.items():
            listed = "".join(f"Package: {name}\nVersion: {version}\nArchitecture: amd64\nFilename: {name}.deb\nSize: 1\nSHA256: {'0' * 64}\n\n"
                             for name, version in versions.items())
            place = folder / "server/dists" / suite
            write(place / "main/binary-amd64/Packages", listed)
            hashed = hashlib.sha256(listed.encode()).hexdigest()
            write(place / "Release", f"Origin: Debian\nSuite: {suite}\nCodename: {suite}\nArchitectures: amd64\nComponents: main\n"
                                     f"SHA256:\n {hashed} {len(listed)} main/binary-amd64/Packages\n")
            sources += f"deb [trusted=yes arch=amd64] file:{folder}/server {suite} main\n"
        write(folder / "etc/sources.list", sources)
        settings = {"Dir::State": folder / "state", "Dir::State::status": folder / "state/status", "Dir::Cache": folder / "cache",
                    "Dir::Etc": folder / "etc", "APT::Sandbox::User": "root", "APT::Architecture": "amd64"}
        write(folder / "apt.conf", "".join(f'{name} "{value}";\n' for name, value in settings.items()))
        self.environment = dict(os.environ, APT_CONFIG=str(folder / "apt.conf"), LC_ALL="C")
        if suites:
            subprocess.run(["apt-get", "update", "-qq"], env=self.environment, check=True, capture_output=True)

    def stale(self, *words):
        return subprocess.run([IMAGE / "stale.py", *map(str, words)], env=self.environment, capture_output=True, text=True, check=False)


class Stale(unittest.TestCase):
    NEWER = {"bookworm": {"libdrm2": "2.4.114-1+b1", "tool": "1:3.0-1", "linux-source-6.12": "6.12.1-1"},
             "bookworm-security": {"tool": "1:3.0-1+deb12u1"}, "bookworm-backports": {"libdrm2": "2.4.120-1~bpo12+1"}}

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.packages = self.folder / "packages"
        write(self.packages / "var/lib/dpkg/status", STATUS)
        self.names = self.folder / "names.txt"
        write(self.names, "# why\ntool\nlibdrm2\n")

    def list_of(self, **versions):
        listed = self.folder / "image.spdx.json"
        write(listed, json.dumps({"packages": [{"name": "kaori-box", "versionInfo": "0.2"}] + [
            {"name": name.replace("_", "-"), "versionInfo": version,
             "externalRefs": [{"referenceLocator": f"pkg:deb/debian/{name}@{version}"}]} for name, version in versions.items()]}))
        return listed

    def test_a_security_update_of_an_unpacked_package_is_named_and_nothing_else(self):
        done = Apt(self.folder / "apt", self.NEWER).stale("--unpacked", self.packages)
        self.assertEqual((done.stdout, done.stderr, done.returncode), ("tool 1:3.0-1 -> 1:3.0-1+deb12u1\n", "", 0))

    def test_packages_that_are_as_new_as_apts_are_not_fetched_again(self):
        suites = {"bookworm": {"libdrm2": "2.4.114-1+b1", "tool": "1:3.0-1~rc1", "systemd-boot-efi": "252.38-1~deb12u1"}}
        self.assertEqual(Apt(self.folder / "apt", suites).stale("--unpacked", self.packages).stdout, "")

    def test_without_lists_the_packages_are_used_as_they_are_and_that_is_said(self):
        done = Apt(self.folder / "apt", {}).stale("--unpacked", self.packages)
        self.assertEqual((done.stdout, done.returncode), ("", 0))
        self.assertIn("say apt-get update", done.stderr)

    def test_of_an_image_it_says_how_the_newer_ones_get_in(self):
        listed = self.list_of(tool="1:3.0-1", libdrm2="2.4.114-1+b1", **{"linux-source-6.12": "6.12.0-1"})
        done = Apt(self.folder / "apt", self.NEWER).stale("--list", listed)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stdout.splitlines(), [
            "linux-source-6.12: 6.12.0-1; bookworm has 6.12.1-1", "tool: 1:3.0-1; bookworm-security has 1:3.0-1+deb12u1",
            "./box image takes the newer packages.",
            "Compiled in, from this machine: sudo apt-get install --only-upgrade linux-source-6.12; then ./box image"])

    def test_an_image_with_the_newest_of_all_is_said_to_have_them(self):
        done = Apt(self.folder / "apt", self.NEWER).stale("--list", self.list_of(tool="1:3.0-1+deb12u1"))
        self.assertEqual((done.stdout, done.returncode), ("Of everything in the image apt has no newer version.\n", 0))

    def test_an_image_is_not_called_new_by_an_apt_that_knows_nothing(self):
        done = Apt(self.folder / "apt", {}).stale("--list", self.list_of(tool="1:3.0-1"))
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stderr, "stale: apt knows nothing of Debian's bookworm; say apt-get update\n")

    def test_the_packages_stamp_changes_with_a_name_and_with_a_version(self):
        apt = Apt(self.folder / "apt", {})
        first = apt.stale("--stamp", self.packages, self.names).stdout
        self.assertEqual(apt.stale("--stamp", self.packages, self.names).stdout, first)
        write(self.names, "tool\nlibdrm2\nmore\n")
        second = apt.stale("--stamp", self.packages, self.names).stdout
        write(self.packages / "var/lib/dpkg/status", STATUS.replace("1:3.0-1", "1:3.0-2"))
        third = apt.stale("--stamp", self.packages, self.names).stdout
        self.assertEqual(len({first, second, third}), 3)


if __name__ == "__main__":
    unittest.main()
