"""What a student reads of a matrix."""

import numpy as np
import pytest
from numpy import pi

from dhlab import InputError, rotz, rp2t, typeset
from dhlab.kinematics.typeset import number_latex, symbol_latex


def test_a_pose_has_four_decimals_and_no_minus_zero():
    T = rp2t(rotz(pi / 2), (1, -1e-9, 0.12345))
    assert repr(typeset(T, "T_AB")) == "\n".join(
        [
            "T_AB = [ 0.0000 -1.0000  0.0000  1.0000]",
            "       [ 1.0000  0.0000  0.0000  0.0000]",
            "       [ 0.0000  0.0000  1.0000  0.1235]",
            "       [ 0.0000  0.0000  0.0000  1.0000]",
        ]
    ).replace("0.1235", f"{0.12345:.4f}")


@pytest.mark.parametrize(
    ("x", "latex"),
    [
        (0.5, r"\tfrac{1}{2}"),
        (-np.cos(pi / 4), r"-\tfrac{\sqrt{2}}{2}"),
        (np.sin(pi / 3), r"\tfrac{\sqrt{3}}{2}"),
        (np.cos(pi / 2), "0"),
        (-1.0, "-1"),
        (0.25, "0.25"),
        (0.5 + 1e-6, "0.5"),
        (-1e-7, "0"),
    ],
)
def test_sines_that_have_a_name_get_it(x, latex):
    assert number_latex(x) == latex


def test_a_vector_stands_upright_in_a_formula():
    assert typeset((1, 2), "p_A")._repr_latex_() == (
        r"$p_{A} = \begin{bmatrix} 1 \\ 2 \end{bmatrix}$"
    )


def test_a_subscript_needs_no_braces_of_its_own():
    assert symbol_latex("T_{12}") == symbol_latex("T_12") == "T_{12}"


@pytest.mark.parametrize("wrong", [np.zeros((2, 2, 2)), 3.0, [], [np.nan], "R"])
def test_what_is_no_matrix_is_refused(wrong):
    with pytest.raises(InputError, match="what is to be typeset"):
        typeset(wrong)
