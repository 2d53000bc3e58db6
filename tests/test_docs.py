"""Docstrings that can be relied on, and a README whose code runs."""

import ast
import importlib
import inspect
import json
import os
import re
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

import dhlab

ROOT = Path(__file__).parents[1]
PUBLIC = {
    name: thing
    for name in getattr(dhlab, "__all__", ())
    if inspect.isclass(thing := getattr(dhlab, name)) or inspect.isfunction(thing)
}
FUNCTIONS = {name: thing for name, thing in PUBLIC.items() if inspect.isfunction(thing)}
METHODS = {
    f"{name}.{key}": member.fget if isinstance(member, property) else member
    for name, thing in PUBLIC.items()
    if inspect.isclass(thing)
    for key, member in vars(thing).items()
    if not key.startswith("_") and (inspect.isfunction(member) or isinstance(member, property))
}
MODULES = [
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
    for path in sorted((ROOT / "dhlab").rglob("*.py"))
    if path.stem != "__main__"
]


def sections(doc):
    """Text of each numpydoc section by its title."""
    parts = re.split(r"^(\w[\w ]*)\n-{3,}$", inspect.cleandoc(doc or ""), flags=re.MULTILINE)
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def documented(doc, section="Parameters"):
    """Names that a section speaks of, without their stars."""
    heads = re.findall(r"^(\*{0,2}\w[^:\n]*?)(?: *:.*)?$", sections(doc).get(section, ""), re.M)
    return {name.strip("* ") for head in heads for name in head.split(",")}


def parameters(function):
    """Names of a function's parameters without `self` and those that begin with an underscore."""
    names = [name for name in inspect.signature(function).parameters if name[0] != "_"]
    return [name for name in names if name not in ("self", "cls")]


def raises_itself(function):
    """Whether a function's own body has a `raise`."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    return any(isinstance(node, ast.Raise) and node.exc for node in ast.walk(tree))


@pytest.mark.parametrize("name", [*PUBLIC, *METHODS])
def test_everything_public_says_what_it_gives_in_one_sentence(name):
    doc = inspect.cleandoc((PUBLIC | METHODS)[name].__doc__ or "")
    assert doc, f"{name} has no docstring"
    assert re.search(r"[.:?]$", doc.split("\n\n")[0]), f"{name}: {doc.splitlines()[0]!r}"


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_public_function_documents_its_parameters(name):
    missing = set(parameters(FUNCTIONS[name])) - documented(FUNCTIONS[name].__doc__)
    assert not missing, f"{name} says nothing of {sorted(missing)}"


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_public_function_documents_what_it_returns_and_raises(name):
    function, there = FUNCTIONS[name], sections(FUNCTIONS[name].__doc__)
    if inspect.signature(function).return_annotation not in (None, "None"):
        assert "Returns" in there or "Yields" in there
    if raises_itself(function):
        assert "Raises" in there


@pytest.mark.parametrize("module", MODULES)
def test_no_docstring_speaks_of_a_parameter_that_is_not_there(module):
    there = importlib.import_module(module)
    own = [t for t in vars(there).values() if getattr(t, "__module__", "") == module]
    classes = [t for t in own if inspect.isclass(t)]
    functions = [t for t in own if inspect.isfunction(t)]
    functions += [m for c in classes for m in vars(c).values() if inspect.isfunction(m)]
    for function in functions:
        stale = documented(function.__doc__) - set(inspect.signature(function).parameters)
        assert not stale, f"{module}.{function.__qualname__} has no {sorted(stale)}"
    for cls in classes:
        stale = documented(cls.__doc__) - set(inspect.signature(cls.__init__).parameters)
        assert not stale, f"{module}.{cls.__qualname__} has no {sorted(stale)}"


def test_the_code_of_the_readme_runs(tmp_path):
    text = (ROOT / "README.md").read_text("utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert blocks
    run = [sys.executable, "-W", "error", "-c", "\n".join(blocks)]
    env = os.environ | {"DHLAB_VIEW": "record", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(run, cwd=tmp_path, env=env, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


FOUND_BY_OTHERS = {
    *("Handle", "AttachError", "DhlabError", "InputError", "PlannedMotion", "Component"),
    *("Branch", "DHRow", "Robot", "shapes"),
}
"""Bases, errors, a module, and what other functions make: seen with those."""


def shown_in_notebooks():
    """Code of all cells of all notebooks."""
    cells = (
        cell
        for path in sorted((ROOT / "notebooks").glob("*.ipynb"))
        for cell in json.loads(path.read_text("utf-8"))["cells"]
    )
    return "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


@pytest.mark.parametrize("name", dhlab.__all__)
def test_every_public_name_is_shown_with_an_example_or_in_a_notebook(name):
    text = getattr(dhlab, name).__doc__ or ""
    used = re.search(rf"\b{name}\b", shown_in_notebooks())
    made_by = re.search(r"made by `(\w+)`", text)
    assert ">>>" in text or used or made_by or name in FOUND_BY_OTHERS, name
