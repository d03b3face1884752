#!/usr/bin/env python3
"""Runs clang-tidy, with the checks of .clang-tidy, over every source that a build compiles.

Usage: tidy.py ROOT BUILD     BUILD has been built. Prints each warning once, and exits 1 when there is one.

All sources of one target are read together, so that what they all include is parsed once. A target whose sources, headers,
command and checks are as they were when nothing was found is not looked at again (BUILD/tidy).
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import time

TIDY = "clang-tidy"
NOT_FOR_CLANG = {"-Winvalid-pch", "-fpch-preprocess"}
PROGRESS_S = 10
WARNING = re.compile(r"^(\S+?:\d+:\d+: (?:warning|error): .*)$", re.MULTILINE)


def targets(build):
    """Target -> its entries of the compilation database."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        name = re.search(r"-o \S*?CMakeFiles/([^/\s]+)\.dir/", entry["command"])
        if name and "cmake_pch" not in entry["file"]:
            found.setdefault(name[1], []).append(entry)
    return {name: entries for name, entries in found.items() if not name.endswith("_headers")}


def arguments(entry):
    """The compiler's arguments, without those that only GCC understands, the file and the object."""
    words = shlex.split(entry["command"])
    words = words[next(i for i, word in enumerate(words) if re.search(r"(c\+\+|g\+\+|clang\+\+)[-\d]*$", word)) + 1:]
    kept, skip = [], False
    for word, after in zip(words, words[1:] + [""]):
        if skip:
            skip = False
        elif word in ("-o", "-c", "-MF", "-MT") or (word == "-include" and after.endswith("cmake_pch.hxx")):
            skip = True
        elif word not in NOT_FOR_CLANG and word != "-MD":
            kept.append(word)
    return kept


def dependencies(build):
    """Object -> the files that it was made of, as ninja noted them."""
    listed = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True, check=True).stdout
    found, now = {}, None
    for line in listed.splitlines():
        if line and not line.startswith(" "):
            now = found.setdefault(line.split(":")[0], [])
        elif line.strip():
            now.append(line.strip())
    return found


class Checker:
    def __init__(self, root, build):
        self.root, self.build, self.folder = root, build, build / "tidy"
        self.folder.mkdir(exist_ok=True)
        self.deps = dependencies(build)
        self.hashes = {}
        version = subprocess.run([TIDY, "--version"], capture_output=True, text=True, check=True).stdout
        self.common = version + (root / ".clang-tidy").read_text()

    def hash_of(self, path):
        if path not in self.hashes:
            file = pathlib.Path(path) if path.startswith("/") else self.build / path
            self.hashes[path] = hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() else "none"
        return self.hashes[path]

    def key(self, entries):
        told = hashlib.sha256(self.common.encode())
        for entry in entries:
            obj = re.search(r"-o (\S+)", entry["command"])[1]
            told.update(entry["command"].encode())
            for path in sorted(set(self.deps.get(obj, [])) | {entry["file"]}):
                if not path.startswith("/usr/") and not path.endswith(".gch"):
                    told.update(self.hash_of(path).encode())
        return told.hexdigest()

    def check(self, name, entries):
        """The warnings of one target; none where it is known to have none."""
        stamp = self.folder / f"{name}.none"
        key = self.key(entries)
        if stamp.is_file() and stamp.read_text() == key:
            return []
        source = self.folder / f"{name}.cpp"
        source.write_text("".join(f'#include "{entry["file"]}"\n' for entry in entries))
        done = subprocess.run([TIDY, "--quiet", str(source), "--", *arguments(entries[0])], capture_output=True, text=True,
                              check=False, cwd=self.root)
        found = sorted(set(WARNING.findall(done.stdout)))
        if done.returncode != 0 and not found:
            found = [f"{name}: clang-tidy failed: {done.stderr.strip()[-400:]}"]
        if not found:
            stamp.write_text(key)
        return found


def offences(root, build):
    """Every warning once."""
    checker, said, told = Checker(root, build), set(), time.monotonic()
    work = sorted(targets(build).items(), key=lambda item: -len(item[1]))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = [pool.submit(checker.check, name, entries) for name, entries in work]
        for count, done in enumerate(concurrent.futures.as_completed(running), 1):
            for line in done.result():
                if line not in said:
                    said.add(line)
                    yield line.replace(f"{root}/", "")
            if time.monotonic() - told > PROGRESS_S:
                told = time.monotonic()
                print(f"clang-tidy: {count} of {len(work)} targets", file=sys.stderr, flush=True)


def main():
    found = list(offences(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
    print("\n".join(found) or "clang-tidy finds nothing")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
