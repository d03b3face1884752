"""What is seen on a machine's screens: whether there is a picture at all, and what is in it."""

LEAST_COLOURS = 8


def is_lit(pixels):
    """It has more in it than a ground and some letters."""
    return len(set(pixels[::997])) > LEAST_COLOURS


def is_near(one, other, apart=30):
    return sum(abs(a - b) for a, b in zip(one, other)) < apart


def marks(picture, colour):
    """How many lines of a status picture have a mark of this colour; see appliance/programs/status/sheet.cpp."""
    width, height, pixels = picture
    pitch = max(1, min(height // 20, width * 2 // 60))
    rows = range(pitch // 2 + pitch // 2, height - pitch, pitch)
    return sum(is_near(pixels[(y * width + pitch * 3 // 4) * 3:][:3], colour) for y in rows)
