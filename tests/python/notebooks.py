"""Runs a notebook from its first cell to its last, in a folder of its own; an error of a cell fails.

    notebooks.py NOTEBOOK.ipynb      with umbra importable
"""
import os
import sys
import tempfile

import nbformat
from nbclient import NotebookClient

path = os.path.abspath(sys.argv[1])
notebook = nbformat.read(path, as_version=4)
for cell in notebook.cells:
    if cell.cell_type == "code":
        assert not cell.outputs and cell.execution_count is None, f"{path}: has outputs; clear them"
os.environ.pop("MPLBACKEND", None)  # notebooks draw into themselves
with tempfile.TemporaryDirectory() as folder:
    for name in ("HOME", "IPYTHONDIR", "MPLCONFIGDIR", "JUPYTER_RUNTIME_DIR", "JUPYTER_DATA_DIR"):
        os.environ[name] = os.path.join(folder, "home")
    os.makedirs(os.environ["HOME"])
    work = os.path.join(folder, "work")
    os.makedirs(work)
    NotebookClient(notebook, timeout=900, kernel_name="python3", resources={"metadata": {"path": work}}).execute()
    drawn = sum("image/png" in output.get("data", {}) for cell in notebook.cells if cell.cell_type == "code"
                for output in cell.outputs)
assert drawn > 0, f"{path}: nothing is drawn"
print(f"{os.path.basename(path)}: runs, {drawn} pictures")
