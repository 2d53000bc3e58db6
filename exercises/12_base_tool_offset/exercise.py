# %% title [markdown]
# # Exercise 12: base, tool and offset
#
# **Goal.** Put a robot where it stands, give it its tool, and let its joints count as the data
# sheet says; its table stays as it is.
#
# **What to know before.** [Base, tool, offset](../../notebooks/10_base_tool_limits.ipynb).
# **Time.** 30 minutes. **Points.** 8.

# %% imports
from dhlab import Panel, csys, deg, dh, robot, rotx, roty, rotz, rp2t, show, side_by_side, transl
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# The numbers are your own. Write your name, as your course knows it:

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% base [markdown]
# ## 1. The base (2 points)
#
# The arm stands on a bench. Its frame {0} has its origin on the bench, at
# `(given["x"], given["y"], given["bench"])` in the world {W}; $z_0$ points up, and {0} is turned
# about it by `given["turn"]` degrees. Draw it: make `base`, a `csys` with the name `"0"` and an
# axis length of `size=0.2`, at that pose. The pose of a rotation and an origin is `rp2t(R, p)`.

# %% base-picture
show(*check.picture("bench"), height=420)

# %% base-answer
### BEGIN SOLUTION
T_W0 = rp2t(rotz(given["turn"] * deg), (given["x"], given["y"], given["bench"]))
base = csys(T_W0, name="0", size=0.2)
### END SOLUTION

# %% base-check
check("base", base)

# %% base-yours-words [markdown]
# The bench with the arm (pale), and your frame. It must be in the arm's foot.

# %% base-yours
def yours_base(base):
    return show(*check.picture("bench"), base, height=420)

check.show(yours_base, base)

# %% tool [markdown]
# ## 2. The tool (2 points)
#
# The last link alone: from frame {3} one goes 0.4 m along the forearm, which is $x_3$. There
# the tool is mounted: it is turned by `given["tilt"]` degrees about $y$, and its tip {T} is
# `given["tool"]` metres further along *its own* $x$. Draw {T} in frame {3}: make `tool`, a `csys`
# with the name `"T"` and `size=0.1`.

# %% tool-picture
show(*check.picture("link"), height=380)

# %% tool-answer
### BEGIN SOLUTION
tilted = rp2t(roty(given["tilt"] * deg), (0.4, 0, 0))
T_3T = tilted @ transl((given["tool"], 0, 0))
tool = csys(T_3T, name="T", size=0.1)
### END SOLUTION

# %% tool-check
check("tool", tool)

# %% tool-yours
def yours_tool(tool):
    return show(*check.picture("link"), tool, height=380)

check.show(yours_tool, tool)

# %% arm [markdown]
# ## 3. The whole arm (4 points)
#
# The table of the arm, from the foot to the last joint, with Craig's zeros:

# %% rows
rows = [dh(0, 0, 0.3, 0), dh(-90 * deg, 0, 0, 0), dh(0, 0.45, 0, 0)]

# %% arm-task [markdown]
# With $\theta = (0, 0, 0)$ its upper arm is level and so is the forearm. The data sheet counts
# otherwise: **with $q = (0, 0, 0)$ the upper arm is upright and the forearm level**, as in the
# picture of part 1, and each joint turns the way it did. So $\theta = q + \text{offset}$.
#
# Make the robot `arm` of these rows with its base, its tool (`grasper=`) and its `offset`, three
# angles. You can use `base.pose` and `tool.pose` of above.

# %% arm-answer
### BEGIN SOLUTION
arm = robot(rows, "rrr", base=T_W0, grasper=T_3T, offset=(0, -90 * deg, 90 * deg))
### END SOLUTION

# %% arm-check
check("arm", arm)

# %% arm-yours-words [markdown]
# Your arm (orange) over the wanted one (pale), all joints at 0. Both are drawn with the last
# link straight to the tip of the tool.

# %% arm-yours
def yours_arm(arm):
    arm.set(color="#d55e00", look="stick")
    return side_by_side(show(*check.picture("whole"), arm, height=420), Panel(arm))

check.show(yours_arm, arm)

# %% end [markdown]
# **What you have done.** $T_{WT} = T_{W0}\, T_{03}(q + \text{offset})\, T_{3T}$: three things
# around the table, and not a number of the table has changed.
#
# Next: [where the fingertip is](../13_finger/13_finger.ipynb).
