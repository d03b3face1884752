#!/usr/bin/env python3
"""Makes the sounds of the show "Kaori" by rule: make.py [FOLDER] writes the WAV files (default: beside this file).

Every sound is computed: sums of decaying partials, filtered noise, sweeps. Noise has a fixed seed, so the same script gives
the same bytes. Mono, 24 kHz, 16 bit; the pack holds them at 48 kHz. Each begins with 50 ms of silence, as the guide asks,
and its loudest sample is set by LOUDEST.
"""
import math
import random
import struct
import sys
import wave
from pathlib import Path

import speech

RATE = 24000  # Samples a second.
LEAD_S = 0.05  # Silence at the beginning: the loudspeaker joins in after what it has in hand.
LOUDEST = {"buzzer": 0.22, "crickets": 0.12, "heart": 0.6, "facets": 0.3}  # Of full scale; others: 0.45.


def hz(note):
    """The frequency of a MIDI note number (69 is A at 440 Hz)."""
    return 440.0 * 2 ** ((note - 69) / 12)


def silence(seconds):
    return [0.0] * round(seconds * RATE)


def add(target, at_s, sound, gain=1.0):
    """Mixes a sound into the target from a time on; what would lie behind its end is left out."""
    first = round(at_s * RATE)
    for i, value in enumerate(sound[: max(0, len(target) - first)]):
        target[first + i] += gain * value


def partials(seconds, tones):
    """A sum of sines that decay: tones are (frequency in Hz, gain, seconds until 1/e)."""
    total = silence(seconds)
    for frequency, gain, decay_s in tones:
        if frequency >= RATE / 2:
            continue
        step = 2 * math.pi * frequency / RATE
        for i in range(len(total)):
            total[i] += gain * math.exp(-i / (decay_s * RATE)) * math.sin(step * i)
    attack, release = round(0.002 * RATE), round(0.02 * RATE)  # So that nothing clicks.
    for i in range(min(release, len(total))):
        total[i] *= min(1, i / attack)
        total[-1 - i] *= i / release
    return total


def bell(frequency, seconds, bright=1.0):
    """A small bell: partials of a struck bar, the higher ones shorter."""
    ratios = [(1, 1.0), (2.76, 0.5), (5.4, 0.25), (8.93, 0.12)]
    return partials(seconds, [(frequency * r, g * bright ** n, seconds / (3 + 3 * n)) for n, (r, g) in enumerate(ratios)])


def band(seconds, centre, width, seed):
    """Noise through a resonance of two poles; centre (Hz) and gain are functions of the time in 0 .. 1."""
    chance = random.Random(seed)
    out, y1, y2 = [], 0.0, 0.0
    count = round(seconds * RATE)
    for i in range(count):
        frequency = centre(i / count)
        radius = math.exp(-math.pi * width / RATE)
        y = (1 - radius) * chance.uniform(-1, 1) + 2 * radius * math.cos(2 * math.pi * frequency / RATE) * y1 - radius ** 2 * y2
        y1, y2 = y, y1
        out.append(y)
    return out


def shaped(sound, gain):
    """A sound times a gain, which is a function of the time in 0 .. 1."""
    return [value * gain(i / len(sound)) for i, value in enumerate(sound)]


def buzzer():
    """The buzzer before the curtain: a reed at 220 Hz with its odd harmonics, 2.6 s."""
    reed = partials(2.6, [(220 * n, 1 / n, 1000) for n in (1, 3, 5, 7, 9)])
    return shaped(reed, lambda t: min(1, 12 * t, 12 * (1 - t)))


def wire():
    """A line is drawn: a pure tone that glides up an octave, with a second one behind it."""
    total = silence(1.6)
    for offset_s, gain in ((0, 1), (0.12, 0.5)):
        phase, line = 0.0, []
        for i in range(round(1.3 * RATE)):
            t = i / (1.3 * RATE)
            phase += 2 * math.pi * hz(60 + 12 * t * t) / RATE
            line.append(math.sin(phase) * math.sin(math.pi * t) ** 2)
        add(total, offset_s, line, gain)
    return total


def facets():
    """Panes fall into place: short clicks of glass, each a little higher, ever closer."""
    total, at_s = silence(1.6), 0.0
    for n in range(22):
        add(total, at_s, bell(hz(76 + (n * 7) % 24), 0.25), 0.5 + 0.5 * n / 22)
        at_s += 0.11 * 0.93 ** n
    return total


def skin():
    """A soft chord that opens: five sines, each a little late, each a little beating."""
    total = silence(2.4)
    for n, note in enumerate((53, 60, 65, 69, 76)):
        for detune in (-0.4, 0.4):
            tone = partials(2.4 - 0.1 * n, [(hz(note) + detune, 1 / (n + 1), 1000)])
            add(total, 0.1 * n, shaped(tone, lambda t: math.sin(math.pi * t) ** 1.5))
    return total


