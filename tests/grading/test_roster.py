"""The list of students."""

import pytest

from dhlab.errors import InputError
from dhlab.grading.roster import people_from, read_people
from dhlab.grading.whose import Owner


@pytest.mark.parametrize(
    ("text", "student", "names"),
    [
        ("Ada Lovelace\nKurt\n", "Ada Lovelace", ("Ada Lovelace",)),
        ("student\nada\n", "ada", ("ada",)),
        (
            "id,last_name,first_name,email\na1,Lovelace,Ada,a@b.c\n",
            "a1",
            ("Ada Lovelace", "a1", "a@b.c"),
        ),
        ("First name;Last name;ID number\nAda;Lovelace;17\n", "17", ("Ada Lovelace", "17")),
        ("Student\tID\tSection\nAda Lovelace\t99\t1\n", "99", ("Ada Lovelace", "99")),
        ('Student,ID\n"Lovelace, Ada",99\n', "99", ("Lovelace, Ada", "99")),
        ("username,name\n,Ada\n", "Ada", ("Ada",)),
        ("\n\nname;id\nAda;17\n", "17", ("Ada", "17")),
        ("name\rAda\rKurt\r", "Ada", ("Ada",)),
        ('Ada "Countess" Lovelace\nKurt\n', 'Ada "Countess" Lovelace', None),
    ],
)
def test_lists_of_many_kinds_are_read(text, student, names):
    person = people_from(text)[0]
    assert (person.student, person.names) == (student, names or (student,))


@pytest.mark.parametrize(
    ("owner", "same"),
    [
        (Owner("Ada Lovelace", "123"), True),
        (Owner("lovelaceada", "123"), True),
        (Owner("a1"), True),
        (Owner("somebody", "a1"), True),
        (Owner("lovelace"), False),
        (Owner("Ada"), False),
    ],
)
def test_a_student_of_the_list_is_known_by_any_name(owner, same):
    (person,) = people_from("id,first_name,last_name\na1,Ada,Lovelace\n")
    assert (person.has_number(owner) or person.is_owner(owner)) is same


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (b"room,phone\n1,2\n", "no column names the students; .* one of student_id, id, username"),
        (b'name\n"Ada\nBob\n', r"students.csv, line 3: unexpected end of data"),
        (b"name\n" + b"x" * 200_000, r"students.csv, line 2: field larger than"),
        (b"Ada\nada\n", "names 'ada' twice; give each student an id of their own"),
    ],
)
def test_a_list_that_cannot_be_used_is_one_sentence(tmp_path, content, words):
    path = tmp_path / "students.csv"
    path.write_bytes(content)
    with pytest.raises(InputError, match=words):
        read_people(path)


def test_a_list_that_is_not_there_is_one_sentence(tmp_path):
    with pytest.raises(InputError, match=r"the list of students '.*' cannot be read"):
        read_people(tmp_path / "none.csv")


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_a_list_comes_in_several_encodings(tmp_path, encoding):
    path = tmp_path / "students.csv"
    path.write_bytes("name\nKurt Gödel\n".encode(encoding))
    assert read_people(path)[0].student == "Kurt Gödel"
