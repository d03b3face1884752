"""The partition from which a UEFI PC starts: a boot loader that shows nothing and asks nothing, and one file for each
slot, which is the kernel and its command line together. Loader and kernels can be signed, each as a whole.

An update overwrites the contents of one slot's file, and of loader.conf, which names the slot that starts; FAT and folders are never
written again. So each kernel's file has one fixed size, whatever is in it, lies in one piece that begins on a whole MiB of the disk,
and loader.conf is one sector.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import fat
import secure_boot
from architectures import PC

MIB = 1 << 20
SECTION_ALIGNED = 0x1000
HEADER_POINTER, TIME_AT, CHECKSUM_AT = 0x3C, 8, 88  # In a PE file, and in its header.
VOLUME_ID = "6B616F72"
LOADERS = "usr/lib/systemd/boot/efi"  # In Debian's packages.
SLOTS = ("a", "b")
KERNEL_BYTES = 24 * MIB  # Of each slot's file; more is refused.
FOLDERS = ("EFI", "EFI/Linux", "EFI/BOOT", "loader")  # In the order in which they are made, each in one sector.
# The loader offers what lies there in its list, where a PC is in set-up mode, and enrols it when a person chooses it.
KEYS_FOLDERS = ("loader/keys", "loader/keys/auto")
SETTINGS = "timeout 0\neditor no\nconsole-mode keep\nauto-entries no\nauto-firmware no\nauto-reboot no\ndefault kaori-{slot}.efi\n"
ENROLS = "secure-boot-enroll manual\n"
INITRAMFS = "firmware.cpio.zst"  # In OUT: files that drivers ask for before the root is there.
TRIES = 4  # What is reserved at the partition's begin changes the tables' size, which changes what has to be reserved.


def run(*command):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout


def free_address(stub, arch):
    """Behind everything that the stub has."""
    ends = [0]
    for line in run(arch.tool("objdump"), "-h", stub).splitlines():
        fields = line.split()
        if len(fields) == 7 and fields[0].isdigit():
            ends.append(int(fields[2], 16) + int(fields[3], 16))
    return max(ends)


def forget_time(program):
    """Of a PE file: when it was made, and the checksum over that, which no firmware looks at."""
    with open(program, "r+b") as file:
        file.seek(HEADER_POINTER)
        header = int.from_bytes(file.read(4), "little")
        for field in (header + TIME_AT, header + CHECKSUM_AT):
            file.seek(field)
            file.write(bytes(4))


def add_sections(stub, sections, target, arch):
    """The stub with files as sections behind its own, in their order."""
    address, options = free_address(stub, arch), []
    for name, path in sections:
        address = -(-address // SECTION_ALIGNED) * SECTION_ALIGNED
        options += ["--add-section", f"{name}={path}", "--change-section-vma", f"{name}={address:#x}"]
        address += path.stat().st_size
    run(arch.tool("objcopy"), *options, stub, target)


def make_unified(stub, parts, target, size=KERNEL_BYTES, arch=PC):
    """The kernel in an EFI program of that size; `parts` are its sections as (name, file), without the kernel's own, which is the last.

    A section of zeros before the kernel brings it to that size: the kernel's own is the last, since it may unpack itself behind its end."""
    padding = target.with_name("padding")
    sections = (*parts[:-1], (".pad", padding), parts[-1])
    padding.write_bytes(bytes(fat.SECTOR))
    add_sections(stub, sections, target, arch)
    missing = size - target.stat().st_size
    if missing < 0:
        sys.exit(f"image: the kernel with all that goes with it has {target.stat().st_size} bytes; a slot has room for {size}")
    with open(padding, "r+b") as file:
        file.truncate(fat.SECTOR + missing // fat.SECTOR * fat.SECTOR)
    add_sections(stub, sections, target, arch)
    padding.unlink()
    forget_time(target)
    with open(target, "r+b") as file:
        file.truncate(size)  # Less than a sector of zeros, where the kernel does not end with one.


def settings(slot, signed=False):
    """loader.conf, which starts a slot by itself: one sector, the same for both slots but for one letter."""
    text = SETTINGS.format(slot=slot) + (ENROLS if signed else "")
    return text + "#" * (fat.SECTOR - len(text) - 1) + "\n"


def make_empty(image, size_mib, folders):
    """A FAT32 in which the first file that is made after so many folders begins on a whole MiB."""
    reserved = 32
    for _ in range(TRIES):
        image.unlink(missing_ok=True)
        run("mkfs.vfat", "--invariant", "-F", "32", "-s", "1", "-R", reserved, "-n", "KAORI", "-i", VOLUME_ID, "-C", image,
            size_mib * MIB // 1024)
        with open(image, "rb") as file:
            first_file = fat.table(file).data_at + 1 + folders  # Behind the root's sector and the folders'.
        if first_file * fat.SECTOR % MIB == 0:
            return
        reserved += MIB // fat.SECTOR - first_file % (MIB // fat.SECTOR)
    sys.exit("image: the kernels of the partition boot cannot be laid on whole MiB")


def in_one_piece(sectors, size):
    """Whether a kernel's file lies as an update needs it."""
    return size == KERNEL_BYTES and sectors[0] * fat.SECTOR % MIB == 0 and \
        sectors == list(range(sectors[0], sectors[0] + KERNEL_BYTES // fat.SECTOR))


def lay_out(image, files, size_mib, arch=PC):
    """Makes the partition of a folder's files, the kernels first, and looks where they came to lie."""
    folders = [folder for folder in (*FOLDERS, *KEYS_FOLDERS) if (files / folder).is_dir()]
    make_empty(image, size_mib, len(folders))
    for folder in folders:
        run("mmd", "-i", image, f"::/{folder}")
    kernels = [f"EFI/Linux/kaori-{slot}.efi" for slot in SLOTS]
    keys = sorted(str(path.relative_to(files)) for path in (files / KEYS_FOLDERS[-1]).glob("*"))
    for path in (*kernels, f"EFI/BOOT/{arch.loader}", "loader/loader.conf", *keys):
        run("mcopy", "-m", "-i", image, files / path, f"::/{path}")
    with open(image, "rb") as file:
        for path in kernels:
            if not in_one_piece(*fat.find(file, *path.split("/"))):
                sys.exit(f"image: {path} does not lie in one piece on whole MiB of the partition boot")
        sectors, size = fat.find(file, "loader", "LOADER~1.CON")
        if (len(sectors), size) != (1, fat.SECTOR):
            sys.exit("image: loader.conf does not fill one sector of the partition boot")


def make_files(out, packages, files, keys, arch):
    """What lies on the partition, into the folder `files`; signed, and with what a PC enrols, where there are keys."""
    for folder in FOLDERS:
        (files / folder).mkdir(parents=True)
    loader, stub = files / "EFI/BOOT" / arch.loader, packages / LOADERS / f"linux{arch.efi}.efi.stub"
    shutil.copyfile(packages / LOADERS / f"systemd-boot{arch.efi}.efi", loader)
    room = secure_boot.signature_bytes(loader, keys) if keys else 0
    for slot in SLOTS:
        target = files / f"EFI/Linux/kaori-{slot}.efi"
        make_unified(stub, sections_of(out, slot, arch), target, KERNEL_BYTES - room, arch)
        if keys:
            secure_boot.sign(target, keys)
    (files / "loader/loader.conf").write_text(settings(SLOTS[0], bool(keys)))
    if keys:
        secure_boot.sign(loader, keys)
        (files / KEYS_FOLDERS[-1]).mkdir(parents=True)
        for name in secure_boot.ENROLLED:
            shutil.copyfile(keys / name, files / KEYS_FOLDERS[-1] / name)


def sections_of(out, slot, arch):
    """Of a slot's program, the kernel last; with the initramfs in OUT, where there is one."""
    initramfs = out / INITRAMFS
    with_files = ((".initrd", initramfs),) if initramfs.is_file() else ()
    return ((".osrel", out / "root/etc/os-release"), (".cmdline", out / command_line_name(slot)), *with_files, (".linux", out / arch.kernel_file))


def make(out, packages, size_mib, keys=None, arch=PC):
    """OUT/boot.vfat, from the kernel in OUT and the command lines of both slots; slot a starts by itself.

    `keys` is a folder of secure_boot.py's, with which loader and kernels are signed."""
    files = out / "boot"
    shutil.rmtree(files, ignore_errors=True)
    make_files(out, Path(packages), files, keys, arch)
    date = int(os.environ["SOURCE_DATE_EPOCH"])
    for path in sorted(files.rglob("*"), reverse=True):
        os.utime(path, (date, date))
    image = out / "boot.vfat"
    lay_out(image, files, size_mib, arch)
    return image


def command_line_name(slot):
    """The file with the command line of a slot's kernel; whoever starts the kernel without this partition starts slot a."""
    return "cmdline" if slot == SLOTS[0] else f"cmdline-{slot}"
