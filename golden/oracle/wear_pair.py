"""Pham-Ba & Molinari 2022: the forces of Eqs. 1 to 5 and the kinematics of a pair."""

from frame import equation, mp, mpf

# Two particles of silica (Table 5), 0.75 and 1.5 nm in radius, that pass each other at some 10 m/s.
PAIR = dict(
    x_i=[1.35e-9, 0.62e-9, 1.31e-9],
    x_j=[-0.05e-9, 0.02e-9, -0.04e-9],
    v_i=[12.5, -3.25, 4.75],
    v_j=[-7.5, 2.0, -1.125],
    omega_i=[3.0e9, -8.5e9, 1.25e9],
    omega_j=[-2.5e9, 4.0e9, 6.0e9],
    r_i=0.75e-9,
    r_j=1.5e-9,
)
AT_REST = dict(v_i=[0.0, 0.0, 0.0], v_j=[0.0, 0.0, 0.0])


def only(names, *changes):
    """Cases of some of the arguments of the pair, with changes."""
    return [{name: dict(PAIR, **change)[name] for name in names} for change in changes]


@equation("wear-1")
def symplectic_euler(x, v, omega, force, torque, m, i, dt):
    """The position in closed form: the drift of the old velocity, and all of what the force adds to it."""
    return dict(v_next=v + force * (dt / m), x_next=x + v * dt + force * (dt**2 / m), omega_next=omega + torque * (dt / i))


@equation("wear-2")
def pair_force(f_n, c_n, v_n, n_n, f_t, c_t, v_t, n_t):
    return dict(force=[-(f_n * a + c_n * v_n * a) - (f_t * b + c_t * v_t * b) for a, b in zip(n_n, n_t)])


@equation(
    "wear-separation",
    only(
        ("x_i", "x_j", "v_i", "v_j", "r_i", "r_j"),
        {},
        dict(x_i=[0.3e-9, -2.4e-9, 0.1e-9], r_i=0.6e-9),
        dict(x_i=[0.0, 0.0, 3.0e-9], x_j=[0.0, 0.0, 0.75e-9], r_i=1.0e-9, r_j=1.25e-9),
        dict(AT_REST, x_j=[5.0e-8, -3.0e-8, 2.0e-8]),
        dict(x_i=[-2.9e-9, 3.1e-9, 1.7e-9], v_i=[-7.5, 2.0, -1.125], r_i=3.0e-9, r_j=2.25e-9),
    ),
)
def separation(x_i, x_j, v_i, v_j, r_i, r_j):
    """The rate of the squared distance, twice the distance times its rate, from where the pair is a unit of time before and
    after, if nothing stops it."""
    apart, moving = x_i - x_j, v_i - v_j
    d = apart.norm()
    before, after = (sum((a + time * b) ** 2 for a, b in zip(apart, moving)) for time in (-1, 1))
    return dict(delta_n=d - (r_i + r_j), n=apart / d, v_n=(after - before) / (4 * d))


def point_velocity(v, omega, lever):
    """Of a material point of a rigid body."""
    return v + omega.cross(lever)


def in_plane(u, n):
    """The part of a vector in the plane across `n`: twice turned by it."""
    return n.cross(u).cross(n)


def sliding(x_i, x_j, v_i, v_j, omega_i, omega_j, at):
    """The velocity of the material of i relative to that of j, in the plane of contact, at points given for either."""
    apart = x_i - x_j
    relative = point_velocity(v_i, omega_i, at[0] - x_i) - point_velocity(v_j, omega_j, at[1] - x_j)
    return in_plane(relative, apart / apart.norm())


def midpoint(x_i, x_j, r_i, r_j):
    """Halfway between the two surfaces."""
    n = (x_i - x_j) / (x_i - x_j).norm()
    return ((x_i - n * r_i) + (x_j + n * r_j)) / 2


@equation(
    "wear-sliding-velocity",
    only(
        tuple(PAIR),
        {},
        dict(x_i=[0.3e-9, -2.4e-9, 0.1e-9], r_i=0.6e-9),
        dict(AT_REST, omega_j=[0.0, 0.0, 0.0]),
        dict(omega_i=[0.0, 0.0, 0.0], omega_j=[0.0, 0.0, 0.0]),
        dict(AT_REST, x_i=[0.0, 0.0, 3.0e-9], x_j=[0.0, 0.0, 0.75e-9], omega_i=[1.0e9, 2.0e9, 5.0e9], omega_j=[-1.0e9, 2.0e9, 3.0e9]),
        dict(x_i=[-2.9e-9, 3.1e-9, 1.7e-9], v_i=[-7.5, 2.0, -1.125], r_i=3.0e-9, r_j=2.25e-9),
        dict(x_i=[0.35e-9, 0.31e-9, -0.17e-9], v_i=[9.0e2, -4.0e2, 1.0e3], r_i=0.75e-9, r_j=0.75e-9),
    ),
)
def sliding_velocity(x_i, x_j, v_i, v_j, omega_i, omega_j, r_i, r_j):
    point = midpoint(x_i, x_j, r_i, r_j)
    return dict(v_t=sliding(x_i, x_j, v_i, v_j, omega_i, omega_j, (point, point)))


