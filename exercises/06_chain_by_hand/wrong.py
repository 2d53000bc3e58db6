# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% tip: radians
q1, q2 = given["q"]
tip = [l1 * cos(q1) + l2 * cos(q1 + q2), l1 * sin(q1) + l2 * sin(q1 + q2), 0]

# %% tip: the first turn about z is left out
q1, q2 = np.radians(given["q"])
tip = [l1 + l2 * cos(q2), l2 * sin(q2), 0]

# %% tip: counted from where the ones before it began
q1, q2 = np.radians(given["q"])
tip = [l1 * cos(q1) + l2 * cos(q2), l1 * sin(q1) + l2 * sin(q2), 0]

# %% tip: shape (2,)
q1, q2 = np.radians(given["q"])
tip = [l1 * cos(q1) + l2 * cos(q1 + q2), l1 * sin(q1) + l2 * sin(q1 + q2)]

# %% arm_pose: no-tool
def arm_pose(q):
    turn_1, turn_2 = (rp2t(rotz(angle), (0, 0, 0)) for angle in q)
    return turn_1 @ transl((l1, 0, 0)) @ turn_2

# %% arm_pose: degrees
def arm_pose(q):
    turn_1, turn_2 = (rp2t(rotz(angle * deg), (0, 0, 0)) for angle in q)
    return turn_1 @ transl((l1, 0, 0)) @ turn_2 @ transl((l2, 0, 0))

# %% arm_pose: joint 2 turns the wrong way
def arm_pose(q):
    turn_1, turn_2 = rp2t(rotz(q[0]), (0, 0, 0)), rp2t(rotz(-q[1]), (0, 0, 0))
    return turn_1 @ transl((l1, 0, 0)) @ turn_2 @ transl((l2, 0, 0))

# %% arm_pose: inverse
def arm_pose(q):
    turn_1, turn_2 = (rp2t(rotz(angle), (0, 0, 0)) for angle in q)
    return np.linalg.inv(turn_1 @ transl((l1, 0, 0)) @ turn_2 @ transl((l2, 0, 0)))

# %% arm_pose: shape (3,)
def arm_pose(q):
    return [l1 * cos(q[0]) + l2 * cos(q[0] + q[1]), l1 * sin(q[0]) + l2 * sin(q[0] + q[1]), 0]

# %% arm_pose: the frame is
def arm_pose(q):
    turn_1, turn_2 = (rp2t(rotz(angle), (0, 0, 0)) for angle in q)
    return transl((l1, 0, 0)) @ turn_1 @ transl((l2, 0, 0)) @ turn_2
