# %% [markdown]
# Typical wrong answers, and the diagnosis meant for each.

# %% finger_tip: no-tool
def finger_tip(q):
    a, b = given["a"] / 1000, given["b"] / 1000
    rows = [dh(pi, 0, 0, q[0]), dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    return np.linalg.multi_dot([link_transform(row) for row in rows])

# %% finger_tip: reversed-order
def finger_tip(q):
    a, b, c = given["a"] / 1000, given["b"] / 1000, given["c"] / 1000
    rows = [dh(pi, 0, 0, q[0]), dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    return np.linalg.multi_dot([link_transform(row) for row in rows[::-1]]) @ transl((c, 0, 0))

# %% finger_tip: skipped-1
def finger_tip(q):
    a, b, c = given["a"] / 1000, given["b"] / 1000, given["c"] / 1000
    rows = [dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    return np.linalg.multi_dot([link_transform(row) for row in rows]) @ transl((c, 0, 0))

# %% finger_tip: convention
def finger_tip(q):
    a, b, c = given["a"] / 1000, given["b"] / 1000, given["c"] / 1000
    rows = [dh(pi, 0, 0, q[0]), dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    T = np.linalg.multi_dot([link_transform(row, "standard") for row in rows])
    return T @ transl((c, 0, 0))

# %% finger_tip: millimetres
def finger_tip(q):
    a, b, c = given["a"], given["b"], given["c"]
    rows = [dh(pi, 0, 0, q[0]), dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    return np.linalg.multi_dot([link_transform(row) for row in rows]) @ transl((c, 0, 0))

# %% finger_tip: sign-alpha-2
def finger_tip(q):
    a, b, c = given["a"] / 1000, given["b"] / 1000, given["c"] / 1000
    rows = [dh(pi, 0, 0, q[0]), dh(pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    return np.linalg.multi_dot([link_transform(row) for row in rows]) @ transl((c, 0, 0))

# %% finger_tip: shape (3,)
def finger_tip(q):
    a, b, c = given["a"] / 1000, given["b"] / 1000, given["c"] / 1000
    rows = [dh(pi, 0, 0, q[0]), dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    T = np.linalg.multi_dot([link_transform(row) for row in rows])
    return T[:3, :3] @ [c, 0, 0] + T[:3, 3]

# %% finger_tip: taken for degrees
def finger_tip(q):
    a, b, c = given["a"] / 1000, given["b"] / 1000, given["c"] / 1000
    q = np.array(q) * deg
    rows = [dh(pi, 0, 0, q[0]), dh(-pi / 2, 0, 0, q[1]), dh(0, a, 0, q[2]), dh(0, b, 0, q[3])]
    return np.linalg.multi_dot([link_transform(row) for row in rows]) @ transl((c, 0, 0))

# %% thumb_in_hand: no-base
def thumb_in_hand(q):
    T = np.eye(4)
    for (alpha, a), angle in zip(links, q, strict=True):
        T = T @ link_transform(dh(alpha, a, 0, angle))
    return T @ transl((0.030, 0, 0))
links = [(pi, 0), (-pi / 2, 0.015), (0, 0.050), (0, 0.040)]

# %% thumb_in_hand: base-side
def thumb_in_hand(q):
    T = np.eye(4)
    for (alpha, a), angle in zip(links, q, strict=True):
        T = T @ link_transform(dh(alpha, a, 0, angle))
    return T @ transl((0.030, 0, 0)) @ rp2t(roty(pi / 2), (0.040, 0.030, -0.015))
links = [(pi, 0), (-pi / 2, 0.015), (0, 0.050), (0, 0.040)]

# %% thumb_in_hand: no-tool
def thumb_in_hand(q):
    T = rp2t(roty(pi / 2), (0.040, 0.030, -0.015))
    for (alpha, a), angle in zip(links, q, strict=True):
        T = T @ link_transform(dh(alpha, a, 0, angle))
    return T
links = [(pi, 0), (-pi / 2, 0.015), (0, 0.050), (0, 0.040)]

# %% thumb_in_hand: raised
def thumb_in_hand(q):
    return link_transform(dh(pi, 0, 0, q[1])) @ link_transform(dh(-pi / 2, 0.015, 0, q[4]))
