"""The rows of a run on disk, whenever it ends."""

from dataclasses import replace

import pytest

from dhlab.errors import DhlabError
from dhlab.grading.journal import UNFINISHED, Journal, earlier_rows
from dhlab.grading.results import RESULTS, write_results
from tests.grading.made import ADA, BOB, CLASS, EVE, RUN


def test_a_new_folder_holds_nothing(tmp_path):
    assert earlier_rows(tmp_path / "results") == (None, [])


def test_rows_that_were_added_are_there_after_any_end(tmp_path):
    with Journal(tmp_path / "results", RUN) as journal:
        journal.add(ADA)
        journal.add(BOB)
        assert earlier_rows(tmp_path / "results") == (RUN, [ADA, BOB])
    assert earlier_rows(tmp_path / "results") == (RUN, [ADA, BOB])


def test_a_row_cut_off_by_a_crash_is_no_row(tmp_path):
    with Journal(tmp_path, RUN) as journal:
        journal.add(ADA)
        journal.add(BOB)
    path = tmp_path / UNFINISHED
    for cut in (2, 20, 200):
        path.write_bytes(path.read_bytes()[:-cut])
        assert earlier_rows(tmp_path) == (RUN, [ADA])
    path.write_bytes(b"\xff\xfe garbage")
    assert earlier_rows(tmp_path) == (None, [])


def test_a_run_that_goes_on_keeps_what_it_is_given(tmp_path):
    with Journal(tmp_path, RUN) as journal:
        journal.add(ADA)
    with Journal(tmp_path, RUN, [ADA]) as journal:
        journal.add(BOB)
    assert earlier_rows(tmp_path) == (RUN, [ADA, BOB])


def test_a_finished_run_leaves_its_results_alone(tmp_path):
    with Journal(tmp_path, RUN) as journal:
        journal.add(ADA)
        write_results(tmp_path / RESULTS, CLASS)
        journal.done()
    assert [path.name for path in tmp_path.iterdir()] == [RESULTS]
    assert earlier_rows(tmp_path) == (RUN, list(CLASS.rows))


def test_rows_of_another_run_do_not_count(tmp_path):
    write_results(tmp_path / RESULTS, CLASS)
    other = replace(RUN, seed=18)
    with Journal(tmp_path, other) as journal:
        journal.add(EVE)
    assert earlier_rows(tmp_path) == (other, [EVE])
    with Journal(tmp_path, RUN) as journal:
        journal.add(EVE)
    assert earlier_rows(tmp_path) == (RUN, [*CLASS.rows, EVE])


def test_two_runs_do_not_write_to_one_folder(tmp_path):
    pytest.importorskip("fcntl", reason="no locks here")
    with Journal(tmp_path, RUN):
        with pytest.raises(DhlabError, match="another run is writing to"):
            Journal(tmp_path, RUN)
        assert earlier_rows(tmp_path) == (RUN, [])
    Journal(tmp_path, RUN).__exit__(None, None, None)
