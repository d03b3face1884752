"""Speech by rule, for the greetings of the lobby: phones become resonances of a throat, as in the synthesizers of the
show's own time. speak(PHONES) gives samples at RATE; phones are words of TABLE with blanks between them.

Means of published measurements, rounded: formants of a man's vowels (Peterson and Barney 1952; Japanese vowels besides),
places of noise of consonants (Stevens, Acoustic Phonetics, 1998).
"""
import math
import random

RATE = 24000  # Samples a second, as make.py has them.
STEP = 48     # Samples between two moves of the throat: 2 ms.
PITCH_HZ = 118.0
GLIDE_S = 0.022  # How fast the throat moves from phone to phone,
SNAP_S = 0.006   # and how fast it opens and shuts.

# Phone: seconds, three formants in Hz, voice 0..1, noise 0..2, where the noise lies in Hz.
VOWELS = {
    "a": (750, 1200, 2550), "i": (300, 2250, 2950), "u": (350, 1300, 2350), "e": (480, 1900, 2550), "o": (480, 850, 2500),
    "uh": (520, 1400, 2450), "ih": (400, 1950, 2550), "eh": (550, 1800, 2500), "oo": (440, 1050, 2250), "ah": (650, 1150, 2450),
}
TABLE = {name: (0.105, formants, 1.0, 0.0, 0) for name, formants in VOWELS.items()}
TABLE |= {
    "m": (0.075, (270, 1000, 2200), 0.45, 0.0, 0), "n": (0.07, (270, 1500, 2500), 0.45, 0.0, 0),
    "N": (0.11, (270, 1250, 2400), 0.45, 0.0, 0), "ng": (0.08, (280, 1900, 2600), 0.45, 0.0, 0),
    "w": (0.065, (310, 700, 2300), 0.7, 0.0, 0), "y": (0.055, (290, 2250, 2950), 0.7, 0.0, 0),
    "r": (0.03, (400, 1500, 2500), 0.35, 0.0, 0), "l": (0.07, (370, 1150, 2650), 0.65, 0.0, 0),
    "v": (0.06, (300, 1150, 2300), 0.45, 0.12, 4500),
    "b": (0.05, (250, 900, 2200), 0.18, 0.0, 0), "d": (0.05, (250, 1700, 2600), 0.18, 0.0, 0),
    "g": (0.055, (250, 1900, 2300), 0.18, 0.0, 0),
    "p": (0.07, (400, 900, 2200), 0.0, 0.0, 0), "t": (0.06, (400, 1700, 2600), 0.0, 0.0, 0),
    "k": (0.065, (400, 1700, 2300), 0.0, 0.0, 0),
    "b'": (0.012, (400, 900, 2200), 0.5, 0.15, 900), "d'": (0.012, (400, 1700, 2600), 0.5, 0.3, 3600),
    "g'": (0.014, (400, 1800, 2300), 0.5, 0.3, 1900),
    "t'": (0.022, (400, 1700, 2600), 0.0, 1.3, 3800), "k'": (0.026, (400, 1700, 2300), 0.0, 1.3, 1700),
    "s": (0.105, (400, 1600, 2600), 0.0, 0.5, 6200), "sh": (0.11, (350, 2000, 2700), 0.0, 0.6, 3100),
    "_": (0.22, (480, 1400, 2500), 0.0, 0.0, 0),
}


class Resonance:
    """Two poles: a throat's formant, or the place of a noise."""

    def __init__(self):
        self.y1 = self.y2 = self.b = self.c = 0.0

    def tune(self, hz, width_hz):
        radius = math.exp(-math.pi * width_hz / RATE)
        self.b, self.c = 2 * radius * math.cos(2 * math.pi * hz / RATE), -radius * radius

    def next(self, x):
        y = (1 - self.b - self.c) * x + self.b * self.y1 + self.c * self.y2
        self.y2, self.y1 = self.y1, y
        return y


def toward(now, goal, time_s):
    return now + (goal - now) * (1 - math.exp(-STEP / (time_s * RATE)))


