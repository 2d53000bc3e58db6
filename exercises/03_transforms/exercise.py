# %% title [markdown]
# # Exercise 3: homogeneous transforms and their inverses
#
# **Goal.** Write a pose as a matrix, carry a point from one frame to another, and take the inverse
# without a library.
#
# **What to know before.** [Transforms](../../notebooks/04_transforms.ipynb), up to the inverse.
# **Time.** 25 minutes. **Points.** 7.

# %% imports
import numpy as np

from dhlab import csys, deg, rotz, rp2t, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# Write your name, as your course knows it. Below it: the numbers of your box.

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% box [markdown]
# ## 1. A pose as a matrix (2 points)
#
# {B} sits in a corner of the box. The way from {A} to that corner is $x$, then $y$, then $z$ metres
# along the axes of {A}; then the box is turned by your angle (in degrees) about $z$.

# %% box-picture
show(*check.picture("box"), height=420)

# %% box-task [markdown]
# What is $T_{AB}$, shape (4, 4)?

# %% box-answer
### BEGIN SOLUTION
T_AB = rp2t(rotz(given["angle"] * deg), (given["x"], given["y"], given["z"]))
### END SOLUTION

# %% box-check
check("T_AB", T_AB)

# %% box-yours
def yours_box(T_AB):
    return show(*check.picture("box"), csys(T_AB, name="yours", size=0.3), height=420)

check.show(yours_box, T_AB)

# %% point [markdown]
# ## 2. The same point in another frame (2 points)
#
# The orange point $P$ has the coordinates $p_B$ in {B}. Where is it in {A}?

# %% point-picture
show(*check.picture("point"), height=400)

# %% point-task [markdown]
# Write `to_A`: from $T_{AB}$ and $p_B$ (three numbers) to $p_A$ (three numbers).

# %% to-a
def to_A(T_AB, p_B):
    ### BEGIN SOLUTION
    return (T_AB @ np.append(p_B, 1))[:3]
    ### END SOLUTION

# %% to-a-check
check("to_A", to_A)

# %% inverse [markdown]
# ## 3. The view from the other frame (3 points)
#
# {A} sees {B} at $T_{AB}$. How does {B} see {A}? Write `inverse_pose` from the blocks of the
# matrix: a transpose and a product are enough, and `np.linalg` is not needed.

# %% inverse-pose
def inverse_pose(T_AB):
    ### BEGIN SOLUTION
    R, p = T_AB[:3, :3], T_AB[:3, 3]
    T_BA = np.eye(4)
    T_BA[:3, :3] = R.T
    T_BA[:3, 3] = -R.T @ p
    return T_BA
    ### END SOLUTION

# %% inverse-check
check("inverse_pose", inverse_pose)

# %% inverse-words [markdown]
# {A} in the middle, {B} as it sees it. From {B}, go by your inverse: you must be back in {A}.

# %% inverse-yours
def yours_inverse(inverse_pose):
    T_AB = rp2t(rotz(35 * deg), (0.8, 0.5, 0.3))
    A, B = csys(name="A", size=0.5, opacity=0.35), csys(T_AB, name="B", size=0.5)
    return show(A, B, csys(T_AB @ inverse_pose(T_AB), name="back", size=0.4), height=400)

check.show(yours_inverse, inverse_pose)

# %% end [markdown]
# **What you have done.** A pose holds axes and origin; its inverse holds the other frame's axes in
# rows, and the way back told in those axes.
#
# Next: [a detour of frames](../04_detour/04_detour.ipynb).
