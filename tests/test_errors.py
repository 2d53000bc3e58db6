import pickle
from math import inf, pi

import pytest

from dhlab.errors import AttachError, DhlabError, InputError, LimitError


@pytest.mark.parametrize("error", [InputError, AttachError, LimitError])
def test_an_error_of_dhlab_is_a_value_error_too(error):
    assert issubclass(error, DhlabError)
    assert issubclass(error, ValueError)


@pytest.mark.parametrize(
    ("value", "interval", "kind", "text"),
    [
        (0.5, (-0.3491, 0.0), "r", "0.5000 rad (28.6 deg) is outside [-0.3491, 0.0000]"),
        (0.6, (0.0, 0.5), "p", "0.6000 m is outside [0.0000, 0.5000]"),
        (-1.0, (0.0, inf), "p", "-1.0000 m is outside [0.0000, inf]"),
        (0.1, (-1.0, -1e-9), "p", "0.1000 m is outside [-1.0000, 0.0000]"),
        (
            pi / 2 + 1e-6,
            (0.0, pi / 2),
            "r",
            "1.570797 rad (90.0 deg) is outside [0.000000, 1.57079",
        ),
    ],
)
def test_a_limit_error_tells_joint_value_and_interval(value, interval, kind, text):
    error = LimitError("index", 1, value, interval, kind)
    assert str(error).startswith(f"joint 1 of 'index': {text}")


def test_a_limit_error_keeps_what_it_tells():
    error = LimitError("index", 2, 0.5, (-1.0, 0.0), "p", hint="clip it")
    assert (error.component, error.joint, error.value) == ("index", 2, 0.5)
    assert (error.interval, error.kind) == ((-1.0, 0.0), "p")
    assert str(error).endswith("; clip it")


def test_a_limit_error_travels_between_processes():
    error = LimitError("index", 2, 0.5, (-1.0, 0.0), "p", hint="clip it")
    again = pickle.loads(pickle.dumps(error))
    assert str(again) == str(error)
    assert again.interval == error.interval
