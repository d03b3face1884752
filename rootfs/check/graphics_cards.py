"""What draws on a graphics card, by its PCI numbers: the table of docs/image.md with the numbers by which cards say what they are.

Numbers are those of the kernel's and Mesa's own lists (i915_pciids.h, amdgpu_drv.c, radeon's pci_ids.h). A card that no line
names is said to be unknown; nothing is guessed of it.
"""

import re
from typing import NamedTuple

# What of a card the image draws with, by which option of ./box image.
NEVER, NOT_AT_ALL, AS_IT_IS = "never", "not at all", "as it is"
INTEL, AMD = "intel", "amd"  # --graphics WHICH, with files of the maker.


class Family(NamedTuple):
    """Cards of one kind. `mesa` is Mesa's driver of them; `draws`: with which image the card draws. NEVER: the processor does with
    each image; NOT_AT_ALL: nothing does. `why` is a sentence of it."""
    vendor: str
    numbers: str  # A pattern of the beginning of the device's number, four hexadecimal digits.
    name: str
    mesa: str
    draws: str
    why: str = ""


TOO_OLD = "it is too old to draw what the stage draws (GLES 3)"
RADEON = "the image has no driver for AMD's cards up to 2011"
TOO_NEW = "Mesa 22.3 of the image is too old for it"
UNTRIED = "no such PC was tried yet"
GUC = "it wants its GuC file, and whether it draws then is not known"

FAMILIES = (
    # Of 2006 to 2010: the kernel drives them, but they draw no GLES 3, and the stage draws nothing else.
    Family("0x8086", r"29[6-9a]|2a[04]|2e|004[26]", "of 2006 to 2010", "crocus", NOT_AT_ALL, TOO_OLD),
    Family("0x8086", r"25[6-9]|27[7a]|29[bcd]|a0[01]|35", "of 2001 to 2008", "i915", NOT_AT_ALL, TOO_OLD),
    Family("0x8086", r"01[0-6]", "Sandy Bridge, Ivy Bridge", "crocus", AS_IT_IS, UNTRIED),
    Family("0x8086", r"04[0-2]|0[acd][0-2]", "Haswell", "crocus", AS_IT_IS, UNTRIED),
    Family("0x8086", r"0f3|22b", "Bay Trail, Braswell", "crocus", AS_IT_IS, UNTRIED),
    Family("0x8086", r"16[0-3]", "Broadwell", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"19[0-3]", "Skylake", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"0a84|1a8|5a8|318", "Apollo Lake, Gemini Lake", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"59[0-2]|87[0c]|3e[9a]|9b[2ac]|9bf", "Kaby Lake to Comet Lake", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"8a[5-7]", "Ice Lake", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"45[457]|4e[567]", "Elkhart Lake, Jasper Lake", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"9a[4567cdf]", "Tiger Lake", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"4c[89]", "Rocket Lake", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"46[89]", "Alder Lake-S", "iris", AS_IT_IS, UNTRIED),
    Family("0x8086", r"46[abcd]|462[68a]", "Alder Lake-P, Alder Lake-N", "iris", INTEL, GUC),
    Family("0x8086", r"a7[28a]", "Raptor Lake", "iris", INTEL, GUC),
    Family("0x8086", r"56[9abc]|4f8|490[5-9]", "DG1, DG2", "iris", INTEL, GUC),
    Family("0x8086", r"7d|64[28ab]0|e2[012]|b0[89ab]", "Meteor Lake and later", "", NOT_AT_ALL, TOO_NEW),

    Family("0x1002", r"[345]|7[1289]", "R300 to R500, or older", "r300", NEVER, RADEON),
    Family("0x1002", r"9[4567]|980|99", "R600 to Northern Islands", "r600", NEVER, RADEON),
    Family("0x1002", r"68[4589a-f]|67[0-7]", "Evergreen, Northern Islands", "r600", NEVER, RADEON),
    Family("0x1002", r"67[89]|68[0-3]|66[0-3]|666", "Southern Islands", "radeonsi", AMD),
    Family("0x1002", r"66[45]|67[ab]|13[01]|98[35]", "Sea Islands", "radeonsi", AMD),
    Family("0x1002", r"690|69[23489]|730[0f]|987|98e4|67[c-f]", "Volcanic and Arctic Islands", "radeonsi", AMD),
    Family("0x1002", r"68[67]|69a|66a|15d[8d]|163[68]|164c|15e7", "Vega, Raven, Renoir", "radeonsi", AMD),
    Family("0x1002", r"73[1-9a-f]|74[23]|163f|164d|164e|1506|1681|13fe", "Navi 10 to 24, Van Gogh", "radeonsi", AMD),
    Family("0x1002", r"74[4-9]|15bf|15c8", "Navi 31 to 33", "radeonsi", AMD, "if this Mesa is new enough for the card"),
    Family("0x1002", r"75", "Navi 44 and 48", "", NEVER, TOO_NEW),

    Family("0x10de", r"", "any", "nouveau", NEVER, "the image has no driver for NVIDIA's cards"),
    Family("0x1af4", r"1050", "virtio-gpu", "virgl", AS_IT_IS, "where the host draws for the virtual machine"),
    Family("0x1234", r"1111", "Bochs", "", AS_IT_IS, "the processor draws"),
)


def family_of(vendor, device):
    """The first that fits, of numbers as the kernel shows them ("0x8086", "0x5916"); nothing of a card that no line names."""
    number = device.removeprefix("0x")
    return next((family for family in FAMILIES if family.vendor == vendor and re.match(family.numbers, number)), None)
