"""What proofs share: a copy of the image with units and programs of the bench in it, and the report that they write."""

import fcntl
import json
import os
import shutil
import subprocess
from pathlib import Path

PACK = Path(__file__).resolve().parents[2] / "rootfs/image/pack.py"
UNITS = "root/usr/lib/systemd/system"


def with_units(image, packages, folder, units, programs=(), without=()):
    """The image with these units (name -> text) wanted by the show, these programs, and `without` what they replace."""
    copy = Path(folder)
    subprocess.run(["cp", "-a", image / "root", image / "bzImage", copy], check=True)
    for name in without:
        (copy / UNITS / "kaori.target.wants" / name).unlink()
    for name, text in units.items():
        (copy / UNITS / name).write_text(text)
        (copy / UNITS / "kaori.target.wants" / name).symlink_to(f"../{name}")
    for program in programs:
        shutil.copy(program, copy / "root/usr/bin")
    environment = dict(os.environ, SOURCE_DATE_EPOCH="1767225600", LC_ALL="C")
    subprocess.run([PACK, copy, packages, copy / "image.json"], check=True, env=environment)
    return copy


def write_report(image, **figures):
    """Adds the figures to boot.json beside the image's folder, and leaves those of others."""
    report = Path(image).resolve().parent / "boot.json"
    with open(report, "a+", encoding="utf-8") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        file.seek(0)
        known = json.loads(file.read() or "{}")
        known.update(figures)
        file.truncate(0)
        file.write(json.dumps(known, indent=2) + "\n")
