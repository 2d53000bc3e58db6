# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% arm_table: enclose another angle
arm_table = [
    dh(0, 0, 0, 0),
    dh(-90 * deg, 0, 0, 0),
    dh(-90 * deg, given["upper"], given["aside"], 0),
    dh(-90 * deg, given["step"], given["fore"], 0),
]

# %% arm_table: a-d-3
arm_table = [
    dh(0, 0, 0, 0),
    dh(-90 * deg, 0, 0, 0),
    dh(0, given["aside"], given["upper"], 0),
    dh(-90 * deg, given["step"], given["fore"], 0),
]

# %% arm_table: convention
arm_table = [
    dh(-90 * deg, 0, 0, 0),
    dh(0, given["upper"], 0, -45 * deg),
    dh(-90 * deg, given["step"], given["aside"], -45 * deg),
    dh(90 * deg, 0, given["fore"], 0),
]

# %% arm_table: degrees
arm_table = [
    (0, 0, 0, 0),
    (-90, 0, 0, -45),
    (0, given["upper"], given["aside"], -45),
    (-90, given["step"], given["fore"], 0),
]

# %% arm_table: joints 3 and 4 are not as far apart
arm_table = [
    dh(0, 0, 0, 0),
    dh(-90 * deg, 0, 0, 0),
    dh(0, given["upper"], given["aside"], 0),
    dh(-90 * deg, 0, given["fore"], 0),
]

# %% arm_table: look at rows 3 and 4
arm_table = [
    dh(0, 0, 0, 0),
    dh(-90 * deg, 0, 0, 0),
    dh(0, given["upper"], 0, 0),
    dh(-90 * deg, given["step"], given["fore"], 0),
]

# %% arm_table: enclose another angle
arm_table = [
    dh(0, 0, 0, 0),
    dh(0, 0, 0, 0),
    dh(0, given["upper"], given["aside"], 0),
    dh(-90 * deg, given["step"], given["fore"], 0),
]

# %% table: along the axis of joint 4
table = [
    *arm_table[:3], dh(-90 * deg, given["step"], 0, 0), dh(90 * deg, 0, given["fore"], 0),
    dh(-90 * deg, 0, 0, 0),
]

# %% table: sign-d-4
table = [
    *arm_table[:3], dh(90 * deg, given["step"], given["fore"], 0), dh(-90 * deg, 0, 0, 0),
    dh(90 * deg, 0, 0, 0),
]

# %% table: fewer rows
table = [*arm_table, dh(90 * deg, 0, 0, 0)]

# %% table: enclose another angle
table = [*arm_table, dh(0, 0, 0, 0), dh(90 * deg, 0, 0, 0)]
