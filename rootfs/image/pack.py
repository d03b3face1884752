#!/usr/bin/env python3
"""Packs OUT/root into OUT/root.erofs with its tree of hashes; writes OUT/kaori.disk, OUT/cmdline, OUT/cmdline-b, and a report of sizes.

    pack.py OUT PACKAGES REPORT.json [DISK_MIB] [--unweighed] [--medium usb] [--secure-boot KEYS] [--arch NAME] [--board NAME --firmware FOLDER]

The data partition gets what the others leave of the disk. Unweighed: nobody asks what a download weighs, which takes as
long as all the rest. Medium usb: an image that starts from a stick too. KEYS: a folder of secure_boot.py's, which signs. NAME is the
processor (architectures.py): amd64, where none is said. A board (boards.py) starts by its maker's files in FOLDER, and not by UEFI.
"""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

import architectures
import boards
import esp
import pi_boot
import sizes

MIB = 1 << 20
SECTOR = 512
BLOCK = 4096
# Every block that the start reads is hashed. Where the processor has no instructions for SHA-256, as before 2019 or in QEMU,
# this takes a third of the time. The kernel's own name, and veritysetup's.
DIGEST = "blake2b-512"
# Fixed, so that the same root gives the same hash. The salt guards nothing: the root is public.
ROOT_UUID = "6b616f72-6900-4000-8000-000000000001"
VERITY_UUID = "6b616f72-6900-4000-8000-000000000002"
DISK_UUID = "6b616f72-6900-4000-8000-000000000003"
DATA_UUID = "6b616f72-6900-4000-8000-000000000004"
SALT = "6b616f72692d626f78" + "00" * 23

# name, size in MiB, GPT type, the partition's own id. Both slots are filled, so that there is always one to go back to.
EFI, ROOT, VERITY, DATA, FAT = "EF00", "8304", "8385", "8300", "0700"
LAYOUT = (
    ("boot", 64, EFI, "6b616f72-6900-4000-8000-000000000010"),
    ("root-a", 384, ROOT, "6b616f72-6900-4000-8000-000000000011"),
    ("verity-a", 8, VERITY, "6b616f72-6900-4000-8000-000000000012"),
    ("root-b", 384, ROOT, "6b616f72-6900-4000-8000-000000000013"),
    ("verity-b", 8, VERITY, "6b616f72-6900-4000-8000-000000000014"),
    ("data", 960, DATA, "6b616f72-6900-4000-8000-000000000015"),
)
# Of a board, in place of the first: one partition that names the slot, and one for each slot's kernel. They come first, since the
# firmware counts its own kind of partitions.
BOARD_BOOT = (
    ("boot", pi_boot.BOOT_MIB, FAT, "6b616f72-6900-4000-8000-000000000010"),
    ("boot-a", pi_boot.SLOT_MIB, FAT, "6b616f72-6900-4000-8000-000000000016"),
    ("boot-b", pi_boot.SLOT_MIB, FAT, "6b616f72-6900-4000-8000-000000000017"),
)
LEAST_DATA_MIB = 16
UNWEIGHED = "--unweighed"
DISK, USB = "disk", "usb"  # Media from which an image is to start.
ALIGNED_MIB = 1  # Partitions begin on whole MiB; one more at each end holds the table.


def run(*command):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout


def laid_out(disk_mib, board=None):
    """The layout on a disk of this size; as it stands where none is said."""
    layout = (*BOARD_BOOT, *LAYOUT[1:]) if board else LAYOUT
    if disk_mib is None:
        return layout
    rest_mib = disk_mib - 2 * ALIGNED_MIB - sum(size for name, size, _, _ in layout if name != "data")
    if rest_mib < LEAST_DATA_MIB:
        needed_mib = disk_mib - rest_mib + LEAST_DATA_MIB
        sys.exit(f"image: a disk of {disk_mib} MiB has no room for data; {needed_mib} are needed")
    return tuple((name, rest_mib if name == "data" else size, kind, uuid) for name, size, kind, uuid in layout)


