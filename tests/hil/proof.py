"""What proofs share: a copy of the image with units and programs of the bench in it, how far pictures differ, and the
report that they write."""

import fcntl
import json
import os
import shutil
import subprocess
from pathlib import Path

PACK = Path(__file__).resolve().parents[2] / "rootfs/image/pack.py"
SECTOR = 512
UNITS = "root/usr/lib/systemd/system"
SAMPLED = 97  # Every so many bytes; a prime, so that all three colours are met everywhere.


def difference(one, other):
    """0 for the same picture, 1 for black against white."""
    if len(one) != len(other):
        return 1.0
    pairs = list(zip(one[::SAMPLED], other[::SAMPLED]))
    return sum(abs(a - b) for a, b in pairs) / (255 * len(pairs))


def with_units(image, packages, folder, units, programs=(), shows=(), without=()):
    """The image with these units (name -> text) wanted by the show, these programs and shows, and `without` what the units
    replace."""
    copy = Path(folder)
    subprocess.run(["cp", "-a", image / "root", image / "bzImage", copy], check=True)
    for name in without:
        (copy / UNITS / "kaori.target.wants" / name).unlink(missing_ok=True)
    for name, text in units.items():
        (copy / UNITS / name).write_text(text)
        (copy / UNITS / "kaori.target.wants" / name).symlink_to(f"../{name}")
    for program in programs:
        shutil.copy(program, copy / "root/usr/bin")
    for show in shows:
        shutil.copy(show, copy / "root/usr/share/kaori")
    environment = dict(os.environ, SOURCE_DATE_EPOCH="1767225600", LC_ALL="C")
    subprocess.run([PACK, copy, packages, copy / "image.json"], check=True, env=environment)
    return copy


def with_settings(image, folder, text):
    """A copy of the image's disk with these words in its box.toml."""
    disk, settings = Path(folder) / "settings.disk", Path(folder) / "box.toml"
    subprocess.run(["cp", "--sparse=always", Path(image) / "kaori.disk", disk], check=True)
    shown = subprocess.run(["sgdisk", "--print", disk], check=True, capture_output=True, text=True).stdout
    begins = next(int(line.split()[1]) for line in shown.splitlines() if line.endswith(" data"))
    settings.write_text(text)
    for change in ("rm settings/box.toml", f"write {settings} settings/box.toml"):
        subprocess.run(["debugfs", "-w", "-R", change, f"{disk}?offset={begins * SECTOR}"], check=True, capture_output=True)
    return disk


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
