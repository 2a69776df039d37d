#!/usr/bin/env python3
"""Replays the workflow of the paper's Figure 2 and checks what each step leaves behind.

usage: figure2_test.py LUMINIST OUTPUT_FOLDER
"""
import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
STEPS = {"1_key": 1, "2_refine": 1, "3_yellow": 2, "4_blue": 3}  # folder: lights in its rig
FILES = ["picture.exr", "picture.png", "target.exr", "importance.png", "residual.png", "rig.toml", "convergence.jsonl"]
LARGEST_RATIO = 0.75  # of a step's final error to its first: crude paint is never matched, but must be followed


def main():
    luminist, output = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(output, ignore_errors=True)
    subprocess.run([luminist, "replay", ROOT / "meshes/still_life/figure2/workflow.jsonl", "-o", output], check=True)
    faults = []
    for step, lights in STEPS.items():
        folder = output / step
        missing = [name for name in FILES if not (folder / name).is_file() or (folder / name).stat().st_size == 0]
        if missing:
            faults.append(f"{step}: missing {', '.join(missing)}")
            continue
        errors = [json.loads(line)["epsilon"] for line in (folder / "convergence.jsonl").read_text().splitlines()]
        ratio = errors[-1] / errors[0]
        print(f"{step}: error {errors[0]:.4f} -> {errors[-1]:.4f}, ratio {ratio:.2f}")
        if not ratio <= LARGEST_RATIO:
            faults.append(f"{step}: the error fell to {ratio:.2f} of its start only (limit {LARGEST_RATIO})")
        found = (folder / "rig.toml").read_text().count("[[light]]")
        if found != lights:
            faults.append(f"{step}: {found} lights in the rig, {lights} wanted")
    if not (output / "contact_sheet.png").is_file():
        faults.append("no contact sheet")
    print("\n".join(faults) if faults else "figure2: all steps are there")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
