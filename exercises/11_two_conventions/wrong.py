# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% to_modified: convention
to_modified = [dh(alpha * deg, a, d, theta * deg) for alpha, a, d, theta in given["standard"]]

# %% to_modified: enclose another angle
links = [(alpha * deg, a) for alpha, a, _, _ in given["standard"]] + [(0, 0)]
joints = [(d, theta * deg) for _, _, d, theta in given["standard"]]
to_modified = [dh(*links[k + 1], *joints[k]) for k in range(3)]

# %% to_modified: degrees
to_modified = [
    (0, 0, *given["standard"][0][2:]),
    (*given["standard"][0][:2], *given["standard"][1][2:]),
    (*given["standard"][1][:2], *given["standard"][2][2:]),
]

# %% to_modified: more rows
to_modified = [*to_modified, dh(given["standard"][2][0] * deg, given["standard"][2][1], 0, 0)]

# %% behind: wrong way round
behind = rp2t(rotx(-alpha), (a, 0, 0))

# %% behind: radians
behind = rp2t(rotx(given["standard"][2][0]), (a, 0, 0))

# %% behind: inverse
behind = rp2t(rotx(-alpha), (-a, 0, 0))

# %% behind: is left out
behind = rp2t(rotx(alpha), (0, 0, 0))

# %% behind: shape (3, 3)
behind = rotx(alpha)

# %% to_standard: convention
to_standard = [dh(alpha * deg, a, d, theta * deg) for alpha, a, d, theta in given["modified"]]

# %% to_standard: shape (3, 2)
to_standard = [(alpha * deg, a) for alpha, a, _, _ in given["modified"]]

# %% to_standard: fewer rows
to_standard = to_standard[:2]
