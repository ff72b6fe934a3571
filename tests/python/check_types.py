"""Requirement: the package and the code of the notebooks pass mypy --strict. check_types.py MYPY SOURCE CACHE"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

mypy, source, cache = sys.argv[1:]
package = pathlib.Path(source) / "python"
with tempfile.TemporaryDirectory() as folder:
    files = []
    for notebook in sorted((pathlib.Path(source) / "examples/notebooks").glob("*.ipynb")):
        cells = [cell for cell in json.loads(notebook.read_text())["cells"] if cell["cell_type"] == "code"]
        file = pathlib.Path(folder) / (notebook.stem.replace("-", "_") + ".py")
        file.write_text("\n".join("".join(cell["source"]) + "\n" for cell in cells))
        files.append(str(file))
    assert len(files) == 3, files
    done = subprocess.run([mypy, "--config-file", package / "mypy.ini", "--cache-dir", cache, package / "deadpoint", *files],
                          env={**os.environ, "MYPYPATH": str(package)})
sys.exit(done.returncode)
