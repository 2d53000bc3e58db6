# %% title [markdown]
# # Exercise 9: a SCARA
#
# **Goal.** Make a robot of four joints from a drawing, one of which slides.
#
# **What to know before.** [Assigning frames](../../notebooks/08_assigning_frames.ipynb);
# exercise 8. **Time.** 25 minutes. **Points.** 6.

# %% imports
from dhlab import Panel, deg, dh, robot, rotx, rp2t, show, side_by_side
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# The robot is your own. Write your name, as your course knows it:

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% drawing [markdown]
# ## From the drawing to the robot (6 points)
#
# Joints 1, 2 and 4 turn, joint 3 slides. They are drawn **with all variables at 0**: the arms
# stretched along $x_0$, the tool all the way up. Axes 3 and 4 are one line. {0} stands on the
# floor, {T} at the tip of the tool: its $z$ points down.

# %% drawing-picture
show(*check.picture("drawing"), height=460)

# %% task [markdown]
# Make the robot `scara`, with all variables at 0 in the pose of the drawing:
# `robot(rows, letters, grasper=...)`, a row `dh(alpha, a, d, theta)` and a letter, `r` or `p`, for
# each joint; `grasper` is the pose of {T} in the frame of the last joint. The four lengths of
# `given` are those of the drawing.
#
# *Free:* which way each $z$ points along its axis, so also whether joint 3 counts up or down; how
# the heights are shared among $d_1$, $d_2$, $d_4$ and the grasper. *Not free:* the zeros of the
# joints. $d_3$ is the variable itself, so 0 where all variables are.

# %% answer
### BEGIN SOLUTION
scara = robot(
    [
        dh(0, 0, given["h"], 0),
        dh(0, given["l1"], 0, 0),
        dh(180 * deg, given["l2"], 0, 0),
        dh(0, 0, 0, 0),
    ],
    "rrpr",
    grasper=(0, 0, given["tool"]),
)
### END SOLUTION

# %% check
check("scara", scara)

# %% yours-words [markdown]
# Your robot with its frames, over the drawing (pale). Its tip must be in {T}; move the sliders:
# does each joint do what it should?

# %% yours
def yours(scara):
    scara.set(look="stick", color="#d55e00", show_csys=True, frame_size=0.1)
    return side_by_side(show(*check.picture("drawing"), scara, height=460), Panel(scara))

check.show(yours, scara)

# %% end [markdown]
# **What you have done.** Along a joint that slides $d$ is the variable: the number in its row is
# where it begins.
#
# Next: [six axes](../10_six_axes/10_six_axes.ipynb).
