# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% drawing: P is placed in the world by its pose in T
drawing = show(csys(name="R"), csys(T_RT, name="T"), csys(T_TP, name="P"), csys(T_RH, name="H"))

# %% drawing: wrong-side
drawing = show(csys(name="R"), csys(T_RT, name="T"), csys(T_TP @ T_RT, name="P"),
               csys(T_RH, name="H"))

# %% drawing: not in the scene: H
drawing = show(csys(name="R"), csys(T_RT, name="T"), csys(T_RT @ T_TP, name="P"))

# %% drawing: inverse
drawing = show(csys(name="R"), csys(T_RT, name="T"), csys(T_RT @ T_TP, name="P"),
               csys(inverse(T_RH), name="H"))

# %% drawing: a view or a list of handles is asked for
drawing = T_RT @ T_TP

# %% T_HP: T_RH is used as it is, where its inverse is needed
T_HP = T_RH @ T_RT @ T_TP

# %% T_HP: reversed-order
T_HP = T_TP @ T_RT @ inverse(T_RH)

# %% T_HP: inverse
T_HP = inverse(T_TP) @ inverse(T_RT) @ T_RH

# %% T_HP: left out
T_HP = T_RT @ T_TP

# %% T_HP: transposed
T_HP = T_RH.T @ T_RT @ T_TP

# %% camera_pose: T_CP is used as it is, where its inverse is needed
def camera_pose(T_RP, T_CP):
    return T_RP @ T_CP

# %% camera_pose: reversed-order
def camera_pose(T_RP, T_CP):
    return inverse(T_CP) @ T_RP

# %% camera_pose: inverse
def camera_pose(T_RP, T_CP):
    return T_CP @ inverse(T_RP)
