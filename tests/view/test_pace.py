"""Not too often, and the last one always."""

import threading
from time import monotonic, sleep

import pytest

from dhlab.scene.handle import CHANGES
from dhlab.view.pace import INTERVAL, LINGER, Pace


class Sink:
    """Remembers the newest state each time it is called."""

    def __init__(self, cost=0.0):
        self.state = None
        self.seen = []
        self.times = []
        self.cost = cost
        self.pace = Pace(self.take)

    def take(self):
        self.times.append(monotonic())
        self.seen.append(self.state)
        sleep(self.cost)

    def change(self, state):
        with CHANGES:
            self.state = state
            self.pace.ask()


def wait_for(condition, seconds=2.0):
    end = monotonic() + seconds
    while not condition() and monotonic() < end:
        sleep(0.002)
    return condition()


def test_the_first_change_is_told_at_once():
    sink = Sink()
    sink.change(1)
    assert sink.seen == [1]


def test_the_last_change_is_told_though_nobody_asks_again():
    sink = Sink()
    for state in range(5):
        sink.change(state)
    assert sink.seen == [0]
    assert wait_for(lambda: sink.seen[-1] == 4)
    assert sink.seen == [0, 4]


def test_a_flood_is_told_sixty_times_a_second_at_most():
    sink = Sink()
    began = monotonic()
    count = 0
    while monotonic() - began < 0.5:
        count += 1
        sink.change(count)
    assert wait_for(lambda: sink.seen[-1] == count)
    took = sink.times[-1] - began
    assert count > 1000
    assert 5 < len(sink.seen) <= took / INTERVAL + 2
    gaps = [b - a for a, b in zip(sink.times, sink.times[1:], strict=False)]
    assert min(gaps) > 0.9 * INTERVAL


def test_a_slow_action_leaves_others_half_of_the_time():
    sink = Sink(cost=0.05)
    began = monotonic()
    while monotonic() - began < 0.4:
        sink.change(monotonic())
    gaps = [b - a for a, b in zip(sink.times, sink.times[1:], strict=False)]
    assert min(gaps) >= 0.09


def test_two_threads_lose_nothing():
    sink = Sink()

    def work(name):
        for k in range(2000):
            sink.change((name, k))

    workers = [threading.Thread(target=work, args=(name,)) for name in "ab"]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert wait_for(lambda: sink.seen[-1] == sink.state)


def test_what_is_stopped_is_not_told():
    sink = Sink()
    sink.change(1)
    sink.change(2)
    with CHANGES:
        sink.pace.stop()
    sleep(3 * INTERVAL)
    assert sink.seen == [1]


def test_no_threads_pile_up():
    sink = Sink()
    before = threading.active_count()
    for state in range(5000):
        sink.change(state)
    assert threading.active_count() <= before + 2


def test_an_action_that_fails_fails_for_the_caller_and_may_be_asked_again():
    def fail():
        raise RuntimeError("no channel")

    pace = Pace(fail)
    with pytest.raises(RuntimeError, match="no channel"):
        pace.ask()
    pace.stop()


def test_a_late_action_that_fails_leaves_the_next_to_be_told(monkeypatch):
    failures, calls = [], []
    monkeypatch.setattr(threading, "excepthook", failures.append)

    def act():
        calls.append(monotonic())
        if len(calls) == 2:
            raise RuntimeError("no channel")

    pace = Pace(act)
    for count in (2, 3, 4):
        with CHANGES:
            pace.ask()
            pace.ask()
        assert wait_for(lambda count=count: len(calls) >= count)
    assert len(failures) == 1


def test_calls_long_after_the_last_are_told_too():
    sink = Sink()
    for burst in range(3):
        sink.change((burst, "first"))
        sink.change((burst, "last"))
        assert wait_for(lambda burst=burst: sink.seen[-1] == (burst, "last"))
        sleep(2 * LINGER)
    assert not [t for t in threading.enumerate() if t.name.endswith("(_act_late)")]
