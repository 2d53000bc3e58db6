# %% title [markdown]
# # Exercise 7: one row, one matrix
#
# **Goal.** Write the function behind every Denavit-Hartenberg table: from one row to the pose of
# one frame in the frame before.
#
# **What to know before.** [The four steps](../../notebooks/07_four_steps.ipynb).
# **Time.** 25 minutes. **Points.** 6.

# %% imports
import numpy as np
from numpy import cos, sin

from dhlab import csys, deg, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# Write your name, as your course knows it: the row of part 2 is your own.

# %% student
STUDENT = ""
given = check.numbers(STUDENT)

# %% link [markdown]
# ## 1. The function (4 points)
#
# In the modified convention a row is a screw about $x$, then a screw about the new $z$:
#
# $$T_{i-1,i} = R_x(\alpha_{i-1})\, D_x(a_{i-1})\, R_z(\theta_i)\, D_z(d_i)$$
#
# The picture shows the four numbers of one row where they belong. The arrow of $\alpha$ turns $z$
# about $x$; the arrow of $\theta$ turns $x$ about $z$.

# %% link-picture
show(*check.picture("row"), height=420)

# %% link-task [markdown]
# Write `dh_link`: from $\alpha$ [rad], $a$ [m], $d$ [m], $\theta$ [rad], in this order, to
# $T_{i-1,i}$, an array of shape (4, 4). Use `numpy` alone.

# %% dh-link
def dh_link(alpha, a, d, theta):
    ### BEGIN SOLUTION
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    return about_x @ about_z
    ### END SOLUTION

# %% dh-link-check
check("dh_link", dh_link)

# %% own [markdown]
# ## 2. Your own row (2 points)
#
# A data sheet gives one row in degrees and millimetres:

# %% own-row
given

# %% own-picture
show(*check.picture("own row"), height=420)

# %% own-task [markdown]
# Call your function with it. What is $T$ in metres?

# %% own-answer
### BEGIN SOLUTION
T_own = dh_link(given["alpha"] * deg, given["a"] / 1000, given["d"] / 1000, given["theta"] * deg)
### END SOLUTION

# %% own-check
check("T_own", T_own)

# %% own-yours-words [markdown]
# Your frame in the same picture. It must cover frame 1 of the link.

# %% own-yours
def yours(T_own):
    return show(*check.picture("own row"), csys(T_own, name="yours", size=0.25), height=420)

check.show(yours, T_own)

# %% end [markdown]
# **What you have done.** A whole arm is this function, once for each joint, and a product.
#
# Next: [a table for a planar arm](../08_planar_table/08_planar_table.ipynb).
