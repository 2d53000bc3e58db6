# %% title [markdown]
# # Exercise 15: a cubic from rest to rest
#
# **Goal.** Bring a joint from one angle to another within a given time, at rest at both ends.
#
# **What to know before.** [Trajectories](../../notebooks/11_trajectories.ipynb); what a derivative
# is. **Time.** 35 minutes. **Points.** 8.

# %% imports
import numpy as np

from dhlab import animate, deg, dh, robot, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# The motion at the end is your own. Write your name, as your course knows it:

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% ends-words [markdown]
# An arm is to go from the pale pose to the other one, from `q0` to `qt` (degrees), from the instant
# `start` to the instant `end` (seconds).

# %% ends-picture
show(*check.picture("ends"), height=360)

# %% cubic [markdown]
# ## 1. Four conditions, four coefficients (3 points)
#
# $$q(t) = c_3 t^3 + c_2 t^2 + c_1 t + c_0,\qquad q(0) = q_0,\; q(T) = q_t,\; \dot q(0) = 0,\;
# \dot q(T) = 0$$
#
# Write `cubic`: from $q_0$, $q_t$ [rad] and $T$ [s] to the coefficients $(c_3, c_2, c_1, c_0)$, the
# highest power first.

# %% cubic-answer
def cubic(q0, qt, T):
    ### BEGIN SOLUTION
    way = qt - q0
    return np.array([-2 * way / T**3, 3 * way / T**2, 0, q0])
    ### END SOLUTION

# %% cubic-check
check("cubic", cubic)

# %% position [markdown]
# ## 2. Where it is at any instant (3 points)
#
# Clocks rarely begin at 0. Write `position`: from `t`, an array of instants, and from `q0`, `qt`,
# `start` and `end` to the angles at those instants. The motion begins at `start` and ends at `end`.

# %% position-answer
def position(t, q0, qt, start, end):
    ### BEGIN SOLUTION
    return np.polyval(cubic(q0, qt, end - start), t - start)
    ### END SOLUTION

# %% position-check
check("position", position)

# %% position-yours-words [markdown]
# The arm goes as your function says; play it. Does it begin gently, and end gently where it should?

# %% position-yours
def yours_position(position):
    rows = [dh(0, 0, 0, 0), dh(0, 0.4, 0, 0)]
    arm = robot(rows, "rr", grasper=(0.3, 0, 0), color="#d55e00", radius=0.02)
    t = np.linspace(given["start"], given["end"], 60)
    ends = zip(given["q0"], given["qt"], strict=True)
    q = np.column_stack([position(t, a * deg, b * deg, t[0], t[-1]) for a, b in ends])
    animate(t, {arm: lambda now: q[np.searchsorted(t, now)]}, trace=True)
    return show(*check.picture("ends"), arm, height=360)

check.show(yours_position, position)

# %% velocity [markdown]
# ## 3. How fast it is (2 points)
#
# Write `velocity`, with the same arguments: the angular velocities [rad/s] at the instants `t`.

# %% velocity-answer
def velocity(t, q0, qt, start, end):
    ### BEGIN SOLUTION
    c = cubic(q0, qt, end - start)
    u = t - start
    return 3 * c[0] * u**2 + 2 * c[1] * u + c[2]
    ### END SOLUTION

# %% velocity-check
check("velocity", velocity)

# %% end [markdown]
# **What you have done.** Half way it is fastest, one and a half times as fast as the mean: that is
# the price of a gentle start with a cubic.
