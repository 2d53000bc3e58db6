# %% title [markdown]
# # Exercise 1: rotation matrices
#
# **Goal.** Write a rotation matrix down: from an angle, and from a picture.
#
# **What to know before.** [What a rotation matrix says](../../notebooks/02_rotation_matrix.ipynb).
# **Time.** 20 minutes. **Points.** 6.
#
# Replace what is marked by your answer, run the cell, then the check below it, as often as you
# like.

# %% imports
import numpy as np
from numpy import cos, sin

from dhlab import csys, deg, rp2t, show
from dhlab.grading import checks

# %% checks
# The checks of this exercise, as text. Leave this cell as it is.
check = checks(course="dhlab")

# %% student-words [markdown]
# Part 3 is a picture of your own. Write your name, as your course knows it:

# %% student
STUDENT = ""
given = check.numbers(STUDENT)

# %% about-z [markdown]
# ## 1. A turn about $z$ (2 points)
#
# {B} has turned about $z_A$ by $50°$. Drag the picture until you look down on it, with $z$ towards
# you: how far along $x_A$ and along $y_A$ does the red axis $x_B$ reach now?

# %% about-z-picture
show(*check.picture("about z"), height=360)

# %% about-z-task [markdown]
# Write `rot_z`: from an angle in radians to the rotation matrix $R_{AB}$, an array of shape (3, 3).
# Its columns are the axes of {B}, told in {A}.

# %% rot-z
def rot_z(angle):
    ### BEGIN SOLUTION
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s, 0],
                     [s,  c, 0],
                     [0,  0, 1]])
    ### END SOLUTION

# %% rot-z-check
check("rot_z", rot_z)

# %% rot-z-yours-words [markdown]
# Your frame for $50°$, beside the one above (pale). They must cover each other.

# %% rot-z-yours
def yours_about_z(rot_z):
    yours = csys(rp2t(rot_z(50 * deg), (0, 0, 0)), name="yours", size=0.8)
    return show(*check.picture("about z"), yours, height=360)

check.show(yours_about_z, rot_z)

# %% about-y [markdown]
# ## 2. A turn about $y$ (2 points)
#
# The same for a turn about $y_A$. Right thumb along $y$: which way do the fingers carry $z$?

# %% about-y-picture
show(*check.picture("about y"), height=360)

# %% rot-y
def rot_y(angle):
    ### BEGIN SOLUTION
    c, s = cos(angle), sin(angle)
    return np.array([[ c, 0, s],
                     [ 0, 1, 0],
                     [-s, 0, c]])
    ### END SOLUTION

# %% rot-y-check
check("rot_y", rot_y)

# %% rot-y-yours
def yours_about_y(rot_y):
    yours = csys(rp2t(rot_y(50 * deg), (0, 0, 0)), name="yours", size=0.8)
    return show(*check.picture("about y"), yours, height=360)

check.show(yours_about_y, rot_y)

# %% read [markdown]
# ## 3. Read a matrix from a picture (2 points)
#
# Every axis of {B} is parallel to one of {A}, the same way or the opposite way. No angles and no
# sines: write $R_{AB}$ down, column by column.

# %% read-picture
show(*check.picture("A and B"), height=380)

# %% read-answer
### BEGIN SOLUTION
x, y, z = np.eye(3)
columns = [(y, z, x), (-y, z, -x), (y, -z, -x), (y, z, x),
           (-y, -z, x), (-y, z, -x), (y, z, x), (-y, -z, x)]
R_AB = np.column_stack(columns[given["picture"]])
### END SOLUTION

# %% read-check
check("R_AB", R_AB)

# %% read-yours
def yours_read(R_AB):
    yours = csys(rp2t(R_AB, (2, 0, 0)), name="yours", size=0.8)
    return show(*check.picture("A and B"), yours, height=380)

check.show(yours_read, R_AB)

# %% end [markdown]
# **What you have done.** The columns of a rotation matrix are the axes of the turned frame: that is
# all there is to remember.
#
# Next: [sequences of turns](../02_sequences/02_sequences.ipynb).
