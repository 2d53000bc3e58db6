"""The working copy of the notebooks."""

import json
import re

import pytest

from dhlab.errors import DhlabError
from dhlab.workcopy import RECORD, refresh, shipped


@pytest.fixture
def sources(tmp_path):
    """Two notebooks as one version of dhlab carries them."""
    folder = tmp_path / "carried"
    folder.mkdir()
    for name in ("index", "first"):
        (folder / name).write_text(f"{name}, version 1")
    return {f"notebooks/{name}.ipynb": folder / name for name in ("index", "first")}


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "copy"


def read(folder):
    """Text of each notebook in a working copy."""
    return {p.stem: p.read_text() for p in folder.rglob("*.ipynb")}


def test_a_new_working_copy_holds_every_notebook(sources, folder):
    done = refresh(folder, sources)
    assert done.copied == tuple(sources)
    assert read(folder) == {"index": "index, version 1", "first": "first, version 1"}


def test_a_second_run_does_nothing(sources, folder):
    refresh(folder, sources)
    before = {p: p.stat().st_mtime_ns for p in folder.rglob("*.ipynb")}
    done = refresh(folder, sources)
    assert (done.copied, done.updated, done.kept) == ((), (), ())
    assert {p: p.stat().st_mtime_ns for p in folder.rglob("*.ipynb")} == before


def test_an_unchanged_notebook_follows_a_newer_dhlab(sources, folder):
    refresh(folder, sources)
    sources["notebooks/first.ipynb"].write_text("first, version 2")
    assert refresh(folder, sources).updated == ("notebooks/first.ipynb",)
    assert read(folder)["first"] == "first, version 2"


def test_a_changed_notebook_is_never_overwritten(sources, folder):
    refresh(folder, sources)
    mine = folder / "notebooks/first.ipynb"
    mine.write_text("my own answer")
    assert refresh(folder, sources).kept == ()
    sources["notebooks/first.ipynb"].write_text("first, version 2")
    for _ in range(2):
        assert refresh(folder, sources).kept == ("notebooks/first.ipynb",)
        assert mine.read_text() == "my own answer"


def test_a_file_that_dhlab_did_not_write_is_never_overwritten(sources, folder):
    mine = folder / "notebooks/first.ipynb"
    mine.parent.mkdir(parents=True)
    mine.write_text("here before dhlab came")
    done = refresh(folder, sources)
    assert (done.copied, done.kept) == (("notebooks/index.ipynb",), ("notebooks/first.ipynb",))
    assert mine.read_text() == "here before dhlab came"


def test_a_notebook_renamed_by_its_owner_comes_afresh(sources, folder):
    refresh(folder, sources)
    mine = folder / "notebooks/first.ipynb"
    mine.write_text("my own answer")
    mine.rename(folder / "notebooks/mine.ipynb")
    assert refresh(folder, sources).copied == ("notebooks/first.ipynb",)
    assert read(folder)["mine"] == "my own answer"
    assert read(folder)["first"] == "first, version 1"


def test_a_change_taken_back_follows_newer_versions_again(sources, folder):
    refresh(folder, sources)
    mine = folder / "notebooks/first.ipynb"
    sources["notebooks/first.ipynb"].write_text("first, version 2")
    mine.write_text("first, version 2")
    assert refresh(folder, sources).updated == ()
    sources["notebooks/first.ipynb"].write_text("first, version 3")
    assert refresh(folder, sources).updated == ("notebooks/first.ipynb",)


def test_a_notebook_that_was_only_opened_follows_a_newer_dhlab(tmp_path, folder):
    def notebook(*sources, **metadata):
        cells = [
            {"cell_type": "code", "source": source, "outputs": [], "metadata": {}}
            for source in sources
        ]
        return json.dumps({"cells": cells, "metadata": metadata})

    source = tmp_path / "first.ipynb"
    source.write_text(notebook("a = 1", ["b = 2\n", "c = 3"]))
    copy = folder / "notebooks/first.ipynb"
    refresh(folder, {"notebooks/first.ipynb": source})
    copy.write_text(notebook("a = 1", "b = 2\nc = 3", language_info={"version": "3.11"}))
    source.write_text(notebook("a = 2"))
    assert refresh(folder, {"notebooks/first.ipynb": source}).updated
    copy.write_text(notebook("a = 3"))
    source.write_text(notebook("a = 4"))
    assert refresh(folder, {"notebooks/first.ipynb": source}).kept
    assert "a = 3" in copy.read_text()


@pytest.mark.parametrize("damage", ["{", "[]"])
def test_a_damaged_record_is_told_and_nothing_is_touched(sources, folder, damage):
    folder.mkdir()
    (folder / RECORD).write_text(damage)
    with pytest.raises(DhlabError, match=r"\.dhlab-copies\.json is damaged .*move it away"):
        refresh(folder, sources)
    assert read(folder) == {}


def test_a_student_gets_no_solutions_and_no_hidden_files():
    for name in shipped():
        assert not re.search(r"(^|/)\.", name), name
        assert not re.fullmatch(r"exercises/.*\.py", name), name
