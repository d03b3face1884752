#!/usr/bin/env -S python3 -B
"""The processors that images are built for, and all that differs between them: architectures.py NAME FIELD prints one value for shell
scripts.

Another processor is another row here, its settings of the kernel in kernel/NAME.config, and its files of Debian's in keep-NAME.txt.
"""

import sys
from typing import NamedTuple


class Architecture(NamedTuple):
    """One kind of processor; `name` is Debian's name of it."""

    name: str
    libraries: str  # The folder of the root with its libraries.
    tools: str  # What the names of its compiler and binutils begin with; this machine's own have no such beginning.
    kernel: str  # The kernel's own name of it: ARCH, and its folder below arch.
    kernel_file: str  # In arch/.../boot, and in an image's folder. It is also the target of make.
    efi: str  # In the names of systemd-boot's programs, "linuxx64.efi.stub".
    loader: str  # What a UEFI firmware starts of a disk (UEFI 2.10, 3.5.1.1).

    def tool(self, name):
        """The name of a program of binutils or of a compiler, "objcopy", for files of this processor."""
        return f"{self.tools}{name}"


NAMED = {row.name: row for row in (
    Architecture("amd64", "usr/lib/x86_64-linux-gnu", "", "x86", "bzImage", "x64", "BOOTX64.EFI"),
    Architecture("arm64", "usr/lib/aarch64-linux-gnu", "aarch64-linux-gnu-", "arm64", "Image", "aa64", "BOOTAA64.EFI"),
)}
PC = NAMED["amd64"]


def main():
    name, field = sys.argv[1:]
    if name not in NAMED:
        sys.exit(f"image: there is no architecture {name}; expected {' or '.join(NAMED)}")
    print(getattr(NAMED[name], field))


if __name__ == "__main__":
    main()
