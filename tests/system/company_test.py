#!/usr/bin/env python3
"""A company's own show, by the programs themselves: a key, a signature, the installation on a box's folder, and shows
that must be refused.

Usage: company_test.py BIN PACK GUIDE REPORT.json     BIN holds the programs; PACK is a show; GUIDE is docs/guide/box.md
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

NEWER = 99
VERSION_AT = 8
TOO_LARGE_BYTES = 2 << 30
REFUSED = 1
JOURNAL_BYTES = 16 << 20  # As text it is longer than on the disk, where it is packed.
MOST_SUPPORT_KB = 5 << 10


def install(programs, box, pack):
    return subprocess.run([programs / "kaori-shows", "--install", pack, "--shows", box / "shows", "--root-keys", box / "keys",
                           "--keys", box / "brought", "--stage", programs / "kaori-stage"],
                          capture_output=True, text=True, check=False)


def chosen(box):
    texts = [path.read_text() for path in sorted((box / "shows").glob("choice.*"))]
    return max(texts, key=lambda text: int(re.search(r"generation (\d+)", text)[1]), default="")


def support_file_kb(programs, box, faults):
    """How large a support file gets on a box whose journal is full, and that no secret of the settings is in it."""
    (box / "brought").mkdir()
    (box / "box.toml").write_text('profile = "stage"\n[network]\npassword = "hunter2"\n')
    journal = box / "journalctl"
    journal.write_text(f"#!/bin/sh\nyes 2026-11-23T22:10:05+0900 kaori-stage: the show has 60 frames a second | head -c {JOURNAL_BYTES}\n")
    journal.chmod(0o755)
    done = subprocess.run([programs / "kaori-shows", "--support", box / "stick", "--shows", box / "shows", "--keys", box / "brought",
                           "--board", box / "board", "--journalctl", journal], capture_output=True, text=True, check=False)
    file = box / "stick" / done.stdout.strip()
    text = file.read_text() if done.returncode == 0 else ""
    if "== Journal ==" not in text or 'profile = "stage"' not in text or "hunter2" in text:
        faults.append(f"the support file is not what it should be: {done.stderr}{text[:1000]}")
    size_kb = len(text) / 1024
    if not 0 < size_kb <= MOST_SUPPORT_KB:
        faults.append(f"the support file has {size_kb} KiB")
    return round(size_kb)


def changed(good, name, change):
    """A copy of a good show with one thing wrong."""
    bad = good.with_name(name + ".kaori")
    data = bytearray(good.read_bytes())
    bad.write_bytes(change(data) or data)
    return bad


def bad_shows(good, unsigned, foreign):
    """Name, file, and what is said of it."""
    def newer(data):
        data[VERSION_AT] = NEWER

    def flipped(data):
        data[len(data) // 2] ^= 1

    large = good.with_name("large.kaori")
    large.write_bytes(good.read_bytes()[:4096])
    os.truncate(large, TOO_LARGE_BYTES)
    return (("unsigned", unsigned, "it is not signed"),
            ("foreign", foreign, "does not trust its signer"),
            ("newer", changed(good, "newer", newer), "made by newer tools"),
            ("flipped", changed(good, "flipped", flipped), "it is damaged"),
            ("short", changed(good, "short", lambda data: data[:-1000]), "its end is missing"),
            ("text", changed(good, "text", lambda data: b"no show at all"), "this is no show"),
            ("large", large, "too large for a box"))


def main():
    programs, pack, guide, report = (Path(word).resolve() for word in sys.argv[1:])
    faults, refused, tried = [], 0, 0
    author = programs / "kaori-atelier"
    with tempfile.TemporaryDirectory() as folder:
        box = Path(folder)
        for name in ("shows", "keys", "stick"):
            (box / name).mkdir()

        def signed(name):
            subprocess.run([author, "keygen", box / f"{name}.key"], check=True, capture_output=True)
            copy = box / "stick" / f"{name}.kaori"
            copy.write_bytes(pack.read_bytes())
            subprocess.run([author, "sign", copy, box / f"{name}.key"], check=True, capture_output=True)
            return copy

        good, foreign = signed("company"), signed("foreign")
        (box / "company.key.pub").rename(box / "keys" / "company.pub")
        for name, bad, words in bad_shows(good, pack, foreign):
            done = install(programs, box, bad)
            tried += 1
            if done.returncode == REFUSED and words in done.stderr and not chosen(box):
                refused += 1
            else:
                faults.append(f"{name}: status {done.returncode}, said {done.stderr!r}")
        done = install(programs, box, good)
        installed = int(done.returncode == 0 and "it is on the box" in done.stdout)
        if not installed:
            faults.append(f"a good show is refused: {done.stderr}")
        before = chosen(box)
        identity = re.search(r"current ([0-9a-f]{64})", before)
        if not identity or (box / "shows" / f"{identity[1]}.kaori").read_bytes() != good.read_bytes():
            faults.append(f"what was installed is not what was signed: {before!r}")
        left = {path.name for path in (box / "shows").iterdir()}
        if left != {f"{identity[1] if identity else ''}.kaori", "choice.0", "choice.1"}:
            faults.append(f"more is left than a show and the choice in two generations: {left}")
        support_kb = support_file_kb(programs, box, faults)
    block = re.search(r"\n\n((?:    \./box [^\n]+\n)+)", guide.read_text())[1]
    figures = {"shows_installed": installed, "bad_shows": tried, "bad_shows_refused": refused, "commands_to_own_show": len(block.splitlines()),
               "support_file_kb": support_kb}
    known = json.loads(report.read_text()) if report.exists() else {}
    report.parent.mkdir(parents=True, exist_ok=True)
    report.write_text(json.dumps(known | figures, indent=2) + "\n")
    print(figures)
    if faults:
        sys.exit("\n".join(faults))


main()