def pitch(t, accents, seconds):
    """Falls over the phrase; each accent, a time in seconds, lifts it for a moment."""
    lift = sum(math.exp(-((t - at) / 0.09) ** 2) for at in accents)
    return PITCH_HZ * (1.12 - 0.3 * t / seconds + 0.2 * lift)


def timed(phones, pace):
    """(phone, second at which it begins, its length); a number behind ":" makes a phone so much longer."""
    at_s, out = 0.0, []
    for word in phones.replace("*", "").split():
        name, _, longer = word.partition(":")
        length_s = TABLE[name][0] * float(longer or 1) / pace
        out.append((name, at_s, length_s))
        at_s += length_s
    return out, at_s


def accents_of(phones, pace):
    """The middles of the phones behind a star."""
    times, _ = timed(phones, pace)
    return [at + 0.5 * length for (_, at, length), word in zip(times, phones.split()) if word.startswith("*")]


def speak(phones, pace=1.0):
    times, seconds = timed(phones, pace)
    accents = accents_of(phones, pace)
    chance = random.Random(11)
    throat, hiss = [Resonance() for _ in range(4)], Resonance()
    formants, voice, noise, phase, pulse, before, out = list(TABLE["_"][1]), 0.0, 0.0, 0.0, [0.0, 0.0], 0.0, []
    for step in range(round((seconds + 0.12) * RATE / STEP)):
        t = step * STEP / RATE
        name = next((n for n, at, length in times if at <= t < at + length), "_")
        _, goal, goal_voice, goal_noise, hz = TABLE[name]
        formants = [toward(now, to, GLIDE_S) for now, to in zip(formants, goal)]
        voice, noise = toward(voice, goal_voice, SNAP_S), toward(noise, goal_noise, SNAP_S)
        for resonance, formant in zip(throat, (*formants, 3500)):
            resonance.tune(formant, 50 + 0.04 * formant)
        if hz:
            hiss.tune(hz, 0.3 * hz)
        period = pitch(t, accents, seconds) / RATE
        for _ in range(STEP):
            phase += period
            hit = 0.0
            if phase >= 1:
                phase -= 1
                hit = 1.0
            for n in range(2):  # Above 100 Hz a pulse of the glottis falls by 12 dB an octave.
                hit = pulse[n] = pulse[n] + (hit - pulse[n]) * 0.026
            wind = chance.uniform(-1, 1)
            x = voice * (hit + 0.0004 * wind)
            for resonance in throat:
                x = resonance.next(x)
            out.append((x - before) * 60 + noise * 0.03 * hiss.next(wind))
            before = x
    return out


def jaw(phones, pace=1.0, lead_s=0.0):
    """How far the jaw opens: points of a motion's curve, which begins and ends shut."""
    open_by = {"a": 0.75, "ah": 0.7, "o": 0.5, "e": 0.4, "eh": 0.45, "uh": 0.4, "oo": 0.25, "i": 0.2, "ih": 0.25, "u": 0.18}
    times, seconds = timed(phones, pace)
    points = [(0.0, 0.0)]
    for name, at, length in times:
        points.append((lead_s + at + 0.5 * length, open_by.get(name, 0.05 if name not in "mbpN_" else 0.0)))
    points.append((lead_s + seconds + 0.15, 0.0))
    return [(round(at, 2), value) for at, value in points]


# What the lobby says.
PHRASES = {
    "welcome-ja": "k k' *o N b b' a N w a _ y *o o k k' o s o o",
    "welcome-en": "g g' oo d _:0.2 *i v n ih ng _ w *eh l k k' uh m",
    "bye-ja": "m *a t t' a _:0.2 a i m a sh *o o",
    "bye-en": "g g' oo d b b' *a ih:1.8",
}


if __name__ == "__main__":
    for phrase, phones in PHRASES.items():
        print(phrase, ", ".join(f"[{at:g}, {value:g}]" for at, value in jaw(phones, 1.0, 0.05)))
