# %% title [markdown]
# # Exercise 13: where is the fingertip?
#
# **Goal.** Compute where a finger ends for any joint angles; then that of the thumb, which is
# mounted askew on the hand.
#
# **What to know before.** [The upper limb](../../notebooks/12_upper_limb.ipynb), its finger and
# hand; exercise 7. **Time.** 35 minutes. **Points.** 8.

# %% imports
import numpy as np
from numpy import pi

from dhlab import csys, deg, dh, link_transform, roty, rp2t, show, transl
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# The finger is your own. Write your name, as your course knows it:

# %% student
STUDENT = ""
given = check.numbers(STUDENT)
given

# %% finger [markdown]
# ## 1. The finger (4 points)
#
# A long finger is a chain of four revolute joints: it spreads, then flexes three times. Its root is
# {R}: $x$ along the stretched finger, $z$ out of the back of the hand. Its table (table 1 of
# Pająk's paper), with the lengths of the drawing in metres, is
#
# | $i$ | $\alpha_{i-1}$ | $a_{i-1}$ | $d_i$ | $\theta_i$ |
# |---|---|---|---|---|
# | 1 | $\pi$ | 0 | 0 | $q_1$ |
# | 2 | $-\pi/2$ | 0 | 0 | $q_2$ |
# | 3 | 0 | $a$ | 0 | $q_3$ |
# | 4 | 0 | $b$ | 0 | $q_4$ |
#
# and the tip is $c$ further along $x_4$. The angles of the drawing are $0°, -25°, -35°, -30°$:
# negative angles curl.

# %% finger-picture
show(*check.picture("finger"), height=380)

# %% finger-task [markdown]
# Write `finger_tip`: from `q`, an array of four angles [rad], to the pose of the tip in {R}, an
# array of shape (4, 4), in metres. `given` holds `a`, `b`, `c` in **millimetres**.
# `link_transform(dh(alpha, a, d, theta))` is the pose of one row; `transl(p)` a pose that only
# shifts.

# %% finger-answer
def finger_tip(q):
    ### BEGIN SOLUTION
    a, b, c = given["a"] / 1000, given["b"] / 1000, given["c"] / 1000
    rows = [dh(pi, 0, 0, q[0]), dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    T = np.eye(4)
    for row in rows:
        T = T @ link_transform(row)
    return T @ transl((c, 0, 0))
    ### END SOLUTION

# %% finger-check
check("finger_tip", finger_tip)

# %% finger-yours-words [markdown]
# Your frame of the tip, for the angles of the drawing. It must be on the fingertip, $x$ along it.

# %% finger-yours
def yours_finger(finger_tip):
    T = finger_tip(np.array([0, -25, -35, -30]) * deg)
    return show(*check.picture("finger"), csys(T, name="yours", size=0.02), height=380)

check.show(yours_finger, finger_tip)

# %% thumb [markdown]
# ## 2. The thumb, told in the hand (4 points)
#
# The thumb's own frame {B} is not the hand's {H}: it is turned by $\pi/2$ about $y$, and its origin
# is at $(0.040, 0.030, -0.015)$ m of {H} (table 3). Its first link has a length (table 2):
#
# | $i$ | $\alpha_{i-1}$ | $a_{i-1}$ | $d_i$ | $\theta_i$ |
# |---|---|---|---|---|
# | 1 | $\pi$ | 0 | 0 | $q_1$ |
# | 2 | $-\pi/2$ | 0.015 | 0 | $q_2$ |
# | 3 | 0 | 0.050 | 0 | $q_3$ |
# | 4 | 0 | 0.040 | 0 | $q_4$ |
#
# The tip is 0.030 m further along $x_4$. Drawn are $-20°, 40°, 25°, 30°$.

# %% thumb-picture
show(*check.picture("thumb"), height=420)

# %% thumb-task [markdown]
# Write `thumb_in_hand`: from `q` to the pose of the thumb's tip in {H}.

# %% thumb-answer
def thumb_in_hand(q):
    ### BEGIN SOLUTION
    T = rp2t(roty(pi / 2), (0.040, 0.030, -0.015))
    links = [(pi, 0), (-pi / 2, 0.015), (0, 0.050), (0, 0.040)]
    for (alpha, a), angle in zip(links, q, strict=True):
        T = T @ link_transform(dh(alpha, a, 0, angle))
    return T @ transl((0.030, 0, 0))
    ### END SOLUTION

# %% thumb-check
check("thumb_in_hand", thumb_in_hand)

# %% thumb-yours
def yours_thumb(thumb_in_hand):
    T = thumb_in_hand(np.array([-20, 40, 25, 30]) * deg)
    return show(*check.picture("thumb"), csys(T, name="yours", size=0.025), height=420)

check.show(yours_thumb, thumb_in_hand)

# %% end [markdown]
# **What you have done.** Base, one factor a joint, tip: forward kinematics of every chain there is.
#
# Next: [a hand](../14_hand/14_hand.ipynb).
