# %% title [markdown]
# # Exercise 14: a hand
#
# **Goal.** Build a mechanism that branches: five chains on one base, with limits.
#
# **What to know before.** [The upper limb](../../notebooks/12_upper_limb.ipynb), its hand;
# exercise 13. **Time.** 35 minutes. **Points.** 7.

# %% imports
from numpy import pi

from dhlab import Panel, deg, dh, robot, robot_complex, roty, rp2t, show, side_by_side
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# The hand is your own. Write your name, as your course knows it. `given` then holds, for each long
# finger, its bones `a`, `b`, `c` and the place of its root `x`, `y` in the frame {H} of the hand,
# in **millimetres**, and how far it spreads, in **degrees**.

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% wood-words [markdown]
# In {H} $x$ points to the fingers, $y$ to the thumb, $z$ out of the back of the hand. The hand of
# the picture is the paper's; yours is a little different.

# %% wood-picture
show(*check.picture("wood"), height=420)

# %% finger [markdown]
# ## 1. A long finger (3 points)
#
# Its rows are those of exercise 13: $\alpha = \pi, -\pi/2, 0, 0$; $a = 0, 0, a, b$; all $d = 0$ and
# at rest all $\theta = 0$. Its tip is $c$ along $x_4$ (the `grasper`), its root at $(x, y, 0)$ in
# {H} (the `base`), its axes parallel to those of {H}. The first joint spreads within the limits of
# `given`, the other three flex from $-\pi/2$ to 0: `limits` has a row, lower and upper, for each
# joint.
#
# Write `finger`: from a name, such as `"index"`, to the robot of this name. Then make the robot
# `index` by it.

# %% finger-answer
def finger(name):
    ### BEGIN SOLUTION
    f = given[name]
    rows = [dh(pi, 0, 0, 0), dh(-pi / 2, 0, 0, 0),
            dh(0, f["a"] / 1000, 0, 0), dh(0, f["b"] / 1000, 0, 0)]
    limits = [(f["spread"][0] * deg, f["spread"][1] * deg)] + 3 * [(-pi / 2, 0)]
    return robot(rows, "rrrr", name=name, limits=limits, radius=0.008, grasper_size=0,
                 base=(f["x"] / 1000, f["y"] / 1000, 0), grasper=(f["c"] / 1000, 0, 0))
    ### END SOLUTION

# %% index
### BEGIN SOLUTION
index = finger("index")
### END SOLUTION

# %% index-check
check("index", index)

# %% index-yours-words [markdown]
# Your finger (orange) in the wanted hand (pale). With the sliders: does it curl to the palm?

# %% index-yours
def yours_index(index):
    index.color = "#d55e00"
    return side_by_side(show(*check.picture("hand"), index, height=420), Panel(index))

check.show(yours_index, index)

# %% hand [markdown]
# ## 2. The hand (4 points)
#
# The thumb is there already:

# %% thumb
def thumb():
    rows = [dh(pi, 0, 0, 0), dh(-pi / 2, 0.015, 0, 0), dh(0, 0.050, 0, 0), dh(0, 0.040, 0, 0)]
    return robot(rows, "rrrr", name="thumb", base=rp2t(roty(pi / 2), (0.040, 0.030, -0.015)),
                 grasper=(0.030, 0, 0), limits=[(-pi / 2, 0)] + 3 * [(0, pi / 2)],
                 radius=0.009, grasper_size=0)

# %% hand-task [markdown]
# Make the `hand`: `robot_complex(...)` of the thumb, the index, the middle, the ring and the little
# finger, in this order: so their joints follow each other in $q$. A robot can be part of one other
# only, so make each finger anew by your function.

# %% hand-answer
### BEGIN SOLUTION
hand = robot_complex(
    thumb(), finger("index"), finger("middle"), finger("ring"), finger("little"), name="hand"
)
### END SOLUTION

# %% hand-check
check("hand", hand)

# %% hand-yours-words [markdown]
# Your hand over the wanted one (pale), with its twenty sliders.

# %% hand-yours
def yours_hand(hand):
    hand.set(radius=0.008)
    return side_by_side(show(*check.picture("hand"), hand, height=420), Panel(hand))

check.show(yours_hand, hand)

# %% end [markdown]
# **What you have done.** A table describes one chain. A hand is five of them, and each has a base
# of its own.
#
# Next: [a cubic from rest to rest](../15_cubic/15_cubic.ipynb).
