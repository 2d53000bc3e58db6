"""One change of the limb's configuration: its messages, its bytes, its time.

Beside it: the same 32 frames through meshcat-python's own transport, with its server running and
the frames computed beforehand. Both are called in the same Jupyter kernel, in turns.
"""

from collections.abc import Iterator
from contextlib import redirect_stdout
from io import StringIO

from kernel import open_kernel
from meshcat_server import connect_page, meshcat_server
from rows import Row, in_turns, median

CHANGES = 40
ROUNDS = 60


def measure() -> Iterator[Row]:
    with meshcat_server() as url, open_kernel() as kernel:
        kernel.value("bench_change", "show_limb")
        kernel.messages()
        kernel.value("bench_change", "change_once")
        sent = kernel.messages()
        yield Row("messages of one change", len(sent), unit="", target="<= 1")
        content = sum(sum(map(len, parts[-2:])) for parts in sent)
        whole = sum(sum(map(len, parts)) for parts in sent)
        yield Row("its content and buffer", content, unit="B", target="<= 2048")
        yield Row("all its parts on the wire, headers included", whole, unit="B", target="<= 2048")
        name = "32 set_transform calls"
        ours, sending, loop, alone, theirs = kernel.value("bench_change", "times", url)
        yield Row("limb.q = q, a loop of them", loop, theirs, name, target="<= 0.04")
        yield Row("  without a view", alone, theirs, name)
        yield Row("limb.q = q, each one sent", ours, theirs, name)
        yield Row("  of this: telling the page", sending, theirs, name)
        connect_page(url)
        ours, _, _, _, theirs = kernel.value("bench_change", "times", url)
        yield Row(
            "limb.q = q, each one sent", ours, theirs, "the same, a page listens", "ms", "<= 0.04"
        )


def show_limb() -> None:
    """In the kernel: show a limb, as a cell that ends in a view does."""
    global limb, view
    from dhlab import View, models

    limb = models.upper_limb()
    view = View().add(limb)
    view._repr_mimebundle_()


def configurations():
    """Random configurations of the limb, shape (CHANGES, 27)."""
    import numpy as np

    lower, upper = limb.limits.T
    return np.random.default_rng(1).uniform(lower, upper, (CHANGES, limb.n))


def change_once() -> None:
    """In the kernel: one change, sent at once."""
    limb.q = configurations()[0]
    view.flush()


def times(url: str) -> list[float]:
    """In the kernel: milliseconds of one change that is sent, of its sending, and of others."""
    import meshcat
    import numpy as np

    from dhlab import models

    lonely = models.upper_limb()
    q = configurations()
    poses = [list(limb.frames(one).items()) for one in q]
    with redirect_stdout(StringIO()):
        visualizer = meshcat.Visualizer(zmq_url=url)
    paths = {name: visualizer[name] for name, _ in poses[0]}
    for path in paths.values():
        path.set_object(meshcat.geometry.Box([0.01, 0.01, 0.01]))

    def change():
        for one in q:
            limb.q = one
            view.flush()

    def loop():
        for one in q:
            limb.q = one

    def change_alone():
        for one in q:
            lonely.q = one

    def set_transforms():
        for frames in poses[:2]:
            for name, pose in frames:
                paths[name].set_transform(pose)

    batches = []

    class Keep:
        def send(self, batch):
            batches.append(batch)

    shown, view._backend = view._backend, Keep()
    change()
    view._backend = shown
    batches = batches[-len(q) :]

    def send():
        for batch in batches:
            shown.send(batch)

    ours, sending, looped, alone, theirs = in_turns(
        [change, send, loop, change_alone, set_transforms], ROUNDS, median
    )
    per_change = np.array([ours, sending, looped, alone, theirs * len(q) / 2]) / len(q)
    return (1000 * per_change).tolist()
