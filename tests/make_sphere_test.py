#!/usr/bin/env python3
"""The sphere that comes with styles/litsphere is what tools/make_sphere.py paints.

usage: make_sphere_test.py OUTPUT_FOLDER
"""
import pathlib
import subprocess
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST = 1  # of 255: libraries of mathematics differ in the last bit, which may round the other way


def rows_of(path):
    """The bytes of a PNG whose rows have no filter."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length = int.from_bytes(data[at : at + 4], "big")
        if data[at + 4 : at + 8] == b"IDAT":
            packed += data[at + 8 : at + 8 + length]
        at += 12 + length
    return zlib.decompress(packed)


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, ROOT / "tools/make_sphere.py", folder / "sphere.png"], check=True)
    made, shipped = rows_of(folder / "sphere.png"), rows_of(ROOT / "styles/litsphere/textures/sphere.png")
    if len(made) != len(shipped):
        sys.exit(f"{len(made)} bytes, not {len(shipped)}")
    worst = max(abs(a - b) for a, b in zip(made, shipped))
    print(f"largest difference {worst}")
    sys.exit(worst > MOST)


if __name__ == "__main__":
    main()
