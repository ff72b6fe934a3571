#!/usr/bin/env python3
"""Checks the relative links of all pages: every file and every heading that a link names must exist.

    scripts/check_links.py [FILE...]

By default all Markdown pages of the repository. Anchors are those that GitHub makes, and the site of `make docs`. Addresses of the
network are not tried.
"""
import functools
import re
import sys
import urllib.parse
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGES = ("*.md", "docs/**/*.md", "cases/**/*.md", "examples/**/*.md", "changes/*.md")


def prose(text):
    """The lines outside of fenced code, numbered from 1."""
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = re.match(r"\s*(```|~~~)", line)
        if mark and fence in (None, mark[1]):
            fence = None if fence else mark[1]
        elif not fence:
            yield number, line


def slug(heading):
    """The anchor of a heading: links keep their text, marks go, blanks become hyphens."""
    heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(text):
    found, counts = set(), {}
    for _, line in prose(text):
        heading = re.match(r"#{1,6} +(.*?)[ #]*$", line)
        if heading:
            name = slug(heading[1])
            found.add(f"{name}-{counts[name]}" if name in counts else name)
            counts[name] = counts.get(name, 0) + 1
        found.update(re.findall(r'<\w+ (?:id|name)="([^"]+)"', line))
    return found


@functools.cache
def anchors_of(path):
    return anchors(path.read_text(encoding="utf-8"))


def links(text):
    """(line, target) of each link and picture; code in the line shows links, but has none. A text may go over two lines."""
    lines = dict(prose(text))
    for number, line in lines.items():
        line = re.sub(r"(`+)(?:(?!\1).)*\1", "", line)
        for pattern in (r"\]\(<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\)", r"^\s*\[[^\]]+\]:\s*<?(\S+?)>?\s*$", r'\b(?:src|href)="([^"]+)"'):
            for target in re.findall(pattern, line):
                yield number, target


def mistake(page, target):
    """What is wrong with a link, or nothing."""
    parts = urllib.parse.urlsplit(target)
    if parts.scheme or parts.netloc:
        return None
    path = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
    if not path.is_relative_to(ROOT):
        return "is outside of the repository"
    if not path.exists():
        return "does not exist"
    if parts.fragment and path.suffix == ".md" and parts.fragment not in anchors_of(path):
        return "has no such heading"
    return None


def pages():
    found = {page for pattern in PAGES for page in ROOT.glob(pattern)}
    return sorted(page for page in found if "build" not in page.relative_to(ROOT).parts)


def main():
    if "--help" in sys.argv:
        print(__doc__)
        return
    checked = [Path(name).resolve() for name in sys.argv[1:]] or pages()
    count, failures = 0, []
    for page in checked:
        for number, target in links(page.read_text(encoding="utf-8")):
            count += 1
            wrong = mistake(page, target)
            if wrong:
                where = page.relative_to(ROOT) if page.is_relative_to(ROOT) else page
                failures.append(f"{where}:{number}: {target} {wrong}")
    if failures:
        print("\n".join(failures))
        sys.exit(f"error: {len(failures)} of {count} links are wrong\n  help: correct them, or the page that they name")
    print(f"{count} links on {len(checked)} pages lead somewhere")


if __name__ == "__main__":
    main()
