# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% rot_z: sign-1
def rot_z(angle):
    c, s = cos(angle), sin(angle)
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])

# %% rot_z: degrees
def rot_z(angle):
    c, s = cos(np.radians(angle)), sin(np.radians(angle))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])

# %% rot_z: sine-cosine-1
def rot_z(angle):
    c, s = sin(angle), cos(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])

# %% rot_z: axis-1-x
def rot_z(angle):
    c, s = cos(angle), sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])

# %% rot_z: is there a return at the end?
def rot_z(angle):
    c, s = cos(angle), sin(angle)
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])

# %% rot_z: shape (2, 2)
def rot_z(angle):
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s], [s, c]])

# %% rot_z: not perpendicular
def rot_z(angle):
    c, s = cos(angle), sin(angle)
    return np.array([[c, s, 0], [s, c, 0], [0, 0, 1]])

# %% rot_z: raised
def rot_z(angle):
    return np.array([[cosine(angle), -sine(angle), 0], [sine(angle), cosine(angle), 0], [0, 0, 1]])

# %% rot_y: sign-1
def rot_y(angle):
    c, s = cos(angle), sin(angle)
    return np.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])

# %% rot_y: left-handed
def rot_y(angle):
    c, s = cos(angle), sin(angle)
    return np.array([[c, 0, s], [0, -1, 0], [-s, 0, c]])

# %% R_AB: inverse
R_AB = R_AB.T

# %% R_AB: left-handed
R_AB = R_AB * [1, 1, -1]

# %% R_AB: the answer is text
R_AB = "column by column"
