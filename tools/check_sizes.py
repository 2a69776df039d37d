#!/usr/bin/env python3
"""Fails on files and functions that have grown past what one can read at a sitting."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMITS = {".h": 150, ".cpp": 400, ".py": 400, ".glsl": 400}
FUNCTION_LINES = 60
FOLDERS = ("src", "tools", "tests", "shaders", "styles")


def long_functions(path, lines):
    """clang-format puts a function's closing brace in column 0; its head is the last line before that starts there."""
    faults, head = [], None
    for number, line in enumerate(lines, 1):
        if re.match(r"[A-Za-z_~].*[^;]$", line) and not line.startswith(("namespace", "struct", "class", "enum", "union")):
            head = head or (number, line) if not line.rstrip().endswith("}") else None
        elif re.match(r"\}\s*$", line):
            if head and number - head[0] + 1 > FUNCTION_LINES:
                name = head[1].strip()[:60]
                faults.append(f"{path.relative_to(ROOT)}:{head[0]}: {number - head[0] + 1} lines in '{name}' "
                              f"(limit {FUNCTION_LINES})")
            head = None
        elif re.match(r"[A-Za-z#/}].*;\s*$", line) or line.startswith(("#", "//", "}")):
            head = None
    return faults


def main():
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", *FOLDERS], cwd=ROOT,
                            capture_output=True, text=True, check=True).stdout.split("\n")
    faults, count = [], 0
    for name in listed:
        path = ROOT / name
        if path.suffix not in LIMITS or not path.is_file():
            continue
        count += 1
        lines = path.read_text().splitlines()
        if len(lines) > LIMITS[path.suffix]:
            faults.append(f"{name}: {len(lines)} lines (limit {LIMITS[path.suffix]}); split it by noun")
        if path.suffix == ".cpp":
            faults += long_functions(path, lines)
    print("\n".join(faults) if faults else f"sizes: {count} files, no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
