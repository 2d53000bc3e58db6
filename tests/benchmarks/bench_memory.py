"""The kernel's memory with a limb, a view and a panel, beside a bare kernel."""

from collections.abc import Iterator

from kernel import open_kernel
from rows import Row

STEPS = {
    "with numpy and ipywidgets": "import numpy, ipywidgets; ipywidgets.FloatSlider()",
    "with the limb": "from dhlab import Panel, View, models; limb = models.upper_limb()",
    "with the limb in a view": "view = View().add(limb); view._repr_mimebundle_()",
    "with the limb in a view and a panel": "panel = Panel(limb); panel._repr_mimebundle_()",
}


def measure() -> Iterator[Row]:
    with open_kernel() as kernel:
        bare = kernel.value("bench_loop", "megabytes")
        for what, code in STEPS.items():
            kernel.run(f"{code}\nNone")
            memory = kernel.value("bench_loop", "megabytes")
            yield Row(f"kernel {what}", memory, bare, "bare kernel", "MB")
