"""Students' names as platforms and people write them."""

import pytest

from dhlab.grading.whose import (
    Owner,
    is_for_another,
    is_same_person,
    name_key,
    owner_of_file,
    owner_of_folder,
    stem_of,
)


@pytest.mark.parametrize(
    ("folder", "name", "number"),
    [
        ("ada", "ada", ""),
        ("Ada Lovelace_12345_assignsubmission_file_", "Ada Lovelace", "12345"),
        ("Ada Lovelace_12345_assignsubmission_file", "Ada Lovelace", "12345"),
        ("Ada_Maria Lovelace_1_assignsubmission_file_", "Ada_Maria Lovelace", "1"),
        ("81234-99 - Ada Lovelace - Nov 3, 2026 405 PM", "Ada Lovelace", "99"),
        ("Jean-Luc - Picard", "Jean-Luc - Picard", ""),
    ],
)
def test_the_name_in_a_folder_s_name(folder, name, number):
    assert owner_of_folder(folder) == Owner(name, number)


@pytest.mark.parametrize(
    ("file", "name", "number"),
    [
        ("ada.ipynb", "ada", ""),
        ("Ada Lovelace.ipynb", "Ada Lovelace", ""),
        ("ada_07_dh_link.ipynb", "ada", ""),
        ("07_dh_link_ada.ipynb", "ada", ""),
        ("07_DH_Link - ada.ipynb", "ada", ""),
        ("ada.07_dh_link.ipynb", "ada", ""),
        ("ada (1).ipynb", "ada", ""),
        ("ada-Copy1.ipynb", "ada", ""),
        ("ada_07_dh_link (2).ipynb.txt", "ada", ""),
        ("j.r.lovelace.ipynb", "j.r.lovelace", ""),
        ("lovelaceada_123_456_07_dh_link.ipynb", "lovelaceada", "123"),
        ("lovelaceada_LATE_123_456_x-1.ipynb", "lovelaceada", "123"),
        ("Ada Lovelace_12345_assignsubmission_file_x.ipynb", "Ada Lovelace", "12345"),
        ("ex7_al17_attempt_2026-11-03-16-05-12_x.ipynb", "al17", ""),
        ("07_dh_link.ipynb", "07_dh_link", ""),
    ],
)
def test_the_name_in_a_file_s_name(file, name, number):
    assert owner_of_file(file, "07_dh_link") == Owner(name, number)


def test_numbers_in_the_name_of_an_exercise_are_not_those_of_canvas():
    assert owner_of_file("ada_01_02_turns.ipynb", "01_02_turns") == Owner("ada")


@pytest.mark.parametrize("file", ["ada.ipynb", "ada.ipynb.txt", "ada.ipynb.json", "ada.PDF", "ada"])
def test_a_stem_is_what_the_owner_wrote(file):
    assert stem_of(file) == "ada"


@pytest.mark.parametrize(
    ("file", "another"),
    [
        ("ada_02_links.ipynb", True),
        ("02_links.ipynb", True),
        ("02_links-Copy1.ipynb", True),
        ("lovelaceada_123_456_02_links.ipynb", True),
        ("ada_01_turns.ipynb", False),
        ("ada_02_links_again.ipynb", False),
        ("ada.ipynb", False),
    ],
)
def test_what_is_named_as_another_exercise_belongs_there(file, another):
    assert is_for_another(file, "01_turns", ["02_links", "links_again"]) is (
        another or file.startswith("ada_02_links_again")
    )


def test_of_two_names_that_fit_the_longer_one_counts():
    assert is_for_another("ada_07_dh_link.ipynb", "dh_link", ["07_dh_link"])
    assert not is_for_another("ada_07_dh_link.ipynb", "07_dh_link", ["dh_link"])


@pytest.mark.parametrize("name", ["Ada Lovelace", " ada  LOVELACE", "ADA lovelace"])
def test_capitals_and_spaces_do_not_make_another_student(name):
    assert name_key(name) == name_key("Ada Lovelace")


def test_two_ways_to_write_an_accent_are_one():
    assert name_key("Zo\u00eb") == name_key("Zoe\u0308")


@pytest.mark.parametrize(
    ("typed", "names", "same"),
    [
        ("Ada Lovelace", ["lovelaceada"], True),
        ("Lovelace, Ada", ["Ada Lovelace"], True),
        ("Anne-Marie d'Arc", ["darcannemarie"], True),
        ("Ada Lovelace", ["lovelaceadam"], False),
        ("", ["ada"], False),
        ("", [""], False),
        ("a b c d e f g h i j k l", ["ab"], False),
        ("Ada", [], False),
    ],
)
def test_a_typed_name_is_known_again(typed, names, same):
    assert is_same_person(typed, names) is same
