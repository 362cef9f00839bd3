"""Pham-Ba & Molinari 2022: time steps, Eqs. 6, 21 and A.1 to A.19."""

from frame import equation, mp, mpf


def compose(first, then):
    """The matrix of two linear maps, one after the other."""
    return mp.matrix(then) * mp.matrix(first)


def limit(step, unit):
    """The smallest time step, in units of `unit`, for which the matrix of a step has the eigenvalue -1: the spectral radius
    grows beyond one there."""
    size = mp.eye(step(mpf(1)).rows)
    return unit * mp.findroot(lambda tau: mp.det(step(tau * unit) + size), (mpf(1) / 7, mpf(3)), solver="anderson")


def dashpot_step(m, k, c):
    """The matrix of a step of position and velocity: a kick by spring and dashpot, then a drift."""

    def step(dt):
        return compose([[1, 0], [-k * dt / m, 1 - c * dt / m]], [[1, dt], [0, 1]])

    return step


def stable(m, k, c):
    return limit(dashpot_step(m, k, c), 1 / max(mp.sqrt(k / m), c / m))


@equation("wear-6")
@equation("wear-A18")
def critical_time_step(m, k_n):
    """Of two equal masses: the one moves against the other as half a mass against a wall."""
    return dict(dt_c=stable(m / 2, k_n, mpf(0)))


@equation("wear-A17", [dict(m_eff=1.945e-24, k_n=58.7), dict(m_eff=2.4e-23, k_n=117.5), dict(m_eff=3.3e5, k_n=42.5)])
def pair_time_step_limit(m_eff, k_n):
    return dict(dt=stable(m_eff, k_n, mpf(0)))


@equation(
    "wear-dtlim",
    [
        dict(m=1.945e-24, k=58.7, c=6.8e-13),
        dict(m=2.4e-23, k=117.5, c=0.0),
        dict(m=3.3e5, k=0.0, c=235.0),
        dict(m=5.5625e-25, k=16.05, c=3.0e-11),
        dict(m=1.0, k=1.0, c=2.0),
    ],
)
def stable_time_step(m, k, c):
    return dict(dt_max=stable(m, k, c))


@equation("wear-dtlim-damped")
def damped_limit(zeta):
    """Of a unit mass on a unit spring, whose undamped limit is two."""
    return dict(ratio=stable(mpf(1), mpf(1), 2 * zeta) / 2)


@equation("wear-dtlim-tang")
def sliding_limit(nu):
    """Two solid spheres of unit mass and radius on the tangential spring alone: its length, their relative velocity across, and
    the sum of their spins. The springs are those of an isotropic solid, of C12 over C11 = nu over 1 - nu."""
    k_n, k_t = (1 - nu) + 2 * nu, (1 - nu) - 3 * nu
    inertia = mpf(2) / 5

    def step(dt):
        kick = [[1, 0, 0], [-2 * k_t * dt, 1, 0], [-2 * k_t * dt / inertia, 0, 1]]
        return compose(kick, [[1, dt, dt], [0, 1, 0], [0, 0, 1]])

    tangential, normal = limit(step, 1 / mp.sqrt(7 * k_t)), stable(mpf(1) / 2, k_n, mpf(0))
    return dict(ratio=tangential / normal, k_ratio=k_t / k_n)


def coincide(m, k):
    """The damping for which both rates of decay, the roots of m s^2 + c s + k, are the same."""
    return mp.sqrt(4 * m * k)


@equation("wear-21")
def critical_damping(k_n, m):
    return dict(c_c=coincide(m / 2, k_n))


@equation("wear-A19", [dict(k_n=58.7, m_eff=1.945e-24), dict(k_n=117.5, m_eff=2.4e-23), dict(k_n=42.5, m_eff=3.3e5)])
def critical_pair_damping(k_n, m_eff):
    return dict(c_c=coincide(m_eff, k_n))


