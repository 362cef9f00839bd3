"""Mechanics: volumes, lattices, gyration, quaternions and rolling."""

from frame import Vector, equation, mp, mpf


@equation("mechanics-sphere-volume", cases=[dict(r=r) for r in (4e-9, 1.15e-8, 1e-6, 0.0)])
def sphere_volume(r):
    # Of the ball in n dimensions, n = 3.
    return dict(volume=mp.pi ** mpf(1.5) / mp.gamma(mpf(2.5)) * r**3)


@equation("mechanics-cap-volume", cases=[dict(r=4e-9, h=h) for h in (3e-10, 4e-9, 7e-9, 8e-9)] + [dict(r=1e-6, h=0.0)])
def cap_volume(r, h):
    # In slices.
    return dict(volume=mp.quad(lambda z: mp.pi * (r - z) * (r + z), [r - h, r]))


@equation("mechanics-hcp-cell", cases=[dict(d=d) for d in (8e-9, 2.3e-8, 1e-6, 3.1e-9)])
def hcp_cell(d):
    # A row at the origin, the next one in the hollows, and a sphere on three that touch each other.
    second = Vector(d / 2, mp.sqrt(d**2 - (d / 2) ** 2), 0)
    centre = (Vector(d, 0, 0) + second) / 3
    height = mp.sqrt(d**2 - centre.dot(centre))
    return dict(a=d, b=2 * second[1], c=2 * height)


PLACES = [[4e-9, -1e-8, 2.2e-8], [0.0, 7e-9, 0.0], [-3e-6, 5e-7, 1e-6], [1.1e-8, 1.1e-8, -1.1e-8]]
MASSES = [(1.1e-21, 7e-20), (5e-20, 5e-20), (2.3e-15, 8e-13), (8e-23, 9.9e-22)]


@equation("mechanics-gyration-term", cases=[dict(x=x, m=m, total=total) for x, (m, total) in zip(PLACES, MASSES)])
def gyration_term(x, m, total):
    return dict(square=[m * part**2 / total for part in x])


@equation("mechanics-own-gyration", cases=[dict(r=r, m=m, total=total) for r, (m, total) in zip((4e-9, 1.15e-8, 1e-6, 1.5e-9), MASSES)])
def own_gyration(r, m, total):
    return dict(square=m / total * r**2 / 3)


@equation(
    "mechanics-joined-distance",
    cases=[
        dict(m_a=2e-20, m_b=3e-20, total=5e-20, square_a=1e-16, square_b=2.5e-16, radius=3e-8),
        dict(m_a=1.1e-21, m_b=6.9e-20, total=7.01e-20, square_a=1.6e-17, square_b=4e-16, radius=2.1e-8),
        dict(m_a=2e-20, m_b=3e-20, total=5e-20, square_a=1e-15, square_b=2.5e-15, radius=3e-8),
        dict(m_a=4e-15, m_b=4e-15, total=8e-15, square_a=0.0, square_b=0.0, radius=1e-6),
    ],
)
def joined_distance(m_a, m_b, total, square_a, square_b, radius):
    # Two points add m_a m_b / M d^2 to the moments of the parts.
    left = total * radius**2 - (m_a * square_a + m_b * square_b)
    return dict(distance=mp.sqrt(left / (m_a * m_b / total)) if left > 0 else 0)


TURNS = [
    dict(a_0=0.5, a=[0.5, -0.5, 0.5], b_0=0.8, b=[0.0, 0.36, 0.48]),
    dict(a_0=0.8, a=[0.0, 0.36, 0.48], b_0=0.8000003, b=[1e-7, 0.3599995, 0.48]),
    dict(a_0=-0.28, a=[0.96, 0.0, 0.0], b_0=0.2799, b=[-0.96003, 1e-5, 0.0]),
    dict(a_0=1.0, a=[0.0, 0.0, 0.0], b_0=0.96, b=[0.28, 0.0, 0.0]),
    dict(a_0=0.6, a=[0.0, 0.8, 0.0], b_0=-0.6, b=[0.0, -0.8, 1e-6]),
]


def _unitary(q_0, q):
    """A quaternion as a matrix of complex numbers."""
    x, y, z = q
    return mp.matrix([[mp.mpc(q_0, -z), mp.mpc(-y, -x)], [mp.mpc(y, -x), mp.mpc(q_0, z)]])


def _parts(matrix):
    """The quaternion of a matrix."""
    return matrix[0, 0].real, Vector(-matrix[0, 1].imag, matrix[1, 0].real, -matrix[0, 0].imag)


def _between(a_0, a, b_0, b):
    return _parts(_unitary(b_0, b) * _unitary(a_0, a).H)


@equation("mechanics-quaternion-product", cases=TURNS)
def quaternion_product(a_0, a, b_0, b):
    scalar, vector = _parts(_unitary(a_0, a) * _unitary(b_0, b))
    return dict(scalar=scalar, vector=vector)


@equation("mechanics-rotation-vector", cases=TURNS)
def rotation_vector(a_0, a, b_0, b):
    scalar, vector = _between(a_0, a, b_0, b)
    return dict(theta=vector * (2 * mp.sign(scalar)))


@equation(
    "mechanics-turned-displacement", cases=[turn | dict(extent=extent) for turn, extent in zip(TURNS, (5e-8, 1.2e-7, 5e-9, 0.0, 3e-8))]
)
def turned_displacement(b_0, b, a_0, a, extent):
    return dict(d=2 * extent * _between(a_0, a, b_0, b)[1].norm())


@equation(
    "mechanics-rolled-path",
    cases=[
        dict(omega_i=[3e8, -2e8, 1e8], omega_j=[-1e8, 4e8, 2e8], n=[0.6, 0.0, 0.8], r=2e-9, dt=5e-13),
        dict(omega_i=[1e7, 2e7, -9e8], omega_j=[3e7, -1e7, 8e8], n=[0.0, 0.0, 1.0], r=5.75e-9, dt=1e-12),
        dict(omega_i=[-4e9, 1e9, 0.0], omega_j=[0.0, 0.0, 0.0], n=[-0.36, 0.48, 0.8], r=1.3e-9, dt=4e-14),
        dict(omega_i=[1e3, -2e3, 5e2], omega_j=[-1e3, 1e3, 1e3], n=[0.0, -0.6, 0.8], r=5e-7, dt=2e-10),
    ],
)
def rolled_path(omega_i, omega_j, n, r, dt):
    # What each sphere of the effective radius would roll on a plane, at its own velocity.
    path = lambda omega, arm: omega.cross(arm) * dt
    return dict(path=path(omega_i, n * r) - path(omega_j, n * r))
