# %% title [markdown]
# # Exercise 2: sequences of turns
#
# **Goal.** Multiply turns in the right order: about axes that move along, and about axes that stay.
#
# **What to know before.** [Order matters](../../notebooks/03_order_matters.ipynb).
# **Time.** 25 minutes. **Points.** 7.

# %% imports
import numpy as np

from dhlab import csys, deg, rotx, roty, rotz, rp2t, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# Write your name, as your course knows it. Below it: your angles, in degrees.

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% moving [markdown]
# ## 1. About the frame's own axes (2 points)
#
# {B} begins as {A}. It turns about $z$ by $a$, then about **its own** $x$, where that is by now, by
# $b$, then about **its own** $y$ by $c$. The picture has {A} on the left and the frame after each
# turn to the right of it.

# %% moving-picture
show(*check.picture("moving"), height=360)

# %% moving-task [markdown]
# What is $R_{AB}$? `rotx`, `roty` and `rotz` are there; angles in radians: `given["a"] * deg`.

# %% moving-answer
### BEGIN SOLUTION
R_moving = rotz(given["a"] * deg) @ rotx(given["b"] * deg) @ roty(given["c"] * deg)
### END SOLUTION

# %% moving-check
check("R_moving", R_moving)

# %% moving-yours
def yours_moving(R_moving):
    yours = csys(rp2t(R_moving, (0, 0, 0)), name="yours", size=0.8)
    return show(*check.picture("moving, B"), yours, height=360)

check.show(yours_moving, R_moving)

# %% fixed [markdown]
# ## 2. About fixed axes (2 points)
#
# The same angles in the same order, but each turn is about an axis of {A}: about $z_A$ by $a$,
# then about $x_A$ by $b$, then about $y_A$ by $c$. Compare the pictures: only the first turn is the
# same.

# %% fixed-picture
show(*check.picture("fixed"), height=360)

# %% fixed-answer
### BEGIN SOLUTION
R_fixed = roty(given["c"] * deg) @ rotx(given["b"] * deg) @ rotz(given["a"] * deg)
### END SOLUTION

# %% fixed-check
check("R_fixed", R_fixed)

# %% fixed-yours
def yours_fixed(R_fixed):
    yours = csys(rp2t(R_fixed, (0, 0, 0)), name="yours", size=0.8)
    return show(*check.picture("fixed, B"), yours, height=360)

check.show(yours_fixed, R_fixed)

# %% wheel [markdown]
# ## 3. The wheel of a bicycle (3 points)
#
# The frame {W} sits in the wheel, its $y$ axis along the axle. With all angles 0 it is as {A}: $x$
# forward, $y$ to the left, $z$ up. The bicycle rides in a direction that is turned by `heading`
# about the vertical $z_A$. It leans by `lean` about the axis that points forward, along the ground.
# And the wheel has turned about its axle by `spin`. All angles count about $z$, $x$ and $y$.
#
# The picture has a heading of 40°, a lean of −20° and a spin of 60°.

# %% wheel-picture
show(*check.picture("wheel"), height=420)

# %% wheel-task [markdown]
# Write `wheel`: from the three angles in radians to $R_{AW}$. When only the heading changes, which
# axes does that carry along? And when only the wheel spins?

# %% wheel-answer
def wheel(heading, lean, spin):
    ### BEGIN SOLUTION
    return rotz(heading) @ rotx(lean) @ roty(spin)
    ### END SOLUTION

# %% wheel-check
check("wheel", wheel)

# %% wheel-yours
def yours_wheel(wheel):
    R = wheel(40 * deg, -20 * deg, 60 * deg)
    yours = csys(rp2t(R, (0, 0, 0)), name="yours", size=0.8)
    return show(*check.picture("wheel"), yours, height=420)

check.show(yours_wheel, wheel)

# %% end [markdown]
# **What you have done.** Own axes: the next factor to the right. Fixed axes: the next factor to the
# left. Told from the ground up or from the wheel outwards, the product is the same.
#
# Next: [transforms and their inverses](../03_transforms/03_transforms.ipynb).