@equation("wear-critical-drag")
def critical_drag(k_n, m):
    """Mirrored at the middle, either particle is on a spring of twice the stiffness that is held there."""
    return dict(c_g=coincide(m, 2 * k_n))


@equation("wear-A1")
def pair_accelerations(m_i, m_j, c_n, k_n, x_i, x_j, v_i, v_j):
    """The forces as the product of the matrix of a graph of one edge with the state."""
    edge = mp.matrix([[1, -1], [-1, 1]])
    force = -(edge * mp.matrix([x_i, x_j]) * k_n + edge * mp.matrix([v_i, v_j]) * c_n)
    return dict(a_i=force[0] / m_i, a_j=force[1] / m_j)


@equation(
    "wear-A2",
    [
        dict(m_eff=1.945e-24, c_n=6.8e-13, k_n=58.7, x=1.25e-10, v=-14.5),
        dict(m_eff=2.4e-23, c_n=0.0, k_n=117.5, x=-3.0e-11, v=20.0),
        dict(m_eff=3.3e5, c_n=59.5, k_n=42.5, x=0.3, v=0.002),
        dict(m_eff=1.945e-24, c_n=6.8e-13, k_n=58.7, x=0.0, v=10.0),
        dict(m_eff=1.945e-24, c_n=6.8e-13, k_n=58.7, x=3.29e-10, v=0.0),
    ],
)
def relative_acceleration(m_eff, c_n, k_n, x, v):
    """The difference of the accelerations of two equal masses."""
    pair = pair_accelerations(2 * m_eff, 2 * m_eff, c_n, k_n, x / 2, -x / 2, v / 2, -v / 2)
    return dict(a=pair["a_i"] - pair["a_j"])


@equation("wear-A4")
@equation("wear-A5")
def time_step(k_n, m_eff, dt, x, v):
    state = dashpot_step(m_eff, k_n, mpf(0))(dt) * mp.matrix([x, v])
    return dict(v_next=state[1], x_next=state[0])


@equation("wear-A6")
def pair_energy(k_n, m_eff, x, v):
    """The square of a length in the plane of position and velocity."""
    return dict(energy=abs(mp.mpc(mp.sqrt(k_n) * x, mp.sqrt(m_eff) * v)) ** 2 / 2)


@equation(
    "wear-A7",
    [
        dict(k_n=58.7, e_0=2.5e-22, x=1.25e-12),
        dict(k_n=117.5, e_0=1.6e-20, x=-1.5e-11),
        dict(k_n=42.5, e_0=3.25, x=0.3),
        dict(k_n=58.7, e_0=1.9e-22, x=0.0),
    ],
)
def scaled_position(k_n, e_0, x):
    """The root of the share of the energy that is in the spring."""
    return dict(x_hat=mp.sign(x) * mp.sqrt(k_n * x**2 / 2 / e_0))


@equation(
    "wear-A8",
    [
        dict(m_eff=1.945e-24, e_0=2.5e-22, v=14.5),
        dict(m_eff=2.4e-23, e_0=1.6e-20, v=-20.0),
        dict(m_eff=3.3e5, e_0=3.25, v=0.002),
        dict(m_eff=1.945e-24, e_0=1.9e-22, v=0.0),
    ],
)
def scaled_velocity(m_eff, e_0, v):
    """The root of the share of the energy that is in the motion."""
    return dict(v_hat=mp.sign(v) * mp.sqrt(m_eff * v**2 / 2 / e_0))


@equation(
    "wear-A9",
    [
        dict(x_hat=0.6, v_hat=0.8),
        dict(x_hat=-0.28, v_hat=0.96),
        dict(x_hat=0.0, v_hat=-1.0),
        dict(x_hat=1.0e-9, v_hat=1.0),
        dict(x_hat=-1.7, v_hat=-2.3),
    ],
)
def scaled_energy(x_hat, v_hat):
    return dict(norm=(mp.mpc(x_hat, v_hat) * mp.mpc(x_hat, -v_hat)).real)


