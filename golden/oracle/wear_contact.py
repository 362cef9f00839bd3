"""Pham-Ba & Molinari 2022: the contact law as a whole, as the paper and as the authors' program read it."""

from frame import Vector, equation
from wear_material import force_parameters
from wear_pair import in_plane, midpoint, normal_force, rescaled_maximum, separation, sliding

# Two particles of silica (Table 5) with a diameter of 1.5 nm in elastic tension.
SMALL = dict(
    x_i=[1.15e-9, 0.6e-9, 1.1e-9],
    x_j=[0.05e-9, 0.05e-9, -0.05e-9],
    v_i=[6.25, -2.5, 3.75],
    v_j=[-3.5, 1.75, 0.5],
    omega_i=[3.0e9, -8.5e9, 1.25e9],
    omega_j=[-2.5e9, 4.0e9, 6.0e9],
    r_i=0.75e-9,
    r_j=0.75e-9,
    m_i=3.89e-24,
    m_j=3.89e-24,
    e=7.3e10,
    nu=0.17,
    sigma_mn=1.6e10,
    sigma_mt=9.0e9,
    gamma=1.5,
    eta=0.9,
    s=0.5,
    xi=[1.0e-11, -2.0e-11, 0.5e-11],
    dt=2.0e-14,
)
OVERLAP = dict(x_i=[0.95e-9, 0.55e-9, 0.95e-9])
WEAKENING = dict(x_i=[1.265e-9, 0.65e-9, 1.2175e-9])
FAR = dict(x_i=[1.4e-9, 0.7e-9, 1.3e-9])
SLIPS = dict(xi=[4.0e-10, -2.5e-10, -1.0e-10])
# Beyond the critical diameter of 1.7 nm.
LARGE = dict(r_i=1.5e-9, r_j=2.25e-9, m_i=3.11e-23, m_j=1.05e-22, x_i=[2.75e-9, 1.4e-9, 2.7e-9])
# The material of the patch tests (Table 4).
TABLE_4 = dict(
    e=1.0, nu=0.15, sigma_mn=0.2, sigma_mt=0.1, gamma=1.5, eta=0.95, r_i=50.0, r_j=60.0, m_i=5.2e5, m_j=9.0e5,
    x_i=[70.0, 40.0, 80.0], x_j=[-5.0, 1.0, 2.5], v_i=[0.01, -0.02, 0.03], v_j=[-0.015, 0.01, 0.005],
    omega_i=[1.0e-3, 2.0e-3, -1.0e-3], omega_j=[-5.0e-4, 1.0e-3, 2.5e-3], xi=[0.5, -1.0, 0.25], dt=5.0,
)  # fmt: skip
CASES = [
    dict(SMALL, **change)
    for change in (
        {},
        OVERLAP,
        dict(OVERLAP, **SLIPS),
        SLIPS,
        dict(WEAKENING, xi=[1.0e-12, -2.0e-12, 0.5e-12]),
        dict(WEAKENING, **SLIPS),
        FAR,
        LARGE,
        dict(LARGE, **SLIPS),
        dict(LARGE, s=0.0),
        dict(LARGE, x_i=[3.15e-9, 1.6e-9, 2.85e-9]),
        dict(OVERLAP, nu=0.25),
        dict(OVERLAP, nu=0.0, eta=1.0),
        dict(OVERLAP, xi=[0.0, 0.0, 0.0], eta=0.0),
        dict(v_i=[6.25e2, -2.5e2, 3.75e2], s=0.0),
        TABLE_4,
        dict(TABLE_4, x_i=[60.0, 35.0, 75.0], xi=[7.0, -3.0, 4.0]),
        dict(TABLE_4, dt=0.0),
    )
]


def kinematics(x_i, x_j, v_i, v_j, r_i, r_j, **_):
    found = separation(x_i, x_j, v_i, v_j, r_i, r_j)
    return found["delta_n"], found["n"], found["v_n"]


def material_of(inputs):
    names = ("e", "nu", "sigma_mn", "sigma_mt", "gamma", "eta", "s", "r_i", "r_j", "m_i", "m_j")
    return force_parameters(**{name: inputs[name] for name in names})


def outcome(p, inputs, force_t, at, spring):
    """The force on i, and the torques of a tangential force that acts at two points, on i and, reversed, on j."""
    delta_n, n, v_n = kinematics(**inputs)
    normal = normal_force(p["k_n"], p["delta_e"], p["delta_f"], delta_n)["f_n"] + p["c_n"] * v_n
    return dict(
        force=force_t - n * normal,
        torque_i=(at[0] - inputs["x_i"]).cross(force_t),
        torque_j=(at[1] - inputs["x_j"]).cross(-force_t),
        xi_next=spring,
    )


def nothing():
    return {name: Vector(0, 0, 0) for name in ("force", "torque_i", "torque_j", "xi_next")}


def law(inputs, points, slip):
    """`points`: where the tangential force acts on i and j; `slip`: the force and the spring that remain of a stretched one."""
    p = material_of(inputs)
    delta_n, n, _ = kinematics(**inputs)
    if delta_n > p["delta_f"]:
        return nothing()
    v_t = sliding(*(inputs[name] for name in ("x_i", "x_j", "v_i", "v_j", "omega_i", "omega_j")), points)
    stretched = in_plane(inputs["xi"], n) + v_t * inputs["dt"]
    cap = rescaled_maximum(delta_n, p["delta_f"], p["f_mt"])["f_mt_rescaled"]
    return outcome(p, inputs, *slip(p, stretched, v_t, cap, points))


@equation("wear-contact", CASES)
def contact(**inputs):
    point = midpoint(*(inputs[name] for name in ("x_i", "x_j", "r_i", "r_j")))

    def slip(p, spring, v_t, cap, points):
        longest = cap / p["k_t"] if p["k_t"] > 0 else None
        if longest is not None and spring.norm() > longest:
            spring = spring / spring.norm() * longest
        return -(spring * p["k_t"] + v_t * p["c_t"]), points, spring

    return law(inputs, (point, point), slip)


@equation("wear-published-contact")
def published_contact(**inputs):
    """The arms are the radii: the force acts at the surface of either particle."""
    x_i, x_j, r_i, r_j = (inputs[name] for name in ("x_i", "x_j", "r_i", "r_j"))
    n = (x_i - x_j) / (x_i - x_j).norm()

    def slip(p, spring, v_t, cap, points):
        both = spring * p["k_t"] + v_t * p["c_t"]
        if both.norm() > cap:
            both = both / both.norm() * cap
            spring = (both - v_t * p["c_t"]) / p["k_t"]
        return -both, points, spring

    return law(inputs, (x_i - n * r_i, x_j + n * r_j), slip)
