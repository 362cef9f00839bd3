"""Laube et al. 2018, Eqs. 3 to 5 and the adsorbed water: what attracts two particles."""

from frame import Vector, equation, mp, mpf


# Decay and oscillation in one: exp(-(1 - 2 pi i) x / sigma).
def _wave(sigma):
    return mp.mpc(1, -2 * mp.pi) / sigma


@equation("titania-3")
def attraction(f_cap, f_solv, n):
    return dict(f_na=Vector(0, 0, 0) - n * f_cap - n * f_solv)


@equation("titania-03-normal", cases=[dict(f_cap=a, f_solv=b) for a, b in ((1e-9, 8.8e-10), (3e-9, 0.0), (5e-9, 3.3e-9), (7e-9, -5.5e-9))])
def attraction_along_normal(f_cap, f_solv):
    return dict(f_na=-f_cap - f_solv)


@equation("titania-4")
def solvation_force(f_0, d, r_i, r_j, sigma):
    return dict(f_solv=f_0 * mp.re(mp.exp(-_wave(sigma) * (d - r_i - r_j))))


@equation("titania-04-int")
def solvation_integral(f_0, x, sigma):
    return dict(u=-f_0 * mp.re(mp.exp(-_wave(sigma) * x) / _wave(sigma)))


@equation(
    "titania-04-slope",
    cases=[
        dict(f_0=-2.06e-8, x=1.3e-10, sigma=2.5e-10),
        dict(f_0=-2.06e-8, x=-5e-11, sigma=2.5e-10),
        dict(f_0=-3.5e-8, x=1.1e-9, sigma=2.5e-10),
    ],
)
def solvation_slope(f_0, x, sigma):
    return dict(slope=-f_0 * mp.re(_wave(sigma) * mp.exp(-_wave(sigma) * x)))


@equation("titania-5")
def amplitude(r_star, f_00, slope):
    return dict(f_0=f_00 + r_star * slope)


@equation("titania-Rstar")
def effective_radius(r_i, r_j):
    mean = 2 / (1 / r_i + 1 / r_j)
    return dict(r_star=mean, r_eff=mean / 2)


@equation("titania-kelvin", cases=[dict(gamma=0.072, kt=4.141947e-21, volume=2.99e-29, rh=0.85)])
def kelvin(gamma, kt, volume, rh):
    suction = -kt * mp.log(rh) / volume
    return dict(suction=suction, r_k=gamma / suction)


def _between(rows, x):
    """Linear interpolation in a table, constant beyond its end."""
    for (x_0, y_0), (x_1, y_1) in zip(rows, rows[1:]):
        if x <= x_1:
            share = (x - mpf(x_0)) / (mpf(x_1) - mpf(x_0))
            return (1 - share) * mpf(y_0) + share * mpf(y_1)
    return mpf(rows[-1][1])


# Humidity against the thickness in nm and, by core diameter in nm, the surface tension in N/m, of the authors' program: doubles there and here.
LAYER = [(0.0, 0.262533), (0.123667, 0.262533), (0.247692, 0.330526), (0.422529, 0.4097), (0.629865, 0.486277)]
LAYER += [(0.793, 0.574083), (0.897458, 0.697542), (0.951875, 0.809125)]
FOUR = [(0.0, 0.109052), (0.184389, 0.109052), (0.402225, 0.095479), (0.577136, 0.081527), (0.725398, 0.06858)]
FOUR += [(0.897598, 0.063857), (1.028767, 0.058307)]
SIX = [(0.0, 0.107892), (0.131611, 0.107892), (0.286943, 0.086195), (0.59432, 0.065728), (0.826887, 0.060347), (1.0, 0.0523)]
EIGHT = [(0.0, 0.098067), (0.134375, 0.098067), (0.261, 0.090194), (0.578747, 0.064652), (0.796143, 0.057125), (1.0, 0.0523)]
TEN = [(0.0, 0.081457), (0.123667, 0.081457), (0.247692, 0.067124), (0.422529, 0.062073), (0.629865, 0.055896)]
TEN += [(0.793, 0.053576), (0.897458, 0.051417), (0.951875, 0.0523)]


@equation("titania-water-layer", cases=[dict(rh=rh, nanometre=1e-9) for rh in (0.05, 0.2, 0.35, 0.5, 0.7, 0.85, 0.92, 0.97)])
def water_layer(rh, nanometre):
    return dict(h_w=nanometre * _between(LAYER, rh))


@equation(
    "titania-surface-tension",
    cases=[
        dict(d_core=d * 1e-9, rh=rh, scale=scale, nanometre=1e-9, newton_per_metre=1.0)
        for d, rh, scale in [
            (3.43, 0.1, 1.0),
            (3.43, 0.5, 1.5224308826),
            (4.43, 0.95, 1.0),
            (5.43, 0.05, 1.0),
            (6.43, 0.45, 1.5224308826),
            (7.43, 0.3, 1.0),
            (8.43, 0.9, 1.5224308826),
            (9.43, 0.5, 1.5224308826),
            (22.43, 0.98, 1.0),
        ]
    ],
)
def surface_tension(d_core, rh, scale, nanometre, newton_per_metre):
    table = next((rows for size, rows in ((5, FOUR), (7, SIX), (9, EIGHT)) if d_core < size * nanometre), TEN)
    thousandths = 1000 * scale * _between(table, rh)
    # The nearest; half-way goes up.
    below = mp.floor(thousandths)
    return dict(gamma=(below + (1 if thousandths - below >= 0.5 else 0)) / 1000 * newton_per_metre)
