#!/usr/bin/env python3
"""Fails on C++ files that clang-format would change; --fix changes them."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main():
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "src", "tools", "tests"],
                            cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    files = [name for name in listed if name.endswith((".h", ".cpp")) and (ROOT / name).is_file()]
    if not files:
        print("format: no file found")
        return 1
    mode = ["-i"] if "--fix" in sys.argv[1:] else ["--dry-run", "-Werror"]
    done = subprocess.run(["clang-format", *mode, *files], cwd=ROOT, capture_output=True, text=True, check=False)
    faults = [line for line in done.stderr.splitlines() if "error:" in line]
    print("\n".join(faults) if faults else f"format: {len(files)} files, no fault")
    return 1 if done.returncode or faults else 0


if __name__ == "__main__":
    sys.exit(main())
