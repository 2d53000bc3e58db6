"""The JavaScript as it is put together."""

import re
from importlib.resources import files

import pytest

from dhlab.view import assets

STATIC = files("dhlab.view") / "static"
MODULES = sorted(path.name.removesuffix(".js") for path in STATIC.iterdir() if ".js" in path.name)


@pytest.mark.parametrize("entry", ["connection", "loader", "librarian"])
def test_a_bundle_imports_nothing(entry):
    assert "import {" not in assets.bundle(entry)
    assert not re.search(r"^import ", assets.bundle(entry), re.MULTILINE)


def test_the_viewer_exports_its_public_face_alone():
    assert re.findall(r"^export (.*?) ?\{", assets.viewer(), re.MULTILINE) == ["class Connection"]


def test_both_loaders_are_small_and_have_what_loads_the_viewer_once():
    for entry in ("loader", "librarian"):
        assert assets.bundle(entry).count("const module_library =") == 1
        assert len(assets.bundle(entry)) < 8_000


def test_each_module_is_in_the_viewer_or_the_loader_once():
    text = assets.viewer() + assets.bundle("loader")
    of_saved_pages = {"blocks", "file", "sliders", "standalone", "unpack"}
    for name in set(MODULES) - {"connection", "librarian", "loader", "page"} - of_saved_pages:
        if not name.startswith(("lesson", "markup")):
            assert text.count(f"const module_{name} =") == 1, name


def test_a_lesson_s_bar_is_in_the_page_that_is_saved_but_not_in_the_viewer():
    saved = assets.bundle("standalone")
    for name in MODULES:
        if name.startswith("lesson"):
            assert saved.count(f"const module_{name} =") == 1, name
            assert f"module_{name}" not in assets.viewer()


@pytest.mark.parametrize("name", MODULES)
def test_each_import_names_something_that_is_exported(name):
    source = (STATIC / f"{name}.js").read_text(encoding="utf-8")
    for names, module in re.findall(r'import \{([^}]*)\} from "\./(\w+)\.js"', source):
        exported = (STATIC / f"{module}.js").read_text(encoding="utf-8")
        for each in names.split(","):
            pattern = rf"^export (async )?(function|class|const) {each.strip()}\b"
            assert re.search(pattern, exported, re.MULTILINE), f"{name}: {each}"


@pytest.mark.parametrize("name", MODULES)
def test_modules_are_short(name):
    source = (STATIC / f"{name}.js").read_text(encoding="utf-8")
    assert source.count("\n") < 300
    assert max(map(len, source.splitlines())) <= 120
    assert "console.log" not in source
    assert "innerHTML" not in source or name in ("toolbar", "markup")


def test_the_viewer_is_small_beside_the_bundle_it_hosts():
    assert len(assets.viewer()) < 125_000
    assert 500_000 < len(assets.meshcat()) < 2_000_000


def test_the_digest_names_the_content():
    assert re.fullmatch("[0-9a-f]{32}", assets.digest())
