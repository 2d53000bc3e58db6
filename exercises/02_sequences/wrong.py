# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% R_moving: fixed-moving
R_moving = roty(given["c"] * deg) @ rotx(given["b"] * deg) @ rotz(given["a"] * deg)

# %% R_moving: radians
R_moving = rotz(given["a"]) @ rotx(given["b"]) @ roty(given["c"])

# %% R_moving: inverse
R_moving = (rotz(given["a"] * deg) @ rotx(given["b"] * deg) @ roty(given["c"] * deg)).T

# %% R_moving: the turn about y is left out
R_moving = rotz(given["a"] * deg) @ rotx(given["b"] * deg)

# %% R_fixed: fixed-moving
R_fixed = rotz(given["a"] * deg) @ rotx(given["b"] * deg) @ roty(given["c"] * deg)

# %% R_fixed: sign-all
R_fixed = roty(-given["c"] * deg) @ rotx(-given["b"] * deg) @ rotz(-given["a"] * deg)

# %% R_fixed: the turn about x and the turn about z change places
R_fixed = roty(given["c"] * deg) @ rotz(given["a"] * deg) @ rotx(given["b"] * deg)

# %% wheel: reversed-order
def wheel(heading, lean, spin):
    return roty(spin) @ rotx(lean) @ rotz(heading)

# %% wheel: the turn about x and the turn about y change places
def wheel(heading, lean, spin):
    return rotz(heading) @ roty(spin) @ rotx(lean)

# %% wheel: the turn about x goes the wrong way round
def wheel(heading, lean, spin):
    return rotz(heading) @ rotx(-lean) @ roty(spin)

# %% wheel: the turn about y is made about z
def wheel(heading, lean, spin):
    return rotz(heading) @ rotx(lean) @ rotz(spin)
