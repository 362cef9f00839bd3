"""Laube et al. 2018, Sections 3 and 5: rigid aggregates, the tip, the constraint and the viscosity."""

from frame import Vector, equation, mp, mpf


def _turn(q_0, q):
    """The matrix of v + 2 q_0 q x v + 2 q x (q x v)."""
    x, y, z = q
    return mp.matrix(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - q_0 * z), 2 * (x * z + q_0 * y)],
            [2 * (x * y + q_0 * z), 1 - 2 * (x * x + z * z), 2 * (y * z - q_0 * x)],
            [2 * (x * z - q_0 * y), 2 * (y * z + q_0 * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _times(matrix, v):
    return Vector(*(matrix * mp.matrix(list(v))))


# Orientations of length one to rounding.
TURNS = [
    dict(q_0=0.5, q=[0.5, -0.5, 0.5]),
    dict(q_0=0.8, q=[0.0, 0.36, 0.48]),
    dict(q_0=-0.28, q=[0.96, 0.0, 0.0]),
    dict(q_0=0.0, q=[-0.6, 0.64, 0.48]),
]


@equation(
    "titania-to-space",
    cases=[
        TURNS[k] | dict(v=v) for k, v in enumerate(([1e-9, 2e-9, -3e-9], [4.2e-8, 0.0, 1e-9], [-1e-9, 5e-9, 2e-9], [7e-9, 7e-9, 1e-10]))
    ],
)
def to_space(q_0, q, v):
    return dict(v_space=_times(_turn(q_0, q), v))


MOMENTA = [[1e-27, -3e-27, 2e-27], [5e-28, 0.0, 4e-28], [-2e-26, 1e-26, 3e-27], [1e-27, 1e-27, -8e-28]]
MOMENTS = [[3e-36, 4e-36, 6e-36], [1e-37, 1e-37, 1.5e-37], [2e-35, 7e-35, 8e-35], [3e-36, 3e-36, 3e-36]]


@equation("titania-spin", cases=[TURNS[k] | dict(l=MOMENTA[k], i=MOMENTS[k]) for k in range(4)])
def spin(q_0, q, l, i):
    in_body = Vector(*(part / moment for part, moment in zip(l, i)))
    return dict(omega=_times(_turn(q_0, q), in_body), energy=l.dot(in_body) / 2)


@equation(
    "titania-free-rotation",
    cases=[TURNS[k] | dict(l=MOMENTA[k], i=MOMENTS[k], dt=dt) for k, dt in enumerate((5e-13, 1e-12, -2e-10, 3e-10))],
)
def free_rotation(q_0, q, l, i, dt):
    # The quaternion as a unitary matrix, whose generators are the Pauli matrices.
    sigma = [mp.matrix([[0, 1], [1, 0]]), mp.matrix([[0, -1j], [1j, 0]]), mp.matrix([[1, 0], [0, -1]])]
    state = q_0 * mp.eye(2)
    for part, matrix in zip(q, sigma):
        state -= 1j * part * matrix
    momentum = list(l)
    for axis, share in ((2, 2), (1, 2), (0, 1), (1, 2), (2, 2)):
        angle = 4 * mp.atan(momentum[axis] * dt / share / (4 * i[axis]))
        state = state * (mp.cos(angle / 2) * mp.eye(2) - 1j * mp.sin(angle / 2) * sigma[axis])
        # A vector that stays in space turns backwards in the body.
        first, second = (axis + 1) % 3, (axis + 2) % 3
        turned = mp.mpc(momentum[first], momentum[second]) * mp.expj(-angle)
        momentum[first], momentum[second] = turned.real, turned.imag
    parts = [mp.re(1j * (matrix * state)[0, 0] + 1j * (matrix * state)[1, 1]) / 2 for matrix in sigma]
    return dict(q_0_next=mp.re(state[0, 0] + state[1, 1]) / 2, q_next=Vector(*parts), l_next=Vector(*momentum))


MEMBERS = [
    dict(r=[4e-9, -1e-8, 2.2e-8], omega=[1e8, -3e8, 2e7], v=[0.5, -0.02, 1.3]),
    dict(r=[0.0, 7e-9, 0.0], omega=[4e7, 0.0, -1e9], v=[0.0, 0.0, -0.5]),
    dict(r=[-3e-8, 5e-9, 1e-9], omega=[-2e6, 5e6, 1e6], v=[12.0, 3.0, -7.0]),
    dict(r=[1.1e-8, 1.1e-8, -1.1e-8], omega=[1e9, 2e9, 4e9], v=[0.1, 0.2, 0.3]),
]


def _cross_matrix(v):
    x, y, z = v
    return mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


@equation("titania-member-velocity", cases=MEMBERS)
def member_velocity(v, omega, r):
    return dict(v_p=v + _times(_cross_matrix(omega), r))


@equation(
    "titania-aggregate-drag",
    cases=[
        dict(eta=1e-11, count=count, s=s, d_x=d_x, d_y=d_y, d_z=d_z, v=MEMBERS[k]["v"], omega=MEMBERS[k]["omega"])
        for k, (count, s, d_x, d_y, d_z) in enumerate(
            [
                (12.0, [1e-9, -2e-9, 5e-10], [3e-15, -1e-16, 2e-16], [-1e-16, 4e-15, 0.0], [2e-16, 0.0, 5e-15]),
                (1.0, [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
                (50.0, [-4e-9, 3e-9, 1e-8], [6e-14, 1e-15, -3e-15], [1e-15, 7e-14, 2e-15], [-3e-15, 2e-15, 8e-14]),
                (3.0, [2e-9, 1e-9, 0.0], [1e-16, 2e-17, 3e-17], [2e-17, 1e-16, 4e-17], [3e-17, 4e-17, 1e-16]),
            ]
        )
    ],
)
def aggregate_drag(eta, count, s, d_x, d_y, d_z, v, omega):
    arms = _cross_matrix(s)
    rates = mp.matrix([list(d_x), list(d_y), list(d_z)]) * mp.matrix(list(omega))
    force = v * count - _times(arms, omega)
    return dict(force=force * -eta, torque=(_times(arms, v) + Vector(*rates)) * -eta)


SPHERES = [(1.1e-21, 4e-9), (2.6e-21, 5.3e-9), (5e-20, 1.15e-8), (8e-23, 1.5e-9)]


@equation("titania-inertia", cases=[dict(m=m, r=r, x=member["r"]) for (m, r), member in zip(SPHERES, MEMBERS)])
def member_inertia(m, r, x):
    # A vector of the tensor is the angular momentum of a unit spin: x x (e x x).
    arms = _cross_matrix(x)
    tensor = mpf(2) / 5 * m * r**2 * mp.eye(3) - m * arms * arms
    return dict(inertia=[tensor[a, b] for a in range(3) for b in range(3)])


@equation(
    "titania-angular-momentum",
    cases=[dict(m=m, r=r, x=member["r"], v=member["v"], omega=member["omega"]) for (m, r), member in zip(SPHERES, MEMBERS)],
)
def member_momentum(m, r, x, v, omega):
    return dict(l=_times(_cross_matrix(x), v) * m + omega * (2 * m * r**2 / 5))


def _area(points):
    """The area below straight lines between points."""
    return sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(points, points[1:]))


@equation("titania-tip-linear")
def tip(v_0, t_turn, t):
    at = lambda time: v_0 * max(-1, min(1, 2 * time / t_turn - 1))
    if t < 0:
        return dict(v=at(t), z=v_0 * -t)
    corners = [time for time in (0, t_turn) if time < t] + [t]
    return dict(v=at(t), z=_area([(time, at(time)) for time in corners]))


@equation(
    "titania-ramp", cases=[dict(t=t, ramp=ramp) for t, ramp in [(1e-9, 5e-9), (7e-9, 5e-9), (3e-9, 0.0), (4.9e-9, 5e-9), (0.0, 5e-9)]]
)
def ramped_time(t, ramp):
    share = lambda time: min(1, time / ramp) if ramp > 0 else 1
    corners = [0] + [time for time in (ramp,) if 0 < time < t] + [t]
    return dict(tau=_area([(time, share(time)) for time in corners]))


@equation(
    "titania-harmonic",
    cases=[
        dict(k=160.0, z=z, z_0=z_0, v=5.0, t=t)
        for z, z_0, t in [(1.3e-8, 1e-9, 2e-9), (1e-9, 1e-9, 1e-10), (-4e-9, 2e-9, 0.0), (7.5e-8, -3e-9, 1.55e-8)]
    ],
)
def steering(k, z, z_0, v, t):
    target = z_0 + v * t
    return dict(f=k * (target - z))


@equation("titania-viscous", cases=[dict(eta=1e-11, v=member["v"]) for member in MEMBERS])
def drag(eta, v):
    return dict(force=Vector(*(-part * eta for part in v)))
