# %% title [markdown]
# # Exercise 4: a detour of frames
#
# **Goal.** Find a pose that nobody measured, by going over frames that were.
#
# **What to know before.** [Transforms](../../notebooks/04_transforms.ipynb), to its end.
# **Time.** 30 minutes. **Points.** 7.

# %% imports
import numpy as np

from dhlab import csys, inverse, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# Write your name, as your course knows it. The poses in your robot cell are your own.

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
T_RT, T_TP, T_RH = (np.array(given[name]) for name in ("T_RT", "T_TP", "T_RH"))

# %% cell [markdown]
# A robot stands in {R}. Three poses are known: the table in the robot's base, $T_{RT}$; the part on
# the table, $T_{TP}$, with {P} on the top of it; and the hand in the robot's base, $T_{RH}$.

# %% cell-picture
show(*check.picture("cell"), height=460)

# %% drawing [markdown]
# ## 1. Put the frames where they are (2 points)
#
# Draw the cell's frames yourself: a view `drawing` that shows four coordinate systems, named `R`,
# `T`, `P` and `H`. {R} stands in the origin of the world. `csys(pose, name="T", size=0.3)` makes
# one, `show(...)` of several makes the view.

# %% drawing-answer
### BEGIN SOLUTION
drawing = show(csys(name="R", size=0.3), csys(T_RT, name="T", size=0.3),
               csys(T_RT @ T_TP, name="P", size=0.3), csys(T_RH, name="H", size=0.3))
### END SOLUTION

# %% drawing-check
check("drawing", drawing)

# %% drawing-yours-words [markdown]
# Your frames with the things that they belong to:

# %% drawing-yours
def with_things(drawing):
    return show(*check.picture("no frames"), *drawing.handles, height=460)

check.show(with_things, drawing)

# %% hand [markdown]
# ## 2. Against an arrow (2 points)
#
# The hand must grasp the part. Where is the part, seen from the hand? Give $T_{HP}$. `inverse` is
# there.

# %% hand-answer
### BEGIN SOLUTION
T_HP = inverse(T_RH) @ T_RT @ T_TP
### END SOLUTION

# %% hand-check
check("T_HP", T_HP)

# %% hand-yours-words [markdown]
# From the hand, go by your $T_{HP}$: the frame must stand on the part.

# %% hand-yours
def yours(T_HP):
    return show(*check.picture("hand"), csys(T_RH @ T_HP, name="yours", size=0.25), height=460)

check.show(yours, T_HP)

# %% camera [markdown]
# ## 3. Where is the camera? (3 points)
#
# A camera hangs somewhere over the cell; nobody knows where. But it sees the part, at $T_{CP}$, and
# the robot has touched the same part, at $T_{RP}$. So one look says where the camera is: $T_{RC}$.
#
# Write `camera_pose`: from $T_{RP}$ and $T_{CP}$ to $T_{RC}$.

# %% camera-answer
def camera_pose(T_RP, T_CP):
    ### BEGIN SOLUTION
    return T_RP @ inverse(T_CP)
    ### END SOLUTION

# %% camera-check
check("camera_pose", camera_pose)

# %% end [markdown]
# **What you have done.** Every way from frame to frame is a product; against an arrow, take the
# inverse. If the names next to each other do not agree, the product is nonsense.
#
# Next: [roll, pitch, yaw](../05_roll_pitch_yaw/05_roll_pitch_yaw.ipynb).
