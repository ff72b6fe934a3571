"""Hooks of MkDocs (mkdocs.yml). The site holds the pages of the whole repository under the paths that they have there, so that one
link serves the site and the repository, and each file that a page links. Its search works without a server."""
import json
import logging
import re
import sys
from pathlib import Path

from mkdocs.structure.files import File, Files

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))
import check_links  # noqa: E402


def linked(page):
    """Files that the page links, and all files of folders that it links."""
    for _, target in check_links.links(page.read_text(encoding="utf-8")):
        path = (page.parent / target.split("#")[0]).resolve()
        if "://" not in target and path.is_relative_to(ROOT) and path.exists():
            yield from [path] if path.is_file() else (each for each in path.rglob("*") if each.is_file())


def on_files(files, config):
    # Fragments of the next changelog are no pages of the site.
    pages = {page for page in check_links.pages() if page.parent.name != "changes"}
    others = {file for page in pages for file in linked(page) if file.suffix != ".md"}
    names = sorted(str(path.relative_to(ROOT)) for path in pages | others)
    theme = [file for file in files if not Path(file.abs_src_path).is_relative_to(config["docs_dir"])]
    return Files([File(name, str(ROOT), config["site_dir"], config["use_directory_urls"]) for name in names] + theme)


def on_nav(nav, config, files):
    """A page that the menu lacks is a mistake, which --strict refuses."""
    for file in files.documentation_pages():
        if file.page is None or file.page not in nav.pages:
            logging.getLogger("mkdocs.hooks").warning("%s is not in the menu of mkdocs.yml", file.src_uri)


def on_page_markdown(markdown, page, config, files):
    """In code within a table GitHub wants a bar escaped, MkDocs does not."""
    def row(line):
        return re.sub(r"`[^`]+`", lambda code: code[0].replace("\\|", "|"), line) if line.startswith("|") else line
    return "\n".join(map(row, markdown.split("\n")))


def on_post_build(config):
    """Browsers load no JSON from a folder; as a script they do."""
    search = Path(config["site_dir"]) / "search"
    index = json.loads((search / "search_index.json").read_text(encoding="utf-8"))
    (search / "search_index.json").unlink()
    (search / "search_index.js").write_text(f"var __search = {{index: Promise.resolve({json.dumps(index)})}};\n", encoding="utf-8")
