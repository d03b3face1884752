#!/usr/bin/env -S python3 -B
"""Two builds of the image are the same bit for bit: reproducible.py IMAGE_FOLDER PROGRAMS_FOLDER [KEPT_FOLDER]

Builds it a second time, elsewhere, from the same programs, packages and kernel, its shaders and its still made anew, and
compares each of these, the root's hash, the boot partition and the whole disk. That the comparison sees a difference is
tried with one program that is one byte longer.
"""

import argparse
import filecmp
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

BUILD = Path(__file__).resolve().parents[2] / "rootfs/image/build"
PACK = BUILD.with_name("pack.py")
SAME = ("shaders/still.ppm", "shaders/shaders.foz", "shaders/shaders_idx.foz", "shaders/shaders.known", "root.erofs", "root.verity", "cmdline",
        "cmdline-b", "boot.vfat", "data.ext4", "kaori.disk")


def keys_of(image):
    """The options by which the image was given public keys, of shows and of updates."""
    kept = image / "root/usr/share/kaori"
    return [word for option, folder in (("--trust", "keys"), ("--update-key", "update-keys"))
            for key in sorted((kept / folder).glob("*")) for word in (option, key)]


def build(programs, kept, out, keys):
    out.mkdir()
    subprocess.run([BUILD, "--out", out, "--programs", programs, "--kept", kept, *keys], check=True, stderr=subprocess.DEVNULL)


def root_hash(out):
    return json.loads(out.with_name(out.name + ".json").read_text())["root_hash"]


def is_seen(out, packages):
    """Whether one byte more in one program gives another hash."""
    before = root_hash(out)
    with open(out / "root/usr/bin/kaori-lips", "ab") as program:
        program.write(b"\0")
    subprocess.run([PACK, out, packages, out.with_name(out.name + ".json")], check=True,
                   env=dict(os.environ, SOURCE_DATE_EPOCH="1767225600", LC_ALL="C"))
    return root_hash(out) != before


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", type=Path)
    parser.add_argument("programs", type=Path)
    parser.add_argument("kept", type=Path, nargs="?", help="where packages and kernel are; the image's own folder")
    args = parser.parse_args()
    kept = args.kept or args.image
    failed = []
    with tempfile.TemporaryDirectory(dir="/var/tmp") as folder:
        again = Path(folder) / "deeper" / "image"
        again.parent.mkdir()
        build(args.programs, kept, again, keys_of(args.image))
        for name in SAME:
            same = filecmp.cmp(args.image / name, again / name, shallow=False)
            print(f"{'ok  ' if same else 'FAIL'}  {name}", flush=True)
            failed += [] if same else [name]
        seen = is_seen(again, kept / "packages")
        print(f"{'ok  ' if seen else 'FAIL'}  a byte more is seen", flush=True)
    sys.exit(len(failed) + (not seen))


main()
