#!/usr/bin/env python3
"""Writes docs/folders.md and its picture from the includes of src and app; --check says whether they are as they would be written.

An arrow leads from a folder to one that it includes, unless others in between lead there too.
"""
import html
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
page, picture = root / "docs/folders.md", root / "docs/images/folders.svg"
WIDTH, HEIGHT, GAP_X, GAP_Y = 112, 30, 18, 46  # of a box, and between boxes [px]


def folder_of(path):
    parts = path.relative_to(root).parts
    return parts[2] if parts[0] == "src" else "app" if parts[0] == "app" else "include"


def includes():
    """For each folder, the others that it includes."""
    found = {}
    for top in ("src/deadpoint", "app", "include/deadpoint"):
        for file in sorted((root / top).rglob("*.[ch]pp")):
            text = file.read_text()
            folder = folder_of(file)
            targets = found.setdefault(folder, set())
            for target in re.findall(r'(?m)^#include "deadpoint/([^"]+)"', text):
                targets.add(target.split("/")[0] if "/" in target else "include")
    return {folder: targets - {folder, "include"} for folder, targets in found.items()}


def reached(graph, folder):
    below = set()
    for target in graph[folder]:
        below |= {target} | reached(graph, target)
    return below


def reduced(graph):
    """Without the arrows that a longer way makes needless."""
    return {folder: {target for target in targets
                     if not any(target in reached(graph, other) for other in targets - {target})}
            for folder, targets in graph.items()}


def levels(graph):
    """Folders by the longest way down from them, the lowest first."""
    height = {}

    def of(folder):
        if folder not in height:
            height[folder] = 1 + max((of(target) for target in graph[folder]), default=-1)
        return height[folder]

    rows = {}
    for folder in sorted(graph):
        rows.setdefault(of(folder), []).append(folder)
    return [rows[level] for level in sorted(rows)]


def draw(arrows, rows):
    width = max(len(row) for row in rows) * (WIDTH + GAP_X) + GAP_X
    height = len(rows) * (HEIGHT + GAP_Y) + GAP_Y
    place = {}
    for level, row in enumerate(rows):
        left = (width - len(row) * (WIDTH + GAP_X) + GAP_X) / 2
        for number, folder in enumerate(row):
            place[folder] = (left + number * (WIDTH + GAP_X), height - GAP_Y - HEIGHT - level * (HEIGHT + GAP_Y))
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" font-family="sans-serif" '
             'font-size="14">',
             '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
             '<path d="M0 0 8 4 0 8z" fill="#667"/></marker></defs>',
             f'<rect width="{width:.0f}" height="{height:.0f}" fill="#fff"/>']
    for folder in sorted(arrows):
        for target in sorted(arrows[folder]):
            (x, y), (u, v) = place[folder], place[target]
            parts.append(f'<path d="M{x + WIDTH / 2:.0f} {y + HEIGHT}C{x + WIDTH / 2:.0f} {y + HEIGHT + GAP_Y / 2:.0f} '
                         f'{u + WIDTH / 2:.0f} {v - GAP_Y / 2:.0f} {u + WIDTH / 2:.0f} {v}" fill="none" stroke="#889" '
                         'marker-end="url(#tip)"/>')
    for folder, (x, y) in place.items():
        fill = "#fdf0d8" if folder in ("machine", "fem", "full") else "#e4eef8"
        parts.append(f'<rect x="{x:.0f}" y="{y:.0f}" width="{WIDTH}" height="{HEIGHT}" rx="5" fill="{fill}" stroke="#667"/>'
                     f'<text x="{x + WIDTH / 2:.0f}" y="{y + 20:.0f}" text-anchor="middle">{html.escape(folder)}</text>')
    return "\n".join([*parts, "</svg>", ""])


def write_page(arrows, rows):
    text = ["<!-- Written by scripts/folder_page.py. -->", "# Folders and their arrows", "",
            "Each folder of `src/deadpoint`, and `app`, includes those to which its arrows lead, directly or through others. "
            "No arrow leads", "back, between folders or between the rooms inside of one (`tests/include_rules`). Folders with a "
            "mesh or fields are yellow; all", "others, up to the twin and the report, need no Gmsh, PETSc or MPI.", "",
            "![folders](images/folders.svg)", "", "| folder | leads to |", "|---|---|"]
    for row in reversed(rows):
        for folder in row:
            text.append(f"| `{folder}` | {', '.join(f'`{target}`' for target in sorted(arrows[folder])) or '-'} |")
    return "\n".join([*text, ""])


def main():
    if "--help" in sys.argv:
        print(__doc__)
        return
    graph = includes()
    graph.pop("include", None)
    arrows, rows = reduced(graph), levels(graph)
    wanted = {page: write_page(arrows, rows), picture: draw(arrows, rows)}
    for file, text in wanted.items():
        if "--check" not in sys.argv:
            file.write_text(text)
        elif not file.exists() or file.read_text() != text:
            sys.exit(f"error: {file.relative_to(root)} is not up to date\n  help: run scripts/folder_page.py")


if __name__ == "__main__":
    main()