@equation(
    "wear-arm",
    [
        dict(r=0.75e-9, delta_n=3.1e-10),
        dict(r=1.5e-9, delta_n=-2.5e-11),
        dict(r=3.75e-9, delta_n=0.0),
        dict(r=15.0, delta_n=-0.3),
        dict(r=75.0, delta_n=29.5),
    ],
)
def moment_arm(r, delta_n):
    """Half the distance of the centres of two such particles."""
    return dict(arm=(r + r + delta_n) / 2)


@equation(
    "wear-torque",
    [
        dict(arm=0.9e-9, force_t=[1.5e-9, -0.25e-9, 2.0e-9], n=[0.6, 0.0, 0.8]),
        dict(arm=1.65e-9, force_t=[-3.0e-9, 4.0e-9, 0.0], n=[0.0, 0.0, -1.0]),
        dict(arm=0.7375e-9, force_t=[0.0, 2.5e-9, 0.0], n=[-1.0, 0.0, 0.0]),
        dict(arm=14.85, force_t=[0.02, 0.05, -0.03], n=[0.36, 0.48, 0.8]),
        dict(arm=3.75e-9, force_t=[0.0, 0.0, 0.0], n=[0.0, 0.6, -0.8]),
    ],
)
def contact_torque(arm, force_t, n):
    """The contact point lies at -arm n, where the force acts."""
    lever = -n * arm
    return dict(torque=lever.cross(force_t))


@equation("wear-3")
def normal_force(k_n, delta_e, delta_f, delta_n):
    """The polygon of Figure 2, cut off at the fracture separation as in Figure A.1."""
    if delta_n > delta_f:
        return dict(f_n=mpf(0))
    if delta_n <= delta_e:
        return dict(f_n=k_n * delta_n)
    return dict(f_n=k_n * delta_e * (1 - (delta_n - delta_e) / (delta_f - delta_e)))


@equation("wear-potential")
def potential(k_n, delta_e, delta_f, delta_n):
    """The work of the force from here to where it ends; a line is integrated by Gauss's rule without error."""
    corners = [delta_n] + [corner for corner in (delta_e, delta_f) if delta_n < corner <= delta_f]
    force = lambda x: normal_force(k_n, delta_e, delta_f, x)["f_n"]
    return dict(v=-mp.quad(force, corners, method="gauss-legendre") if len(corners) > 1 else mpf(0))


@equation("wear-4")
def tangential_force(k_t, delta_t, f_mt_rescaled):
    return dict(f_t=k_t * delta_t if k_t * delta_t < f_mt_rescaled else f_mt_rescaled)


@equation("wear-trim")
def trimmed_distance(k_t, delta_t, f_mt_rescaled):
    return dict(delta_t_trimmed=f_mt_rescaled / k_t if k_t * delta_t > f_mt_rescaled else delta_t)


@equation("wear-5")
def rescaled_maximum(delta_n, delta_f, f_mt):
    """Figure 3: whole in contact, and from there a line down to nothing at the fracture separation."""
    if delta_n <= 0:
        return dict(f_mt_rescaled=f_mt)
    return dict(f_mt_rescaled=f_mt - f_mt * delta_n / delta_f if delta_n < delta_f else mpf(0))


@equation(
    "wear-spring",
    [
        dict(xi=[1.0e-11, -2.0e-11, 0.5e-11], n=[0.6, 0.0, 0.8], v_t=[8.0, 1.5, -6.0], dt=3.5e-14),
        dict(xi=[0.0, 0.0, 0.0], n=[0.0, 0.0, 1.0], v_t=[-12.0, 4.0, 0.0], dt=2.0e-14),
        dict(xi=[0.0, 3.0e-11, 0.0], n=[0.0, 1.0, 0.0], v_t=[5.0, 0.0, -2.5], dt=8.0e-14),
        dict(xi=[-4.0e-11, 1.25e-11, 2.0e-11], n=[0.36, -0.48, 0.8], v_t=[0.0, 0.0, 0.0], dt=3.5e-14),
        dict(xi=[0.3, 0.1, -0.2], n=[-0.8, 0.0, 0.6], v_t=[0.03, -0.05, 0.04], dt=0.7),
    ],
)
def stretched_spring(xi, n, v_t, dt):
    """By the projector 1 - n n. The normal counts as it is, also where its f64 are not a unit vector."""
    projector = mp.matrix(3, 3)
    for a in range(3):
        for b in range(3):
            projector[a, b] = (a == b) - n[a] * n[b]
    projected = projector * mp.matrix(list(xi))
    return dict(xi_next=[projected[a] + v_t[a] * dt for a in range(3)])


@equation(
    "wear-spring-energy",
    [
        dict(k_t=16.0, xi=[1.0e-11, -2.0e-11, 0.5e-11]),
        dict(k_t=32.25, xi=[0.0, 1.75e-10, 0.0]),
        dict(k_t=0.0, xi=[1.0e-11, 3.0e-11, -1.0e-11]),
        dict(k_t=11.5, xi=[-0.3, 0.125, 0.7]),
        dict(k_t=64.5, xi=[0.0, 0.0, 0.0]),
    ],
)
def spring_energy(k_t, xi):
    """The work of stretching the spring from nothing; a line is integrated by Gauss's rule without error."""
    return dict(u_t=mp.quad(lambda share: (xi * (k_t * share)).dot(xi), [0, 1], method="gauss-legendre"))
