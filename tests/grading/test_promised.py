"""What the text of an exercise promises is held against its questions before it is released."""

import re

import pytest

from dhlab.errors import DhlabError
from dhlab.grading.build import build, notebook_path


def refused(folder):
    """The lines that are said when an exercise is refused, without its folder."""
    with pytest.raises(DhlabError) as error:
        build(folder)
    assert not notebook_path(folder).exists()
    return str(error.value).replace(f"{folder}/", "").splitlines()


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            'check("rot_z", rot_z)',
            'check("rot_zz", rot_z)',
            [
                "exercise.py, line 24: check('rot_zz', ...) asks for a question that is not in "
                "checks.py; there are rot_z, R",
                "exercise.py: no cell checks 'rot_z'; write check('rot_z', rot_z)",
            ],
        ),
        (
            '# %%\ncheck("R", R)\n',
            "",
            ["exercise.py: no cell checks 'R'; write check('R', R)"],
        ),
        (
            'check("R", R)',
            'check("R", first)',
            ["exercise.py, line 33: what a check sees is marked; write check('R', R)"],
        ),
        (
            'check("R", R)',
            'check("R")',
            ["exercise.py, line 33: what a check sees is marked; write check('R', R)"],
        ),
        (
            "# # Turns",
            "# # Turns\n# **Time.** 2 minutes. **Points.** 6.",
            ["exercise.py, line 3: the text says 6 points; the questions of checks.py have 3 tog"],
        ),
        (
            "# %% rot-z",
            "# %% one [markdown]\n# ## 1. A turn (4 points)\n\n# %% rot-z",
            ["exercise.py, line 17: the heading says 4 points; checks.py has 3 for rot_z and R"],
        ),
        (
            '# %%\ncheck("R", R)\n',
            '# %%\ncheck("R", R)\n# %% two [markdown]\n# ## 2. More (1 point)\n#\n# Words.\n',
            ["exercise.py, line 35: the heading says 1 points; no question is checked below it"],
        ),
    ],
)
def test_a_text_that_does_not_fit_the_questions_is_refused_with_its_line(
    folder, edit, old, new, said
):
    edit("exercise.py", old, new)
    lines = refused(folder)
    assert len(lines) == len(said)
    assert all(line.startswith(words) for line, words in zip(lines, said, strict=True)), lines


def test_points_that_fit_and_none_are_fine(folder, edit):
    edit("exercise.py", "# # Turns", "# # Turns\n# **Points.** 3.")
    edit("exercise.py", "# %% rot-z", "# %% a [markdown]\n# ## 1. A (2 points)\n\n# %% rot-z")
    edit("exercise.py", "check.show", 'check("R", R)\ncheck.show')  # checked twice, counted once
    edit(
        "exercise.py",
        "# %%\n### BEGIN SOLUTION\nfirst",
        "# %% b [markdown]\n# ### 2. B (1 point)\n\n# %%\n### BEGIN SOLUTION\nfirst",
    )
    assert build(folder).changed


@pytest.mark.parametrize(
    ("hint", "line"),
    [
        ("c, s = np.cos(angle), np.sin(angle)", 19),
        ("write [[c,-s,0], [s,c,0], [0,0,1]]", None),
        ("np.array([[c,-s,0], [s,c,0], [0,0,1]])", 20),
        ("Which column? first @ rot_z(0.7)", None),
        ('Begin with first = rotx(given[\\"angle\\"])', 28),
        ("Which column stays as it is?", None),
    ],
)
def test_a_hint_that_holds_a_line_of_an_answer_is_refused(folder, edit, hint, line):
    edit("checks.py", "Which column stays as it is?", hint)
    if line is None:
        assert build(folder).changed
    else:
        said = f"exercise.py, line {line}: the hint of 'rot_z' gives this line away"
        assert refused(folder) == [said]


