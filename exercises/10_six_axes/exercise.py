# %% title [markdown]
# # Exercise 10: six axes
#
# **Goal.** Find the table of an arm like the PUMA 560: axes that meet, that are parallel, and that
# do neither.
#
# **What to know before.** [Assigning frames](../../notebooks/08_assigning_frames.ipynb);
# exercise 8. **Time.** 40 minutes. **Points.** 7.

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

# %% arm [markdown]
# ## 1. The arm: axes 1 to 4 (4 points)
#
# Axes 1 and 2 meet in the shoulder, where {0} stands still. Axis 3 is parallel to axis 2, an upper
# arm further. From there one steps *aside* along axis 3, then by a *step* off axis 3 at the elbow,
# and then along the forearm, in which axis 4 lies. All the lengths of `given` are in the drawing.

# %% arm-picture
show(*check.picture("arm"), height=480)

# %% arm-task [markdown]
# Write the four rows `dh(alpha, a, d, theta)` for axes 1 to 4 in the **modified** convention. For
# each row: first turn $z$ by `alpha` about $x$, and go `a` along $x$, from the axis before to this
# axis; then `theta` about and `d` along this axis. `d` of row 4 leads to the wrist.
#
# *Free:* which way each $z$ points along its axis; the numbers in the $\theta$ column. With
# $\theta = 0°, -45°, -45°, 0°$ and the $z$ of our table your arm stands as it is drawn.

# %% arm-answer
### BEGIN SOLUTION
arm_table = [
    dh(0, 0, 0, 0),
    dh(-90 * deg, 0, 0, -45 * deg),
    dh(0, given["upper"], given["aside"], -45 * deg),
    dh(-90 * deg, given["step"], given["fore"], 0),
]
### END SOLUTION

# %% arm-check
check("arm_table", arm_table)

# %% arm-yours-words [markdown]
# Your frames on the arm (pale). Each $z$ must lie in its axis.

# %% arm-yours
def yours_arm(arm_table):
    yours = robot(arm_table, "rrrr", look="stick", color="#d55e00", frame_size=0.14)
    yours.show_csys = True
    return show(*check.picture("arm"), yours, height=480)

check.show(yours_arm, arm_table)

# %% wrist [markdown]
# ## 2. The wrist: axes 5 and 6 (3 points)
#
# Axes 4, 5 and 6 meet in the wrist, each at right angles to the one before. Write the whole
# `table`: six rows. Where the hand is in your last frame is not asked. (The wrist is drawn bent, by
# $\theta_5 = 30°$.)

# %% wrist-picture
show(*check.picture("wrist"), height=480)

# %% wrist-answer
### BEGIN SOLUTION
table = [*arm_table, dh(90 * deg, 0, 0, 30 * deg), dh(-90 * deg, 0, 0, 0)]
### END SOLUTION

# %% wrist-check
check("table", table)

# %% wrist-yours
def yours_wrist(table):
    yours = robot(table, 6 * "r", look="stick", color="#d55e00", frame_size=0.14)
    yours.show_csys = True
    return show(*check.picture("wrist"), yours, height=480)

check.show(yours_wrist, table)

# %% end [markdown]
# **What you have done.** Where axes meet, $a = 0$; where they are parallel, $\alpha = 0$; where
# they do neither, both numbers are there. That is the whole craft.
#
# Next: [the other convention](../11_two_conventions/11_two_conventions.ipynb).