@equation("wear-A10")
def scaled_time_step(k_n, m_eff, dt):
    return dict(h=dt / mp.sqrt(m_eff / k_n))


def scaled(h):
    """The matrix of a scaled step, by its kick and its drift."""
    return compose([[1, 0], [-h, 1]], [[1, h], [0, 1]])


@equation("wear-A11", [dict(h=0.2, x=0.6, v=0.8), dict(h=1.9, x=-0.28, v=0.96), dict(h=2.5, x=0.0, v=-1.0)])
def scaled_step(h, x, v):
    kicked = v - h * x
    return dict(v_next=kicked, x_next=x + h * kicked)


def named(matrix):
    return dict(a_xx=matrix[0, 0], a_xv=matrix[0, 1], a_vx=matrix[1, 0], a_vv=matrix[1, 1])


@equation("wear-A12", [dict(h=0.2), dict(h=1.9), dict(h=1.0), dict(h=0.0), dict(h=2.0), dict(h=6.28e-3)])
def amplification_matrix(h):
    return named(scaled(h))


@equation(
    "wear-A13",
    [
        dict(a_xx=0.96, a_xv=0.2, a_vx=-0.2, a_vv=1.0, x=0.6, v=0.8),
        dict(a_xx=-2.61, a_xv=1.9, a_vx=-1.9, a_vv=1.0, x=-0.28, v=0.96),
        dict(a_xx=-3.0, a_xv=2.0, a_vx=-2.0, a_vv=1.0, x=1.0, v=1.0),
        dict(a_xx=0.5, a_xv=-1.25, a_vx=0.75, a_vv=-0.1, x=0.0, v=-1.0),
    ],
)
def amplify(a_xx, a_xv, a_vx, a_vv, x, v):
    """The columns of the matrix, added up."""
    return dict(x_next=x * a_xx + v * a_xv, v_next=x * a_vx + v * a_vv)


@equation("wear-invariant")
def step_invariant(h, x, v):
    """A quadratic form that the step leaves as it is: M A is symmetric about the diagonal, M = [[1, -h/2], [-h/2, 1]]."""
    form = mp.matrix([[1, -h / 2], [-h / 2, 1]])
    state = mp.matrix([x, v])
    return dict(invariant=(state.T * form * state)[0])


def after(h, n, x, v):
    """Step by step."""
    for _ in range(int(n)):
        v -= h * x
        x += h * v
    return x, v


@equation("wear-A14")
def state_after(h, n, x_0, v_0):
    x, v = after(h, n, x_0, v_0)
    return dict(x=x, v=v)


@equation(
    "wear-A15",
    [
        dict(h=0.2, n=7.0),
        dict(h=1.0, n=6.0),
        dict(h=1.98, n=1000.0),
        dict(h=2.0, n=1000.0),
        dict(h=2.02, n=200.0),
        dict(h=1.9, n=4095.0),
        dict(h=0.1, n=0.0),
        dict(h=0.5, n=2.75),
    ],
)
def amplification_power(h, n):
    (a_xx, a_vx), (a_xv, a_vv) = after(h, n, mpf(1), mpf(0)), after(h, n, mpf(0), mpf(1))
    return dict(a_xx=a_xx, a_xv=a_xv, a_vx=a_vx, a_vv=a_vv)


@equation("wear-A16")
def eigenvalues(h):
    """By the angle that a step turns, or beyond two by the decay and growth of a step."""
    if h < 2:
        root = mp.expj(2 * mp.asin(h / 2))
        return dict(re_1=root.real, im_1=root.imag, re_2=root.real, im_2=-root.imag)
    rate = 2 * mp.acosh(h / 2)
    return dict(re_1=-mp.exp(-rate), im_1=mpf(0), re_2=-mp.exp(rate), im_2=mpf(0))
