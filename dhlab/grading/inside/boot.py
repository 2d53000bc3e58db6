"""The first file that runs in a sandbox: ``python -I -S -B boot.py USER FOLDER...``.

It gives up the rights of root, makes packages findable (FOLDER...), and hands over to `main`.
Of dhlab only the folder of this file need be there.
"""

import os
import sys
from types import ModuleType

SETTINGS = {
    "DHLAB_VIEW": "record",
    "HOME": "/tmp",
    "LANG": "C.UTF-8",
    "MPLBACKEND": "Agg",
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
    "PATH": "/usr/bin:/bin",
}


def become(user: int) -> None:
    """Become another user for good, if this is root."""
    if user and os.getuid() == 0:
        os.setgroups([])
        os.setresgid(user, user, user)
        os.setresuid(user, user, user)


def die_first() -> None:
    """Be the first to end where the whole machine runs out of memory."""
    try:
        with open("/proc/self/oom_score_adj", "w", encoding="ascii") as file:
            file.write("1000")
    except OSError:  # not on this system
        pass


def find_inside() -> None:
    """Make `dhlab.grading.inside` importable without what dhlab's own packages load."""
    folder = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    for name, path in (("dhlab", os.path.dirname(folder)), ("dhlab.grading", folder)):
        package = ModuleType(name)
        package.__path__ = [path]
        sys.modules[name] = package


if __name__ == "__main__":
    die_first()
    become(int(sys.argv[1]))
    os.environ.update(SETTINGS)
    sys.path[:] = [entry for entry in sys.path if entry != os.path.dirname(__file__)]
    sys.path += sys.argv[2:]
    find_inside()
    from dhlab.grading.inside.main import main

    main()
