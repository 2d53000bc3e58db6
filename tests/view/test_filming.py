"""Films that Python asks for, with a page that is played by the test."""

from types import SimpleNamespace

import pytest

from dhlab import animate, cube, transl
from dhlab.errors import InputError
from dhlab.view import View

from .test_outputs import Shell


@pytest.fixture
def shell(monkeypatch):
    """A shell with a kernel, whose cells have names."""
    shell = Shell()
    shell.kernel = SimpleNamespace()
    for module in ("view", "filming"):
        monkeypatch.setattr(f"dhlab.view.{module}.shell_with_kernel", lambda: shell)
    shell.begin("cell", "id-1")
    return shell


@pytest.fixture
def moving(comms, shell):
    """A view whose box moves as planned, and its channel."""
    box = cube(1)
    animate([0, 1], {box: lambda t: transl((t, 0, 0))})
    view = View("moving").add(box)
    widget = view.widget
    return view, next(comm for comm in comms if comm.comm_id == widget.model_id)


def asked(comm):
    """Numbers of the films that the page was asked for."""
    told = [data["content"] for data, _ in comm.sent if data["method"] == "custom"]
    return [content["number"] for content in told if content["kind"] == "film"]


def answer(view, content, *buffers):
    view.widget._handle_custom_msg(content, list(buffers))


def test_the_file_is_written_when_the_film_arrives(moving, tmp_path):
    view, comm = moving
    film = view.save_film(tmp_path / "box.webm")
    assert not film.arrived
    assert "the file comes after that" in repr(film)
    assert list(tmp_path.iterdir()) == []
    (number,) = asked(comm)
    answer(view, {"film": number, "ending": "webm"}, memoryview(b"a film"))
    assert film.arrived
    assert film.path.read_bytes() == b"a film"
    assert repr(film) == f"film {film.path}: saved, 0.00 MB"


def test_a_view_that_is_closed_says_that_there_will_be_no_film(moving, tmp_path):
    view, comm = moving
    made, late = view.save_film(tmp_path / "made.webm"), view.save_film(tmp_path / "late.webm")
    answer(view, {"film": asked(comm)[0], "ending": "webm"}, b"x")
    view.close()
    assert (made.arrived, made.trouble) == (True, "")
    assert repr(late) == f"no film {late.path}: the view was closed before it was made"


def test_the_first_of_several_pages_makes_the_film(moving, tmp_path):
    view, comm = moving
    film = view.save_film(tmp_path / "box.webm")
    for made in (b"first", b"second"):
        answer(view, {"film": asked(comm)[0], "ending": "webm"}, made)
    assert film.path.read_bytes() == b"first"


def test_what_is_no_webm_gets_the_ending_of_what_it_is(moving, tmp_path):
    view, comm = moving
    film = view.save_film(tmp_path / "box.webm")
    answer(view, {"film": asked(comm)[0], "ending": "mp4"}, b"x")
    assert film.path == tmp_path / "box.mp4"
    again = view.save_film(tmp_path / "box.webm")
    answer(view, {"film": asked(comm)[1], "ending": "/../../evil"}, b"x")
    assert again.path == tmp_path / "box.webm"


def test_a_page_that_cannot_film_and_a_folder_that_is_gone_are_told(moving, tmp_path):
    view, comm = moving
    film = view.save_film(tmp_path / "box.webm")
    answer(view, {"film": asked(comm)[0], "trouble": "no camera"})
    assert repr(film).endswith("box.webm: no camera")
    folder = tmp_path / "gone"
    folder.mkdir()
    film = view.save_film(folder / "box.webm")
    folder.rmdir()
    answer(view, {"film": asked(comm)[1], "ending": "webm"}, b"x")
    assert "could not be written (No such file or directory)" in film.trouble
    answer(view, {"film": 99, "ending": "webm"}, b"x")


def test_without_a_page_it_says_what_to_do(moving, shell, tmp_path):
    view, comm = moving
    shell.begin("cell")
    with pytest.raises(InputError, match=r"no page shows 'moving', .* show the view in a cell"):
        view.save_film(tmp_path / "box.webm")
    answer(view, {"ask": "scene", "have": 0})
    view.save_film(tmp_path / "box.webm")
    assert len(asked(comm)) == 1


def test_what_cannot_be_filmed_raises_before_the_page_is_asked(moving, tmp_path):
    view, comm = moving
    with pytest.raises(InputError, match=r"saved as WebM: 'limb.webm' for one, got '.*box.gif'"):
        view.save_film(tmp_path / "box.gif")
    with pytest.raises(InputError, match="there is no folder"):
        view.save_film(tmp_path / "no" / "box.webm")
    with pytest.raises(InputError, match="nothing moves in 'still': plan a motion first"):
        View("still").add(cube(1)).save_film(tmp_path / "box.webm")
    assert asked(comm) == []


def test_a_view_that_is_not_shown_has_no_page(shell, tmp_path):
    box = cube(1)
    animate([0, 1], {box: lambda t: transl((t, 0, 0))})
    with pytest.raises(InputError, match="no page shows 'unseen'"):
        View("unseen").add(box).save_film(tmp_path / "box.webm")
