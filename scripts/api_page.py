#!/usr/bin/env python3
"""Writes docs/api.md from the comments of the public headers; --check says whether the page is as it would be written."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "api.md"
HEADERS = ("press", "reduced_press", "read_options", "result", "study", "session", "diagnostic", "error", "observer", "version")
HEAD = """# Public headers

Made from the comments in `include/deadpoint` by `scripts/api_page.py`; [library.md](library.md) says how to link them and what
is stable. All values are in SI units. Everything is in namespace `deadpoint`.
"""


def sections(lines):
    """Yields (comment, code) for all that stands in the namespace; a comment belongs to the code that follows it."""
    comment, code, depth = [], [], 0
    for line in lines:
        text = line.strip()
        if text.startswith("///") and depth == 0 and not code:
            comment.append(text[3:].strip())
            continue
        if not text and depth == 0 and not code:
            comment = []
            continue
        if not text and depth == 0:
            yield comment, code
            comment, code = [], []
            continue
        code.append(line.rstrip())
        depth += line.count("{") - line.count("}")
        if depth == 0 and (text.endswith("};") or (text.endswith((";", "}")) and not text.startswith("template"))):
            yield comment, code
            comment, code = [], []


def without_private(code):
    """The declaration as a user needs it."""
    kept, hidden = [], False
    for line in code:
        text = line.strip()
        if text in ("private:", "/// For deadpoint itself."):
            hidden = True
        if text == "};":
            hidden = False
        if not hidden and "Implementation" not in text:
            kept.append(line)
    return kept


def page_of(header):
    text = (ROOT / "include" / "deadpoint" / f"{header}.hpp").read_text()
    before, inside = re.split(r"^namespace deadpoint \{$", text, maxsplit=1, flags=re.MULTILINE)
    inside = inside[: inside.rindex("}  // namespace deadpoint")]
    about = " ".join(line[3:].strip() or "\n\n" for line in before.splitlines() if line.startswith("///"))
    out = [f"\n## deadpoint/{header}.hpp\n"]
    if about:
        out.append(about.replace(" \n\n ", "\n\n") + "\n")
    for comment, code in sections(inside.splitlines()):
        code = without_private(code)
        if not code:
            continue
        out += ["```cpp"] + [f"/// {line}".rstrip() for line in comment] + code + ["```\n"]
    return "\n".join(out)


def main():
    known = {path.stem for path in (ROOT / "include" / "deadpoint").glob("*.hpp")}
    if known != set(HEADERS):
        sys.exit(f"error: scripts/api_page.py does not list {sorted(known ^ set(HEADERS))}")
    page = HEAD + "".join(page_of(header) for header in HEADERS)
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(page)
    elif not PAGE.exists() or PAGE.read_text() != page:
        sys.exit("error: docs/api.md is not what the headers say\n  help: run scripts/api_page.py")


main()
