"""The `dhlab` command and the working copy of the notebooks."""

import json
import os
import re
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

from dhlab import cli, models
from dhlab.errors import DhlabError
from dhlab.workcopy import RECORD, refresh, shipped

ROOT = Path(__file__).parents[1]


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


def test_the_notebooks_that_came_with_dhlab_start_with_an_index():
    assert cli.INDEX in shipped()


def test_a_student_gets_no_solutions_and_no_hidden_files():
    for name in shipped():
        assert not re.search(r"(^|/)\.", name), name
        assert not re.fullmatch(r"exercises/.*\.py", name), name


def test_help_names_every_command_and_its_options(capsys):
    with pytest.raises(SystemExit, match="0"):
        cli.main(["--help"])
    text = capsys.readouterr().out
    for add in cli.COMMANDS:
        assert re.search(rf"^ +{add.__name__.removeprefix('add_')} ", text, re.MULTILINE)
    with pytest.raises(SystemExit, match="0"):
        cli.main(["lab", "--help"])
    text = capsys.readouterr().out
    for option in ("--dir", "--no-browser", "--port", "--no-token", "never overwritten"):
        assert option in text
    with pytest.raises(SystemExit, match="0"):
        cli.main(["export", "--help"])
    text = capsys.readouterr().out
    for option in ("NAME", "-o FILE", "--look {user,solid,stick}", "double click"):
        assert option in text


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "required: COMMAND"),
        (["lobby"], "invalid choice: 'lobby'"),
        (["lab", "--port", "many"], "a port is a number from 1 to 65535, got 'many'"),
        (["lab", "--port", "70000"], "a port is a number from 1 to 65535, got '70000'"),
        (["export", "upper_limb"], "required: -o"),
        (["export", "puma", "-o", "a.html", "--look", "odd"], "invalid choice: 'odd'"),
    ],
)
def test_a_wrong_command_line_says_what_was_wanted(arguments, words, capsys):
    with pytest.raises(SystemExit, match="2"):
        cli.main(arguments)
    assert words in capsys.readouterr().err


def test_a_folder_that_cannot_be_written_is_one_sentence(tmp_path, capsys):
    (tmp_path / "file").write_text("not a folder")
    assert cli.main(["lab", "--dir", str(tmp_path / "file" / "copy")]) == 2
    assert re.match(r"dhlab: .*file.*\n$", capsys.readouterr().err)


@pytest.mark.parametrize("look", [[], ["--look", "user"], ["--look", "stick"]])
def test_a_model_is_exported_as_one_page(tmp_path, capsys, look):
    page = tmp_path / "limb.html"
    assert cli.main(["export", "upper_limb", "-o", str(page), *look]) == 0
    assert capsys.readouterr().out == f"dhlab: wrote {page} ({page.stat().st_size / 1e6:.1f} MB)\n"
    assert page.stat().st_size < 600_000
    text = page.read_text("utf-8")
    assert "<title>upper limb</title>" in text
    for name in ("arm", "thumb", "index", "middle", "ring", "little"):
        assert f'{{"name":"{name}"' in text


def test_each_model_can_be_exported(tmp_path):
    for model in models.__all__:
        assert cli.main(["export", model, "-o", str(tmp_path / f"{model}.html")]) == 0


@pytest.mark.parametrize("words", [["detour"], ["puma", "--lesson"]])
def test_a_lesson_is_exported_as_one_page(tmp_path, capsys, words):
    page = tmp_path / "lesson.html"
    assert cli.main(["export", *words, "-o", str(page)]) == 0
    assert capsys.readouterr().out.startswith(f"dhlab: wrote {page}")
    text = page.read_text("utf-8")
    assert "dhlab-lesson" in text
    assert "https://" not in text.replace("https://www.w3.org", "")
    assert len(text) < 1_300_000


@pytest.mark.parametrize("model", ["lower_limb", "__all__", "limb"])
def test_a_model_that_is_not_there_is_told_with_the_choices(tmp_path, capsys, model):
    assert cli.main(["export", model, "-o", str(tmp_path / "page.html")]) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"dhlab: no model or lesson '{model}'; there are models arm, finger, ")
    assert "upper_limb" in said
    assert "order_matters" in said
    assert list(tmp_path.iterdir()) == []


def test_a_page_that_cannot_be_written_is_one_sentence(tmp_path, capsys):
    assert cli.main(["export", "puma", "-o", str(tmp_path / "none" / "page.html")]) == 2
    assert re.match(r"dhlab: there is no folder '.*none' for .*\n$", capsys.readouterr().err)


def test_jupyterlab_asks_for_a_token_unless_told_otherwise(tmp_path):
    def arguments(*words):
        return cli.server_arguments(cli.parser().parse_args(["lab", *words]), tmp_path)

    assert not any("token" in word for word in arguments("--no-browser", "--port", "9000"))
    assert "--IdentityProvider.token=" in arguments("--no-token")
    assert "--ServerApp.port=9000" in arguments("--port", "9000")


def test_what_was_done_is_told_in_lines(sources, folder):
    done = refresh(folder, sources)
    assert cli.told(done) == [
        "dhlab: new in your copy: notebooks/index.ipynb, notebooks/first.ipynb"
    ]
    assert cli.told(refresh(folder, sources)) == []


@pytest.fixture
def server(tmp_path):
    """A running `dhlab lab` without a token: its address and its process."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "dhlab", "lab", "--no-browser", "--no-token"]
    paths = {"PYTHONPATH": os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH")]))}
    home = {name: str(tmp_path / name) for name in ("HOME", "JUPYTER_DATA_DIR", "IPYTHONDIR")}
    process = subprocess.Popen(
        [*command, "--port", str(port), "--dir", "work"],
        cwd=tmp_path,
        env=os.environ | paths | home,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    yield f"http://127.0.0.1:{port}", process
    process.terminate()
    process.wait(timeout=20)


def fetch(server, path, seconds=30.0):
    """Answer of a server that may still be starting."""
    address, process = server
    end = time.monotonic() + seconds
    while True:
        try:
            with urllib.request.urlopen(address + path, timeout=seconds) as answer:
                return json.load(answer)
        except OSError:
            if process.poll() is not None or time.monotonic() > end:
                raise
            time.sleep(0.1)


def test_lab_serves_the_working_copy_and_saves_the_state_of_widgets(server):
    assert fetch(server, f"/api/contents/{cli.INDEX}")["type"] == "notebook"
    plugin = "@jupyter-widgets/jupyterlab-manager:plugin"
    settings = fetch(server, f"/lab/api/settings/{plugin}")
    assert settings["schema"]["properties"]["saveState"]["default"] is True
