"""Pham-Ba & Molinari 2022: the energy of a strained body, A.50 to A.61, and its elastic constants."""

from frame import equation, mp, mpf


def frame(phi, theta):
    """The unit vectors outwards, north and east at an azimuth and a latitude: the turned axes x, z and y."""
    (s, c), (n, m) = (mp.sin(phi), mp.cos(phi)), (mp.sin(theta), mp.cos(theta))
    about_z = mp.matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    about_y = mp.matrix([[m, 0, -n], [0, 1, 0], [n, 0, m]])
    turned = about_z * about_y
    return turned[:, 0], turned[:, 2], turned[:, 1]


def stretch(r, epsilon_x, epsilon_z, phi, theta):
    """What a strain adds to the vector to the neighbour, 2 r away."""
    strain = mp.matrix([[epsilon_x, 0, 0], [0, 0, 0], [0, 0, epsilon_z]])
    return strain * frame(phi, theta)[0] * (2 * r)


def component(axis, delta_x, delta_z, phi, theta):
    return (frame(phi, theta)[axis].T * mp.matrix([delta_x, 0, delta_z]))[0]


@equation("wear-A50")
def separation_x(r, epsilon_x, phi, theta):
    return dict(delta_x=stretch(r, epsilon_x, 0, phi, theta)[0])


@equation("wear-A51")
def separation_z(r, epsilon_z, theta):
    return dict(delta_z=stretch(r, 0, epsilon_z, mpf(0), theta)[2])


# The directions of some of the twelve neighbours and others, the strains of a patch test.
DIRECTIONS = [
    dict(delta_x=1.1e-11, delta_z=-2.5e-12, phi=0.7853981633974483, theta=0.0),
    dict(delta_x=-7.5e-12, delta_z=3.0e-11, phi=2.5, theta=0.7853981633974483),
    dict(delta_x=0.3, delta_z=0.45, phi=-1.25, theta=-0.5),
    dict(delta_x=0.0, delta_z=1.25e-11, phi=4.0, theta=1.2),
    dict(delta_x=2.0e-11, delta_z=0.0, phi=0.125, theta=-1.4375),
]


@equation("wear-A52", DIRECTIONS)
def separation_radial(delta_x, delta_z, phi, theta):
    return dict(delta_r=component(0, delta_x, delta_z, phi, theta))


@equation("wear-A53", DIRECTIONS)
def separation_meridional(delta_x, delta_z, phi, theta):
    return dict(delta_theta=component(1, delta_x, delta_z, phi, theta))


@equation("wear-A54", [dict(delta_x=case["delta_x"], phi=case["phi"]) for case in DIRECTIONS])
def separation_zonal(delta_x, phi):
    return dict(delta_phi=component(2, delta_x, 0, phi, mpf(0)))


@equation(
    "wear-A55",
    [
        dict(k_n=58.7, k_t=16.05, delta_n=1.1e-11, delta_theta=-2.5e-12, delta_phi=4.0e-12),
        dict(k_n=117.5, k_t=0.0, delta_n=-7.5e-12, delta_theta=3.0e-11, delta_phi=-1.0e-11),
        dict(k_n=42.5, k_t=14.75, delta_n=0.3, delta_theta=0.45, delta_phi=-0.125),
        dict(k_n=58.7, k_t=58.7, delta_n=0.0, delta_theta=0.0, delta_phi=2.0e-11),
        dict(k_n=0.0, k_t=16.05, delta_n=3.0e-11, delta_theta=1.5e-11, delta_phi=0.0),
    ],
)
def pair_strain_energy(k_n, k_t, delta_n, delta_theta, delta_phi):
    """Half the forces of the springs times the separations."""
    forces = (k_n * delta_n, k_t * delta_theta, k_t * delta_phi)
    return dict(u_pair=sum(f * d for f, d in zip(forces, (delta_n, delta_theta, delta_phi))) / 2)


def body_energy(r, k_n, k_t, epsilon_x, epsilon_z):
    """A.56 by quadrature. In the azimuth the energy has terms up to four times the angle, which the mean of eight equidistant
    angles integrates without error; in the sine of the latitude it is a polynomial of degree four, for which three nodes of
    Gauss suffice."""
    nodes = ((-mp.sqrt(mpf(3) / 5), mpf(5) / 9), (mpf(0), mpf(8) / 9), (mp.sqrt(mpf(3) / 5), mpf(5) / 9))
    total = mpf(0)
    for sine, weight in nodes:
        theta = mp.asin(sine)
        for k in range(8):
            phi = 2 * mp.pi * k / 8
            delta = stretch(r, epsilon_x, epsilon_z, phi, theta)
            parts = [component(axis, delta[0], delta[2], phi, theta) for axis in range(3)]
            total += weight * pair_strain_energy(k_n, k_t, *parts)["u_pair"]
    return total * 2 * mp.pi / 8 / 2


@equation("wear-A56")
def surrounded_energy(r, k_n, k_t, epsilon_x, epsilon_z):
    return dict(u=body_energy(r, k_n, k_t, epsilon_x, epsilon_z))


@equation("wear-A57", [dict(u=3.5e-20), dict(u=1.25e-18), dict(u=7.5), dict(u=0.0)])
def close_packed_energy(u):
    """Twelve times the mean over the sphere."""
    return dict(u_prime=12 * (u / (4 * mp.pi)))


@equation("wear-A58")
def close_packed_volume(r):
    """Of the cell that three neighbours span."""
    return dict(v=mp.det(mp.matrix([[0, 1, 1], [1, 0, 1], [1, 1, 0]]) * (mp.sqrt(2) * r)))


def slope(r, k_n, k_t, epsilon_x, epsilon_z):
    """The derivative of the energy per volume by the strain along x: of a parabola, its central difference of any width."""
    ahead, behind = (body_energy(r, k_n, k_t, epsilon_x + step, epsilon_z) for step in (1, -1))
    return 12 / (4 * mp.pi) * (ahead - behind) / 2 / close_packed_volume(r)["v"]


@equation("wear-A59")
def body_stress(r, k_n, k_t, epsilon_x, epsilon_z):
    return dict(sigma_x=slope(r, k_n, k_t, epsilon_x, epsilon_z))


@equation("wear-A60")
def constant_11(r, k_n, k_t):
    return dict(c_11=slope(r, k_n, k_t, mpf(1), mpf(0)))


@equation("wear-A61")
def constant_12(r, k_n, k_t):
    return dict(c_12=slope(r, k_n, k_t, mpf(0), mpf(1)))


@equation("wear-EnuFromC")
def elastic_moduli(c11, c12):
    """By a bar under a unit strain whose sides are free: (C11 + C12) e + C12 = 0 gives their strain e."""
    sideways = -c12 / (c11 + c12)
    return dict(nu=-sideways, e=c11 + 2 * c12 * sideways)
