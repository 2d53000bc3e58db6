"""HTML in which a text is always a text: what is not made here is escaped."""

import html
from typing import TypeAlias

from dhlab.grading.plain import one_line


class Html(str):
    """Text that is HTML already; `tag` makes it."""

    __slots__ = ()


Inside: TypeAlias = "str | Html | list[Html] | None"


def tag(name: str, *inside: Inside, **attributes: object) -> Html:
    """Return an element.

    Parameters
    ----------
    name : str
    *inside : str, Html, list of Html or None
        Plain texts are escaped, and hidden characters in them shown; None is nothing.
    **attributes : object
        A final underscore is dropped (`class_`), others become hyphens; None and False leave an
        attribute out, True writes it alone.

    Returns
    -------
    element : Html

    Examples
    --------
    >>> tag("td", "<b>", class_="name", aria_hidden="true")
    '<td class="name" aria-hidden="true">&lt;b&gt;</td>'
    """
    words = [_attribute(key, value) for key, value in attributes.items()]
    return Html(f"<{name}{''.join(words)}>{''.join(_escaped(part) for part in inside)}</{name}>")


def _attribute(key: str, value: object) -> str:
    name = key.removesuffix("_").replace("_", "-")
    if value is None or value is False:
        return ""
    return f" {name}" if value is True else f' {name}="{html.escape(one_line(str(value)))}"'


def _escaped(part: Inside) -> str:
    if part is None:
        return ""
    if isinstance(part, list):
        return "".join(part)
    return part if isinstance(part, Html) else html.escape(one_line(part, 5000))
