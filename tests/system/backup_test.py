#!/usr/bin/env python3
"""Backup and restore of a box, by the program itself: what another tool reads in a backup, a second box made of it, and
backups that must be refused.

Usage: backup_test.py BIN PACK REPORT     BIN holds the programs; PACK is a show; REPORT (out/backup.json) gets `restore_differs`,
the files that are not the same on a second box that was made of the backup, and `clone_minutes`, from the first to the second one
with the disks of both in this computer
"""

import hashlib
import io
import json
import subprocess
import sys
import tarfile
import tempfile
import time
from pathlib import Path

REFUSED = 1
TOO_LARGE_BYTES = 2 << 20


def shows(programs, box, *words):
    return subprocess.run([programs / "kaori-shows", "--shows", box / "shows", "--root-keys", box / "none", "--keys", box / "settings/keys",
                           "--board", box / "board", "--stage", programs / "kaori-stage", *words],
                          capture_output=True, text=True, check=False)


def put(box, path, text):
    (box / path).parent.mkdir(parents=True, exist_ok=True)
    (box / path).write_text(text)


def box_with_show(programs, pack, box):
    """A box on which a signed show was installed, with settings, expressions and calibration."""
    put(box, "settings/box.toml", 'name = "left"\nprofile = "stage"\n')
    put(box, "own/01-smile.toml", "smile")
    put(box, "own/last-face", "her face")
    put(box, "own/log/evening", "a report")
    put(box, "lips/lips.settings", "lips")
    put(box, "machine-id", "0123456789abcdef")
    (box / "shows").mkdir()
    (box / "settings/keys").mkdir()
    subprocess.run([programs / "kaori-atelier", "keygen", box / "company.key"], check=True, capture_output=True)
    (box / "company.key.pub").rename(box / "settings/keys/company.pub")
    show = box / "company.kaori"
    show.write_bytes(pack.read_bytes())
    subprocess.run([programs / "kaori-atelier", "sign", show, box / "company.key"], check=True, capture_output=True)
    done = shows(programs, box, "--install", show)
    if done.returncode != 0:
        sys.exit(f"the show is not installed: {done.stderr}")
    return show


