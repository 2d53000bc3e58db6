"""10,000 changes of the limb's configuration in one cell, watched in a page.

The loop must not wait for anybody, the page must show its last state soon after it, and neither
the kernel nor the page may grow.
"""

import gc
from collections.abc import Iterator
from time import perf_counter, time

from rows import Row, median

CHANGES = 10_000
ROUNDS = 6
CELLS = (
    "import bench_loop, numpy as np\n"
    "from dhlab import Panel, View, models, side_by_side\n"
    "limb, lonely = models.upper_limb(), models.upper_limb()",
    "view = View('limb').add(limb)\nview",
)
WATCH = """([value, seconds]) => {
  const view = globalThis[Symbol.for("dhlab.page")].views.at(-1);
  const node = view.scene.nodes.get(view.scene.paths.get("arm/1"));
  const stage = view.stages.at(-1);
  globalThis.seen = new Promise((resolve, reject) => {
    const end = Date.now() + 1000 * seconds;
    const look = () => {
      if (Math.abs(node.shown.value - value) < 1e-9 && stage.settled) resolve(Date.now() / 1000);
      else if (Date.now() > end) reject(new Error("the last state was not shown"));
      else requestAnimationFrame(look);
    };
    look();
  });
}"""
COUNT = """() => {
  globalThis.received = 0;
  const { kernel } = jupyterapp.shell.currentWidget.sessionContext.session;
  kernel.anyMessage.connect((_, { msg, direction }) => {
    if (direction === "recv" && msg.header.msg_type === "comm_msg") globalThis.received += 1;
  });
}"""


def measure() -> Iterator[Row]:
    from page import open_lab

    with open_lab() as desk:
        notebook = desk.open(*CELLS)
        for index in range(len(CELLS)):
            notebook.run_cell(index)
        notebook.view("limb").settle()
        yield from rounds(notebook, "with a view")
        notebook.run("view.close()\nside_by_side(View('limb').add(limb), Panel(limb))")
        notebook.view("limb").settle()
        yield from rounds(notebook, "with a view and a panel")


def rounds(notebook, what: str) -> Iterator[Row]:
    """Run the loop several times."""
    from page import heap_megabytes

    session = notebook.page.context.new_cdp_session(notebook.page)
    notebook.evaluate(COUNT)
    shown, alone, late, memory, heap, counts = [], [], [], [], [], []
    for count in range(ROUNDS):
        last = 0.1 + 0.01 * count
        notebook.evaluate(WATCH, [last, 60])
        before = notebook.evaluate("globalThis.received")
        took, ended, bare = notebook.value(f"bench_loop.loops(limb, lonely, {last})")
        late.append(notebook.evaluate("globalThis.seen") - ended)
        counts.append(notebook.evaluate("globalThis.received") - before)
        shown.append(took)
        alone.append(bare)
        memory.append(notebook.value("bench_loop.megabytes()"))
        heap.append(heap_megabytes(notebook.page, session))
    yield Row(f"{CHANGES:,} changes {what}", min(shown), min(alone), "without anybody", "s")
    yield Row("  widget messages of one loop", median(counts), unit="")
    yield Row("  the page shows the last state after", max(late), unit="s", target="<= 0.5")
    yield Row(f"  kernel's memory after {ROUNDS} loops", memory[-1], memory[1], "after 2", "MB")
    yield Row(f"  page's memory after {ROUNDS} loops", heap[-1], heap[1], "after 2", "MB")


def loops(limb, lonely, last: float) -> list[float]:
    """In the kernel: seconds of the loop, the instant of its end, seconds of it without a view."""
    import numpy as np

    lower, upper = limb.limits.T
    middle, reach = 0.5 * (upper + lower), 0.5 * (upper - lower)
    q = middle + 0.9 * reach * np.sin(np.linspace(0, 9, CHANGES))[:, None]
    q[-1, 0] = last
    taken = []
    for robot in (lonely, limb):
        began = perf_counter()
        for one in q:
            robot.q = one
        taken.append(perf_counter() - began)
    return [taken[1], time(), taken[0]]


def megabytes() -> float:
    """In the kernel: memory of this process."""
    import psutil

    gc.collect()
    return psutil.Process().memory_info().rss / 1e6
