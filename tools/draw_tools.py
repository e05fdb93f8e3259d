#!/usr/bin/env python3
"""Draws the sections of all punches and dies of the built-in catalogue: docs/bend/tools.svg."""

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCALE, WIDTH, GAP, NAME = 0.75, 862.0, 18.0, 14.0
STYLE = (
    ".punch{fill:#c8d6e5;stroke:#30475e;stroke-width:.8}.die{fill:#e3d9c6;stroke:#5e4a30;stroke-width:.8}"
    ".foot{stroke:#30475e;stroke-width:.8;stroke-dasharray:3 2}"
    ".title{font-size:13px;font-weight:bold;fill:#222}.id{font-size:9px;text-anchor:middle;fill:#222}"
)


def groups(tools):
    """Titles with the tools of each, as the rows of the picture."""
    punches, dies = tools["punches"], tools["dies"]
    tall = [p for p in punches if "-H" in p["id"]]
    usual = [p for p in punches if p not in tall]
    starting = lambda ones, *names: [t for t in ones if t["id"].startswith(names)]
    yield "Straight punches; dashed: the feet of their ears", starting(usual, "P88", "P85")
    yield "Acute punches, those of large radii, and the flat one", starting(usual, "P30", "P26", "R", "F")
    yield "Goose necks", starting(usual, "G")
    yield "Tall punches", tall
    offset = [d for d in dies if d["id"].endswith("-Z")]
    rest = [d for d in dies if d not in offset]
    yield "Dies, 88°", [d for d in rest if d["angle"] == 88]
    yield "Dies, 85°", [d for d in rest if d["angle"] == 85 and d["opening"] < 32]
    yield "Wide dies, 85°", [d for d in rest if d["angle"] == 85 and d["opening"] >= 32]
    yield "Acute dies, and the flat one", [d for d in rest if d["angle"] in (30, 180)]
    yield "Dies for narrow Zs", offset


def extent(tool):
    xs, zs = zip(*tool["profile"])
    return min(xs) * SCALE, max(xs) * SCALE, min(zs) * SCALE, max(zs) * SCALE


def drawn(tool, x, zero, kind):
    points = " ".join(f"{x + SCALE * y:.1f},{zero - SCALE * z:.1f}" for y, z in tool["profile"])
    yield f'<polygon class="{kind}" points="{points}"/>'
    if "ears" in tool:
        at = zero - SCALE * tool["ears"]["height"]
        yield f'<line class="foot" x1="{x - 14:.1f}" x2="{x + 14:.1f}" y1="{at:.1f}" y2="{at:.1f}"/>'


def picture(tools):
    body, top = [], 12.0
    for title, row in groups(tools):
        top += 20.0
        body.append(f'<text class="title" x="12" y="{top:.1f}">{title}</text>')
        kind = "punch" if "tip_radius" in row[0] else "die"
        x, above, below = 12.0, max(extent(t)[3] for t in row), min(extent(t)[2] for t in row)
        zero = top + 8.0 + above
        for tool in row:
            left, right, *_ = extent(tool)
            wide = max(right - left, 5.2 * len(tool["id"]))
            if x + wide > WIDTH - 10.0:
                x, zero = 12.0, zero - below + NAME + 8.0 + above
            body += drawn(tool, x + 0.5 * (wide - right - left), zero, kind)
            body.append(f'<text class="id" x="{x + 0.5 * wide:.1f}" y="{zero - below + 11:.1f}">{tool["id"]}</text>')
            x += wide + GAP
        top = zero - below + NAME
    height = top + 12.0
    head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH:.0f} {height:.0f}" font-family="sans-serif">'
    return "\n".join([head, f"<style>{STYLE}</style>", '<rect width="100%" height="100%" fill="white"/>', *body, "</svg>", ""])


if __name__ == "__main__":
    tools = json.loads((ROOT / "src/shop/european_tools.json").read_text())
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs/bend/tools.svg"
    target.write_text(picture(tools))
