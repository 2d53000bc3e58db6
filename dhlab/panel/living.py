"""Notebooks as living pages: ``nbconvert`` to HTML, with pictures and sliders that need no kernel.

The widget state that was saved with a notebook, or that came of ``--execute``, becomes part of the
page, with the viewer once for all its outputs. The page loads nothing for them.
"""

from collections.abc import Iterable, Mapping
from html import escape
from importlib.resources import files
from typing import Any

from nbconvert.exporters import HTMLExporter
from nbconvert.preprocessors import Preprocessor
from traitlets.config import Config

from dhlab.panel.formulas import with_formulas

WIDGET = "application/vnd.jupyter.widget-view+json"
STATE = "application/vnd.jupyter.widget-state+json"
OURS = "dhlab."


class LivingPage(Preprocessor):
    """Puts the pictures and sliders of dhlab, alive, in the place of its widgets.

    The formulas between its cells become MathML, which needs no network. What a notebook shows of
    other packages stays as it is. A widget that was not saved gives way to whatever else its output
    holds: a still picture, or a line of text.
    """

    def preprocess(self, nb: Any, resources: Any) -> tuple[Any, Any]:
        """Change the outputs of a notebook that is being converted.

        Parameters
        ----------
        nb : NotebookNode
        resources : dict

        Returns
        -------
        nb, resources
        """
        try:
            _enliven(nb)
        except (KeyError, TypeError, ValueError) as error:
            self.log.warning("dhlab: the saved widgets cannot be read (%r); left alone", error)
        return nb, resources


class LivingExporter(HTMLExporter):
    """``jupyter nbconvert --to dhlab_html``: HTML with living pictures, whatever is configured."""

    export_from_notebook = "HTML with living pictures"

    @property
    def default_config(self) -> Config:
        """HTML's own configuration, and the living page."""
        config: Config = super().default_config.copy()
        config.merge(Config({"HTMLExporter": {"preprocessors": [LivingPage]}}))
        return config


def _enliven(nb: Any) -> None:
    """Replace all outputs that show something of dhlab; drop the widgets that only they needed."""
    outputs = list(_widget_outputs(nb))
    models = nb.metadata.get("widgets", {}).get(STATE, {}).get("state", {})
    is_ours = any(_is_ours(model) for model in models.values())
    parts = _parts(models, outputs) if is_ours else {}
    for k, output in enumerate(outputs):
        if k in parts:
            output.data = {"text/html": parts[k], "text/plain": output.data.get("text/plain", "")}
        elif output.data[WIDGET].get("model_id") not in models and len(output.data) > 1:
            del output.data[WIDGET]
    if is_ours:
        _prune(nb, models)
        for cell in nb.cells:
            if cell.cell_type == "markdown":
                cell.source = with_formulas(cell.source)


def _widget_outputs(nb: Any) -> Iterable[Any]:
    for cell in nb.cells:
        yield from (
            output for output in cell.get("outputs", ()) if WIDGET in output.get("data", {})
        )


def _is_ours(model: Mapping[str, Any]) -> bool:
    return str(model.get("state", {}).get("_anywidget_id", "")).startswith(OURS)


def _parts(models: Mapping[str, Any], outputs: list[Any]) -> dict[int, str]:
    """Return HTML by the number of the output; what all share is in the first."""
    from dhlab.panel.saved import Saved

    saved = Saved(models)
    told = {k: saved.part(str(out.data[WIDGET].get("model_id"))) for k, out in enumerate(outputs)}
    living = {k: part for k, part in told.items() if part is not None}
    texts = {k: _output(part, outputs[k].data) for k, part in living.items()}
    if texts:
        first = min(texts)
        texts[first] = _shared(saved.scenes) + texts[first]
    return texts


def _output(part: Mapping[str, Any], data: Mapping[str, Any]) -> str:
    """Write one output: what it shows, and until it lives its still picture if there is one."""
    from dhlab.view.html import safe_json

    png = "".join(str(data.get("image/png", "")).split())
    still = f'<img alt="" src="data:image/png;base64,{escape(png)}">' if png else ""
    about = f'<script type="application/json">{safe_json(part)}</script>'
    return f'<div class="dhlab-live">{about}{still}</div>'


def _shared(scenes: Mapping[str, bytes]) -> str:
    """Write what all outputs share: styles, the viewer, the scenes and the script that begins."""
    from dhlab.view import assets
    from dhlab.view.html import packed, static

    folder = files("dhlab.panel") / "static"
    style = (folder / "living.css").read_text(encoding="utf-8") + static("lesson.css")
    style += f".dhlab-live-sliders {{\n{static('sliders.css')}}}\n"
    viewer = f'"use strict";\n{assets.bundle("living", folder)}'
    carried = {"meshcat": assets.meshcat().encode(), "viewer": viewer.encode(), **scenes}
    blocks = (
        f'<script type="text/plain" data-dhlab="{escape(name)}">{packed(content)}</script>'
        for name, content in carried.items()
    )
    start = assets.bundle("livingstart", folder)
    return f'<style>{style}</style>{"".join(blocks)}<script type="module">{start}</script>'


def _prune(nb: Any, models: Mapping[str, Any]) -> None:
    """Keep the widgets that some output still shows."""
    from dhlab.panel.saved import Saved

    shown = (str(output.data[WIDGET].get("model_id")) for output in _widget_outputs(nb))
    kept = Saved(models).needed(shown)
    if kept:
        nb.metadata.widgets[STATE]["state"] = kept
    else:
        del nb.metadata["widgets"]
