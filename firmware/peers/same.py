#!/usr/bin/env python3
"""Whether two programs printed the same numbers but for round-off. usage: same.py SCALAR FIRST SECOND"""
import struct
import sys

# Round-off of a few hundred products, relative to the largest number.
TOLERANCE = {"f32": 1e-4, "f64": 1e-12}


def numbers(path):
    lines = [line.split() for line in open(path)]
    return [struct.unpack(">d", bytes.fromhex(line[1]))[0] for line in lines if line[:1] == ["result"]]


first, second = numbers(sys.argv[2]), numbers(sys.argv[3])
worst = max(abs(a - b) for a, b in zip(first, second, strict=True)) / max(map(abs, first))
if not worst <= TOLERANCE[sys.argv[1]]:
    sys.exit(f"{sys.argv[2]} and {sys.argv[3]} differ by {worst:.1e} of their largest number")
