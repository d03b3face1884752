#!/usr/bin/env -S python3 -B
"""Writes down what is in an image, in SPDX 2.3 and CycloneDX 1.5, with the texts of its licences.

    sbom.py ARCHITECTURE OUT PACKAGES OVERLAY STAND_INS PROGRAMS REPORT.json [SYSROOT] [--board NAME --mesa FOLDER]

SYSROOT is the folder with the packages that were compiled into programs for another processor; without it they are this machine's.
Of a board's image the Mesa in FOLDER (mesa/build) is a part, and so are the files of the board's maker.
Every file and link of OUT/root and of OUT/boot, the partition from which a PC starts, belongs to one of: a package of Debian's
(name, version, source, licence), this project, a stand-in for a library, the show, or what the build made. Where one does not,
or is not what its package has, it is named, and nothing is written.
Results beside REPORT.json: its name with .spdx.json, .cdx.json and .licences.txt; REPORT.json gets `sbom_files`, the
number of files, `sbom_files_unmatched` and `stale_packages`.
"""

import argparse
import hashlib
import json
import os
import sys
from pathlib import Path
from typing import NamedTuple

import architectures
import boards
import cyclonedx
import debs
import licences
import secure_boot
import spdx
import stale

OWN_LICENCE = "Apache-2.0"
BOOT = "boot"  # Its files are listed below this name; the root itself has no such folder.
SHARED = "usr/share/kaori"
# What the build makes, by its path's beginning: of libraries, of the show, of the kernel and its command line.
MADE = (f"{SHARED}/ahead", f"{SHARED}/shaders", f"{BOOT}/EFI/Linux/kaori-")
# Of a board: what lies in the partition of each slot, by its name there.
BOARD_MADE, BOARD_OWN = ("kernel.img", "cmdline.txt", ".dtb"), ("config.txt", "autoboot.txt")
SHOW = (f"{SHARED}/kaori.kaori", f"{SHARED}/still.ppm")
OWN = (f"{SHARED}/surfaces/", f"{SHARED}/firmware/", f"{BOOT}/loader/")
VERSION = f"{SHARED}/version"  # From the overlay; the build writes number and product into it.
LOADERS = "usr/lib/systemd/boot/efi"  # In Debian's package.
KEYS = (f"{SHARED}/keys/", f"{SHARED}/update-keys/", f"{BOOT}/loader/keys/")
GPU_FIRMWARE = "usr/lib/firmware/"


class File(NamedTuple):
    """A regular file; links have no content of their own and are not listed."""

    path: str
    sha1: str
    sha256: str


class Part(NamedTuple):
    """One thing that an image consists of."""

    name: str
    version: str
    what: str
    licence: str
    supplier: str
    package: debs.Package | None  # Of Debian's.
    files: list
    linked: bool  # Compiled into others: it has no files of its own.


class Places(NamedTuple):
    """Where an image and what it was made of lie, and for which processor."""

    arch: architectures.Architecture
    out: Path
    packages: Path
    overlay: Path
    stand_ins: tuple
    programs: Path
    sysroot: Path | None
    board: boards.Board | None = None
    mesa: Path | None = None  # Of our own build, in place of Debian's.


def digest(path, kind):
    with open(path, "rb") as file:
        return hashlib.file_digest(file, kind).hexdigest()


def entries(folder):
    """Paths of all files and links below a folder, in order; links are not followed."""
    for place, folders, files in os.walk(folder):
        for name in files + [name for name in folders if os.path.islink(os.path.join(place, name))]:
            yield os.path.relpath(os.path.join(place, name), folder)


def is_same(one, other):
    """Whether two files, or two links, are alike."""
    if os.path.islink(one) or os.path.islink(other):
        return os.path.islink(one) and os.path.islink(other) and os.readlink(one) == os.readlink(other)
    return os.path.isfile(other) and digest(one, "sha256") == digest(other, "sha256")


def in_package(places, path):
    """Where a file of the root lies among the unpacked packages: below usr, or where its folder was before usr had all."""
    below = path.removeprefix("usr/")
    found = [place for place in (places.packages / path, places.packages / below) if os.path.lexists(place)]
    return found[0] if found else None


