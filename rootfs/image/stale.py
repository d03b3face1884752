#!/usr/bin/env -S python3 -B
"""Names what an image carries of Debian in a version that apt has a newer one of.

    stale.py --list IMAGE.spdx.json        of an image, by the list of what is in it; exits 1 where there is any
    stale.py --unpacked PACKAGES           of packages that were unpacked for images
    stale.py --stamp PACKAGES NAMES.txt    prints a hash of the names that are wanted and the versions that are unpacked

Compares with what apt knew when it last asked its servers (apt-get update), of the release that images are made of.
"""

import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path

import debs

RELEASE = "bookworm"
SUITES = re.compile(rf"{RELEASE}(-updates|-security)?/main")
COMPILED_IN = Path(__file__).with_name("compiled_in.txt")


def newest(names):
    """Name -> (version, suite) of the newest that apt knows for the release; without names that apt does not know."""
    if not names:
        return {}
    shown = subprocess.run(["apt-cache", "madison", *sorted(names)], capture_output=True, text=True, check=True).stdout
    found = {}
    for line in shown.splitlines():
        name, version, place = (field.strip() for field in line.split(" | "))
        suite = next((word for word in place.split() if SUITES.fullmatch(word)), "")
        if suite and place.endswith(" Packages") and (name not in found or debs.is_newer(version, found[name][0])):
            found[name] = version, suite.split("/")[0]
    return found


def stale(versions, known):
    """(name, its version, the newer one, where that is) of each of {name: version} that `known`, as of newest(), has newer."""
    return [(name, version, *known[name]) for name, version in sorted(versions.items())
            if name in known and debs.is_newer(known[name][0], version)]


def of_list(path):
    """{name: version} of the Debian packages in a list of what is in an image."""
    listed = json.loads(Path(path).read_text())["packages"]
    found = {}
    for package in listed:
        for reference in package.get("externalRefs", ()):
            if reference["referenceLocator"].startswith("pkg:deb/debian/"):
                found[package["name"]] = package["versionInfo"]
    return found


def lines_of(path):
    """Without comments and empty lines."""
    return [line for line in Path(path).read_text().splitlines() if line and line[0] != "#"]


def stamp(packages, names):
    versions = sorted(f"{package.name} {package.version}" for package in debs.unpacked(packages).values())
    return hashlib.sha256("\n".join([*lines_of(names), "", *versions]).encode()).hexdigest()


def report(found):
    """Lines for people, and how the newer versions get into an image."""
    compiled_in = set(lines_of(COMPILED_IN))
    for name, version, newer, suite in found:
        yield f"{name}: {version}; {suite} has {newer}"
    ours = [name for name, *_ in found if name in compiled_in]
    if len(ours) < len(found):
        yield "./box image takes the newer packages."
    if ours:
        yield f"Compiled in, from this machine: sudo apt-get install --only-upgrade {' '.join(ours)}; then ./box image"


def main():
    kind, path, *names = sys.argv[1:]
    if kind == "--stamp":
        print(stamp(path, names[0]))
        return
    versions = of_list(path) if kind == "--list" else \
        {name: package.version for name, package in debs.unpacked(path).items()}
    known = newest(versions)
    unknown = f"stale: apt knows nothing of Debian's {RELEASE}; say apt-get update" if versions and not known else None
    found = stale(versions, known)
    if kind == "--unpacked":  # Without apt's lists the packages are used as they are.
        print("".join(f"{name} {version} -> {newer}\n" for name, version, newer, _ in found), end="")
        print(unknown or "", end="\n" if unknown else "", file=sys.stderr)
        return
    if unknown:
        sys.exit(unknown)
    print("\n".join(report(found)) or "Of everything in the image apt has no newer version.")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
