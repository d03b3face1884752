#!/usr/bin/env -S python3 -B
"""Makes the box's root: what keep.txt names of Debian's packages, our programs, our own files, and every library
that any of these links to, but for those of stand_ins.txt, which are replaced by empty ones.

    assemble.py [--board NAME --mesa FOLDER] ARCHITECTURE PACKAGES KEEP STAND_INS OVERLAY ROOT PROGRAM...

What only one kind of processor has is in a file beside KEEP: keep-amd64.txt. A board has a file of its own in that one's place, and
the Mesa in FOLDER (mesa/build) in place of Debian's.
"""

import argparse
import fnmatch
import os
import shutil
import subprocess
import sys
from pathlib import Path

from debs import MERGED, merged
import architectures
import boards
import stand_in

# What the stage opens besides its libraries, in its order, in their folder; then the show.
OPENED = ("libEGL_mesa.so.0", "dri/swrast_dri.so")
MESA = ("*/dri/*_dri.so", "*/libEGL_mesa.so.*", "*/libgbm.so.*", "*/libglapi.so.*", "*/drirc.d/*", "*/egl_vendor.d/*")
AHEAD = "usr/share/kaori/ahead"
LARGE_BYTES = 8 << 20  # Of LLVM and of Mesa's drivers a third is looked at until the first picture.
MOUNT_POINTS = ("dev", "proc", "sys", "run", "tmp", "var/lib/kaori")


def index(packages):
    """Every file and link of the packages: its path in the box -> its path here."""
    found = {}
    for folder, folders, files in os.walk(packages):
        for name in files + [f for f in folders if os.path.islink(os.path.join(folder, f))]:
            path = os.path.join(folder, name)
            found[merged(os.path.relpath(path, packages))] = path
    return found


def with_mesa(files, mesa):
    """The files with another Mesa in place of all of Debian's, so that none of its parts meets one of the other."""
    others = {name: path for name, path in files.items() if not any(fnmatch.fnmatch(name, pattern) for pattern in MESA)}
    return {**others, **index(mesa)}


def lines_of(path):
    """Without comments and empty lines."""
    return [line.strip() for line in Path(path).read_text().splitlines() if line.strip() and line[0] != "#"]


def chosen(keep, files):
    for line in lines_of(keep):
        pattern = line.lstrip("/")
        names = fnmatch.filter(files, pattern)
        if not names:
            sys.exit(f"{keep}: no package has {line}")
        yield from names


def needed(path):
    """The libraries that an ELF file links to, by name, and the loader of a program, by path."""
    with open(path, "rb") as file:
        if file.read(4) != b"\x7fELF":
            return []
    shown = subprocess.run(["readelf", "-dl", path], capture_output=True, text=True, check=True).stdout
    names = [line.split("[", 1)[1].rstrip("]") for line in shown.splitlines() if "(NEEDED)" in line]
    return names + [line.split(": ", 1)[1].rstrip("]")
                    for line in shown.splitlines() if "program interpreter" in line]


def find_library(name, files, arch):
    if name.startswith("/"):
        return merged(name.lstrip("/"))
    for folder in (arch.libraries, f"{arch.libraries}/systemd", "usr/lib64", "usr/lib"):
        if f"{folder}/{name}" in files:
            return f"{folder}/{name}"
    return sys.exit(f"no package has the library {name}")


def with_libraries(names, programs, files, replaced, arch):
    """The names, and everything they link to but what is replaced; a link brings what it points to."""
    kept = set()
    waiting = list(names)
    for program in programs:
        waiting += [find_library(name, files, arch) for name in needed(program)]
    while waiting:
        name = waiting.pop()
        if name in kept:
            continue
        kept.add(name)
        path = files[name]
        if os.path.islink(path):
            target = os.readlink(path)
            target = merged(target.lstrip("/")) if target.startswith("/") else \
                os.path.normpath(os.path.join(os.path.dirname(name), target))
            waiting.append(target)
        else:
            waiting += [find_library(library, files, arch) for library in needed(path) if library not in replaced]
    return sorted(kept)