def owner_on_board(places, path):
    """Which part a file belongs to that a board has and a PC has not; None where it is no such file."""
    if path.startswith(f"{BOOT}/"):
        name = os.path.basename(path)
        known = {"made": BOARD_MADE, "own": BOARD_OWN, "board-firmware": (*places.board.firmware, places.board.licence)}
        return next((part for part, endings in known.items() if name.endswith(endings)), None)
    built = places.mesa / "root" / path
    return "mesa" if os.path.lexists(built) and is_same(places.out / "root" / path, built) else None


def owner(places, owners, path):
    """Which part a file of the image belongs to; None where nothing is known of it, or it is not what it should be."""
    here = places.out / path if path.startswith(f"{BOOT}/") else places.out / "root" / path
    if path == f"{BOOT}/EFI/BOOT/{places.arch.loader}":
        loader = f"{LOADERS}/systemd-boot{places.arch.efi}.efi"
        unsigned = places.packages / loader
        return owners.get(loader) if is_same(here, unsigned) or secure_boot.is_signed(here, unsigned) else None
    if places.board and (whose := owner_on_board(places, path)):
        return whose
    if path.startswith(MADE) or path in debs.MERGED:
        return "made"
    if path in SHOW:
        return "show"
    if path.startswith(KEYS) and path.endswith((".pub", ".auth")):
        return "keys"
    if path.startswith(GPU_FIRMWARE):
        return "gpu-firmware"
    if path == VERSION:
        return "own"
    if os.path.lexists(places.overlay / path):
        return "own" if is_same(here, places.overlay / path) else None
    if path.startswith(OWN) or os.path.dirname(path) == "usr/bin" and (places.programs / os.path.basename(path)).is_file():
        return "own"
    if os.path.dirname(path) == places.arch.libraries and os.path.basename(path) in places.stand_ins:
        return "stand-ins"
    unpacked = in_package(places, path)
    return owners.get(path) if unpacked and is_same(here, unpacked) else None


def sorted_out(places, packages):
    """({owner: its files}, paths that belong to nothing)."""
    owners = debs.owners(places.packages, packages)
    found, unmatched = {}, []
    paths = [*entries(places.out / "root"), *(f"{BOOT}/{path}" for path in entries(places.out / BOOT))]
    for path in sorted(paths):
        whose = owner(places, owners, path)
        if whose is None:
            unmatched.append(path)
            continue
        here = places.out / ("" if path.startswith(f"{BOOT}/") else "root") / path
        files = found.setdefault(whose, [])
        if not here.is_symlink():
            files.append(File(path, digest(here, "sha1"), digest(here, "sha256")))
    return found, unmatched


def own_version(places):
    """This project's, of the build that made the programs."""
    cache = (places.programs / "../CMakeCache.txt").resolve()
    lines = cache.read_text().splitlines() if cache.is_file() else ()
    return next((line.split("=", 1)[1] for line in lines if line.startswith("CMAKE_PROJECT_VERSION:")), "unknown")


def of_project(places, found):
    """The parts that are not Debian's: (key of the files, name, what it is, licence)."""
    version = own_version(places)
    kinds = (("own", "kaori-box", "the box's programs, units and settings", OWN_LICENCE),
             ("stand-ins", "kaori-stand-ins", "libraries without functions, of the names of others", OWN_LICENCE),
             ("made", "kaori-made", "what the build made: kernels with their command lines, compiled shaders, lists", "NOASSERTION"),
             ("show", "kaori-show", "the show, and a picture of its first moment", "NOASSERTION"),
             ("keys", "kaori-keys", "public keys: whose shows the box plays, whose updates it takes, what a PC's Secure Boot enrols", "NOASSERTION"),
             ("board-firmware", "board-firmware", "files of the board's maker by which it starts, as whoever built the image gave them; "
              "their licence lies beside them, and is the maker's", "NOASSERTION"),
             ("gpu-firmware", "gpu-firmware", "files of the makers of graphics cards, as whoever built the image gave them; their "
              "licences are their makers', and go along with the files", "NOASSERTION"))
    for key, name, what, licence in kinds:
        if key in found:
            yield Part(name, version, what, licence, "NOASSERTION", None, found[key], False)


def copyright_of(folder, package):
    """The text of a package's copyright file, below `folder`; that of its source where it has none."""
    for name in (package.name, package.source):
        path = folder / "usr/share/doc" / name / "copyright"
        if path.is_file():
            return path.read_text(errors="replace")
    return ""


