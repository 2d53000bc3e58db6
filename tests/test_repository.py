"""What the repository itself must be: few names at the top, no traces of one machine."""

import re
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TOP = {
    ".ci", ".github", ".gitignore", "LICENSE", "README.md",
    "dhlab", "exercises", "notebooks", "pyproject.toml", "tests",
}  # fmt: skip


@pytest.fixture(scope="module")
def tracked():
    """Files under version control."""
    command = ["git", "-C", str(ROOT), "ls-files", "-z"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        pytest.skip("not a clone: no list of files")
    return [ROOT / name for name in done.stdout.split("\0") if name]


def test_the_top_of_the_repository_holds_only_what_the_design_names(tracked):
    assert {path.relative_to(ROOT).parts[0] for path in tracked} <= TOP


def test_no_file_names_a_path_of_one_machine(tracked):
    pattern = re.compile(r"(?<![./\w])/(work|root|farm|home)/[\w.]")
    for path in [p for p in tracked if p.exists() and p.stat().st_size < 1_000_000]:
        text = path.read_bytes().decode("utf-8", errors="replace")
        found = pattern.search(text.replace(pattern.pattern, ""))
        assert not found, f"{path.relative_to(ROOT)}: {text[found.start() : found.end() + 40]!r}"


def test_every_dependency_says_why_it_is_there():
    text = (ROOT / "pyproject.toml").read_text("utf-8")
    core = tomllib.loads(text)["project"]["dependencies"]
    for requirement in core:
        assert ">=" in requirement
        assert re.search(rf"\"{re.escape(requirement)}\", +# \w", text), requirement


@pytest.mark.parametrize("script", ["tests/run", ".ci/run"])
def test_the_scripts_can_be_run(script):
    path = ROOT / script
    assert path.stat().st_mode & 0o111
    assert path.read_text("utf-8").startswith("#!/usr/bin/env bash\n")
