"""What may be done wrong to a finished matrix: inverted, transposed, mirrored, in millimetres."""

from collections.abc import Iterator

import numpy as np

from dhlab.diagnosis.product import After
from dhlab.diagnosis.values import Floats, inverted
from dhlab.diagnosis.verdict import Mistake, mistake
from dhlab.kinematics.transforms import pose_of

FRAMES = "Which frame does the matrix describe, and in which frame are its columns written?"


def transposed(T: Floats) -> Floats:
    """Transpose of matrices, shape (..., 4, 4)."""
    return np.swapaxes(T, -1, -2)


def scaled(T: Floats, factor: float) -> Floats:
    """Poses with their origins in another unit."""
    out = T.copy()
    out[..., :3, 3] *= factor
    return out


def turned_origin(T: Floats) -> Floats:
    """Poses whose origin was rotated by their own rotation."""
    out = T.copy()
    out[..., :3, 3] = (T[..., :3, :3] @ T[..., :3, 3, None])[..., 0]
    return out


def unturned_origin(T: Floats) -> Floats:
    """Poses whose origin was rotated back."""
    out = T.copy()
    out[..., :3, 3] = (np.swapaxes(T[..., :3, :3], -1, -2) @ T[..., :3, 3, None])[..., 0]
    return out


def negated_origin(T: Floats) -> Floats:
    """Poses with the inverse rotation and the origin negated but not rotated."""
    return pose_of(np.swapaxes(T[..., :3, :3], -1, -2), -T[..., :3, 3])


def mirrored(T: Floats, k: int) -> Floats:
    """Poses with one column of the rotation negated."""
    out = T.copy()
    out[..., :3, k] *= -1
    return out


def hand_of(m: Mistake) -> str:
    """What a slip is about: two axes that are turned round make a right-handed frame again."""
    return "hand" if m.key.startswith("left-handed") else ""


def after_slips(rotation: bool, slides: bool = True) -> Iterator[tuple[Mistake, After]]:
    """Mistakes made with a whole matrix; of a rotation alone, and of a pose with an origin."""
    if rotation:
        yield (
            mistake("inverse", "the inverse (for a rotation: the transpose) is given", FRAMES),
            inverted,
        )
    else:
        yield mistake("inverse", "the inverse is given", FRAMES), inverted
        yield (
            mistake(
                "transposed",
                "the whole matrix is transposed",
                "Where in a pose does the origin stand?",
            ),
            transposed,
        )
    for k in range(3):
        yield (
            mistake(
                f"left-handed-{'xyz'[k]}",
                f"the {'xyz'[k]} axis points the opposite way, so that the frame is left-handed",
                "What is x cross y in your frame?",
            ),
            lambda T, k=k: mirrored(T, k),  # type: ignore[misc]
        )
    if not rotation and slides:
        yield from _origin_slips()


def _origin_slips() -> Iterator[tuple[Mistake, After]]:
    unit = "In which unit are the lengths asked for?"
    yield mistake("millimetres", "lengths are in millimetres", unit), lambda T: scaled(T, 1000)
    yield mistake("thousandth", "lengths are divided by 1000", unit), lambda T: scaled(T, 1e-3)
    order = "Is the shift made along the axes before the turn or after it?"
    yield (
        mistake("origin-rotated", "the translation is rotated once more", order),
        turned_origin,
    )
    yield (
        mistake("origin-not-rotated", "the translation is not rotated, but should be", order),
        unturned_origin,
    )
    yield (
        mistake(
            "inverse-origin",
            "the inverse is given, and its translation is only negated and not rotated",
            FRAMES,
        ),
        negated_origin,
    )


def origin_signs() -> Iterator[tuple[Mistake, After]]:
    """One coordinate of the origin with the wrong sign: slips of the pen."""
    for k, axis in enumerate("xyz"):

        def negated(T: Floats, k: int = k) -> Floats:
            out = T.copy()
            out[..., k, 3] *= -1
            return out

        question = f"From the one origin to the other: does it go along {axis} or against it?"
        key, when = f"origin-sign-{axis}", f"{axis} of the origin has the wrong sign"
        yield mistake(key, when, question), negated
