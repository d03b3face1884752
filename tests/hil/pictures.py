"""What is seen on a machine's screens: whether there is a picture at all, and what is in it."""

LEAST_COLOURS = 8


def is_lit(pixels):
    """It has more in it than a ground and some letters."""
    return len(set(pixels[::997])) > LEAST_COLOURS


def share_of(colour, pixels, apart=30):
    """How much of the picture is nearly of this colour (R, G, B)."""
    near = sum(abs(pixels[i] - colour[0]) + abs(pixels[i + 1] - colour[1]) + abs(pixels[i + 2] - colour[2]) < apart
               for i in range(0, len(pixels) - 2, 3))
    return near / (len(pixels) / 3)