def hair():
    """A harp's glissando over a pentatonic scale."""
    total = silence(2.4)
    for n, note in enumerate([60 + 12 * (k // 5) + (0, 2, 4, 7, 9)[k % 5] for k in range(15)]):
        add(total, 0.075 * n, partials(1.2, [(hz(note) * h, 1 / h ** 2, 0.5 / h) for h in (1, 2, 3, 4)]))
    return total


def heart():
    """Four beats of a heart, 72 a minute: two low thuds each."""
    total = silence(3.4)
    for beat in range(4):
        for offset_s, gain in ((0.0, 1.0), (0.24, 0.7)):
            thud = shaped(partials(0.2, [(55, 1, 0.06), (82, 0.4, 0.04)]), lambda t: 1 - t)
            add(total, beat * 60 / 72 + offset_s, thud, gain)
    return total


def boil():
    """A kettle comes to the boil: steam, then a whistle that rises and beats."""
    seconds = 3.0
    steam = shaped(band(seconds, lambda t: 2500 + 2500 * t, 1500, 1), lambda t: min(1, 2 * t) * min(1, 6 * (1 - t)))
    phase, whistle = 0.0, []
    for i in range(round(seconds * RATE)):
        t = i / (seconds * RATE)
        phase += 2 * math.pi * (900 + 1150 * min(1, 1.6 * t) + 12 * math.sin(2 * math.pi * 11 * t * seconds)) / RATE
        swell = min(1, max(0.0, (t - 0.15) * 2)) * min(1, 6 * (1 - t))
        whistle.append(swell * (math.sin(phase) + 0.3 * math.sin(2 * phase)))
    peak = max(map(abs, steam))
    return [0.35 * s / peak + 0.5 * w for s, w in zip(steam, whistle)]


def bark():
    """Two barks of a small dog: a pulse train that falls, through the resonances of an open mouth, with breath."""
    total = silence(0.86)
    for at_s, pitch in ((0.0, 1.0), (0.38, 0.93)):
        length, phase, source = 0.2, 0.0, []
        chance = random.Random(7)
        for i in range(round(length * RATE)):
            t = i / (length * RATE)
            phase += pitch * (300 + 260 * math.sin(math.pi * min(1, 1.25 * t))) / RATE
            pulse = 1 - 2 * (phase % 1.0)
            source.append((pulse + 0.5 * chance.uniform(-1, 1)) * math.sin(math.pi * t ** 0.5) ** 1.2)
        voiced = silence(length)
        for formant, width, gain in ((750, 120, 1.0), (1500, 180, 0.7), (2900, 300, 0.35)):
            radius = math.exp(-math.pi * width / RATE)
            y1 = y2 = 0.0
            for i, value in enumerate(source):
                y = (1 - radius) * value + 2 * radius * math.cos(2 * math.pi * formant / RATE) * y1 - radius ** 2 * y2
                y1, y2 = y, y1
                voiced[i] += gain * y
        add(total, at_s, voiced)
    return total


def leap():
    """She leaps out of the picture: air that rushes up and is gone."""
    return shaped(band(0.9, lambda t: 300 + 4200 * t ** 2, 500, 3), lambda t: t ** 1.5 * min(1, 12 * (1 - t)))


def land():
    """She is back in the picture: the same rush downwards, and a soft chord where it ends."""
    total = silence(2.0)
    rush = shaped(band(0.8, lambda t: 4500 - 4000 * t, 500, 4), lambda t: min(1, 8 * t) * (1 - t))
    peak = max(map(abs, rush))
    add(total, 0, rush, 0.6 / peak)
    for n, note in enumerate((60, 67, 76)):
        add(total, 0.55 + 0.05 * n, bell(hz(note), 1.3, 0.5), 0.3)
    return total


def crickets():
    """Evening: three crickets, each with its own pitch and pace."""
    total = silence(9.0)
    for pitch, period_s, offset_s in ((4300, 0.62, 0.0), (4700, 0.71, 0.2), (3900, 0.93, 0.45)):
        chirp = silence(0.24)
        for pulse in range(4):
            add(chirp, 0.055 * pulse, shaped(partials(0.04, [(pitch, 1, 1000)]), lambda t: math.sin(math.pi * t)))
        at_s = offset_s
        while at_s < 8.7:
            add(total, at_s, chirp)
            at_s += period_s
    return shaped(total, lambda t: min(1, 5 * t, 5 * (1 - t)))


def snap():
    """A string is cut: one hard pluck, high, and nothing after it."""
    return partials(0.5, [(hz(88) * n, 1 / n, 0.06 / n) for n in (1, 2.02, 3.05, 4.1)])


def farewell():
    """The farewell: a music box, slowly running down, and a bass note to each bar."""
    total = silence(14.0)
    melody = [(76, 1), (74, 1), (72, 1), (67, 2), (69, 1), (72, 1), (71, 1), (67, 1), (64, 2), (65, 1),
              (69, 1), (67, 1), (64, 1), (62, 2), (67, 1), (60, 3)]
    bass = {0: 48, 3: 52, 6: 45, 9: 43, 12: 41, 15: 43, 18: 48}
    at_s, beat, pace_s = 0.0, 0, 0.44
    for note, beats in melody:
        add(total, at_s, bell(hz(note + 12), 2.2, 0.6))
        for k in range(beats):
            if beat + k in bass:
                add(total, at_s + k * pace_s, bell(hz(bass[beat + k] + 12), 2.5, 0.3), 0.7)
        at_s += beats * pace_s
        beat += beats
        pace_s *= 1.022
    return shaped(total, lambda t: min(1, 8 * (1 - t)))


def lobby():
    """Two notes of a door's chime."""
    total = silence(2.6)
    add(total, 0, bell(hz(76), 1.6, 0.5))
    add(total, 0.55, bell(hz(72), 2.0, 0.5))
    return total


def write(path, sound):
    loudest = LOUDEST.get(path.stem, 0.45) / max(map(abs, sound))
    samples = silence(LEAD_S) + [value * loudest for value in sound]
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(struct.pack(f"<{len(samples)}h", *(round(32767 * value) for value in samples)))


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    folder.mkdir(parents=True, exist_ok=True)
    for make in (buzzer, wire, facets, skin, hair, heart, boil, bark, leap, land, crickets, snap, farewell, lobby):
        write(folder / f"{make.__name__}.wav", make())
    for name, phones in speech.PHRASES.items():
        write(folder / f"{name}.wav", speech.speak(phones))


if __name__ == "__main__":
    main()
