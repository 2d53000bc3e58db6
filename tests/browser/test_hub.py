"""Two users of one JupyterHub, each with the same notebook, through the hub's proxy."""

import numpy as np
import psutil
import pytest

from dhlab import models

from .fronts import CELLS, PLAYER, Seat
from .hub import serving_hub, what_is_missing
from .test_saved import at, furthest

MISSING = what_is_missing()
pytestmark = pytest.mark.skipif(bool(MISSING), reason=f"NOT TESTED: JupyterHub; {MISSING}")

USERS = ("ada", "bob")
KERNEL = "() => jupyterapp.shell.currentWidget.sessionContext.session.kernel.id"
START_BARE = """async () => {
  const kernel = await jupyterapp.serviceManager.kernels.startNew({ name: "python3" });
  await kernel.info;
}"""
CONNECT = """(address) => new Promise((answer) => {
  const socket = new WebSocket(address);
  socket.onopen = () => answer("open");
  socket.onerror = () => answer("refused");
})"""


@pytest.fixture(scope="module")
def hub(tmp_path_factory):
    with serving_hub(tmp_path_factory.mktemp("hub")) as hub:
        yield hub


@pytest.fixture(scope="module")
def seats(browser, hub):
    """The notebook in front of each user, each in a browser of their own."""
    contexts = [browser.new_context(viewport={"width": 1280, "height": 900}) for _ in USERS]
    seats = []
    for user, context in zip(USERS, contexts, strict=True):
        seat = Seat(context.new_page())
        seat.asked = []
        seat.page.on("request", lambda request, seat=seat: seat.asked.append(request.url))
        hub.visit(seat.page, user, hub.write(user, *CELLS))
        seat.wait_for_it()
        seats.append(seat)
    yield seats
    for context in contexts:
        context.close()


def listening(process):
    """Addresses at which a process waits for others."""
    connections = process.net_connections("inet")
    return [c.laddr for c in connections if c.status == psutil.CONN_LISTEN]


def test_both_users_see_the_limb_through_the_proxy_and_ask_nobody_else(hub, seats):
    for seat in seats:
        assert furthest(seat.shown, at(models.upper_limb(), seat.q)) < 1e-6
        assert len(np.unique(seat.shown.pixels().reshape(-1, 3), axis=0)) > 200
        asked = {url for url in seat.asked if not url.startswith(("data:", "blob:"))}
        assert not [url for url in asked if not url.startswith(hub.url)]


@pytest.mark.parametrize("own", [0, 1], ids=USERS)
def test_a_drag_moves_ones_own_limb_here_and_there_and_not_the_others(seats, own):
    seat, other = seats[own], seats[1 - own]
    before, others = seat.q, other.q
    seat.drag(0, 25)
    seat.wait_for_agreement(before)
    after = seat.q
    assert after[0] > before[0] + 0.3
    assert furthest(seat.shown, at(models.upper_limb(), after)) < 1e-6
    other.drag(3, -10)  # what comes after this has been answered came through that kernel too
    other.wait_for_agreement(others)
    assert np.flatnonzero(other.q != others).tolist() == [3]
    assert furthest(other.shown, at(models.upper_limb(), other.q)) < 1e-6
    assert np.array_equal(seat.q, after)


def test_a_planned_motion_plays_through_the_proxy(seats):
    for seat in seats:
        seat.press("Move")
        seat.shown.wait_until(f"{PLAYER}?.time === 1.5 && !{PLAYER}.playing", seconds=60)
        seat.wait_for_agreement()
        limb = models.upper_limb()
        assert np.array_equal(seat.q, limb.clip(limb.home - 0.4))


def test_nothing_listens_on_a_port_of_ours(hub, seats):
    ours = {seat.told["process"] for seat in seats}
    seats[0].page.evaluate(START_BARE)
    kernels = [p for p in hub.processes() if any("ipykernel" in word for word in p.cmdline())]
    waiting = {p.pid: len(listening(p)) for p in kernels}
    (bare,) = set(waiting) - ours
    assert waiting[bare] > 0
    assert [waiting[pid] for pid in ours] == [waiting[bare]] * 2
    addresses = [address for p in hub.processes() for address in listening(p)]
    assert {address.ip for address in addresses} == {"127.0.0.1"}


def test_neither_user_reaches_the_others_kernel(hub, seats):
    kernels = [seat.page.evaluate(KERNEL) for seat in seats]
    for seat, own in zip(seats, USERS, strict=True):
        for user, kernel in zip(USERS, kernels, strict=True):
            way = f"{hub.url}/user/{user}/api/kernels"
            mine = user == own
            assert seat.page.context.request.get(way).status == (200 if mine else 403)
            address = f"{way.replace('http', 'ws', 1)}/{kernel}/channels"
            assert seat.page.evaluate(CONNECT, address) == ("open" if mine else "refused")
