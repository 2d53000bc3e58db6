# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% rpy_matrix: fixed-moving
def rpy_matrix(roll, pitch, yaw):
    return rotx(roll) @ roty(pitch) @ rotz(yaw)

# %% rpy_matrix: degrees
def rpy_matrix(roll, pitch, yaw):
    return rotz(yaw * deg) @ roty(pitch * deg) @ rotx(roll * deg)

# %% rpy_matrix: inverse
def rpy_matrix(roll, pitch, yaw):
    return (rotz(yaw) @ roty(pitch) @ rotx(roll)).T

# %% rpy_matrix: the turn about y goes the wrong way round
def rpy_matrix(roll, pitch, yaw):
    return rotz(yaw) @ roty(-pitch) @ rotx(roll)

# %% rpy_angles: order-210
def rpy_angles(R):
    pitch = arctan2(-R[2, 0], sqrt(R[0, 0]**2 + R[1, 0]**2))
    return arctan2(R[1, 0], R[0, 0]), pitch, arctan2(R[2, 1], R[2, 2])

# %% rpy_angles: sign
def rpy_angles(R):
    pitch = arctan2(R[2, 0], sqrt(R[0, 0]**2 + R[1, 0]**2))
    return arctan2(R[2, 1], R[2, 2]), pitch, arctan2(R[1, 0], R[0, 0])

# %% rpy_angles: degrees
def rpy_angles(R):
    pitch = arctan2(-R[2, 0], sqrt(R[0, 0]**2 + R[1, 0]**2))
    return np.degrees([arctan2(R[2, 1], R[2, 2]), pitch, arctan2(R[1, 0], R[0, 0])])

# %% rpy_angles: what is special about the others
def rpy_angles(R):
    return np.arctan(R[2, 1] / R[2, 2]), arcsin(-R[2, 0]), np.arctan(R[1, 0] / R[0, 0])

# %% attitude: degrees
attitude = np.degrees(rpy_angles(R_AB))

# %% attitude: shape (3, 3)
attitude = R_AB

# %% attitude: transpose
attitude = rpy_angles(R_AB.T)
