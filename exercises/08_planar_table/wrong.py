# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% table: standard convention
table = [dh(0, given["l1"], 0, 0), dh(0, given["l2"], 0, 0), dh(0, given["l3"], 0, 0)]

# %% table: a and d are exchanged
table = [dh(0, 0, 0, 0), dh(0, 0, given["l1"], 0), dh(0, given["l2"], 0, 0)]

# %% table: in this order
table = [(30 * deg, 0, 0, 0), (50 * deg, 0, given["l1"], 0), (-40 * deg, 0, given["l2"], 0)]

# %% table: millimetres
table = [dh(0, 0, 0, 0), dh(0, 1000 * given["l1"], 0, 0), dh(0, 1000 * given["l2"], 0, 0)]

# %% table: not as far apart
table = [dh(0, 0, 0, 0), dh(0, given["l2"], 0, 0), dh(0, given["l1"], 0, 0)]

# %% table: enclose another angle
table = [dh(0, 0, 0, 0), dh(90 * deg, given["l1"], 0, 0), dh(0, given["l2"], 0, 0)]

# %% table: more rows
table = [
    dh(0, 0, 0, 0), dh(0, given["l1"], 0, 0), dh(0, given["l2"], 0, 0), dh(0, given["l3"], 0, 0)
]

# %% table: shape (3, 3)
table = [(0, 0, 0), (0, given["l1"], 0), (0, given["l2"], 0)]

# %% table_upright: the axis of joint 1 does not lie where it should
table_upright = table

# %% table_upright: degrees
table_upright = [[90, 0, 0, 30], [0, given["l1"], 0, 50], [0, given["l2"], 0, -40]]

# %% table_upright: enclose another angle
table_upright = [
    dh(90 * deg, 0, 0, 0), dh(90 * deg, given["l1"], 0, 0), dh(90 * deg, given["l2"], 0, 0)
]
