"""The architecture: who may import whom, and what `import dhlab` costs."""

import ast
import importlib
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
LAYERS = [  # a module imports from its own layer and from those above it in this list
    ["errors"],
    ["arrays"],
    ["kinematics"],
    ["shapes"],
    ["scene"],
    ["models"],
    ["animation"],
    ["lessons"],
    ["diagnosis"],
    ["grading"],
    ["view"],  # from here on a screen is needed
    ["panel"],
    ["workcopy"],
    ["cli"],
    ["__main__"],
]
SCREEN = "view"
SCREEN_PACKAGES = {"IPython", "anywidget", "ipywidgets", "jupyterlab", "meshcat", "traitlets"}
HEAVY_PACKAGES = {"matplotlib", "mapbox_earcut"}  # only inside the function that needs them

RANK = {name: rank for rank, names in enumerate(LAYERS) for name in names}
MODULES = {
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): path
    for path in sorted((ROOT / "dhlab").rglob("*.py"))
}
TREES = {name: ast.parse(path.read_text("utf-8")) for name, path in MODULES.items()}
INNER = [name for name in MODULES if name != "dhlab"]


def layer(module):
    """Name of the layer that a module of dhlab lies in."""
    return module.split(".")[1]


def imported(tree):
    """Full names of everything that a module imports, inside functions too."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are written in full"
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def inside(module, tree=None):
    """Modules of dhlab that a module imports; a package only where nothing in it is named."""
    names = {name for name in imported(tree or TREES[module]) if name in MODULES} - {module}
    return {n for n in names if not any(other.startswith(f"{n}.") for other in names)}


def when_run(module):
    """Modules of dhlab that a module imports when it runs, not only for its annotations."""
    return inside(module, ast.Module([n for n in TREES[module].body if not for_types_only(n)], []))


def for_types_only(node):
    """Whether a statement is ``if TYPE_CHECKING:``."""
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


@pytest.mark.parametrize("module", INNER)
def test_a_module_lies_in_a_layer_of_the_design(module):
    assert layer(module) in RANK


@pytest.mark.parametrize("module", INNER)
def test_a_module_imports_only_from_its_own_layer_and_those_above(module):
    used = {other for other in inside(module) if other != "dhlab"}
    below = sorted(other for other in used if RANK[layer(other)] > RANK[layer(module)])
    assert not below, f"{module} imports {below}, which lie below it"


@pytest.mark.parametrize("module", INNER)
def test_a_module_does_not_import_the_list_of_public_names(module):
    named = [n for n in ast.walk(TREES[module]) if isinstance(n, ast.ImportFrom)]
    from_top = [node for node in named if node.module == "dhlab"]
    assert not from_top, f"line {from_top[0].lineno}: import from the module that has the name"


def test_no_modules_import_each_other_in_a_circle():
    list(TopologicalSorter({m: when_run(m) - {"dhlab"} for m in INNER}).static_order())


@pytest.mark.parametrize("module", [m for m in INNER if RANK.get(layer(m), 0) < RANK[SCREEN]])
def test_above_the_line_nothing_of_a_screen_is_imported(module):
    used = {name.split(".")[0] for name in imported(TREES[module])}
    assert not used & SCREEN_PACKAGES
    assert not {"dhlab.view", "dhlab.panel"} & set(imported(TREES[module]))


@pytest.mark.parametrize("module", MODULES)
def test_heavy_packages_are_imported_inside_the_function_that_needs_them(module):
    top = ast.Module([n for n in TREES[module].body if not isinstance(n, ast.If)], [])
    functions = (ast.FunctionDef, ast.AsyncFunctionDef)
    for definition in [n for n in ast.walk(top) if isinstance(n, functions)]:
        definition.body = []
    assert not {name.split(".")[0] for name in imported(top)} & HEAVY_PACKAGES


@pytest.mark.parametrize("module", MODULES)
def test_the_package_does_not_print_assert_or_import_stars(module):
    for node in ast.walk(TREES[module]):
        where = f"{module}, line {getattr(node, 'lineno', 0)}"
        assert not isinstance(node, ast.Assert), f"assert in {where}"
        if isinstance(node, ast.ImportFrom):
            assert "*" not in [alias.name for alias in node.names], f"star import in {where}"
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            speaks = module.startswith("dhlab.cli.")
            assert speaks or node.func.id != "print", f"print in {where}"


@pytest.mark.parametrize("module", [m for m in MODULES if m != "dhlab.__main__"])
def test_every_public_name_exists(module):
    there = importlib.import_module(module)
    missing = [name for name in getattr(there, "__all__", ()) if not hasattr(there, name)]
    assert not missing


def test_import_dhlab_loads_nothing_of_a_screen():
    code = "import sys, dhlab; print(*sorted({name.split('.')[0] for name in sys.modules}))"
    loaded = set(subprocess.check_output([sys.executable, "-c", code], text=True).split())
    slow = {"asyncio", "decimal", "fractions", "hashlib", "html", "PIL", "tornado", "zmq"}
    forbidden = SCREEN_PACKAGES | HEAVY_PACKAGES | slow
    assert not loaded & forbidden


def test_import_dhlab_loads_no_module_below_the_line():
    code = "import sys, dhlab; print(*[name for name in sys.modules if name.startswith('dhlab.')])"
    loaded = subprocess.check_output([sys.executable, "-c", code], text=True).split()
    assert not [name for name in loaded if RANK[layer(name)] >= RANK[SCREEN]]
