"""A backend without a screen: a dict of what would be seen and a log of what was sent."""

from dhlab.scene.node import Node
from dhlab.view.commands import Command, apply


class RecordingBackend:
    """Remembers the picture instead of showing it; graders, tests and notebook runs look at it.

    Attributes
    ----------
    nodes : dict of str to Node
        What would be seen now.
    log : list of lists of commands
        Every batch that was sent, oldest first.

    Examples
    --------
    >>> from dhlab.scene.node import Node
    >>> from dhlab.view.commands import Put
    >>> backend = RecordingBackend()
    >>> backend.send([Put("cube", Node())])
    >>> list(backend.nodes), len(backend.log)
    (['cube'], 1)
    """

    def __init__(self) -> None:
        self.nodes: dict[str, Node] = {}
        self.log: list[list[Command]] = []

    def send(self, batch: list[Command]) -> None:
        """Change the picture by one batch.

        Parameters
        ----------
        batch : list of Put, Place, Paint, Remove
        """
        apply(self.nodes, batch)
        self.log.append(batch)
