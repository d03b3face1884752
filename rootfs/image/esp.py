"""The partition from which a UEFI PC starts: a boot loader that shows nothing and asks nothing, and one file for each
slot, which is the kernel and its command line together. It can be signed as a whole, and its name can count tries."""

import os
import shutil
import subprocess
from pathlib import Path

MIB = 1 << 20
SECTION_ALIGNED = 0x1000
HEADER_POINTER, TIME_AT, CHECKSUM_AT = 0x3C, 8, 88  # In a PE file, and in its header.
VOLUME_ID = "6B616F72"
LOADERS = "usr/lib/systemd/boot/efi"  # In Debian's packages.
SETTINGS = "timeout 0\neditor no\nconsole-mode keep\nauto-entries no\nauto-firmware no\nauto-reboot no\n"


def run(*command):
    return subprocess.run([str(c) for c in command], check=True, capture_output=True, text=True).stdout


def free_address(stub):
    """Behind everything that the stub has."""
    ends = [0]
    for line in run("objdump", "-h", stub).splitlines():
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


def make_unified(stub, release, cmdline, kernel, target):
    """The kernel in an EFI program, with its command line."""
    address, options = free_address(stub), []
    for name, path in ((".osrel", release), (".cmdline", cmdline), (".linux", kernel)):
        address = -(-address // SECTION_ALIGNED) * SECTION_ALIGNED
        options += ["--add-section", f"{name}={path}", "--change-section-vma", f"{name}={address:#x}"]
        address += path.stat().st_size
    run("objcopy", *options, stub, target)
    forget_time(target)


def make(out, packages, size_mib):
    """OUT/boot.vfat, from the kernel and the command line in OUT."""
    files = out / "boot"
    shutil.rmtree(files, ignore_errors=True)
    for folder in ("EFI/BOOT", "EFI/Linux", "loader"):
        (files / folder).mkdir(parents=True)
    loaders = Path(packages) / LOADERS
    shutil.copyfile(loaders / "systemd-bootx64.efi", files / "EFI/BOOT/BOOTX64.EFI")
    make_unified(loaders / "linuxx64.efi.stub", out / "root/etc/os-release", out / "cmdline", out / "bzImage",
                 files / "EFI/Linux/kaori-a.efi")
    (files / "loader/loader.conf").write_text(SETTINGS)
    image = out / "boot.vfat"
    image.unlink(missing_ok=True)
    run("mkfs.vfat", "--invariant", "-F", "32", "-n", "KAORI", "-i", VOLUME_ID, "-C", image, size_mib * MIB // 1024)
    date = int(os.environ["SOURCE_DATE_EPOCH"])
    for path in sorted(files.rglob("*"), reverse=True):
        os.utime(path, (date, date))
    run("mcopy", "-s", "-m", "-i", image, files / "EFI", files / "loader", "::/")
    return image
