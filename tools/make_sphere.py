#!/usr/bin/env python3
"""Paints the lit sphere of styles/litsphere: `tools/make_sphere.py styles/litsphere/textures/sphere.png`.

A ball in warm light from the upper left, laid in with a broad brush: five mixed paints from a violet shadow to cream, put
down in short strokes along the form that shift the border between them; cool light of the sky along the rim of the shadow,
and a soft highlight. 8-bit sRGB; beyond the ball its rim goes on, so that no filter mixes a background in.
"""
import math
import struct
import sys
import zlib

SIZE = 256
LIGHT = (-0.5, 0.6, 0.62)  # painted_from of style.toml, before it is normalized
PAINTS = [  # (cosine between normal and light, linear colour)
    (-1.0, (0.030, 0.026, 0.070)),
    (-0.35, (0.055, 0.035, 0.085)),
    (0.05, (0.230, 0.090, 0.100)),
    (0.40, (0.640, 0.290, 0.160)),
    (0.72, (0.950, 0.620, 0.330)),
    (1.0, (1.000, 0.890, 0.660)),
]
SKY = (0.10, 0.16, 0.30)


def noise(x, y, seed):
    """Value noise in -1..1, smooth, of period 1 in both."""

    def corner(i, j):
        h = (i * 0x9E3779B1 ^ j * 0x85EBCA77 ^ seed * 0xC2B2AE3D) & 0xFFFFFFFF
        h = (h ^ h >> 15) * 0x2C1B3C6D & 0xFFFFFFFF
        h = (h ^ h >> 12) * 0x297A2D39 & 0xFFFFFFFF
        return (h >> 8) / 0x7FFFFF - 1.0

    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    low = corner(i, j) * (1 - u) + corner(i + 1, j) * u
    high = corner(i, j + 1) * (1 - u) + corner(i + 1, j + 1) * u
    return low * (1 - v) + high * v


def mix(a, b, t):
    return tuple(p * (1 - t) + q * t for p, q in zip(a, b))


def smooth(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def paint(cosine):
    """The paints run into each other only near their borders."""
    color = PAINTS[0][1]
    for (low, _), (high, next_color) in zip(PAINTS, PAINTS[1:]):
        middle, half = (low + high) / 2, (high - low) / 2
        color = mix(color, next_color, smooth(middle - 0.85 * half, middle + 0.85 * half, cosine))
    return color


def ball(x, y, light):
    """The colour at a place of the unit disc, y up."""
    z = math.sqrt(max(1.0 - x * x - y * y, 0.0))
    cosine = x * light[0] + y * light[1] + z * light[2]
    # Strokes lie across the light's direction on the picture: long that way, short along it.
    along, across = x * light[0] + y * light[1], -x * light[1] + y * light[0]
    wobble = 0.055 * noise(26 * along, 7 * across + 3, 1) + 0.03 * noise(60 * along, 11 * across, 2)
    color = paint(cosine + wobble * (1.0 - 0.5 * max(cosine, 0.0)))
    sky = smooth(0.62, 1.0, math.hypot(x, y) + 0.5 * wobble) * smooth(0.25, -0.55, cosine)
    color = mix(color, SKY, 0.85 * sky)
    halfway = (light[0], light[1], light[2] + 1.0)
    length = math.sqrt(sum(c * c for c in halfway))
    gloss = (x * halfway[0] + y * halfway[1] + z * halfway[2]) / length
    return mix(color, (1.0, 0.98, 0.92), 0.9 * smooth(0.965, 0.992, gloss + 0.15 * wobble))


def srgb(value):
    value = min(max(value, 0.0), 1.0)
    return round(255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055))


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: make_sphere.py FILE.png")
    length = math.sqrt(sum(c * c for c in LIGHT))
    light = tuple(c / length for c in LIGHT)
    rows = bytearray()
    for row in range(SIZE):
        rows.append(0)  # no filter
        for column in range(SIZE):
            x, y = (2 * column + 1) / SIZE - 1, 1 - (2 * row + 1) / SIZE
            radius = max(math.hypot(x, y), 1.0)
            rows.extend(srgb(c) for c in ball(x / radius, y / radius, light))

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)
    with open(sys.argv[1], "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header))
        file.write(chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    main()
