# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% dh_link: convention
def dh_link(alpha, a, d, theta):
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    return about_z @ about_x

# %% dh_link: degrees
def dh_link(alpha, a, d, theta):
    alpha, theta = np.radians([alpha, theta])
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    return about_x @ about_z

# %% dh_link: in the order theta, d, a, alpha
def dh_link(theta, d, a, alpha):
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    return about_x @ about_z

# %% dh_link: the factor of alpha goes the wrong way round
def dh_link(alpha, a, d, theta):
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, sa, 0], [0, -sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    return about_x @ about_z

# %% dh_link: the factor of d is left out
def dh_link(alpha, a, d, theta):
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    return about_x @ about_z

# %% dh_link: inverse
def dh_link(alpha, a, d, theta):
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    return np.linalg.inv(about_x @ about_z)

# %% dh_link: the last row of a pose is 0, 0, 0, 1
def dh_link(alpha, a, d, theta):
    ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
    about_x = np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    about_z = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
    return (about_x @ about_z).T

# %% T_own: millimetres
T_own = dh_link(given["alpha"] * deg, given["a"], given["d"], given["theta"] * deg)

# %% T_own: radians
T_own = dh_link(given["alpha"], given["a"] / 1000, given["d"] / 1000, given["theta"])

# %% T_own: shape (4,)
T_own = [given["alpha"] * deg, given["a"] / 1000, given["d"] / 1000, given["theta"] * deg]
