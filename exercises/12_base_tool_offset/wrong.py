# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% base: radians
base = csys(rp2t(rotz(given["turn"]), (given["x"], given["y"], given["bench"])), name="0")

# %% base: inverse
base = csys(rp2t(base.pose[:3, :3].T, -base.pose[:3, :3].T @ base.pose[:3, 3]), name="0")

# %% base: the turn about z is left out
base = csys((given["x"], given["y"], given["bench"]), name="0", size=0.2)

# %% base: order
base = csys(rp2t(rotz(given["turn"] * deg), (0, 0, 0)) @ transl(base.pose[:3, 3]), name="0")

# %% tool: the turn about y is made about x
tool = csys(
    rp2t(rotx(given["tilt"] * deg), (0.4, 0, 0)) @ transl((given["tool"], 0, 0)), name="T"
)

# %% tool: change places
tool = csys(rp2t(roty(given["tilt"] * deg), (0.4 + given["tool"], 0, 0)), name="T", size=0.1)

# %% tool: wrong way round
tool = csys(
    rp2t(roty(-given["tilt"] * deg), (0.4, 0, 0)) @ transl((given["tool"], 0, 0)), name="T"
)

# %% arm: no-base
arm = robot(rows, "rrr", grasper=tool.pose, offset=(0, -90 * deg, 90 * deg))

# %% arm: no-tool
arm = robot(rows, "rrr", base=base.pose, offset=(0, -90 * deg, 90 * deg))

# %% arm: no-offset
arm = robot(rows, "rrr", base=base.pose, grasper=tool.pose)

# %% arm: no-offset
arm = robot(
    [dh(0, 0, 0.3, 0), dh(-90 * deg, 0, 0, -90 * deg), dh(0, 0.45, 0, 90 * deg)], "rrr",
    base=base.pose, grasper=tool.pose,
)

# %% arm: count from another zero
arm = robot(rows, "rrr", base=base.pose, grasper=tool.pose, offset=(0, 90 * deg, -90 * deg))

# %% arm: no-tool
arm = robot(rows, "rrr", base=base.pose, offset=(0, 0, 0))
