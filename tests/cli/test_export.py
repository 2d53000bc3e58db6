"""`dhlab export`."""

import re

import pytest

from dhlab import cli, models


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