def built_mesa(places):
    """Mesa as a package: of Debian's source, built by us."""
    version = (places.mesa / "version").read_text().strip()
    return debs.Package("mesa", version, places.arch.name, "mesa", version)


def of_debian(package, text, files, texts):
    """A part; `texts` gets those of its licences that SPDX has no name of."""
    known = licences.of_copyright(package.source, text)
    texts.update(known.texts)
    linked = not files
    what = "compiled into the kernel or into programs of the box" if linked else "files of a package of Debian's"
    return Part(package.name, package.version, what, known.expression, "Organization: Debian", package, files, linked)


def compiled_into(places):
    """Name -> package: of the sysroot, and of this machine what that has not, such as the kernel's source."""
    names = stale.lines_of(stale.COMPILED_IN)
    unpacked = debs.unpacked(places.sysroot) if places.sysroot else {}
    return {**debs.installed(names), **{name: package for name, package in unpacked.items() if name in names}}


def parts_of(places, packages, found):
    """(all parts of the image in order, texts of references, {text of a copyright file: whose})."""
    parts, texts, copyrights = list(of_project(places, found)), {}, {}
    shipped = [(packages[name], places.packages, found[name]) for name in sorted(set(found) & set(packages))]
    compiled_in = compiled_into(places)
    linked = [(package, Path("/"), []) for _, package in sorted(compiled_in.items())]
    own = [(built_mesa(places), None, found["mesa"])] if "mesa" in found else []
    for package, folder, files in shipped + own + linked:
        text = copyright_of(folder, package) if folder else (places.mesa / "copyright").read_text(errors="replace")
        copyrights.setdefault(text.strip(), []).append(f"{package.name} {package.version} (source {package.source} {package.source_version})")
        parts.append(of_debian(package, text, files, texts))
    return parts, texts, copyrights


def licence_page(copyrights):
    """What has to go along with an image: the copyright files of all that is in it, each text once."""
    rule = "=" * 100
    pages = ["Licences of what is in this image. Each package's sources are in Debian's archive, in the version that is named.\n"]
    for text, names in sorted(copyrights.items(), key=lambda item: item[1]):
        pages.append("\n".join([rule, *names, rule, "", text, ""]))
    common = Path("/usr/share/common-licenses")
    for path in sorted(path for path in common.glob("*") if not path.is_symlink()):
        pages.append("\n".join([rule, f"{path}, which the texts above name", rule, "", path.read_text(), ""]))
    return "\n".join(pages)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("arch", choices=architectures.NAMED)
    for name in ("out", "packages", "overlay", "stand_ins", "programs", "report"):
        parser.add_argument(name, type=Path)
    parser.add_argument("sysroot", type=Path, nargs="?")
    parser.add_argument("--board", choices=boards.NAMED)
    parser.add_argument("--mesa", type=Path)
    return parser.parse_args()


def main():
    args = arguments()
    report_file = args.report
    places = Places(architectures.NAMED[args.arch], args.out, args.packages, args.overlay, tuple(stale.lines_of(args.stand_ins)), args.programs,
                    args.sysroot, boards.NAMED.get(args.board), args.mesa)
    packages = debs.unpacked(args.packages)
    found, unmatched = sorted_out(places, packages)
    if unmatched:
        sys.exit("\n".join(f"sbom: {path}: belongs to no package and to nothing of the project" for path in unmatched))
    parts, texts, copyrights = parts_of(places, packages, found)
    report = json.loads(report_file.read_text())
    image = spdx.Image(report["root_hash"], own_version(places), int(os.environ["SOURCE_DATE_EPOCH"]))
    name = str(report_file.with_suffix(""))
    for ending, document in ((".spdx.json", spdx.document(image, parts, texts)), (".cdx.json", cyclonedx.document(image, parts))):
        Path(name + ending).write_text(json.dumps(document, indent=1) + "\n")
    Path(f"{name}.licences.txt").write_text(licence_page(copyrights))
    versions = {part.name: part.version for part in parts if part.package}
    report.update(sbom_files=sum(len(part.files) for part in parts), sbom_files_unmatched=len(unmatched),
                  stale_packages=len(stale.stale(versions, stale.newest(versions))))
    report_file.write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
