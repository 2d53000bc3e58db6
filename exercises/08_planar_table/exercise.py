# %% title [markdown]
# # Exercise 8: a table from a drawing
#
# **Goal.** Read the Denavit-Hartenberg table of an arm with three parallel axes off a drawing.
#
# **What to know before.** [Assigning frames](../../notebooks/08_assigning_frames.ipynb).
# **Time.** 20 minutes. **Points.** 5.

# %% imports
from dhlab import deg, dh, robot, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# The arm is your own. Write your name, as your course knows it:

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% flat [markdown]
# ## 1. The arm lies flat (3 points)
#
# The drawing shows the arm with its joint axes and the lengths between them; `given` holds the same
# lengths. Frame {0} stands still in the foot. The joints are drawn at $30°$, $50°$ and $-40°$, each
# counted from the link before.

# %% flat-picture
show(*check.picture("flat"), height=420)

# %% flat-task [markdown]
# Write its `table` in the **modified** convention: three rows
# `dh(alpha, a, d, theta)`, where `alpha` and `a` lead from the axis before to this one and `d` and
# `theta` go along and about this axis. In radians and metres: `90 * deg`, `given["l1"]`.
#
# *Free:* which way each $z$ points along its axis; how the $d$ of parallel axes share the height;
# the numbers in the $\theta$ column, where the joint variables stand: take the angles of the
# drawing, and your arm stands as it is drawn. Where the gripper is in your last frame is not asked.

# %% flat-answer
### BEGIN SOLUTION
table = [
    dh(0, 0, 0, 30 * deg),
    dh(0, given["l1"], 0, 50 * deg),
    dh(0, given["l2"], 0, -40 * deg),
]
### END SOLUTION

# %% flat-check
check("table", table)

# %% flat-yours-words [markdown]
# Your frames on the arm (pale). Does each $z$ lie in its axis?

# %% flat-yours
def yours_flat(table):
    yours = robot(table, "rrr", look="stick", color="#d55e00", frame_size=0.1)
    yours.show_csys = True
    return show(*check.picture("flat"), yours, height=420)

check.show(yours_flat, table)

# %% upright [markdown]
# ## 2. The same arm upright (2 points)
#
# The same arm is set upright: now it moves in the plane of $x_0$ and $z_0$. Its axes are level and
# as far from each other as before.

# %% upright-picture
show(*check.picture("upright"), height=420)

# %% upright-answer
### BEGIN SOLUTION
table_upright = [
    dh(90 * deg, 0, 0, 30 * deg),
    dh(0, given["l1"], 0, 50 * deg),
    dh(0, given["l2"], 0, -40 * deg),
]
### END SOLUTION

# %% upright-check
check("table_upright", table_upright)

# %% upright-yours
def yours_upright(table_upright):
    yours = robot(table_upright, "rrr", look="stick", color="#d55e00", frame_size=0.1)
    yours.show_csys = True
    return show(*check.picture("upright"), yours, height=420)

check.show(yours_upright, table_upright)

# %% end [markdown]
# **What you have done.** Between parallel axes there is one number to find, $a$. The last link is
# in no row: behind it there is no axis to lead to.
#
# Next: [a SCARA](../09_scara/09_scara.ipynb).
