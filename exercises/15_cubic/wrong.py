# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% cubic: reversed-coefficients
def cubic(q0, qt, T):
    return np.array([q0, 0, 3 * (qt - q0) / T**2, -2 * (qt - q0) / T**3])

# %% cubic: line
def cubic(q0, qt, T):
    return np.array([0, 0, (qt - q0) / T, q0])

# %% cubic: factors-exchanged
def cubic(q0, qt, T):
    return np.array([-3 * (qt - q0) / T**3, 2 * (qt - q0) / T**2, 0, q0])

# %% cubic: sign-c3
def cubic(q0, qt, T):
    return np.array([2 * (qt - q0) / T**3, 3 * (qt - q0) / T**2, 0, q0])

# %% cubic: no-start
def cubic(q0, qt, T):
    return np.array([-2 * (qt - q0) / T**3, 3 * (qt - q0) / T**2, 0, 0])

# %% cubic: end-for-way
def cubic(q0, qt, T):
    return np.array([-2 * qt / T**3, 3 * qt / T**2, 0, q0])

# %% cubic: powers-lost
def cubic(q0, qt, T):
    return np.array([-2 * (qt - q0), 3 * (qt - q0), 0, q0])

# %% cubic: shape (3,)
def cubic(q0, qt, T):
    return np.array([-2 * (qt - q0) / T**3, 3 * (qt - q0) / T**2, q0])

# %% position: time-not-shifted
def position(t, q0, qt, start, end):
    return np.polyval(cubic(q0, qt, end - start), t)

# %% position: end-for-duration
def position(t, q0, qt, start, end):
    return np.polyval(cubic(q0, qt, end), t - start)

# %% position: time-shifted-back
def position(t, q0, qt, start, end):
    return np.polyval(cubic(q0, qt, end - start), t + start)

# %% position: time-backwards
def position(t, q0, qt, start, end):
    return np.polyval(cubic(q0, qt, end - start), start - t)

# %% position: instant
def position(t, q0, qt, start, end):
    return np.polyval(cubic(q0, qt, t[-1] - t[0]), t - t[0])

# %% position: line
def position(t, q0, qt, start, end):
    return q0 + (qt - q0) * (t - start) / (end - start)

# %% position: reversed-coefficients
def position(t, q0, qt, start, end):
    return np.polyval(cubic(q0, qt, end - start)[::-1], t - start)

# %% velocity: powers-not-multiplied
def velocity(t, q0, qt, start, end):
    c = cubic(q0, qt, end - start)
    return np.polyval(c[:3], t - start)

# %% velocity: the position is given
def velocity(t, q0, qt, start, end):
    return position(t, q0, qt, start, end)

# %% velocity: is there a return at the end?
def velocity(t, q0, qt, start, end):
    np.gradient(position(t, q0, qt, start, end), t)
