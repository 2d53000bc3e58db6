"""Listing and reading what was handed in: nothing is unpacked, followed or read without end."""

import os
import stat
import struct
import zipfile

import pytest

from dhlab.errors import DhlabError, InputError
from dhlab.grading import entries as module
from dhlab.grading.entries import Entry, handed_in


def listed(source, **options):
    """Path -> content or problem, of everything handed in."""
    found = {}
    with handed_in(source, **options) as entries:
        for entry in entries:
            try:
                found[entry.path] = entry.read()
            except InputError as error:
                found[entry.path] = str(error)
    return found


def packed(path, files, **options):
    """Write a zip archive."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, **options) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return path


def test_a_folder_is_listed_without_what_programs_leave_behind(tmp_path):
    for name in ("ada/turns.ipynb", "bob.ipynb", "ada/.ipynb_checkpoints/turns.ipynb", ".DS_Store"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(name.encode())
    found = listed(tmp_path)
    assert found == {
        "ada": "is a folder",
        "ada/turns.ipynb": b"ada/turns.ipynb",
        "bob.ipynb": b"bob.ipynb",
    }


def test_the_results_inside_the_folder_are_not_handed_in(tmp_path):
    (tmp_path / "results").mkdir()
    (tmp_path / "results" / "ada.json").write_text("{}")
    (tmp_path / "ada.ipynb").write_text("{}")
    assert list(listed(tmp_path, skip=tmp_path / "results")) == ["ada.ipynb"]


def test_no_symbolic_link_is_followed(tmp_path):
    (tmp_path / "secret.ipynb").write_text("secret")
    folder = tmp_path / "class"
    (folder / "eve").mkdir(parents=True)
    (folder / "bob.ipynb").symlink_to(tmp_path / "secret.ipynb")
    (folder / "eve" / "turns.ipynb").symlink_to("/etc/passwd")
    (folder / "mallory").symlink_to(tmp_path)
    (folder / "loop").symlink_to(folder)
    found = listed(folder)
    link = "is a symbolic link, which is not followed"
    assert found == {
        "bob.ipynb": link,
        "eve": "is a folder",
        "eve/turns.ipynb": link,
        "loop": link,
        "mallory": link,
    }


def test_a_link_put_in_place_of_a_listed_file_is_not_followed(tmp_path):
    path = tmp_path / "ada.ipynb"
    path.write_text("{}")
    with handed_in(tmp_path) as (entry,):
        path.unlink()
        path.symlink_to("/etc/passwd")
        with pytest.raises(InputError, match="cannot be opened"):
            entry.read()


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_pipe_is_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "ada.ipynb")
    assert listed(tmp_path) == {"ada.ipynb": "is not a file but a pipe or a device"}


def test_a_name_that_is_no_utf_8_can_be_shown(tmp_path):
    try:
        (tmp_path / os.fsdecode(b"zo\xeb.ipynb")).write_text("{}")
    except OSError:
        pytest.skip("this file system takes UTF-8 alone")
    assert list(listed(tmp_path)) == ["zo\\xeb.ipynb"]


def test_a_huge_file_is_not_read(tmp_path, monkeypatch):
    monkeypatch.setattr(module, "MOST_BYTES", 1_000_000)
    (tmp_path / "ada.ipynb").write_bytes(b" " * 1_000_001)
    (tmp_path / "bob.ipynb").write_bytes(b" " * 1_000_000)
    found = listed(tmp_path)
    assert found["ada.ipynb"] == "is larger than 1 MB"
    assert len(found["bob.ipynb"]) == 1_000_000


def test_a_folder_of_too_many_files_is_no_class(tmp_path, monkeypatch):
    monkeypatch.setattr(module, "MOST_FILES", 3)
    for k in range(4):
        (tmp_path / f"{k}.ipynb").touch()
    with pytest.raises(DhlabError, match=r"holds more than 3 files; is it the class\?"):
        listed(tmp_path)


def test_deep_folders_come_to_an_end(tmp_path):
    (tmp_path.joinpath(*["deep"] * 30)).mkdir(parents=True)
    assert "lies too deep in folders" in listed(tmp_path).values()


def test_a_notebook_alone_is_a_class_of_one(tmp_path):
    (tmp_path / "ada.ipynb").write_bytes(b"{}")
    assert listed(tmp_path / "ada.ipynb") == {"ada.ipynb": b"{}"}


@pytest.mark.parametrize(
    ("name", "words"),
    [("none", "there is no folder or archive '.*none'"), ("a.txt", "no folder, no zip archive")],
)
def test_what_is_no_class_is_one_sentence(tmp_path, name, words):
    (tmp_path / "a.txt").write_text("text")
    with pytest.raises(DhlabError, match=words):
        listed(tmp_path / name)


def test_an_archive_is_read_in_memory(tmp_path):
    path = packed(tmp_path / "class.zip", {"ada/": "", "ada/turns.ipynb": "{}", "bob.ipynb": "[]"})
    before = set(tmp_path.iterdir())
    assert listed(path) == {"ada": "is a folder", "ada/turns.ipynb": b"{}", "bob.ipynb": b"[]"}
    assert set(tmp_path.iterdir()) == before


def test_a_folder_packed_whole_is_looked_into(tmp_path):
    path = packed(tmp_path / "class.zip", {"class/ada.ipynb": "{}", "class/bob.ipynb": "[]"})
    assert list(listed(path)) == ["ada.ipynb", "bob.ipynb"]


@pytest.mark.parametrize(
    "name", ["../ada.ipynb", "/etc/ada.ipynb", "a/../../ada.ipynb", r"..\ada.ipynb", "C:/ada.ipynb"]
)
def test_a_path_that_climbs_out_is_not_read(tmp_path, name):
    path = packed(tmp_path / "class.zip", {name: "{}", "bob.ipynb": "[]"})
    found = listed(path)
    assert found.pop("bob.ipynb") == b"[]"
    assert list(found.values()) == ["has a path that climbs out of the archive"]


def test_a_link_in_an_archive_is_not_followed(tmp_path):
    info = zipfile.ZipInfo("ada.ipynb")
    info.create_system, info.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(tmp_path / "class.zip", "w") as archive:
        archive.writestr(info, "/etc/passwd")
    assert listed(tmp_path / "class.zip") == {
        "ada.ipynb": "is a symbolic link, which is not followed"
    }


def test_a_file_packed_small_is_not_unpacked_without_end(tmp_path):
    path = packed(
        tmp_path / "class.zip", {"ada.ipynb": bytes(module.MOST_BYTES + 1), "b.ipynb": "{}"}
    )
    assert listed(path) == {"ada.ipynb": "is larger than 32 MB", "b.ipynb": b"{}"}


def forged(path, size):
    """Make an archive say that its only file is of another size."""
    packed(path, {"ada.ipynb": bytes(100_000)})
    data = bytearray(path.read_bytes())
    for mark, place in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        start = data.index(mark) + place
        data[start : start + 4] = struct.pack("<I", size)
    path.write_bytes(data)
    return path


def test_what_an_archive_says_of_a_size_is_not_believed(tmp_path):
    assert "damaged" in listed(forged(tmp_path / "small.zip", 10))["ada.ipynb"]
    assert "zip bomb" in listed(forged(tmp_path / "large.zip", 30_000_000))["ada.ipynb"]


def test_an_archive_that_says_to_be_huge_is_refused_whole(tmp_path, monkeypatch):
    monkeypatch.setattr(module, "MOST_UNPACKED", 1_000_000)
    path = packed(tmp_path / "class.zip", {f"{k}.ipynb": bytes(300_000) for k in range(4)})
    with pytest.raises(DhlabError, match=r"4 files of together 0.0 GB: it looks like a zip bomb"):
        listed(path)


def test_an_archive_of_too_many_files_is_refused_whole(tmp_path, monkeypatch):
    monkeypatch.setattr(module, "MOST_FILES", 3)
    path = packed(tmp_path / "class.zip", {f"{k}.ipynb": "" for k in range(4)})
    with pytest.raises(DhlabError, match="looks like a zip bomb"):
        listed(path)


def test_a_damaged_archive_is_one_sentence(tmp_path):
    path = packed(tmp_path / "class.zip", {f"{k}.ipynb": "{}" for k in range(9)})
    data = path.read_bytes()
    directory = data.index(b"PK\x01\x02")
    for damaged in (data[:-100], b"", data[:directory] + b"?" + data[directory + 1 :]):
        path.write_bytes(damaged)
        with pytest.raises(DhlabError, match=r"the archive '.*class.zip' is damaged or cut off"):
            listed(path)


def test_a_damaged_file_in_an_archive_leaves_the_others(tmp_path):
    path = packed(tmp_path / "class.zip", {"ada.ipynb": "{}" * 500, "bob.ipynb": "[]"})
    data = bytearray(path.read_bytes())
    start = data.index(b"ada.ipynb") + len("ada.ipynb")
    data[start : start + 6] = b"\xff" * 6
    path.write_bytes(data)
    found = listed(path)
    assert found["ada.ipynb"].startswith("is damaged in the archive")
    assert found["bob.ipynb"] == b"[]"


def test_an_encrypted_file_and_an_odd_packing_are_told(tmp_path):
    path = packed(tmp_path / "class.zip", {"ada.ipynb": "{}"})
    data = bytearray(path.read_bytes())
    data[data.index(b"PK\x01\x02") + 8] |= 1
    path.write_bytes(data)
    assert listed(path) == {"ada.ipynb": "is encrypted"}
    with zipfile.ZipFile(path, "w", zipfile.ZIP_LZMA) as archive:
        archive.writestr("ada.ipynb", "{}")
    assert "pack it as an ordinary zip" in listed(path)["ada.ipynb"]


def test_an_archive_in_an_archive_stays_packed(tmp_path):
    inner = packed(tmp_path / "inner.zip", {"turns.ipynb": "{}"}).read_bytes()
    path = packed(tmp_path / "class.zip", {"ada.zip": inner})
    assert listed(path) == {"ada.zip": inner}


def test_a_folder_cannot_be_read_as_a_file():
    with pytest.raises(InputError, match="is a folder"):
        Entry(("ada",), is_folder=True).read()
