"""The command line as a whole."""

import re

import pytest

from dhlab import cli


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
