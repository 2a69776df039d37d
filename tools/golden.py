#!/usr/bin/env python3
"""Renders the golden pictures of styles, compares them, and writes a page to look at.

Usage: tools/golden.py [STYLE...] [-o FOLDER]     all styles without a name; FOLDER is out/golden by default

For each case the page shows the new picture, the reference (hover over the new one to flip between them), their
difference, the worst pixels, why the tolerances are as they are, and the command that accepts the new picture. The
status is 1 if a picture differs or has no reference.
"""
import argparse
import html
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LUMINIST = ROOT / "build" / "luminist"

HEAD = """<!doctype html>
<meta charset="utf-8">
<title>Golden pictures</title>
<style>
body { background: #28282a; color: #ddd; font: 15px sans-serif; margin: 24px }
section { border-top: 1px solid #555; padding: 12px 0 }
figure { display: inline-block; margin: 8px 12px 8px 0; position: relative; vertical-align: top }
figcaption { color: #aaa }
img { display: block; image-rendering: pixelated }
.flip img + img { position: absolute; top: 0; left: 0; visibility: hidden }
.flip:hover img + img { visibility: visible }
.mark { position: absolute; width: 14px; height: 14px; margin: -8px; border: 1px solid #ff4; border-radius: 8px }
.failed b { color: #ff8a65 } .passed b { color: #9ccc65 }
table { border-collapse: collapse; display: inline-block; vertical-align: top; margin-top: 8px }
td, th { padding: 1px 10px 1px 0; text-align: right; font: 13px monospace }
code { background: #111; padding: 2px 6px }
</style>
"""


def text(value):
    return html.escape(str(value))


def picture(style, name):
    return f'<img src="{text(style)}/{text(name)}">'


def worst_table(case):
    if not case["worst"]:
        return ""
    rows = ["<tr><th>x<th>y<th>difference<th>new<th>reference"]
    for pixel in case["worst"]:
        new, reference = (" ".join(f"{v:.3f}" for v in pixel[side]) for side in ("new", "reference"))
        rows.append(f'<tr><td>{pixel["x"]}<td>{pixel["y"]}<td>{pixel["difference"]:.3g}<td>{new}<td>{reference}')
    return "<table>" + "\n".join(rows) + "</table>\n"


def case_section(style, folder, case):
    state = "passed" if case["passed"] else "failed"
    lines = [f'<section class="{state}"><h3>{text(style)} / {text(case["name"])} <b>{state}</b></h3>',
             f'<p>{text(case["verdict"])}. <i>{text(case["reason"])}</i></p>']
    reference = picture(style, case["reference"]) if "reference" in case else ""
    caption = "new; hover: reference" if reference else "new; there is no reference"
    lines.append(f'<figure><div class="flip" style="position: relative">{picture(style, case["new"])}{reference}</div>'
                 f"<figcaption>{caption}</figcaption></figure>")
    if reference:
        lines.append(f"<figure>{reference}<figcaption>reference</figcaption></figure>")
    if "difference" in case:
        marks = "".join(f'<i class="mark" style="left: {p["x"]}px; top: {p["y"]}px"></i>' for p in case["worst"])
        lines.append(f'<figure>{picture(style, case["difference"])}{marks}'
                     "<figcaption>difference, the worst pixels marked</figcaption></figure>")
    lines.append(worst_table(case))
    command = f'build/luminist golden {folder} --case {case["name"]} --update'
    lines.append(f"<p>To accept the new picture: <code>{text(command)}</code></p></section>")
    return "\n".join(lines)


def run_style(style, output):
    folder = ROOT / "styles" / style
    if not (folder / "style.toml").is_file():
        known = ", ".join(sorted(path.parent.name for path in (ROOT / "styles").glob("*/style.toml")))
        sys.exit(f"tools/golden.py: there is no style {style}; there are {known}")
    place = output / style
    status = subprocess.run([LUMINIST, "golden", folder, "-o", place], check=False).returncode
    outcomes = place / "outcomes.json"
    if status not in (0, 1) or not outcomes.is_file():
        sys.exit(f"tools/golden.py: luminist golden {folder} ended with status {status}")
    return json.loads(outcomes.read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("styles", nargs="*", metavar="STYLE")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("out/golden"))
    words = parser.parse_args()
    if not LUMINIST.is_file():
        sys.exit("tools/golden.py: build first: tools/test, or cmake --build --preset release")
    styles = [pathlib.Path(name).name for name in words.styles]
    styles = styles or sorted(path.parent.name for path in (ROOT / "styles").glob("*/style.toml"))
    words.output.mkdir(parents=True, exist_ok=True)
    sections = []
    failed = total = 0
    for style in styles:
        outcomes = run_style(style, words.output)
        for case in outcomes["cases"]:
            total += 1
            failed += not case["passed"]
            folder = pathlib.Path(outcomes["folder"])
            folder = folder.relative_to(ROOT) if folder.is_relative_to(ROOT) else folder
            sections.append((case["passed"], case_section(outcomes["style"], folder, case)))
    sections.sort(key=lambda entry: entry[0])  # what failed comes first
    page = words.output / "index.html"
    page.write_text(HEAD + f"<h1>Golden pictures: {failed} of {total} differ</h1>\n"
                    + "\n".join(body for _, body in sections), encoding="utf-8")
    print(f"{failed} of {total} pictures differ: {page}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
