# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% T_AB: radians
T_AB = rp2t(rotz(given["angle"]), (given["x"], given["y"], given["z"]))

# %% T_AB: the translation is rotated once more
shift = rp2t(np.eye(3), (given["x"], given["y"], given["z"]))
T_AB = rp2t(rotz(given["angle"] * deg), (0, 0, 0)) @ shift

# %% T_AB: inverse
T_AB = np.linalg.inv(rp2t(rotz(given["angle"] * deg), (given["x"], given["y"], given["z"])))

# %% T_AB: the last row of a pose is 0, 0, 0, 1
T_AB = rp2t(rotz(given["angle"] * deg), (given["x"], given["y"], given["z"])).T

# %% T_AB: shape (3, 3)
T_AB = rotz(given["angle"] * deg)

# %% T_AB: millimetres
T_AB = rp2t(rotz(given["angle"] * deg), (1000 * given["x"], 1000 * given["y"], 1000 * given["z"]))

# %% to_A: no-translation
def to_A(T_AB, p_B):
    return T_AB[:3, :3] @ p_B

# %% to_A: inverse
def to_A(T_AB, p_B):
    return (np.linalg.inv(T_AB) @ np.append(p_B, 1))[:3]

# %% to_A: rotat
def to_A(T_AB, p_B):
    return p_B + T_AB[:3, 3]

# %% inverse_pose: only negated
def inverse_pose(T_AB):
    return rp2t(T_AB[:3, :3].T, -T_AB[:3, 3])

# %% inverse_pose: inverse
def inverse_pose(T_AB):
    return T_AB

# %% inverse_pose: 0, 0, 0, 1
def inverse_pose(T_AB):
    return T_AB.T

# %% inverse_pose: the frame is
def inverse_pose(T_AB):
    return rp2t(T_AB[:3, :3].T, T_AB[:3, 3])

# %% inverse_pose: left-handed
def inverse_pose(T_AB):
    R, p = T_AB[:3, :3], T_AB[:3, 3]
    T_BA = np.eye(4)
    T_BA[:3, :3], T_BA[:3, 3] = -R, -R.T @ p
    return T_BA
