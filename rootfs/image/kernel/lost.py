#!/usr/bin/env -S python3 -B
"""Which settings the kernel would make by itself, and lost to "nothing at all": lost.py SOURCE ARCH SETTINGS CONFIG DEFAULTS

CONFIG is made by `make allnoconfig` of our settings, DEFAULTS by `make alldefconfig` of the same. A setting that is on in the second
alone is one of which the kernel's authors say that whoever has the rest wants it too: a clock of a chip whose other drivers are there, a
fault of a processor. Of those that belong to hardware (FOLDERS, NAMES) each must stand in SETTINGS, as =y or as =n: it was thought of
then. Prints a line for each that does not.
"""

import re
import sys
from pathlib import Path

# Below drivers. What is there makes that a device answers at all; what a device can do besides stands elsewhere.
FOLDERS = ("bus", "char/hw_random", "clk", "clocksource", "dma", "gpio", "iommu", "irqchip", "mailbox", "mmc", "pci", "phy", "pinctrl", "pmdomain",
           "regulator", "reset", "soc", "usb/core", "usb/host")
FILES = ("mm/Kconfig", "drivers/usb/Kconfig", "drivers/acpi/Kconfig", "drivers/rtc/Kconfig")
# In FILES and in the processor's own: memory that a device reaches, timers, and faults of chips.
NAMES = re.compile(r"ZONE_DMA\w*|X86_PM_TIMER|USB_PCI\w*|RTC_HCTOSYS|\w*ERRATUM\w*|\w*PREITS")
ENTRY = re.compile(r"^(?:menu)?config (\w+)\n((?:[ \t].*\n|\n)*)", re.M)
# Whoever configures is asked; other settings follow from those.
ASKED = re.compile(r'^\s+(?:bool|tristate|prompt)\s+"', re.M)


def asked_in(file):
    return {name for name, body in ENTRY.findall(file.read_text(errors="replace")) if ASKED.search(body)}


def of_hardware(source, arch):
    """Names of all settings that are looked at."""
    found = set()
    for folder in FOLDERS:
        for file in (source / "drivers" / folder).rglob("Kconfig*"):
            found |= asked_in(file)
    for file in (*FILES, f"arch/{arch}/Kconfig"):
        if (source / file).is_file():
            found |= {name for name in asked_in(source / file) if NAMES.fullmatch(name)}
    return found


def settings_on(text):
    return set(re.findall(r"^CONFIG_(\w+)=y$", text, re.M))


def lost(hardware, settings, config, defaults):
    """Names, sorted."""
    named = set(re.findall(r"^CONFIG_(\w+)=", settings, re.M))
    return sorted(((settings_on(defaults) - settings_on(config)) & hardware) - named)


def main():
    source, arch, *files = sys.argv[1:]
    found = lost(of_hardware(Path(source), arch), *(Path(file).read_text() for file in files))
    for name in found:
        print(f"the kernel's authors have CONFIG_{name}=y beside our settings, which leave it out; say there =y, or =n and why")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
