#!/usr/bin/env -S python3 -B
"""Puts files of graphics cards' makers into an image: gpu_firmware.py FOLDER NAMES OUT

FOLDER has them by the names by which drivers ask, as in amdgpu/polaris10_mc.bin; it may be a package of Debian's that is unpacked
(lib/firmware/...). Of them those are taken that NAMES lists, which drivers of the kernel may ask for. They go into
OUT/root/usr/lib/firmware, and into OUT/firmware.cpio.zst, an initramfs: drivers ask before the root is there.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

BELOW = ("", "lib/firmware", "usr/lib/firmware")  # Of the folder: where packages have them.
IN_INITRAMFS = "lib/firmware"  # Where the kernel looks.
FOLDER_MODE, FILE_MODE = 0o40755, 0o100644
ALIGNED = 4
END = "TRAILER!!!"


def chosen(folder, names):
    """{name: file} of what is there of the names; a link counts as what it points to."""
    found = {}
    for name in names:
        files = [folder / below / name for below in BELOW if (folder / below / name).is_file()]
        if files:
            found[name] = files[0]
    return found


def entry(number, name, mode, content=b""):
    """One of an archive in cpio's form "newc", as the kernel's Documentation/driver-api/early-userspace/buffer-format.rst has it."""
    fields = (number, mode, 0, 0, 1, int(os.environ["SOURCE_DATE_EPOCH"]), len(content), 0, 0, 0, 0, len(name) + 1, 0)
    head = b"070701" + b"".join(b"%08X" % field for field in fields) + name.encode() + b"\0"
    return b"".join(part + bytes(-len(part) % ALIGNED) for part in (head, content))


def archive(files):
    """Of {name: file}: folders first, each once."""
    names = sorted(f"{IN_INITRAMFS}/{name}" for name in files)
    folders = sorted({str(parent) for name in names for parent in Path(name).parents} - {"."})
    entries = [(name, FOLDER_MODE, b"") for name in folders]
    entries += [(f"{IN_INITRAMFS}/{name}", FILE_MODE, files[name].read_bytes()) for name in sorted(files)]
    entries.append((END, 0, b""))
    return b"".join(entry(number, *one) for number, one in enumerate(entries, 1))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    folder, names, out = (Path(word) for word in sys.argv[1:])
    files = chosen(folder, names.read_text().split())
    if not files:
        sys.exit(f"image: {folder} has no file that a driver of this kernel asks for; {names} lists their names")
    for name, file in files.items():
        target = out / "root/usr/lib/firmware" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, target)
        target.chmod(0o644)
    packed = subprocess.run(["zstd", "-q", "-19", "-T2", "-c"], input=archive(files), capture_output=True, check=True).stdout
    (out / "firmware.cpio.zst").write_bytes(packed)
    print(f"      {len(files)} files of graphics cards' makers, {len(packed) / 1e6:.1f} MB packed", file=sys.stderr)


if __name__ == "__main__":
    main()
