#!/usr/bin/env -S python3 -B
"""Keys of one's own for a PC's Secure Boot, and what they sign: secure_boot.py keys FOLDER

FOLDER gets, once, for each of PK (whose PC it is), KEK (who may change db) and db (whose programs start): NAME.key, which is secret,
NAME.crt, and NAME.auth, which a firmware in set-up mode takes. Only db.key and db.crt sign an image; what else is secret can lie
elsewhere. Needs openssl, efitools and sbsigntool.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import uuid
from pathlib import Path

VALID_DAYS = 25 * 365  # Firmware looks at no date; a certificate has one all the same.
# Each with whose key signs what a firmware is told of it.
SIGNED_BY = {"PK": "PK", "KEK": "PK", "db": "KEK"}
ENROLLED = tuple(f"{name}.auth" for name in reversed(SIGNED_BY))  # In the order in which the loader enrols them.
HEADER_POINTER, CHECKSUM_AT = 0x3C, 88  # In a PE file, and in its header.
SIGNATURE_ENTRY_AT, SIGNATURE_ENTRY_BYTES = 168, 8  # In the header of a program of 64 bits: where its signature is, and how long.
ALIGNED = 8  # Signatures begin at whole multiples.


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"secure boot: {command[0]} failed: {(done.stderr.strip() or 'it said nothing').splitlines()[-1]}")


def make_keys(folder):
    """All of them, or nothing: they are there as a whole once the folder is."""
    if folder.exists():
        sys.exit(f"secure boot: {folder} is there already; keys are made once")
    folder.parent.mkdir(parents=True, exist_ok=True)
    made = Path(tempfile.mkdtemp(dir=folder.parent))
    owner = uuid.uuid4()
    for name in SIGNED_BY:
        run("openssl", "req", "-new", "-x509", "-newkey", "rsa:2048", "-sha256", "-nodes", "-days", VALID_DAYS,
            "-subj", f"/CN=Kaori box {name}/", "-keyout", made / f"{name}.key", "-out", made / f"{name}.crt")
        (made / f"{name}.key").chmod(0o600)
        run("cert-to-efi-sig-list", "-g", owner, made / f"{name}.crt", made / f"{name}.esl")
    for name, signer in SIGNED_BY.items():
        run("sign-efi-sig-list", "-g", owner, "-k", made / f"{signer}.key", "-c", made / f"{signer}.crt", name, made / f"{name}.esl",
            made / f"{name}.auth")
        (made / f"{name}.esl").unlink()
    made.rename(folder)


def missing(folder):
    """The first file that signing and enrolling want and that is not there; None where all are."""
    return next((name for name in ("db.key", "db.crt", *ENROLLED) if not (folder / name).is_file()), None)


def sign(program, keys):
    """In place. The signature lies behind the program, which becomes longer by signature_bytes."""
    signed = program.with_name(program.name + ".signed")
    run("sbsign", "--key", keys / "db.key", "--cert", keys / "db.crt", "--output", signed, program)
    os.replace(signed, program)


def signature_bytes(program, keys):
    """How much longer a program becomes by these keys; it is the same for every program whose length is a multiple of ALIGNED."""
    with tempfile.TemporaryDirectory() as folder:
        trial = Path(folder) / "trial.efi"
        shutil.copyfile(program, trial)
        sign(trial, keys)
        return trial.stat().st_size - -(-program.stat().st_size // ALIGNED) * ALIGNED


def is_signed(program, unsigned):
    """Whether a program is another with a signature: alike but for the checksum, and where the signature is."""
    one, other = bytearray(program.read_bytes()), bytearray(unsigned.read_bytes())
    if len(one) <= len(other):
        return False
    for content in (one, other):
        header = int.from_bytes(content[HEADER_POINTER:HEADER_POINTER + 4], "little")
        for at, count in ((header + CHECKSUM_AT, 4), (header + SIGNATURE_ENTRY_AT, SIGNATURE_ENTRY_BYTES)):
            content[at:at + count] = bytes(count)
    return one[:len(other)] == other


def main():
    if len(sys.argv) != 3 or sys.argv[1] != "keys":
        sys.exit(__doc__)
    make_keys(Path(sys.argv[2]).resolve())


if __name__ == "__main__":
    main()
