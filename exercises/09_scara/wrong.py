# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% scara: Joint 3 has the wrong letter
scara = robot(scara.own.chain.rows, "rrrr", grasper=scara.grasper)

# %% scara: tool is left out
scara = robot(scara.own.chain.rows, "rrpr")

# %% scara: convention
scara = robot(
    [
        dh(0, given["l1"], given["h"], 0),
        dh(180 * deg, given["l2"], 0, 0),
        dh(0, 0, 0, 0),
        dh(0, 0, given["tool"], 0),
    ],
    "rrpr",
)

# %% scara: not as far apart
scara = robot(
    [dh(0, 0, given["h"], 0), dh(0, given["l2"], 0, 0), dh(180 * deg, given["l1"], 0, 0),
     dh(0, 0, 0, 0)],
    "rrpr", grasper=scara.grasper,
)

# %% scara: count from another zero
scara = robot(
    [dh(0, 0, 0, 0), dh(0, given["l1"], 0, 0), dh(180 * deg, given["l2"], 0, 0), dh(0, 0, 0, 0)],
    "rrpr", grasper=scara.grasper,
)

# %% scara: the tip does not
scara = robot(
    [dh(0, 0, given["h"], 0), dh(0, given["l1"], 0, 0), dh(0, given["l2"], 0, 0), dh(0, 0, 0, 0)],
    "rrpr", grasper=scara.grasper,
)

# %% scara: millimetres
scara = robot(
    [
        dh(0, 0, 1000 * given["h"], 0),
        dh(0, 1000 * given["l1"], 0, 0),
        dh(180 * deg, 1000 * given["l2"], 0, 0),
        dh(0, 0, 0, 0),
    ],
    "rrpr",
    grasper=(0, 0, 1000 * given["tool"]),
)

# %% scara: another zero
scara = robot(scara.own.chain.rows, "rrpr", grasper=scara.grasper, offset=(0, 90 * deg, 0, 0))

# %% scara: fewer rows
scara = robot(
    [dh(0, 0, given["h"], 0), dh(0, given["l1"], 0, 0), dh(180 * deg, given["l2"], 0, 0)],
    "rrp", grasper=scara.grasper,
)

# %% scara: a list is no robot
scara = [dh(0, 0, given["h"], 0), dh(0, given["l1"], 0, 0)]
