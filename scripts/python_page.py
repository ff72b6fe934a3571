#!/usr/bin/env python3
"""Writes docs/python.md from the docstrings of the Python package; --check says whether the page is as it would be written."""
import ast
import inspect
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "python" / "deadpoint"
PAGE = ROOT / "docs" / "python.md"
INTRODUCTION = ROOT / "python" / "introduction.md"
SECTIONS = (
    ("Cases and full runs", "_press"), ("Loads and heat", "_loads"), ("The reduced press", "_rom"), ("Results", "_results"),
    ("Series", "_series"),
    ("Tables", "_tables"), ("Fields", "_fields"), ("Charts", "_plot"), ("Studies", "_studies"),
    ("Progress", "_progress"), ("Errors", "_errors"),
)


def exported():
    """The names that the package offers, and classes of objects that they hand out."""
    tree = ast.parse((PACKAGE / "__init__.py").read_text())
    for node in tree.body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return {*ast.literal_eval(node.value), "Plot"}
    sys.exit("error: python/deadpoint/__init__.py has no __all__")


def text_of(docstring):
    """A docstring as Markdown: roles, parameters and literals."""
    text = inspect.cleandoc(docstring)
    text = re.sub(r":(?:func|meth|attr|class):`(?:deadpoint\.)?([^`]+)`", r"`\1`", text).replace("``", "`")
    lines, last = [], None
    for line in text.splitlines():
        field = re.match(r":(param|returns|raises) ?([\w.]*): (.*)", line)
        if field:
            kind, name, rest = field.groups()
            label = {"param": f"`{name}`", "returns": "returns", "raises": f"raises `{name}`"}[kind]
            if last is None and lines and lines[-1]:
                lines.append("")
            line, last = f"- {label}: {rest}", kind
        elif last and line:
            line = "  " + line.strip()
        lines.append(line)
    return "\n".join(lines)


def signature(function, name):
    """The call as a user writes it, without self."""
    arguments = ast.unparse(function.args)
    arguments = re.sub(r"^(self|cls)(, )?", "", arguments)
    returned = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"{name}({arguments}){returned}".replace(" -> None", "")


def is_property(function):
    return any(ast.unparse(d).split(".")[-1] in ("property", "cached_property") for d in function.decorator_list)


def attribute_docs(body):
    """(name, type, docstring) of attributes that a string follows."""
    for node, after in zip(body, body[1:]):
        if not (isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) and isinstance(after.value.value, str)):
            continue
        if isinstance(node, ast.AnnAssign):
            yield ast.unparse(node.target).removeprefix("self."), ast.unparse(node.annotation), after.value.value
        elif isinstance(node, ast.Assign):
            yield ast.unparse(node.targets[0]).removeprefix("self."), "", after.value.value


def require_docs(node):
    """Every public attribute has a docstring."""
    described = {name for name, _, _ in attribute_docs(node.body)}
    for one in node.body:
        if isinstance(one, ast.AnnAssign) and one.target.id not in described and not one.target.id.startswith("_"):
            sys.exit(f"error: {node.name}.{one.target.id} has no docstring")


def class_lines(node):
    require_docs(node)
    out = [f"\n### {node.name}\n", text_of(ast.get_docstring(node) or "") + "\n"]
    attributes = list(attribute_docs(node.body))
    functions = [one for one in node.body if isinstance(one, ast.FunctionDef)]
    for function in functions:
        if function.name == "__init__":
            attributes += attribute_docs(function.body)
        elif is_property(function) and not function.name.startswith("_"):
            attributes.append((function.name, ast.unparse(function.returns), ast.get_docstring(function) or ""))
    if attributes:
        out += ["| attribute | type | meaning |", "|---|---|---|"]
        for name, kind, doc in attributes:
            if not name.startswith("_"):
                meaning = " ".join(text_of(doc).split()).replace("|", "\\|")
                out.append(f"| `{name}` | {'`' + kind.replace('|', chr(92) + '|') + '`' if kind else ''} | {meaning} |")
        out.append("")
    for function in functions:
        doc = ast.get_docstring(function)
        if doc and not function.name.startswith("_") and not is_property(function) and "For deadpoint itself" not in doc:
            out += [f"**`{signature(function, '.' + function.name)}`**\n", text_of(doc) + "\n"]
    return out


def module_lines(name, names):
    tree = ast.parse((PACKAGE / f"{name}.py").read_text())
    out = []
    for node in tree.body:
        if isinstance(node, ast.FunctionDef) and node.name in names:
            call = signature(node, "deadpoint." + node.name)
            out += [f"\n### deadpoint.{node.name}\n", f"**`{call}`**\n", text_of(ast.get_docstring(node) or "") + "\n"]
        elif isinstance(node, ast.ClassDef) and node.name in names:
            out += class_lines(node)
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name in names:
            if not ast.get_docstring(node):
                sys.exit(f"error: {name}.{node.name} has no docstring")
            names.remove(node.name)
    return out


def page():
    names = exported()
    out = [INTRODUCTION.read_text().rstrip() + "\n"]
    for title, module in SECTIONS:
        if (PACKAGE / f"{module}.py").exists():
            out += [f"\n## {title}", *module_lines(module, names)]
    if names:
        sys.exit(f"error: {sorted(names)} stand in no section of scripts/python_page.py")
    return re.sub(r"\n{3,}", "\n\n", "\n".join(out)).rstrip() + "\n"


def main():
    text = page()
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(text)
    elif not PAGE.exists() or PAGE.read_text() != text:
        sys.exit("error: docs/python.md is not what the docstrings say\n  help: run scripts/python_page.py")


main()
