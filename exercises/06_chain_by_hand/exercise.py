# %% title [markdown]
# # Exercise 6: a chain by hand
#
# **Goal.** Go from the ground to the tip of an arm with two joints: once with sines and cosines,
# once with a product of transforms that works for any arm.
#
# **What to know before.** [From link to link](../../notebooks/06_link_to_link.ipynb).
# **Time.** 25 minutes. **Points.** 6.

# %% imports
import numpy as np
from numpy import cos, sin

from dhlab import csys, deg, rotz, rp2t, show, sphere, transl
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# Write your name, as your course knows it. Below it: the lengths of your arm in metres, and its two
# joint angles in degrees.

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
l1, l2 = given["l1"], given["l2"]
given

# %% arm [markdown]
# Both joints turn about $z$, which points up. Joint 1 stands in the ground frame {0}; link 1 is
# $l_1$ long, link 2 is $l_2$ long. Each angle is counted from the link *before*: with $q = (0, 0)$
# the arm is straight along $x_0$.

# %% arm-picture
show(*check.picture("arm"), height=420)

# %% tip [markdown]
# ## 1. Where is the tip? (2 points)
#
# For the angles in the picture, give the tip $(x, y, z)$ in {0}, in metres.

# %% tip-answer
### BEGIN SOLUTION
q1, q2 = np.radians(given["q"])
tip = [l1 * cos(q1) + l2 * cos(q1 + q2), l1 * sin(q1) + l2 * sin(q1 + q2), 0]
### END SOLUTION

# %% tip-check
check("tip", tip)

# %% tip-yours
def yours_tip(tip):
    point = sphere(0.04, name="your tip", color="#d55e00", edges=False).move(tip)
    return show(*check.picture("arm"), point, height=420)

check.show(yours_tip, tip)

# %% pose [markdown]
# ## 2. The whole pose, as a product (4 points)
#
# Write `arm_pose`: from $q = (q_1, q_2)$ in radians to the pose of the tip in {0}, shape (4, 4).
# Its $x$ axis goes along the last link. `rp2t`, `rotz` and `transl` are there, `l1` and `l2` too.

# %% arm-pose
def arm_pose(q):
    ### BEGIN SOLUTION
    turn_1, turn_2 = (rp2t(rotz(angle), (0, 0, 0)) for angle in q)
    return turn_1 @ transl((l1, 0, 0)) @ turn_2 @ transl((l2, 0, 0))
    ### END SOLUTION

# %% arm-pose-check
check("arm_pose", arm_pose)

# %% arm-pose-yours
def yours_pose(arm_pose):
    yours = csys(arm_pose(np.radians(given["q"])), name="yours", size=0.3)
    return show(*check.picture("arm"), yours, height=420)

check.show(yours_pose, arm_pose)

# %% end [markdown]
# **What you have done.** A chain is a product: turn, slide, turn, slide. With sines and cosines the
# angles must be added by hand; the product does it by itself, in three dimensions too.
#
# Next: [one row, one matrix](../07_dh_link/07_dh_link.ipynb).