def archive(files):
    """A backup with these files, made without our program: path to content."""
    lines = "kaori-backup 1\nbox forged\nmade today\nshow root\n"
    lines += "".join(f"{hashlib.sha256(text).hexdigest()} {len(text)} {path}\n" for path, text in files.items())
    lines += f"sum {hashlib.sha256(lines.encode()).hexdigest()}\n"
    made = io.BytesIO()
    with tarfile.open(fileobj=made, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for path, text in {"contents": lines.encode(), **files}.items():
            member = tarfile.TarInfo(path)
            member.size = len(text)
            tar.addfile(member, io.BytesIO(text))
    return made.getvalue()


def bad_backups(good):
    data = good.read_bytes()
    flipped = bytearray(data)
    flipped[len(data) // 2] ^= 1
    newer = data.replace(b"kaori-backup 1\n", b"kaori-backup 2\n", 1)
    return (("flipped", bytes(flipped), "it is damaged"),
            ("short", data[:-700], "its end is missing"),
            ("newer", newer, "made by a newer box"),
            ("outside", archive({"own/../machine-id": b"another"}), "belongs to no box"),
            ("large", archive({"own/01-a.toml": b"a" * TOO_LARGE_BYTES}), "too large for a box"),
            ("text", b"no backup at all", "no backup of a box"))


# What a restore puts, and what it leaves to each box: its name, its number, its last face, what it did.
RESTORED = ("settings", "own", "lips", "shows")
OF_ONE_BOX = ("settings/box.toml", "own/last-face", "own/log/evening", "shows/choice.0", "shows/choice.1")


def files_of(box):
    return {str(path.relative_to(box)): path.read_bytes() for folder in RESTORED if (box / folder).exists()
            for path in (box / folder).rglob("*") if path.is_file()}


def clone(programs, first, second, stick):
    """(files of the first box that the second one has not or otherwise, minutes that it took)."""
    begun = time.monotonic()
    made = [shows(programs, first, "--backup", stick), shows(programs, second, "--restore", next(stick.glob("*.kaorishow")), "--at-once")]
    minutes = (time.monotonic() - begun) / 60
    if any(done.returncode for done in made):
        sys.exit("no second box: " + "".join(done.stderr for done in made))
    ours, theirs = files_of(first), files_of(second)
    return [path for path in sorted({*ours, *theirs} - {*OF_ONE_BOX}) if ours.get(path) != theirs.get(path)], minutes


def main():
    programs, pack, report = (Path(word).resolve() for word in sys.argv[1:])
    faults = []

    def want(condition, words):
        if not condition:
            faults.append(words)

    with tempfile.TemporaryDirectory() as folder:
        first, second, third, stick, other_stick = (Path(folder) / name for name in ("first", "second", "third", "stick", "other-stick"))
        for place in (first, second, third, stick, other_stick, second / "shows", third / "shows"):
            place.mkdir()
        show = box_with_show(programs, pack, first)
        done = shows(programs, first, "--backup", stick)
        want(done.returncode == 0 and "the backup is on the stick" in done.stdout, f"no backup: {done.stderr}")
        backup = next(stick.glob("*.kaorishow"))
        with tarfile.open(backup) as tar:
            files = {member.name: tar.extractfile(member).read() for member in tar}
        want("machine-id" not in files and "own/last-face" not in files, f"the backup has what is the box's own: {sorted(files)}")
        want(show.read_bytes() in files.values(), "the backup has another show")
        for line in files["contents"].decode().splitlines()[4:-1]:
            digest, _, path = line.split(" ", 2)
            want(hashlib.sha256(files[path]).hexdigest() == digest, f"the list has another checksum of {path}")

        # An archive that another tool made.
        made = stick / "made.kaorishow"
        made.write_bytes(archive({"own/05-made.toml": b"made"}))
        done = shows(programs, second, "--diff", made)
        want("new     own/05-made.toml" in done.stdout, f"what tar made is not read: {done.stdout}{done.stderr}")

        put(second, "settings/box.toml", 'name = "right"\n')
        put(second, "machine-id", "another")
        for name, content, words in bad_backups(backup):
            bad = stick / f"{name}.kaorishow"
            bad.write_bytes(content)
            done = shows(programs, second, "--restore", bad)
            want(done.returncode == REFUSED and words in done.stderr, f"{name}: status {done.returncode}, said {done.stderr!r}")
            left = [path for path in (second / "restore").glob("*")] if (second / "restore").exists() else []
            want(not left, f"{name} left {left}")

        done = shows(programs, second, "--diff", backup)
        want(done.returncode == 0 and "in place of the box's own one" in done.stdout and not (second / "restore/next").exists(),
             f"--diff: {done.stdout}{done.stderr}")
        done = shows(programs, second, "--restore", backup)
        waits = second / "restore/next/files"
        want("switch the box off and on" in done.stdout, f"--restore: {done.stdout}{done.stderr}")
        want((waits / "own/01-smile.toml").read_text() == "smile", "the expression does not wait")
        want((waits / "settings/box.toml").read_text() == 'name = "right"\nprofile = "stage"\n', "the second box loses its name")
        want(not (waits / "own/log").exists(), "a report of another box waits")
        want([path.read_bytes() for path in (waits / "shows").iterdir()] == [show.read_bytes()], "the show does not wait")
        want((second / "settings/box.toml").read_text() == 'name = "right"\n', "the box was changed before its next start")

        put(third, "settings/box.toml", 'name = "third"\n')
        put(third, "own/09-goes.toml", "of the third box")
        differing, minutes = clone(programs, first, third, other_stick)
        want(not differing, f"the third box has not the same: {differing}")
        want((third / "settings/box.toml").read_text() == 'name = "third"\nprofile = "stage"\n', "the third box loses its name")
        want((third / "restore/kept/files/own/09-goes.toml").read_text() == "of the third box", "what was there is not kept")
    report.parent.mkdir(parents=True, exist_ok=True)
    report.write_text(json.dumps({"restore_differs": len(differing), "clone_minutes": round(minutes, 3)}, indent=2) + "\n")
    print(f"backup: one written, two restored, six refused; a second box was made in {minutes * 60:.1f} s")
    if faults:
        sys.exit("\n".join(faults))


main()
