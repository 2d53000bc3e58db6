# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% index: limits-missing
index = robot(index.own.chain.rows, "rrrr", name="index", base=index.base, grasper=index.grasper)

# %% index: limits-degrees
index = robot(
    index.own.chain.rows, "rrrr", name="index", base=index.base, grasper=index.grasper,
    limits=[given["index"]["spread"], (-90, 0), (-90, 0), (-90, 0)],
)

# %% index: no-base
index = robot(
    index.own.chain.rows, "rrrr", name="index", grasper=index.grasper, limits=index.limits
)

# %% index: no-tool
index = robot(index.own.chain.rows, "rrrr", name="index", base=index.base, limits=index.limits)

# %% index: the upper limit of joint 1
index = robot(
    index.own.chain.rows, "rrrr", name="index", base=index.base, grasper=index.grasper,
    limits=[(-20 * deg, 20 * deg), *index.limits[1:]],
)

# %% index: joints 2 and 3 are not as far apart
index = robot(
    [dh(pi, 0, 0, 0), dh(-pi / 2, 0, 0, 0), dh(0, given["index"]["b"] / 1000, 0, 0),
     dh(0, given["index"]["a"] / 1000, 0, 0)],
    "rrrr", name="index", base=index.base, grasper=index.grasper, limits=index.limits,
)

# %% index: limits-sense
index = robot(
    [dh(0, 0, 0, 0), *index.own.chain.rows[1:]], "rrrr", name="index", base=index.base,
    grasper=index.grasper, limits=index.limits,
)

# %% index: fewer rows
index = robot(
    index.own.chain.rows[1:], "rrr", name="index", base=index.base, grasper=index.grasper
)

# %% hand: fewer chains
hand = robot_complex(thumb(), finger("index"), finger("middle"), finger("ring"), name="hand")

# %% hand: parts-order
hand = robot_complex(
    finger("index"), finger("middle"), finger("ring"), finger("little"), thumb(), name="hand"
)

# %% hand: which ones are joined
hand = finger("index")

# %% hand: a list is no robot
hand = [thumb(), finger("index"), finger("middle"), finger("ring"), finger("little")]

# %% hand: no-base
hand = robot_complex(
    thumb().set(base=rp2t(roty(0), (0, 0, 0))), finger("index"), finger("middle"), finger("ring"),
    finger("little"), name="hand",
)

# %% hand: each part is right by itself
hand = robot_complex(
    thumb(), finger("index"), finger("middle"), finger("ring"), finger("little"), name="hand",
)
hand.base = (0, 0, 0.1)
