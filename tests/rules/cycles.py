#!/usr/bin/env python3
"""Names folders that include each other, directly or around a circle, at every depth of the tree.

Usage: cycles.py ROOT     prints "folder -> folder -> folder" for each circle, and exits 1 when there is one.

At depth one the folders are drivers, render ...; at depth two drivers/base, drivers/ports ...; and so on to the deepest.
A program's main.cpp puts the parts together and is included by nobody: it does not count as its folder.
"""

import pathlib
import sys

import direction
import table


def edges(root, depth):
    """Folder -> the folders that it includes, both cut to `depth` parts of their path."""
    found = {}
    for path, file in direction.sources(root):
        if path.endswith("/" + table.MAIN_FILE):
            continue
        for include in direction.includes(path, file):
            if not include.quoted:
                continue
            here, there = ("/".join(name.split("/")[:-1][:depth]) for name in (path, include.target))
            if there and here != there:
                found.setdefault(here, set()).add(there)
    return found


def circles(graph):
    """The strongly connected parts of more than one folder, each as a sorted list (Tarjan 1972)."""
    number, low, stack, found = {}, {}, [], []

    def visit(node):
        number[node] = low[node] = len(number)
        stack.append(node)
        for other in sorted(graph.get(node, ())):
            if other not in number:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], number[other])
        if low[node] == number[node]:
            part = []
            while not part or part[-1] != node:
                part.append(stack.pop())
            if len(part) > 1:
                found.append(sorted(part))

    for node in sorted(graph):
        if node not in number:
            visit(node)
    return found


def offences(root):
    """A line for each circle, once, at the depth at which it is seen first."""
    deepest = max(path.count("/") for path, _ in direction.sources(root))
    said = set()
    for depth in range(1, deepest + 1):
        for part in circles(edges(root, depth)):
            line = " <-> ".join(part)
            if line not in said:
                said.add(line)
                yield line


def main():
    found = list(offences(pathlib.Path(sys.argv[1])))
    print("\n".join(f"these folders include each other: {line}" for line in found) or "no folders include each other")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