def linked(path):
    """The parts of a library that the dynamic linker reads, as (first byte, bytes): symbols and relocations, which lie before
    its code, and what is relocated, which is all that can be written. Code and tables are read as they are used."""
    shown = subprocess.run(["readelf", "-SlW", path], capture_output=True, text=True, check=True).stdout
    rows = [line.replace("[ ", "[").split() for line in shown.splitlines()]
    code = next(int(row[4], 16) for row in rows if row[1:2] == [".init"])
    written = [(int(row[1], 16), int(row[4], 16)) for row in rows if row[:1] == ["LOAD"] and "W" in row[6]]
    return [(0, code), *written]


def write_ahead(stage, files, replaced, root, arch, opened=OPENED):
    """What the first program reads ahead for the stage: the programs that it loads, about in their order, and of large
    ones what the dynamic linker reads.

    Not the show: of that it looks at a small part only."""
    waiting = [find_library(name, files, arch) for name in needed(stage)] + [f"{arch.libraries}/{name}" for name in opened]
    order = []
    while waiting:
        name = waiting.pop(0)
        if name not in order:
            order.append(name)
            waiting += [find_library(library, files, arch) for library in needed(files[name]) if library not in replaced]
    target = root / AHEAD
    target.parent.mkdir(parents=True, exist_ok=True)
    parts = [f"/usr/bin/{Path(stage).name}\n"]
    for name in order:
        if os.path.getsize(files[name]) <= LARGE_BYTES:
            parts.append(f"/{name}\n")
        else:
            parts += [f"{first} {bytes_of} /{name}\n" for first, bytes_of in linked(files[name])]
    target.write_text("".join(parts))


def copy(names, files, root):
    """Names of one file stay names of one file."""
    copies = {}
    for name in names:
        path, target = files[name], root / name
        target.parent.mkdir(parents=True, exist_ok=True)
        state = os.lstat(path)
        if os.path.islink(path):
            os.symlink(os.readlink(path), target)
        elif state.st_ino in copies:
            os.link(copies[state.st_ino], target)
        else:
            shutil.copy2(path, target)
            copies[state.st_ino] = target


def replace(replaced, kept, files, root, arch):
    for name in replaced:
        users = [files[user] for user in kept if not os.path.islink(files[user]) and name in needed(files[user])]
        if not users:  # Without LLVM, as on a board, nobody links to what only LLVM does.
            continue
        stand_in.make(files[find_library(name, files, arch)], users, root / arch.libraries / name, arch)


def install(programs, root, arch):
    for program in programs:
        target = root / "usr/bin" / Path(program).name
        target.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([arch.tool("strip"), "-o", target, program], check=True)
        target.chmod(0o755)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--board", choices=boards.NAMED)
    parser.add_argument("--mesa")
    for name in ("processor", "packages", "keep", "stand_ins", "overlay", "root"):
        parser.add_argument(name)
    parser.add_argument("programs", nargs="+")
    return parser.parse_args()


def main():
    args = arguments()
    keep, overlay, programs = args.keep, args.overlay, args.programs
    arch, root, board = architectures.NAMED[args.processor], Path(args.root), boards.NAMED.get(args.board)
    keeps = (keep, Path(keep).with_name(f"keep-{args.board or arch.name}.txt"))
    files = with_mesa(index(args.packages), args.mesa) if args.mesa else index(args.packages)
    shutil.rmtree(root, ignore_errors=True)
    for name in MOUNT_POINTS:
        (root / name).mkdir(parents=True)
    for name in MERGED:
        (root / name).symlink_to(f"usr/{name}")
        (root / "usr" / name).mkdir(parents=True, exist_ok=True)
    replaced = lines_of(args.stand_ins)
    names = [name for file in keeps for name in chosen(file, files)]
    kept = with_libraries(names, programs, files, replaced, arch)
    copy(kept, files, root)
    replace(replaced, kept, files, root, arch)
    install(programs, root, arch)
    opened = (OPENED[0], board.opened) if board else OPENED
    write_ahead(next(program for program in programs if program.endswith("/kaori-stage")), files, replaced, root, arch, opened)
    shutil.copytree(overlay, root, symlinks=True, dirs_exist_ok=True)


main()
