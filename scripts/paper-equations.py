#!/usr/bin/env python3
"""Writes docs/validation/paper-equations.md from tests/paper/equations.toml: every equation, table and figure of the paper, how
the program uses it, where it is computed and which test shows it. The script refuses a list that leaves one out or names a
file, test or symbol that does not exist.

    scripts/paper-equations.py           write the page
    scripts/paper-equations.py --check   fail if the page is not what would be written
"""
import pathlib
import re
import sys
import tomllib

root = pathlib.Path(__file__).resolve().parent.parent
source = root / "tests/paper/equations.toml"
page = root / "docs/validation/paper-equations.md"
fates = {
    "as printed": "as printed",
    "corrected": "wrong as printed, corrected",
    "replaced": "another method for the same quantity",
    "compared": "result, compared with ours",
    "data": "carried over as data",
    "not used": "not used",
}
wanted = (
    [("Eq.", n) for n in range(1, 35)]
    + [("A.", n) for n in range(1, 47)]
    + [("Table", n) for n in range(1, 8)]
    + [("Table A.", 1)]
    + [("Fig.", n) for n in range(1, 26)]
    + [("Fig. A.", n) for n in (1, 2)]
)


def covered(name):
    """The numbers a name such as "Eq. 4-7", "A.1-A.2" or "Fig. A.1-A.2" stands for."""
    match = re.fullmatch(r"(Eq\.|Fig\. A\.|Fig\.|Table A\.|Table|A\.) ?(\d+)(?:-(?:A\.)?(\d+))?", name)
    if not match:
        sys.exit(f"error: {source.name}: '{name}' is not an equation, table or figure")
    first, last = int(match[2]), int(match[3] or match[2])
    return [(match[1], n) for n in range(first, last + 1)]


def problems(entries):
    found = []
    seen = [item for entry in entries for item in covered(entry["id"])]
    found += [f"{kind} {n} is missing" for kind, n in wanted if (kind, n) not in seen]
    found += [f"{kind} {n} is listed more than once, or is not in the paper" for kind, n in seen if seen.count((kind, n)) > 1
              or (kind, n) not in wanted]
    for entry in entries:
        where = entry["id"]
        if entry["fate"] not in fates:
            found.append(f"{where}: there is no fate '{entry['fate']}'")
        for place in entry.get("code", []):
            file, symbol = place.split(": ", 1)
            path = root / "src/deadpoint" / file
            if not path.is_file() or symbol not in path.read_text():
                found.append(f"{where}: '{symbol}' is not in src/deadpoint/{file}")
        for place in entry.get("test", []):
            file, name = place.split(": ", 1)
            path = root / "tests" / file
            if not path.is_file() or f'TEST_CASE("{name}"' not in path.read_text():
                found.append(f"{where}: there is no test '{name}' in tests/{file}")
        if "page" in entry and not (page.parent / entry["page"]).is_file():
            found.append(f"{where}: there is no page '{entry['page']}'")
        needs_proof = entry["fate"] in ("as printed", "corrected", "replaced")
        if needs_proof and not (entry.get("code") and entry.get("test")):
            found.append(f"{where}: names no code or no test")
    return found


def row(entry):
    places = [place.split(": ", 1) for place in entry.get("code", [])]
    code = "<br>".join(f"[`{symbol}`](../../src/deadpoint/{file})" for file, symbol in places)
    tests = "<br>".join("[{1}](../../tests/{0})".format(*place.split(": ", 1)) for place in entry.get("test", []))
    if "page" in entry:
        linked = f"[{pathlib.PurePath(entry['page']).name}]({entry['page']})"
        tests = f"{tests}<br>{linked}" if tests else linked
    fate = fates[entry["fate"]] + (f": {entry['note']}" if entry.get("note") else "")
    return f"| {entry['id']} | {entry['what']} | {fate} | {code} | {tests} |"


def text(entries):
    count = {fate: sum(len(covered(e["id"])) for e in entries if e["fate"] == fate) for fate in fates}
    head = [
        "<!-- Written by scripts/paper-equations.py from tests/paper/equations.toml. Do not edit. -->",
        "# The paper's equations, tables and figures",
        "",
        "This page lists each equation (1-34, A.1-A.46), table and figure of Zheng et al. (2018), how the program uses it, where the",
        "program computes it, and which test or page shows this. The derivations are in [theory.md](../theory.md).",
        "",
        f"Of {sum(count.values())}: " + "; ".join(f"{number} {fates[fate]}" for fate, number in count.items()) + ".",
        "",
        "| | what | how it is used | code | shown by |",
        "|---|---|---|---|---|",
    ]
    return "\n".join(head + [row(entry) for entry in entries]) + "\n"


def main():
    entries = tomllib.loads(source.read_text())["entry"]
    if found := problems(entries):
        sys.exit("\n".join(f"error: {source.name}: {problem}" for problem in found))
    wanted_text = text(entries)
    if "--check" in sys.argv:
        if not page.is_file() or page.read_text() != wanted_text:
            sys.exit(f"error: {page.relative_to(root)} is not up to date\n  help: run scripts/paper-equations.py")
        return
    page.write_text(wanted_text)


if __name__ == "__main__":
    main()