def test_all_that_is_amiss_is_told_at_once(folder, edit):
    edit("exercise.py", "# # Turns", "# # Turns\n# **Points.** 6.")
    edit("exercise.py", "rot_z(0.7)\n", "rot_z(0.8)\n")
    edit("wrong.py", '# %% R: shape (3,)\nR = [given["angle"], 0, 0.7]\n', "")
    edit("wrong.py", "# %% rot_z: degrees", "# %% rot: degrees")
    said = refused(folder)
    for words in ("says 6 points", "4 wrong answers; 5 are", "no question 'rot'", "'R' fails its"):
        assert sum(words in line for line in said) == 1
    assert len(said) == 4


def test_all_wrong_answers_that_are_not_explained_are_told_at_once(folder, edit):
    edit("wrong.py", "# %% rot_z: sign-1", "# %% rot_z: axis-1-y")
    edit("wrong.py", "# %% rot_z: axis-1-x", "# %% rot_z: sign-1")
    edit("wrong.py", "# %% R: shape (3,)", "# %% R: e")
    said = refused(folder)
    assert [line.split(":")[0] for line in said] == [f"wrong.py, line {k}" for k in (2, 8, 14)]
    assert "'e' says too little of what is meant for 'R'; write" in said[2]


def test_words_of_a_diagnosis_begin_where_a_word_begins(folder, edit):
    edit("wrong.py", "# %% R: shape (3,)", "# %% R: hape (3,)")
    assert "'hape (3,)' was meant for 'R', but it gets 0 points" in refused(folder)[0]


def test_what_follows_from_another_problem_is_not_told(folder, edit):
    edit("exercise.py", "# %% rot-z", "# %% a [markdown]\n# ## 1. A (3 points)\n\n# %% rot-z")
    edit("exercise.py", 'check("R", R)', 'check("RR", R)')
    (amiss, missing) = refused(folder)
    assert "check('RR', ...) asks for a question that is not" in amiss
    assert "no cell checks 'R'" in missing


def test_a_value_is_proved_as_its_check_sees_it(folder, edit):
    edit(
        "exercise.py", "check.show(yours, R)", "check.show(yours, R)\nif R is not ...:\n    R *= 0"
    )
    assert build(folder).changed


def test_an_answer_that_is_right_only_after_its_check_is_refused(folder, edit):
    edit("exercise.py", "R = first @ rot_z(0.7)", "R = first + 0")
    edit(
        "exercise.py",
        "# %% yours",
        "# %%\n### BEGIN SOLUTION\nR[:] = first @ rot_z(0.7)\n### END SOLUTION\n\n# %% yours",
    )
    (said,) = [line for line in refused(folder) if "fails its own checks" in line]
    assert said.startswith("exercise.py, line 27: the answer to 'R' fails")


def test_a_question_that_was_renamed_in_the_checks_alone_is_told_so(folder, edit):
    edit("checks.py", 'Question("R",', 'Question("R_own",')
    edit("wrong.py", "# %% R: reversed-order\nR =", "# %% R_own: reversed-order\nR_own =")
    edit("wrong.py", "# %% R: shape (3,)\nR =", "# %% R_own: shape (3,)\nR_own =")
    amiss, missing = refused(folder)
    assert "check('R', ...) asks for a question that is not in checks.py" in amiss
    assert "no cell checks 'R_own'" in missing
    edit("exercise.py", 'check("R", R)', "first_of_R = R[0]")
    edit("exercise.py", "check.show(yours, R)", 'check.show(yours, R)\ncheck("R_own", R_own)')
    (blank, *_) = refused(folder)
    assert re.fullmatch(
        r"exercise\.py, line 33: the cell that begins here raised NameError: .*, in the blank "
        r"notebook; no question is called 'R' \(there are rot_z, R_own\), so nothing stands in its "
        "place",
        blank,
    )


def test_a_task_that_cannot_judge_is_told_to_who_wrote_it(folder, edit):
    edit("checks.py", "import MatrixTask, turn", "import MatrixTask, slide, turn")
    edit("checks.py", 'turn("z", lambda angle: angle)', "slide((0, 0, lambda angle: angle))")
    (said,) = [line for line in refused(folder) if "'rot_z'" in line]
    assert said.startswith("checks.py: the task of 'rot_z' cannot judge an answer (")
    assert "instructor" not in said
