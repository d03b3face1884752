"""The modes of a V4L2 camera, by the kernel's own calls (Documentation/userspace-api/media/v4l)."""

import fcntl
import os
import struct


def _request(number, size):
    """_IOWR('V', number, size) of linux/ioctl.h."""
    return 3 << 30 | size << 16 | ord("V") << 8 | number


QUERYCAP = 2 << 30 | 104 << 16 | ord("V") << 8  # _IOR('V', 0, struct v4l2_capability)
ENUM_FMT = _request(2, 64)
ENUM_FRAMESIZES = _request(74, 44)
ENUM_FRAMEINTERVALS = _request(75, 52)
CAPTURE, CAN_CAPTURE, DEVICE_CAPS = 1, 0x1, 0x80000000
DISCRETE = 1
MOST = 200  # Of each kind: a camera whose list never ends is left.


def _enumerate(camera, request, size, begin):
    """Answers of an enumerating call: `begin(index)` are the first bytes of the question. An error ends the list."""
    for index in range(MOST):
        question = bytearray(begin(index).ljust(size, b"\0"))
        try:
            fcntl.ioctl(camera, request, question)
        except OSError:
            return
        yield bytes(question)


def modes_of(path):
    """[(pixel format as four letters, width, height, pictures a second)] of a camera; [] where it takes no pictures, None
    where it cannot be opened. Only discrete sizes and intervals, which USB cameras have."""
    try:
        camera = os.open(path, os.O_RDWR | os.O_NONBLOCK)
    except OSError:
        return None
    try:
        capability = bytearray(104)
        try:
            fcntl.ioctl(camera, QUERYCAP, capability)
        except OSError:
            return []
        all_caps, node_caps = struct.unpack_from("<II", capability, 84)
        if not (node_caps if all_caps & DEVICE_CAPS else all_caps) & CAN_CAPTURE:
            return []
        return list(_modes(camera))
    finally:
        os.close(camera)


def _modes(camera):
    for answer in _enumerate(camera, ENUM_FMT, 64, lambda i: struct.pack("<II", i, CAPTURE)):
        pixels = answer[44:48]
        for size in _enumerate(camera, ENUM_FRAMESIZES, 44, lambda i, pixels=pixels: struct.pack("<I4s", i, pixels)):
            kind, width, height = struct.unpack_from("<III", size, 8)
            if kind != DISCRETE:
                continue
            of_size = (lambda i, pixels=pixels, width=width, height=height: struct.pack("<I4sII", i, pixels, width, height))
            for interval in _enumerate(camera, ENUM_FRAMEINTERVALS, 52, of_size):
                kind, seconds, parts = struct.unpack_from("<III", interval, 16)
                if kind == DISCRETE and seconds:
                    yield pixels.decode("ascii", "replace"), width, height, parts / seconds
