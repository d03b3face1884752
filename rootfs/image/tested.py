#!/usr/bin/env -S python3 -B
"""Says whether an update may be made of an image: the bench has tried this very one, to the end, and nothing failed.

Usage: tested.py IMAGE REPORT...     a report is the report.json of kaori-bench. Prints one line, and ends with 1 where it may not.
"""

import hashlib
import json
import sys
from pathlib import Path

# As hw-sim/hil/image_files.cpp has them; an image has those of a PC or those of a board.
FILES = ("root.erofs", "root.verity", "boot/EFI/Linux/kaori-a.efi", "boot/EFI/Linux/kaori-b.efi", "boot-a.vfat", "boot-b.vfat")


def hash_of(path):
    sums = hashlib.sha256()
    with open(path, "rb") as file:
        while part := file.read(1 << 20):
            sums.update(part)
    return sums.hexdigest()


def hashes_of(image):
    return {name: hash_of(image / name) for name in FILES if (image / name).is_file()}


def read(report):
    """What the bench wrote; nothing where it wrote none, or that is no report."""
    try:
        kept = json.loads(report.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return kept if isinstance(kept, dict) else {}


def fault(kept):
    """Why a report of the right image is not enough; None where it is."""
    checks = kept.get("checks", [])
    failed = [check["name"] for check in checks if not check.get("passed") and not check.get("skipped")]
    if failed:
        return f"failed on the bench: {', '.join(failed)}"
    left = kept.get("wanted", 0) - len(checks)
    return f"was not tried to the end: {left} checks are left" if left > 0 or not checks else None


def other_files(hashes, reports):
    """Which files are not those of the report that is nearest; None where there is no report of any image."""
    others = [[name for name in hashes if kept["files"].get(name) != hashes[name]] for kept in reports]
    return min(others, key=len, default=None)


def verdict(image, reports):
    """(whether an update may be made of it, the line that says so)."""
    hashes = hashes_of(image)
    kept = [one for one in map(read, reports) if one.get("files")]
    same = next((one for one in kept if one["files"] == hashes), None)
    if same is None:
        others = other_files(hashes, kept)
        return False, f"the image in {image} was not tested" + (f": the bench tried another {', '.join(others)}" if others else "; ./box test --bench does it")
    wrong = fault(same)
    skipped = sum(bool(check.get("skipped")) for check in same["checks"])
    passed = f"is the one that was tested: {len(same['checks']) - skipped} checks have passed, {skipped} were skipped"
    return wrong is None, f"the image in {image} {wrong or passed}"


def main():
    may, line = verdict(Path(sys.argv[1]), [Path(word) for word in sys.argv[2:]])
    print(line)
    return 0 if may else 1


if __name__ == "__main__":
    sys.exit(main())
