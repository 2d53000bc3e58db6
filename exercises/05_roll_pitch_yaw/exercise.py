# %% title [markdown]
# # Exercise 5: roll, pitch, yaw
#
# **Goal.** From three angles to a rotation, and back.
#
# **What to know before.** [Three numbers for an orientation](../../notebooks/05_orientation.ipynb).
# **Time.** 30 minutes. **Points.** 6.

# %% imports
import numpy as np
from numpy import arcsin, arctan2, cos, sin, sqrt

from dhlab import csys, deg, rotx, roty, rotz, rp2t, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# Write your name, as your course knows it: the plane of part 3 is your own.

# %% student
STUDENT = ""
given = check.numbers(STUDENT)

# %% turns [markdown]
# ## 1. From angles to the matrix (2 points)
#
# About the **fixed** axes: roll about $x_A$ first, then pitch about $y_A$, then yaw about $z_A$.
# The picture shows a plane before and after each of the three.

# %% turns-picture
show(*check.picture("turns"), height=400)

# %% turns-task [markdown]
# Write `rpy_matrix`: from roll, pitch, yaw in radians to $R_{AB}$. `rotx`, `roty`, `rotz` are
# there.

# %% rpy-matrix
def rpy_matrix(roll, pitch, yaw):
    ### BEGIN SOLUTION
    return rotz(yaw) @ roty(pitch) @ rotx(roll)
    ### END SOLUTION

# %% rpy-matrix-check
check("rpy_matrix", rpy_matrix)

# %% back [markdown]
# ## 2. From the matrix to angles (3 points)
#
# Multiplied out, with $c_r = \cos(\text{roll})$, $s_p = \sin(\text{pitch})$ and so on:
#
# $$R = \begin{pmatrix} c_y c_p & c_y s_p s_r - s_y c_r & c_y s_p c_r + s_y s_r \\
# s_y c_p & s_y s_p s_r + c_y c_r & s_y s_p c_r - c_y s_r \\
# -s_p & c_p s_r & c_p c_r \end{pmatrix}$$
#
# Write `rpy_angles`: from $R$ to (roll, pitch, yaw). Every triple that makes $R$ is right. Use
# `arctan2`, which knows the quadrant. (In the checks the pitch is never ±90°.)

# %% rpy-angles
def rpy_angles(R):
    ### BEGIN SOLUTION
    pitch = arctan2(-R[2, 0], sqrt(R[0, 0]**2 + R[1, 0]**2))
    roll = arctan2(R[2, 1], R[2, 2])
    yaw = arctan2(R[1, 0], R[0, 0])
    return roll, pitch, yaw
    ### END SOLUTION

# %% rpy-angles-check
check("rpy_angles", rpy_angles)

# %% own [markdown]
# ## 3. Your plane (1 point)
#
# A gyroscope says how your plane lies:

# %% own-matrix
R_AB = np.array(given["R"])
R_AB

# %% own-picture
show(*check.picture("own plane"), height=400)

# %% own-task [markdown]
# With which roll, pitch and yaw does the pilot tell it? Three numbers, in radians, to 0.001.

# %% own-answer
### BEGIN SOLUTION
attitude = rpy_angles(R_AB)
### END SOLUTION

# %% own-check
check("attitude", attitude)

# %% own-yours
def yours(attitude):
    roll, pitch, yaw = attitude
    R = rotz(yaw) @ roty(pitch) @ rotx(roll)
    return show(*check.picture("own plane"), csys(rp2t(R, (0, 0, 0)), name="yours", size=0.8),
                height=400)

check.show(yours, attitude)

# %% end [markdown]
# **What you have done.** Three numbers need a convention to mean anything; and two triples, at
# least, tell every orientation.
#
# Next: [a chain by hand](../06_chain_by_hand/06_chain_by_hand.ipynb).
