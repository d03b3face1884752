#!/usr/bin/env -S python3 -B
"""What of a board's device tree a kernel has no driver for: device_tree.py TREE.dtb KERNEL GAPS

Prints a line for each enabled device without one, and for each that is driven and waits for one that is not: for its clock, interrupt,
reset, power domain, voltage, wires or the like. A driver is known by what it says itself that it drives: the kernel's tables of
compatibles (struct of_device_id), which lie in its file as they are, the file not being compressed. A driver that a setting lost is
missing there; one that is there and does not work is not found out, nor is the second of two drivers of one device.

GAPS lists what need not work, by the first compatible of the device and with the reason; "A>B" is what device A does without B for. What
stands there and is driven, or is not in the tree at all, is a fault too.
"""

import re
import struct
import sys
from pathlib import Path

MAGIC, BEGIN, END, PROPERTY, NOTHING = 0xD00DFEED, 1, 2, 3, 4  # Devicetree Specification 0.4, 5.4.
# Of struct of_device_id: a name and a type of 32 bytes each, which are hardly ever set, and the compatible in 128.
BEFORE, COMPATIBLE_BYTES = bytes(64), 128
CELL = 4
# A property that names devices, each with as many cells behind it as that device says by another one.
WITH_CELLS = {"clocks": "#clock-cells", "resets": "#reset-cells", "power-domains": "#power-domain-cells", "mboxes": "#mbox-cells",
              "phys": "#phy-cells", "dmas": "#dma-cells", "interrupts-extended": "#interrupt-cells",
              "thermal-sensors": "#thermal-sensor-cells", "pwms": "#pwm-cells", "gpios": "#gpio-cells", "gpio": "#gpio-cells"}
ALONE = re.compile(r".+-supply|pinctrl-\d+|ddc|firmware|brcm,firmware|mmc-pwrseq|msi-parent")
# One bus whose devices say by registers of their own which driver is theirs.
AMBA = "arm,primecell"


class Node:
    """One device, or what describes a part of one."""

    def __init__(self, name, parent):
        self.name, self.parent, self.properties, self.children = name, parent, {}, []

    def path(self):
        return f"{self.parent.path().rstrip('/')}/{self.name}" if self.parent else "/"

    def words(self, name):
        return self.properties.get(name, b"").decode().rstrip("\0").split("\0") if name in self.properties else []

    def cells(self, name):
        content = self.properties.get(name, b"")
        return struct.unpack(f">{len(content) // CELL}I", content)

    def enabled(self):
        return self.words("status") in ([], ["okay"], ["ok"]) and (self.parent is None or self.parent.enabled())

    def all(self):
        yield self
        for child in self.children:
            yield from child.all()


def read_tree(blob):
    """The node at the root of a device tree's blob."""
    magic, _, at, strings = struct.unpack_from(">4I", blob)
    if magic != MAGIC:
        raise ValueError("no device tree")
    top = node = None
    while True:
        token, = struct.unpack_from(">I", blob, at)
        at += CELL
        if token == BEGIN:
            end = blob.index(0, at)
            node = Node(blob[at:end].decode(), node)
            top = top or node
            if node.parent:
                node.parent.children.append(node)
            at = end // CELL * CELL + CELL
        elif token == PROPERTY:
            size, name = struct.unpack_from(">2I", blob, at)
            key = blob[strings + name:blob.index(0, strings + name)].decode()
            node.properties[key] = blob[at + 2 * CELL:at + 2 * CELL + size]
            at += 2 * CELL - -size // CELL * CELL
        elif token == END:
            node = node.parent
        elif token != NOTHING:
            return top


def device_of(node):
    """The device that a node is a part of: a state of a pin controller is driven with it."""
    while node and "compatible" not in node.properties:
        node = node.parent
    return node


def interrupts_to(node):
    """The nearest interrupt controller that a node or one above it names."""
    while node and "interrupt-parent" not in node.properties:
        node = node.parent
    return node.cells("interrupt-parent")[:1] if node else ()


def providers(node, by_handle):
    """(property, device) of all that a device waits for, by what its node says."""
    found = []
    for name in node.properties:
        counted = WITH_CELLS.get(name) or ("#gpio-cells" if name.endswith(("-gpios", "-gpio")) else None)
        if name == "interrupts":
            found += [(name, handle) for handle in interrupts_to(node)]
        elif counted:
            cells = list(node.cells(name))
            while cells:
                handle = cells.pop(0)
                found.append((name, handle))
                del cells[:next(iter(by_handle[handle].cells(counted)), 0) if handle in by_handle else None]
        elif ALONE.fullmatch(name):
            found += [(name, handle) for handle in node.cells(name)]
    return [(name, device_of(by_handle[handle])) for name, handle in found if handle in by_handle]


def is_driven(node, kernel):
    """Whether a table of the kernel has one of a node's compatibles."""
    return any(BEFORE + name.encode().ljust(COMPATIBLE_BYTES, b"\0") in kernel for name in node.words("compatible"))


def read_gaps(text):
    """{compatible: why the device need not work}."""
    return dict(line.split(maxsplit=1) for line in text.splitlines() if line.strip() and not line.startswith("#"))


def faults(tree, kernel, gaps):
    """One line for each device that should be driven and is not, for each that waits in vain, and for each gap that is none."""
    nodes = list(tree.all())
    by_handle = {handle: node for node in nodes for handle in node.cells("phandle")}
    devices = [node for node in nodes[1:] if "compatible" in node.properties and node.enabled()]
    driven = {node: AMBA in node.words("compatible") or is_driven(node, kernel) for node in devices}
    found, unused = [], set(gaps)
    for node in devices:
        name = node.words("compatible")[0]
        own = {name: f"{node.path()} ({name}) has no driver"}
        if driven[node]:
            lacking = [(why, provider, provider.words("compatible")[0]) for why, provider in providers(node, by_handle)
                       if provider and not driven.get(provider, provider is tree)]
            own = {f"{name}>{other}": f"{node.path()} ({name}) waits by `{why}` for {provider.path()} ({other}), which has no driver"
                   for why, provider, other in lacking}
        unused -= {name, *own} if own else set()
        found += [line for key, line in own.items() if not {name, key} & set(gaps)]
    return found + [f"{name} need not be let off: it has a driver, or is not there" for name in sorted(unused)]


def main():
    tree, kernel, gaps = map(Path, sys.argv[1:])
    found = faults(read_tree(tree.read_bytes()), kernel.read_bytes(), read_gaps(gaps.read_text()))
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
