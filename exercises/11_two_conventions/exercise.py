# %% title [markdown]
# # Exercise 11: the same arm in the other convention
#
# **Goal.** Turn a standard table into a modified one, and back, without looking at the arm again.
#
# **What to know before.** [Two conventions](../../notebooks/09_two_conventions.ipynb).
# **Time.** 30 minutes. **Points.** 8.

# %% imports
from dhlab import deg, dh, robot, rotx, rp2t, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# The two arms are your own. Write your name, as your course knows it:

# %% student
STUDENT = ""
given = check.numbers(STUDENT)

# %% first [markdown]
# ## 1. From standard to modified (3 points)
#
# A **standard** row is a screw about $z$, then one about $x$: its joint, then the link *behind* it,
# $R_z(\theta_i) D_z(d_i) D_x(a_i) R_x(\alpha_i)$. A **modified** row has the link *before* its
# joint, $R_x(\alpha_{i-1}) D_x(a_{i-1}) R_z(\theta_i) D_z(d_i)$. Your first arm, by its standard
# table, with angles in degrees:

# %% first-table
robot([dh(alpha * deg, a, d, theta * deg) for alpha, a, d, theta in given["standard"]],
      "rrr", convention="standard", name="first").own.chain

# %% first-picture-words [markdown]
# The standard frames: frame $i$ sits at the far end of link $i$, on the axis of the *next* joint.

# %% first-picture
show(*check.picture("standard"), height=420)

# %% first-task [markdown]
# Write its table in the modified convention: three rows `dh(alpha, a, d, theta)` for the same
# three joints. `given["standard"]` holds the rows above, lengths in metres, angles in degrees:
# `given["standard"][0][2]` is $d_1$.
#
# *Free:* the numbers in the $\theta$ column, where the variables stand; which way each $z$ points.

# %% first-answer
### BEGIN SOLUTION
links = [(0, 0)] + [(alpha * deg, a) for alpha, a, _, _ in given["standard"]]
joints = [(d, theta * deg) for _, _, d, theta in given["standard"]]
to_modified = [dh(*links[k], *joints[k]) for k in range(3)]
### END SOLUTION

# %% first-check
check("to_modified", to_modified)

# %% first-yours-words [markdown]
# Your modified frames (the orange arm) on the first arm. Frame $i$ sits on axis $i$ now.

# %% first-yours
def yours_first(to_modified):
    yours = robot(to_modified, "rrr", look="stick", color="#d55e00", frame_size=0.09)
    yours.show_csys = True
    return show(*check.picture("first"), yours, height=420)

check.show(yours_first, to_modified)

# %% behind [markdown]
# ## 2. What is left over (2 points)
#
# Two numbers of the standard table are in no row of the modified one: $\alpha_3$ and $a_3$ belong
# to the link behind the last joint. So they go into the grasper: write `behind`, the pose of the
# *standard* frame 3 in the *modified* frame 3, an array of shape (4, 4). Whatever $z$ you chose in
# part 1, take the modified frame 3 here whose rows have $\theta_i$ and $d_i$ as they stand above.
# `rotx(angle)` is a rotation about $x$, `rp2t(R, p)` the pose of a rotation and an origin.

# %% behind-answer
### BEGIN SOLUTION
alpha, a = given["standard"][2][0] * deg, given["standard"][2][1]
behind = rp2t(rotx(alpha), (a, 0, 0))
### END SOLUTION

# %% behind-check
check("behind", behind)

# %% second [markdown]
# ## 3. And back (3 points)
#
# Your second arm, by its **modified** table. Write its three rows in the **standard** convention.
# What then comes before the first row is not asked, nor what comes behind the last.

# %% second-table
robot([dh(alpha * deg, a, d, theta * deg) for alpha, a, d, theta in given["modified"]],
      "rrr", name="second").own.chain

# %% second-picture
show(*check.picture("modified"), height=420)

# %% second-answer
### BEGIN SOLUTION
ahead = [(alpha * deg, a) for alpha, a, _, _ in given["modified"]] + [(0, 0)]
turns = [(d, theta * deg) for _, _, d, theta in given["modified"]]
to_standard = [dh(*ahead[k + 1], *turns[k]) for k in range(3)]
### END SOLUTION

# %% second-check
check("to_standard", to_standard)

# %% second-yours-words [markdown]
# Your arm (orange), begun behind the first link. Do the joints lie where they should?

# %% second-yours
def yours_second(to_standard):
    yours = robot(to_standard, "rrr", convention="standard", look="stick")
    yours.base = rp2t(rotx(given["modified"][0][0] * deg), (0, 0, 0))
    yours.set(color="#d55e00", show_csys=True, frame_size=0.09)
    return show(*check.picture("second"), yours, height=420)

check.show(yours_second, to_standard)

# %% end [markdown]
# **What you have done.** Between the conventions all `alpha` and `a` move by one row, and the one
# that falls out goes into the base or into the grasper. `d` and `theta` stay.
#
# Next: [base, tool and offset](../12_base_tool_offset/12_base_tool_offset.ipynb).
