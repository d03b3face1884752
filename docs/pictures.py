#!/usr/bin/env python3
"""The pictures of the docs: what each of them shows, how it is made, and whether it is older than what it shows.

Usage: pictures.py check              names each picture whose sources have changed since it was made; exits 1 when there is one
       pictures.py make [--all] [--build FOLDER]
                                      makes those anew (--all: every one) with the programs of FOLDER (out/build/release)

docs/pictures.sums keeps one line for each picture: the SHA-256 of its sources when it was made, and its name. A source is a
file or a folder; it is what a reader sees in the picture: the files of a page, a scenario, the show's texts, and what the face is
modelled and drawn with. Of C++ and shaders comments and blanks do not count, and no list of what is built. A picture that is made of a
moving show never comes out twice the same, so that its own bytes say nothing.
"""

import argparse
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SUMS = ROOT / "docs" / "pictures.sums"

SHOW = ("appliance/shows/kaori",)
# What draws a face, and what models the one that is drawn.
DRAWING = (*(f"render/{folder}" for folder in ("face", "gl", "passes", "scene", "shaders")),
           *(f"appliance/authoring/{folder}" for folder in ("appearance", "mesh", "sculpt")))
# What takes a picture of a page, and what the page gets from its server: pictures of the screens and of the lips, and texts.
CONSOLE = ("docs/pictures.mjs", "hw-sim/console", "hw-sim/monitor", *SHOW, *DRAWING)
DESK = ("docs/pictures.mjs", "appliance/programs/desk/page", "appliance/core/board/lip_picture.cpp")
NEEDLES = ("docs/needles.play", "appliance/programs/editor", *SHOW, *DRAWING)
GUIDE = ("docs/guide/pictures.play", "docs/guide/pictures.sh", "appliance/authoring/sheet", "appliance/programs/editor", *SHOW, *DRAWING)
GUIDE_NAMES = ("cast", "expressions", "morphs", "needles", "page", "scenes", "styles")

# Picture -> its sources.
PICTURES = {
    "docs/console.png": CONSOLE,
    "docs/desk.png": DESK,
    "docs/needles.png": NEEDLES,
    **{f"docs/guide/pictures/{name}.jpg": GUIDE for name in GUIDE_NAMES},
}


CODE = (".cpp", ".h", ".frag", ".vert", ".glsl")
COMMENT = re.compile(rb"//[^\n]*|/\*.*?\*/", re.S)


def shown_by(file):
    """The bytes of a file that may change what it shows, however its lines are broken; a "//" within a text ends it here as well, which hides a change at most."""
    if file.name == "CMakeLists.txt":
        return b""
    return b"".join(COMMENT.sub(b"", file.read_bytes()).split()) if file.suffix in CODE else file.read_bytes()


def checksum(sources, root=ROOT):
    """Of the names of all files of `sources` and what each shows, in the order of their names."""
    files = []
    for source in sources:
        path = root / source
        files += [one for one in path.rglob("*") if one.is_file()] if path.is_dir() else [path]
    total = hashlib.sha256()
    for file in sorted(files):
        total.update(f"{file.relative_to(root)}\0".encode())
        total.update(hashlib.sha256(shown_by(file)).digest())
    return total.hexdigest()


def read_sums(file=SUMS):
    if not file.exists():
        return {}
    return {name: total for total, name in (line.split() for line in file.read_text().splitlines())}


def old_pictures(pictures=None, sums=None, root=ROOT):
    """The pictures that are not there, or whose sources are not those of which they were made, with the reason."""
    pictures = PICTURES if pictures is None else pictures
    sums = read_sums() if sums is None else sums
    old = {}
    for name, sources in pictures.items():
        if not (root / name).exists():
            old[name] = "is not there"
        elif sums.get(name) != checksum(sources, root):
            old[name] = f"was made before {', '.join(sources)} changed"
    return old


def run(*command, **options):
    subprocess.run([str(part) for part in command], check=True, **options)


def in_browser(build, *names):
    """docs/pictures.mjs, by the runner of the browser tests, which installs their driver beside the build."""
    run(ROOT / "tests/hw-sim/browser/run.sh", build / "bin", build / "browser", ROOT / "docs/pictures.mjs",
        env={**os.environ, "KAORI_PICTURES": ",".join(names), "KAORI_ROOT": str(ROOT)})


def make_needles(build):
    with tempfile.TemporaryDirectory() as folder:
        run(build / "bin/kaori-rehearsal", "--pack", build / "shows/kaori.kaori", "--play", ROOT / "docs/needles.play",
            "--pictures", folder, "--hz", 30, "--size", "960x540")
        still = sorted(pathlib.Path(folder).glob("*.png"))[3]  # Second 3.
        (ROOT / "docs/needles.png").write_bytes(still.read_bytes())


# What makes which pictures.
MAKERS = (
    (("docs/console.png",), lambda build: in_browser(build, "console")),
    (("docs/desk.png",), lambda build: in_browser(build, "desk")),
    (("docs/needles.png",), make_needles),
    (tuple(f"docs/guide/pictures/{name}.jpg" for name in GUIDE_NAMES),
     lambda build: run(ROOT / "docs/guide/pictures.sh", build)),
)


def make(build, every):
    old = PICTURES if every else old_pictures()
    sums = read_sums()
    for names, maker in MAKERS:
        if not any(name in old for name in names):
            continue
        print(f"making {', '.join(names)}", file=sys.stderr)
        maker(build)
        sums.update({name: checksum(PICTURES[name]) for name in names})
        SUMS.write_text("".join(f"{sums[name]}  {name}\n" for name in sorted(sums) if name in PICTURES))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("command", choices=("check", "make"))
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "out/build/release")
    asked = parser.parse_args()
    if asked.command == "make":
        make(asked.build.resolve(), asked.all)
        return 0
    old = old_pictures()
    for name, why in old.items():
        print(f"{name} {why}; make it anew with ./box pictures, look at it, and commit it with docs/pictures.sums")
    return 1 if old else 0


if __name__ == "__main__":
    sys.exit(main())
