"""Requirement: a link to a page or a heading that does not exist is found, and no link that leads somewhere is blamed."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
import check_links  # noqa: E402

PAGE = """# The `[[sets]]` of *a* press, step by step
[there](other.md#two-words) and [twice](other.md#same-1), [here](#the-sets-of-a-press-step-by-step), ![picture](a.svg)
[network](https://example.org/x.md#y), `[code](gone.md)`, <img src="a.svg">
```
[block](gone.md)
# no heading
```
[gone](gone.md) [no heading](other.md#no-heading) [outside](../../x.md) <img src="b.svg">
[folder](.) [escape](with%20blank.md)
"""
OTHER = "# Two words\n## Same\n## Same\n"


class Links(unittest.TestCase):
    def test_mistakes(self):
        with tempfile.TemporaryDirectory() as folder:
            root, before = Path(folder).resolve() / "root", check_links.ROOT
            root.mkdir()
            for name, text in (("page.md", PAGE), ("other.md", OTHER), ("a.svg", ""), ("with blank.md", "")):
                (root / name).write_text(text)
            check_links.ROOT = root
            self.addCleanup(setattr, check_links, "ROOT", before)
            wrong = {(number, target): check_links.mistake(root / "page.md", target) for number, target in check_links.links(PAGE)}
        self.assertEqual({key: text for key, text in wrong.items() if text},
                         {(8, "gone.md"): "does not exist", (8, "other.md#no-heading"): "has no such heading",
                          (8, "../../x.md"): "is outside of the repository", (8, "b.svg"): "does not exist"})
        self.assertEqual(len(wrong), 12)

    def test_anchors(self):
        self.assertEqual(check_links.slug("`parts.<name>.shapes (each item)`"), "partsnameshapes-each-item")
        self.assertEqual(check_links.slug("See [the page](other.md), and go on"), "see-the-page-and-go-on")


if __name__ == "__main__":
    unittest.main()
