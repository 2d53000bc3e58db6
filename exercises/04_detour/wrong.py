# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% T_RP: reversed-order
T_RP = T_TP @ T_RT

# %% T_RP: T_TP is left out
T_RP = T_RT

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