def pack_root(out):
    """EROFS, every file owned by root. Not compressed: it starts faster so, and a download shrinks more as a whole."""
    image = out / "root.erofs"
    image.unlink(missing_ok=True)
    run("mkfs.erofs", "-T", os.environ["SOURCE_DATE_EPOCH"], "-U", ROOT_UUID, "--all-root",
        image, out / "root")
    with open(image, "ab") as file:
        file.truncate(-(-image.stat().st_size // BLOCK) * BLOCK)
    return image


def hash_root(out, image):
    """The tree of hashes, and the hash at its root."""
    tree = out / "root.verity"
    tree.unlink(missing_ok=True)
    shown = run("veritysetup", "format", f"--hash={DIGEST}", f"--salt={SALT}", f"--uuid={VERITY_UUID}", image, tree)
    return tree, next(line.split()[-1] for line in shown.splitlines() if line.startswith("Root hash"))


def command_line(image, root_hash, slot, medium=DISK, board=None):
    """The kernel itself sets up the verified root: no program runs before. The tree's first block is its header.

    A kernel that is to find its root on USB authorises what is plugged in there; kaori-boot, its first program, ends that."""
    blocks = image.stat().st_size // BLOCK
    ids = {name: uuid for name, _, _, uuid in LAYOUT}
    root, tree = f"PARTUUID={ids[f'root-{slot}']}", f"PARTUUID={ids[f'verity-{slot}']}"
    table = f"0 {blocks * BLOCK // SECTOR} verity 1 {root} {tree} {BLOCK} {BLOCK} {blocks} 1 {DIGEST} {root_hash} {SALT}"
    words = f"{boards.NAMED[board].command_line} " if board else ""
    return f'dm-mod.waitfor={root},{tree} dm-mod.create="root,,,ro,{table}" root=/dev/dm-0 rootfstype=erofs ro ' \
           f"init=/usr/bin/kaori-boot usbcore.authorized_default={int(medium == USB)} quiet loglevel=3 panic=5 " \
           f"{words}rauc.slot={slot.upper()}"


def folder_of(name, user):
    """A folder that nobody else may look into, as debugfs makes it; `user` as passwd has it."""
    return (f"mkdir {name}", f"set_inode_field {name} uid {user[2]}", f"set_inode_field {name} gid {user[3]}",
            f"set_inode_field {name} mode 040700")


def make_data(out, size_mib):
    """An ext4 with the settings in it, folders of the journal's, the stage's and the lips' own, empty, and no time but the image's."""
    os.environ["E2FSPROGS_FAKE_TIME"] = os.environ["SOURCE_DATE_EPOCH"]
    data = out / "data.ext4"
    data.unlink(missing_ok=True)
    run("mke2fs", "-q", "-t", "ext4", "-U", DATA_UUID, "-E", f"hash_seed={DATA_UUID},lazy_itable_init=0", "-m", "0",
        "-L", "kaori-data", data, f"{size_mib}M")
    users = {line.split(":")[0]: line.split(":") for line in (out / "root/etc/passwd").read_text().splitlines()}
    settings = Path(__file__).with_name("box.toml")
    for change in ("mkdir journal", "mkdir settings", f"write {settings} settings/box.toml",
                   *(f"set_inode_field settings/box.toml {field}" for field in ("uid 0", "gid 0", "mode 0100644")),
                   *folder_of("own", users["kaori-stage"]), *folder_of("lips", users["kaori-lips"]),
                   *folder_of("input", users["kaori-input"]), *folder_of("desk", users["kaori-desk"]), "mkdir shows", "mkdir update", "mkdir restore", "set_inode_field restore mode 040711"):
        run("debugfs", "-w", "-R", change, data)
    return data


def write_disk(out, layout, parts):
    """A sparse file; `parts` are written into the partitions of their names."""
    disk = out / "kaori.disk"
    disk.unlink(missing_ok=True)
    with open(disk, "wb") as file:
        file.truncate((sum(size for _, size, _, _ in layout) + 2 * ALIGNED_MIB) * MIB)
    options, start = [], ALIGNED_MIB
    for number, (name, size, kind, uuid) in enumerate(layout, 1):
        options += ["-n", f"{number}:{start}M:+{size}M", "-t", f"{number}:{kind}", "-c", f"{number}:{name}",
                    "-u", f"{number}:{uuid}"]
        if name in parts:
            if parts[name].stat().st_size > size * MIB:
                sys.exit(f"image: {parts[name].name} does not fit into {name} ({size} MiB)")
            run("dd", f"if={parts[name]}", f"of={disk}", "bs=1M", f"seek={start}", "conv=notrunc,sparse")
        start += size
    run("sgdisk", "-o", "-U", DISK_UUID, *options, disk)
    return disk


# zstd's levels, as an update is packed (appliance/core/update/compression.cpp): while one works on an image, and for a download.
QUICK, SMALLEST = 12, 19


def compressed_bytes(level, *files):
    """What a download weighs: everything that the box starts from, packed by zstd within the window that a box unpacks."""
    joined = b"".join(f.read_bytes() for f in files)
    return len(subprocess.run(["zstd", "-q", f"-{level}", "--zstd=wlog=23", "-T2", "-c"], input=joined, capture_output=True, check=True).stdout)


def folder_bytes(folder):
    """Of files; each counts once, whatever its names."""
    sizes = {}
    for path in folder.rglob("*"):
        if path.is_file() and not path.is_symlink():
            state = path.stat()
            sizes[state.st_ino] = state.st_size
    return sum(sizes.values())


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("out", "packages", "report"):
        parser.add_argument(name, type=Path)
    parser.add_argument("disk_mib", type=int, nargs="?")
    parser.add_argument(UNWEIGHED, action="store_true")
    parser.add_argument("--medium", choices=(DISK, USB), default=DISK)
    parser.add_argument("--secure-boot", type=Path)
    parser.add_argument("--arch", choices=architectures.NAMED, default=architectures.PC.name)
    parser.add_argument("--board", choices=boards.NAMED)
    parser.add_argument("--firmware", type=Path)
    return parser.parse_args()


def make_boot(args, arch, size_mib):
    """{partition: its content} of what the firmware reads: a PC's or a board's."""
    if not args.board:
        return {"boot": esp.make(args.out, args.packages, size_mib, args.secure_boot, arch)}
    command_lines = {slot: (args.out / esp.command_line_name(slot)).read_text() for slot in esp.SLOTS}
    return pi_boot.make(args.out, boards.NAMED[args.board], args.firmware, args.out / arch.kernel_file, command_lines)


def weigh(report, kernel, image, tree, board):
    """What a download weighs into the report, packed quickly; of a board, whose Mesa has no LLVM, also without its kernel, and by part, as a
    download is packed."""
    report["compressed_mb"] = round(compressed_bytes(QUICK, kernel, image, tree) / 1e6, 1)
    if board:
        root = image.with_name("root")
        report["image_no_llvm_mb"] = round(compressed_bytes(SMALLEST, image, tree) / 1e6, 1)
        report["compressed_parts_mb"] = {name: round(compressed_bytes(SMALLEST, *files) / 1e6, 1)
                                         for name, files in sizes.parts(root, {"kernel": [kernel], "verity": [tree]}).items()}


def main():
    args = arguments()
    out, arch = args.out, architectures.NAMED[args.arch]
    layout = laid_out(args.disk_mib, args.board)
    sizes_mib = {name: size for name, size, _, _ in layout}
    image = pack_root(out)
    tree, root_hash = hash_root(out, image)
    for slot in esp.SLOTS:
        (out / esp.command_line_name(slot)).write_text(command_line(image, root_hash, slot, args.medium, args.board) + "\n")
    boot = make_boot(args, arch, sizes_mib["boot"])
    data = make_data(out, sizes_mib["data"])
    write_disk(out, layout, {**boot, "data": data, **{f"root-{slot}": image for slot in esp.SLOTS},
                            **{f"verity-{slot}": tree for slot in esp.SLOTS}})
    kernel = out / arch.kernel_file
    in_mb = {"kernel": kernel.stat().st_size, "root": image.stat().st_size, "verity": tree.stat().st_size,
             "unpacked": folder_bytes(out / "root"),
             "graphics": sum(f.stat().st_size for f in (out / "root").rglob("libLLVM*") if not f.is_symlink())
             + next((out / "root").rglob("swrast_dri.so")).stat().st_size,
             "show": (out / "root/usr/share/kaori/kaori.kaori").stat().st_size}
    if (out / esp.INITRAMFS).is_file():
        in_mb["gpu_firmware"] = (out / esp.INITRAMFS).stat().st_size
    report = {"root_hash": root_hash, "signed": bool(args.secure_boot), "medium": args.medium, "arch": arch.name,
              "parts_mb": {name: round(size / 1e6, 1) for name, size in in_mb.items()}}
    if not args.unweighed:
        weigh(report, kernel, image, tree, args.board)
    args.report.write_text(json.dumps(report, indent=2) + "\n")


if __name__ == "__main__":
    main()
