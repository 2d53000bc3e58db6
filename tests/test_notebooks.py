"""What every notebook must be before it is run: titled, clean, and free of this machine."""

import ast
import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
NOTEBOOKS = {
    path.relative_to(ROOT).as_posix(): json.loads(path.read_text("utf-8"))
    for folder in ("notebooks", "exercises")
    for path in sorted((ROOT / folder).rglob("*.ipynb"))
    if ".ipynb_checkpoints" not in path.parts
}
MACHINE_PATHS = re.compile(r"(?<![\w./])(/(home|root|Users|work|tmp|opt|mnt)/\w|[A-Z]:\\\\\w)")


def code_cells(name):
    """Number and cell of each code cell."""
    return [(k, c) for k, c in enumerate(NOTEBOOKS[name]["cells"]) if c["cell_type"] == "code"]


def source(cell):
    """Text of a cell, which the file keeps as one string or as lines."""
    return "".join(cell["source"])


def test_there_are_notebooks():
    assert NOTEBOOKS


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_begins_with_its_title(name):
    first = NOTEBOOKS[name]["cells"][0]
    assert first["cell_type"] == "markdown"
    assert re.match(r"# \S", source(first))


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_cell_has_an_id_of_its_own(name):
    notebook = NOTEBOOKS[name]
    assert (notebook["nbformat"], notebook["nbformat_minor"] >= 5) == (4, True)
    ids = [cell.get("id") for cell in notebook["cells"]]
    assert all(ids)
    assert len(set(ids)) == len(ids)


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_names_no_path_of_a_machine(name):
    found = MACHINE_PATHS.search(json.dumps(NOTEBOOKS[name], ensure_ascii=False))
    assert not found, found


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_is_saved_without_outputs_and_counters(name):
    for k, cell in code_cells(name):
        if "nbval-check-output" not in cell["metadata"].get("tags", []):
            assert not cell["outputs"], f"cell {k} has outputs"
            assert cell["execution_count"] is None, f"cell {k} has a counter"
    assert "widgets" not in NOTEBOOKS[name]["metadata"]


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_is_saved_without_the_state_of_its_widgets(name):
    assert "widgets" not in NOTEBOOKS[name]["metadata"]


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_a_notebook_runs_on_the_kernel_that_everybody_has(name):
    kernel = NOTEBOOKS[name]["metadata"]["kernelspec"]
    assert (kernel["name"], kernel["language"]) == ("python3", "python")


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_code_cell_is_plain_python(name):
    for _, cell in code_cells(name):
        ast.parse(source(cell))


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_the_index_names_every_notebook(name):
    index = "".join(map(source, NOTEBOOKS["notebooks/index.ipynb"]["cells"]))
    path = name.removeprefix("notebooks/") if name.startswith("notebooks/") else f"../{name}"
    assert path == "index.ipynb" or f"({path})" in index


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_link_to_a_file_leads_somewhere(name):
    cells = [c for c in NOTEBOOKS[name]["cells"] if c["cell_type"] == "markdown"]
    links = re.findall(r"\]\(([^)#\s]+)[^)]*\)", "".join(map(source, cells)))
    for link in links:
        if not re.match(r"[a-z]+:", link):
            assert ((ROOT / name).parent / link).exists(), link
