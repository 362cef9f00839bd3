# Written by stubs.py.
# mypy: disable-error-code="overload-overlap"
"""Laube et al. 2018: water-covered nanoparticles. The equations, by the names of their functions."""

from typing import Any, NamedTuple, overload, type_check_only

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "aggregate_drag",
    "amplitude",
    "attraction",
    "attraction_along_normal",
    "capacity",
    "capillary_force",
    "capillary_slope",
    "capillary_work",
    "contact_area",
    "damping_coefficient",
    "diffusion",
    "drag",
    "effective_radius",
    "exact_gap",
    "exact_half_filling_angle",
    "exact_rupture",
    "exact_slope",
    "exact_work",
    "exit_cosine",
    "fractal_diameter",
    "fractal_number",
    "free_rotation",
    "friction_factor",
    "half_filling_angle",
    "kelvin",
    "layered_arm",
    "lognormal",
    "lognormal_share",
    "member_inertia",
    "member_momentum",
    "member_velocity",
    "meniscus_gap",
    "mixed_stiffness",
    "mobility_number",
    "moment_arm",
    "normal_damping",
    "overlap",
    "peak_friction",
    "plane_area",
    "radii",
    "ramped_time",
    "rayleigh_time",
    "relaxation",
    "repulsion",
    "return_cosine",
    "return_probability",
    "rolling_resistance",
    "rolling_share",
    "rolling_torque",
    "rupture",
    "sauter_diameter",
    "sawtooth",
    "sliding_spring",
    "solvation_force",
    "solvation_integral",
    "solvation_slope",
    "spin",
    "spring_energy",
    "steering",
    "stiffness",
    "surface_tension",
    "tip",
    "to_space",
    "torques",
    "total_force",
    "water_layer",
]

def total_force(f_na: ArrayLike, f_nr: ArrayLike, f_nd: ArrayLike, f_t: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 1, Section 2: total force on i exerted by its partner.

    Parameters
    ----------
    f_na : array (..., 3) [N]
        $\\mathbf{F}_{na}$: attraction, Eq. 3
    f_nr : array (..., 3) [N]
        $\\mathbf{F}_{nr}$: repulsion, Eq. 8
    f_nd : array (..., 3) [N]
        $\\mathbf{F}_{nd}$: normal damping, Eq. 6
    f_t : array (..., 3) [N]
        $\\mathbf{F}_t$: tangential force, Eq. 12
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{F}_{ij}$: force on i; the force on j is its negative

    Formula as printed
    ------------------
        \\mathbf{F}_{ij} = \\mathbf{F}_{na} + \\mathbf{F}_{nr} + \\mathbf{F}_{nd} + \\mathbf{F}_t = \\mathbf{F}_n + \\mathbf{F}_t

    Reading
    -------
    As printed. The force is that on i, with $\\mathbf{n}_{ij}$ from j to i: then Eq. 3 attracts and Eq. 8 repels. The first three act along
    the normal, the last in the contact plane; all but the attraction are zero out of contact.

    Laws
    ----
    * normal and tangential part can be told apart

    titania-1, spec/titania/eq01_total_force.rs, rounding error at most 1 ULP
    """

@overload
def moment_arm(r_i: float | str, r_j: float | str, d: float | str, *, check: bool = True) -> float:
    """Section 2, unnumbered: distance of the contact point from the centre of a particle.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $R_i$: radius of the particle
    r_j : float or array [m], > 0
        $R_j$: radius of its partner
    d : float or array [m], > 0
        $d$: distance of the centres
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    arm : float or array [m]
        $R_i^{aug}$: moment arm

    Formula as printed
    ------------------
        R_i^{aug} = R_i + \\frac{d - R_i - R_j}{2}

    Reading
    -------
    "Augmented by half the thickness of the compressed water layer": half the gap between the bare surfaces at that distance. The two arms
    then add up to the distance between the centres; otherwise, as with a constant thickness `h_n`, a tangential force would create
    angular momentum. Radii that are both augmented by the same length give the same arms.

    Laws
    ----
    * arms add up to the distance which constant layers do not
    * augmenting both radii changes no arm

    titania-arm, spec/titania/eq02_torque.rs, rounding error at most 1 ULP
    """
@overload
def moment_arm(r_i: ArrayLike | str, r_j: ArrayLike | str, d: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def layered_arm(r_i: float | str, h_n: float | str, *, check: bool = True) -> float:
    """Section 2, unnumbered: the same, taken literally.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $R_i$: bare radius of the particle
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    arm : float or array [m]
        $R_i^{aug}$: moment arm

    Formula as printed
    ------------------
        R_i^{aug} = R_i + \\frac{h_n}{2}

    Reading
    -------
    "Augmented by half the thickness of the compressed water layer", whatever the distance. At rest it is 0.1 nm shorter than
    [`moment_arm`], the default; with this arm a tangential force creates angular momentum.

    Laws
    ----
    * arms add up to the distance which constant layers do not

    titania-arm-layer, spec/titania/eq02_torque.rs, rounding error at most 0.5 ULP
    """
@overload
def layered_arm(r_i: ArrayLike | str, h_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Torques(NamedTuple):
    n: NDArray[np.float64]
    l_i: Any
    l_j: Any
    m_i: NDArray[np.float64]
    m_j: NDArray[np.float64]

def torques(x_i: ArrayLike, x_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, f_t: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, m_r: ArrayLike | str, *, check: bool = True) -> _Torques:
    """Eq. 2, Section 2: torques of a contact on its particles.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    r_i : float or array [m], > 0
        $R_i$: radius of i
    r_j : float or array [m], > 0
        $R_j$: radius of j
    f_t : array (..., 3) [N]
        $\\mathbf{F}_t$: force on i; only its tangential part is used
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    m_r : float or array [N m], >= 0
        $M_r$: magnitude of the rolling torque, Eq. 13
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    n : array (..., 3)
        $\\mathbf{n}_{ij}$: normal, from j to i
    l_i : float or array [m]
        $l_i$: moment arm of i
    l_j : float or array [m]
        $l_j$: moment arm of j
    m_i : array (..., 3) [N m]
        $\\mathbf{M}_i$: torque on i about its centre
    m_j : array (..., 3) [N m]
        $\\mathbf{M}_j$: torque on j about its centre

    Formula as printed
    ------------------
        \\mathbf{M}_{ij} = -\\mathbf{F}_t \\times R_i^{aug} \\mathbf{n}_{ij} - \\mathbf{M}_r

    Reading
    -------
    Erratum: with $\\mathbf{n}_{ij}$ from j to i, as Eqs. 3 and 8 require, the contact point of i lies at $-l_i \\mathbf{n}_{ij}$ and the
    torque of a force there is $+\\mathbf{F}_t \\times l_i \\mathbf{n}_{ij}$.

    $$
    \\mathbf{M}_i = \\mathbf{F}_t \\times l_i \\mathbf{n}_{ij} - \\mathbf{M}_r, \\quad
    \\mathbf{M}_j = \\mathbf{F}_t \\times l_j \\mathbf{n}_{ij} + \\mathbf{M}_r
    $$

    The rolling torque $\\mathbf{M}_r$ points along $(\\boldsymbol{\\omega}_i - \\boldsymbol{\\omega}_j)_{\\perp \\mathbf{n}}$ and is zero where
    that vector is. There is no torque about the normal.

    Effect: the printed sign creates angular momentum at the rate $(d + l_i + l_j) \\, \\mathbf{n}_{ij} \\times \\mathbf{F}_t$.

    Proof: `the_torques_balance_the_couple_of_the_forces_which_the_printed_sign_does_not`.

    Laws
    ----
    * the torques balance the couple of the forces which the printed sign does not
    * no torque acts about the normal
    * rolling resistance takes energy and keeps angular momentum

    titania-2, spec/titania/eq02_torque.rs, rounding error at most 16 ULP
    """

def attraction(f_cap: ArrayLike | str, f_solv: ArrayLike | str, n: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 3, Section 2.1: attraction of two particles.

    Parameters
    ----------
    f_cap : float or array [N]
        $F_{cap}$: capillary force, positive when it attracts
    f_solv : float or array [N]
        $F_{solv}$: solvation force, positive when it attracts
    n : array (..., 3), a unit vector
        $\\mathbf{n}_{ij}$: normal, from j to i
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_na : array (..., 3) [N]
        $\\mathbf{F}_{na}$: force on i

    Formula as printed
    ------------------
        \\mathbf{F}_{na} = -(F_{cap} + F_{solv}) \\, \\mathbf{n}_{ij}

    Reading
    -------
    Ambiguous: the formula is followed, its terms are positive where they attract. Eq. 4 with the negative amplitude of Eq. 5 would then repel bare surfaces that touch; in the convention
    of its source, where a force is positive when it repels, it attracts them. The stiffnesses that the authors' program derives by Eq. 9, and the paper's range of 20 to 45 GPa, result
    only with the latter, so [`Solvation::Israelachvili`] is the default and [`Solvation::Printed`] the named alternative: they differ by the sign of `f_solv`. As printed, two particles
    at the distance at which Eq. 9 balances the forces do not stay at rest: the attraction grows faster than the contact force, and they move to another distance.

    Laws
    ----
    * a positive force pulls i towards j
    * both forces pull with all their strength
    * swapping the particles reverses it

    titania-3, spec/titania/eq03_attraction.rs, rounding error at most 0.5 ULP
    """

@overload
def attraction_along_normal(f_cap: float | str, f_solv: float | str, *, check: bool = True) -> float:
    """Eq. 3, Section 2.1: attraction of two particles along the normal.

    Parameters
    ----------
    f_cap : float or array [N]
        $F_{cap}$: capillary force, positive when it attracts
    f_solv : float or array [N]
        $F_{solv}$: solvation force, positive when it attracts
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_na : float or array [N]
        $F_{na}$: force on i along the normal from j to i

    Formula as printed
    ------------------
        F_{na} = \\mathbf{F}_{na} \\cdot \\mathbf{n}_{ij} = -(F_{cap} + F_{solv})

    Reading
    -------
    What the engine computes, and tabulates: [`attraction`] is this times the normal.

    Laws
    ----
    * both forces pull with all their strength

    titania-03-normal, spec/titania/eq03_attraction.rs, rounding error at most 0.5 ULP
    """
@overload
def attraction_along_normal(f_cap: ArrayLike | str, f_solv: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Kelvin(NamedTuple):
    suction: Any
    r_k: Any

def kelvin(gamma: ArrayLike | str, kt: ArrayLike | str, volume: ArrayLike | str, rh: ArrayLike | str, *, check: bool = True) -> _Kelvin:
    """Not in the paper, Kelvin's equation: suction in a meniscus that is in equilibrium with humid air, and its radius of curvature.

    Parameters
    ----------
    gamma : float or array [N/m], > 0
        $\\gamma$: surface tension
    kt : float or array [J], > 0
        $k_B T$: thermal energy
    volume : float or array [m^3], > 0
        $V$: volume of a molecule of the liquid
    rh : float or array, (0, 1)
        $\\text{RH}$: relative humidity
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    suction : float or array [Pa]
        $P_c$: pressure of the air minus pressure of the liquid
    r_k : float or array [m]
        $r_K$: Kelvin radius

    Formula as printed
    ------------------
        P_c = \\frac{k_B T}{V} \\ln\\frac{1}{\\text{RH}}, \\quad r_K = \\frac{\\gamma}{P_c}

    Reading
    -------
    Classical capillarity, on which the paper builds. $V$ is the volume of a molecule: the quotient is the gas constant times the temperature over the
    molar volume, 138.2 MPa for water at 300 K. At a humidity of one half the suction is 95.8 MPa whatever the surface tension.

    Laws
    ----
    * vapour above a meniscus of that curvature has the humidity
    * water at room temperature and half humidity has 96 megapascal

    titania-kelvin, spec/titania/def_water.rs, rounding error at most 1 ULP
    """

@overload
def water_layer(rh: float | str, nanometre: float | str, *, check: bool = True) -> float:
    """Not in the paper: thickness of the free water layer as a function of humidity.

    Parameters
    ----------
    rh : float or array, [0, 1]
        $\\text{RH}$: relative humidity
    nanometre : float or array [m], > 0
        $\\text{nm}$: a nanometre in the caller's units
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    h_w : float or array [m]
        $h_w$: thickness of the layer

    Formula as printed
    ------------------
        h_w = h_w(\\text{RH})

    Reading
    -------
    The table of the authors' program, for oxide particles of 10 nm, interpolated linearly; 0.438 nm at half humidity, within the $0.41 \\pm 0.03$ nm
    that the paper states. It bounds the meniscus; contact begins at the thinner compressed layer.

    Laws
    ----
    * the layer grows with the humidity
    * the layer is that of the paper at half humidity
    * the layer has the points of the table and lines between them

    titania-water-layer, spec/titania/def_water.rs, rounding error at most 0.5 ULP
    """
@overload
def water_layer(rh: ArrayLike | str, nanometre: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def surface_tension(d_core: float | str, rh: float | str, scale: float | str, nanometre: float | str, newton_per_metre: float | str, *, check: bool = True) -> float:
    """Not in the paper: surface tension of the adsorbed water as a function of size and humidity.

    Parameters
    ----------
    d_core : float or array [m], > 0
        $d_\\text{core}$: core diameter of the smaller particle
    rh : float or array, [0, 1]
        $\\text{RH}$: relative humidity
    scale : float or array, > 0
        $\\text{scale}$: tension relative to that of TIP3P
    nanometre : float or array [m], > 0
        $\\text{nm}$: a nanometre in the caller's units
    newton_per_metre : float or array [N/m], > 0
        $\\text{N/m}$: a newton per metre in the caller's units
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    gamma : float or array [N/m]
        $\\gamma$: surface tension

    Formula as printed
    ------------------
        \\gamma = \\text{scale} \\cdot \\gamma_0(d_\\text{core}, \\text{RH})

    Reading
    -------
    The tables of the authors' program, computed for the water model TIP3P and particles of 4, 6, 8 and 10 nm: linear in the humidity, the nearest size
    below 5, 7, 9 nm and above. The size is the core diameter of the smaller particle. The scale of 0.072/0.04729279 converts the tension of TIP3P into
    the tension of water; one leaves it unchanged. Rounded to a thousandth of the unit N/m, as there. The steps from size to size make the stiffness of
    Eq. 9 fall between 5 and 6 nm and between 9 and 10 nm.

    Laws
    ----
    * at half humidity it has four values
    * water is less tense the more humid the air
    * the tension has the points of the four tables and lines between them

    titania-surface-tension, spec/titania/def_water.rs, rounding error at most 0.5 ULP
    """
@overload
def surface_tension(d_core: ArrayLike | str, rh: ArrayLike | str, scale: ArrayLike | str, nanometre: ArrayLike | str, newton_per_metre: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _MeniscusGap(NamedTuple):
    gap: Any
    slope: Any

def meniscus_gap(r_eff: ArrayLike | str, r_k: ArrayLike | str, theta: ArrayLike | str, beta: ArrayLike | str, *, check: bool = True) -> _MeniscusGap:
    """Distance of two layers whose meniscus has a given half-filling angle, and its slope.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    theta : float or array [rad], [0, 1.5707963267948966)
        $\\theta$: contact angle
    beta : float or array [rad], [0, 1.5707963267948966]
        $\\beta$: half-filling angle, at most $\\pi/2 - \\theta$
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    gap : float or array [m]
        $D$: distance of the layers, negative when they overlap
    slope : float or array [m]
        $dD/d\\beta$: its slope

    Formula as printed
    ------------------
        D = g - 4 R \\sin^2\\tfrac{\\beta}{2}, \\quad g = \\frac{4 c \\, r_K A}{S + Q}, \\quad
        S = A + r_K (2 - s), \\quad Q = \\sqrt{A^2 + 2 r_K A s + r_K^2 (2 - s)^2}

    Reading
    -------
    Multiplied by $r_K r l$, the condition of equilibrium becomes $\\frac{c}{2(1 + s)} g^2 - S g + 2 c \\, r_K A = 0$; the smaller root has a neck of
    positive radius. $Q^2$ is the discriminant, a sum of positive terms. The slope follows from the derivative of the quadratic, divided by $-Q$.
    Where the Kelvin radius and the filling angle are tiny, the gap is a small difference: such menisci determine the rounding bound.

    Laws
    ----
    * the meniscus has the curvature of kelvin
    * the slope of the gap is its derivative

    titania-meniscus-gap, spec/titania/def_meniscus.rs, rounding error at most 16 ULP
    """

@type_check_only
class _Rupture(NamedTuple):
    beta_r: Any
    gap_r: Any

def rupture(r_eff: ArrayLike | str, r_k: ArrayLike | str, theta: ArrayLike | str, *, check: bool = True) -> _Rupture:
    """Where the meniscus ruptures: the angle and the distance at which its branch ends.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    theta : float or array [rad], [0, 1.5707963267948966)
        $\\theta$: contact angle
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    beta_r : float or array [rad]
        $\\beta_r$: half-filling angle at rupture
    gap_r : float or array [m]
        $D_r$: distance of the layers at rupture

    Formula as printed
    ------------------
        \\frac{dD}{d\\beta}(\\beta_r) = 0, \\quad D_r = D(\\beta_r)

    Reading
    -------
    The distance increases with the angle up to rupture and decreases beyond. Below the rupture angle a stretched meniscus would shrink by its
    own suction: that branch is unstable. Sixty bisections resolve the angle to the last bit of a double, and the distance to twice as many
    bits.
    Where the Kelvin radius is tiny compared with the particles, the gap is a small difference: such menisci determine the rounding bound.

    Laws
    ----
    * no meniscus reaches beyond the rupture
    * scales with radius and kelvin radius
    * a liquid that hardly wets ruptures too

    titania-rupture, spec/titania/def_meniscus.rs, rounding error at most 24 ULP
    """

@overload
def half_filling_angle(r_eff: float | str, r_k: float | str, theta: float | str, gap: float | str, *, check: bool = True) -> float:
    """Half-filling angle of the meniscus at a given distance: the stable branch, zero beyond the rupture.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    theta : float or array [rad], [0, 1.5707963267948966)
        $\\theta$: contact angle
    gap : float or array [m]
        $D$: distance of the layers
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    beta : float or array [rad]
        $\\beta$: half-filling angle

    Formula as printed
    ------------------
        D(\\beta) = D, \\quad \\beta_r \\le \\beta \\le \\frac{\\pi}{2} - \\theta

    Reading
    -------
    On the stable branch $\\varphi(\\beta) = \\sqrt{D_r - D(\\beta)}$ is nearly linear, down to the rupture: Newton's method for
    $\\varphi(\\beta) = \\sqrt{D_r - D}$ starts on the chord and converges in a few steps; a step that would leave the branch goes halfway to
    its end instead. Spheres that overlap so far that no meniscus is left have the largest angle.

    Laws
    ----
    * the angle gives back the distance
    * the angle falls as the particles part
    * the branch ends at the angle of rupture and at the largest

    titania-half-filling, spec/titania/def_meniscus.rs, rounding error at most 1 ULP
    """
@overload
def half_filling_angle(r_eff: ArrayLike | str, r_k: ArrayLike | str, theta: ArrayLike | str, gap: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def capillary_force(gamma: float | str, r_k: float | str, r_eff: float | str, theta: float | str, beta: float | str, *, check: bool = True) -> float:
    """Not in the paper: capillary force of a meniscus in equilibrium with the air.

    Parameters
    ----------
    gamma : float or array [N/m], > 0
        $\\gamma$: surface tension
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles
    theta : float or array [rad], [0, 1.5707963267948966)
        $\\theta$: contact angle
    beta : float or array [rad], [0, 1.5707963267948966]
        $\\beta$: half-filling angle
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_cap : float or array [N]
        $F_{cap}$: capillary force

    Formula as printed
    ------------------
        F_{cap} = \\pi \\gamma R \\sin\\beta \\left[2 \\sin(\\theta + \\beta) + \\frac{R \\sin\\beta}{r_K}\\right]

    Reading
    -------
    Surface tension around the wetted circle and suction over its area, in the circular approximation; the curvature follows from Kelvin's equation.
    Positive when it attracts, as Eq. 3 takes it. Without a meniscus, $\\beta = 0$, it is zero.

    Laws
    ----
    * the worked example of two particles of 4 nanometre
    * large spheres in touch are held by two pi gamma r cos theta
    * the ends of the branch for pairs of sizes

    titania-capillary, spec/titania/def_capillary.rs, rounding error at most 1 ULP
    """
@overload
def capillary_force(gamma: ArrayLike | str, r_k: ArrayLike | str, r_eff: ArrayLike | str, theta: ArrayLike | str, beta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def capillary_slope(gamma: float | str, r_k: float | str, r_eff: float | str, theta: float | str, beta: float | str, *, check: bool = True) -> float:
    """Not in the paper: slope of the capillary force with respect to the distance.

    Parameters
    ----------
    gamma : float or array [N/m], > 0
        $\\gamma$: surface tension
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles
    theta : float or array [rad], [0, 1.5707963267948966)
        $\\theta$: contact angle
    beta : float or array [rad], (0, 1.5707963267948966]
        $\\beta$: half-filling angle, not the angle at rupture
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    slope : float or array [N/m]
        $F'_{cap}$: change of the force with the distance

    Formula as printed
    ------------------
        \\frac{dF_{cap}}{dd} = \\frac{dF_{cap}}{d\\beta} \\Big/ \\frac{dD}{d\\beta}

    Reading
    -------
    Along the branch both depend on the angle. At rupture the slope is infinite: the force decreases like the square root of the remaining distance.

    Laws
    ----
    * the slope is the derivative along the branch

    titania-capillary-slope, spec/titania/def_capillary.rs, rounding error at most 1 ULP
    """
@overload
def capillary_slope(gamma: ArrayLike | str, r_k: ArrayLike | str, r_eff: ArrayLike | str, theta: ArrayLike | str, beta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def capillary_work(gamma: float | str, r_k: float | str, r_eff: float | str, theta: float | str, beta: float | str, beta_r: float | str, *, check: bool = True) -> float:
    """Not in the paper: work of the capillary force during separation, from a given half-filling angle to the angle at rupture.

    Parameters
    ----------
    gamma : float or array [N/m], > 0
        $\\gamma$: surface tension
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles
    theta : float or array [rad], [0, 1.5707963267948966)
        $\\theta$: contact angle
    beta : float or array [rad], [0, 1.5707963267948966]
        $\\beta$: half-filling angle
    beta_r : float or array [rad], [0, 1.5707963267948966]
        $\\beta_r$: half-filling angle at rupture
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    w : float or array [J]
        $W$: work

    Formula as printed
    ------------------
        W = \\int_d^{d_r} F_{cap} \\, dd = \\int_{\\beta}^{\\beta_r} F_{cap} \\frac{dD}{d\\beta} \\, d\\beta

    Reading
    -------
    By ten-point Gauss quadrature: the integrand is smooth in the angle up to rupture.

    Laws
    ----
    * the force is the slope of the work

    titania-capillary-work, spec/titania/def_capillary.rs, rounding error at most 0.5 ULP
    """
@overload
def capillary_work(gamma: ArrayLike | str, r_k: ArrayLike | str, r_eff: ArrayLike | str, theta: ArrayLike | str, beta: ArrayLike | str, beta_r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _ExactGap(NamedTuple):
    gap: Any
    slope: Any

def exact_gap(r_eff: ArrayLike | str, r_k: ArrayLike | str, theta: ArrayLike | str, beta: ArrayLike | str, *, check: bool = True) -> _ExactGap:
    """Distance of two layers whose meniscus has a given half-filling angle, by the exact profile, and its slope.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles, at most $10^4 \\, r_K$
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    theta : float or array [rad], [0, 1.5]
        $\\theta$: contact angle
    beta : float or array [rad], (0, 1.5707963267948966]
        $\\beta$: half-filling angle, at most $\\pi/2 - \\theta$
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    gap : float or array [m]
        $D$: distance of the layers, negative when they overlap
    slope : float or array [m]
        $dD/d\\beta$: its slope

    Formula as printed
    ------------------
        D = 2 h - 4 R \\sin^2\\tfrac{\\beta}{2}, \\quad h = \\int_l^w \\frac{dy}{y'} = \\int_l^w \\frac{(l m - y^2) \\, dy}{\\sqrt{(y^2 - l^2)(m^2 - y^2)}}, \\quad
        l = \\sqrt{r_K^2 + 2 r_K C} - r_K, \\quad m = l + 2 r_K

    Reading
    -------
    $l$ is the radius of the neck. With $t^2 = l^2 (m^2 - y^2) / (y^2 - l^2)$ and $I = \\int_{t_0}^\\infty dt / \\sqrt{(t^2 + l^2)(t^2 + m^2)}$ the elliptic integrals become those that
    Gauss's transformation of $t$ leaves as they are. With $a_0 = m$, $c_0 = l$ and $u = 1/t$

    $$
    a_{n+1} = \\frac{a_n + \\sqrt{a_n^2 - c_n^2}}{2}, \\quad c_{n+1} = \\frac{c_n^2}{4 a_{n+1}}, \\quad u_{n+1} = \\frac{2 u_n}{1 + \\sqrt{1 + c_n^2 u_n^2}}, \\quad
    I = \\frac{\\operatorname{arsinh}(a_\\infty u_\\infty)}{a_\\infty}
    $$

    $$
    h = \\left(l m - \\sum_{n \\ge 0} 2^{n-1} c_n^2\\right) I - \\frac{w \\sigma}{1 + \\rho} + \\sum_{n \\ge 1} 2^{n-1} c_n^2 u_{n+1} \\sqrt{1 + a_n^2 u_n^2}, \\quad
    \\sigma^2 = 1 - \\rho^2 = \\frac{w^2 - l^2}{m^2 - l^2}, \\quad u_1 = \\frac{2 \\sigma}{l (1 + \\rho)}
    $$

    $a_n$ is the arithmetic-geometric mean of $m$ and $\\sqrt{m^2 - l^2}$: ten steps give all digits, and square roots and a logarithm are all that a number needs. $l/w$, $\\sigma$ and $\\rho$ are computed without cancellation. The
    slope follows from the derivatives of the elliptic integrals, in which the singular terms of the neck and of the wetted circle cancel:

    $$
    \\frac{dh}{d\\beta} = \\frac{r_K}{a^2} \\left[C' (2 r_K^2 I + h) - w (w' \\cos(\\theta + \\beta) + w s + r_K)\\right], \\quad a = l + r_K
    $$

    Laws
    ----
    * the height is the integral of the profile
    * the slope of the gap is its derivative
    * short menisci are nearly circular
    * particles much larger than the kelvin radius have no value

    titania-exact-gap, spec/titania/def_exact_meniscus.rs, rounding error at most 3 ULP
    """

@type_check_only
class _ExactRupture(NamedTuple):
    beta_r: Any
    gap_r: Any

def exact_rupture(r_eff: ArrayLike | str, r_k: ArrayLike | str, theta: ArrayLike | str, *, check: bool = True) -> _ExactRupture:
    """Where the exact meniscus ruptures: the angle and the distance at which its branch ends.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles, at most $10^4 \\, r_K$
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    theta : float or array [rad], [0, 1.5]
        $\\theta$: contact angle
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    beta_r : float or array [rad]
        $\\beta_r$: half-filling angle at rupture
    gap_r : float or array [m]
        $D_r$: distance of the layers at rupture

    Formula as printed
    ------------------
        \\frac{dD}{d\\beta}(\\beta_r) = 0, \\quad D_r = D(\\beta_r)

    Reading
    -------
    As [`rupture`](super::def_meniscus::rupture), by sixty bisections. Two particles of 8 nm at half humidity part at a distance of their bare surfaces that is 0.11 nm larger than in the circular approximation.

    Laws
    ----
    * no meniscus reaches beyond the rupture
    * an exact meniscus ruptures farther out than a circular one
    * scales with radius and kelvin radius

    titania-exact-rupture, spec/titania/def_exact_meniscus.rs, rounding error at most 8 ULP
    """

@overload
def exact_half_filling_angle(r_eff: float | str, r_k: float | str, theta: float | str, gap: float | str, *, check: bool = True) -> float:
    """Half-filling angle of the exact meniscus at a given distance: the stable branch, zero beyond the rupture.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles, at most $10^4 \\, r_K$
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    theta : float or array [rad], [0, 1.5]
        $\\theta$: contact angle
    gap : float or array [m]
        $D$: distance of the layers
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    beta : float or array [rad]
        $\\beta$: half-filling angle

    Formula as printed
    ------------------
        D(\\beta) = D, \\quad \\beta_r \\le \\beta \\le \\frac{\\pi}{2} - \\theta

    Reading
    -------
    As [`half_filling_angle`](super::def_meniscus::half_filling_angle), with the exact distance.

    Laws
    ----
    * the angle gives back the distance
    * the force of the exact meniscus at the distances of a worked example

    titania-exact-half-filling, spec/titania/def_exact_meniscus.rs, rounding error at most 2 ULP
    """
@overload
def exact_half_filling_angle(r_eff: ArrayLike | str, r_k: ArrayLike | str, theta: ArrayLike | str, gap: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def exact_slope(gamma: float | str, r_k: float | str, r_eff: float | str, theta: float | str, beta: float | str, *, check: bool = True) -> float:
    """Slope of the force of the exact meniscus with respect to the distance.

    Parameters
    ----------
    gamma : float or array [N/m], > 0
        $\\gamma$: surface tension
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles, at most $10^4 \\, r_K$
    theta : float or array [rad], [0, 1.5]
        $\\theta$: contact angle
    beta : float or array [rad], (0, 1.5707963267948966]
        $\\beta$: half-filling angle, not the angle at rupture
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    slope : float or array [N/m]
        $F'_{cap}$: change of the force with the distance

    Formula as printed
    ------------------
        \\frac{dF_{cap}}{dd} = \\frac{dF_{cap}}{d\\beta} \\Big/ \\frac{dD}{d\\beta}

    Reading
    -------
    As [`capillary_slope`](super::def_capillary::capillary_slope), with the exact distance. At rupture the slope is infinite.

    Laws
    ----
    * the slope is the derivative along the branch

    titania-exact-slope, spec/titania/def_exact_meniscus.rs, rounding error at most 3 ULP
    """
@overload
def exact_slope(gamma: ArrayLike | str, r_k: ArrayLike | str, r_eff: ArrayLike | str, theta: ArrayLike | str, beta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def exact_work(gamma: float | str, r_k: float | str, r_eff: float | str, theta: float | str, beta: float | str, beta_r: float | str, *, check: bool = True) -> float:
    """Work of the force of the exact meniscus during separation, from a given half-filling angle to the angle at rupture.

    Parameters
    ----------
    gamma : float or array [N/m], > 0
        $\\gamma$: surface tension
    r_k : float or array [m], > 0
        $r_K$: Kelvin radius
    r_eff : float or array [m], > 0
        $R$: harmonic mean radius of the water-covered particles, at most $10^4 \\, r_K$
    theta : float or array [rad], [0, 1.5]
        $\\theta$: contact angle
    beta : float or array [rad], (0, 1.5707963267948966]
        $\\beta$: half-filling angle
    beta_r : float or array [rad], (0, 1.5707963267948966]
        $\\beta_r$: half-filling angle at rupture
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    w : float or array [J]
        $W$: work

    Formula as printed
    ------------------
        W = \\int_d^{d_r} F_{cap} \\, dd = \\int_{\\beta}^{\\beta_r} F_{cap} \\frac{dD}{d\\beta} \\, d\\beta

    Reading
    -------
    As [`capillary_work`](super::def_capillary::capillary_work), by ten-point Gauss quadrature, with the exact distance.

    Laws
    ----
    * the force is the slope of the work

    titania-exact-work, spec/titania/def_exact_meniscus.rs, rounding error at most 1 ULP
    """
@overload
def exact_work(gamma: ArrayLike | str, r_k: ArrayLike | str, r_eff: ArrayLike | str, theta: ArrayLike | str, beta: ArrayLike | str, beta_r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def solvation_force(f_0: float | str, d: float | str, r_i: float | str, r_j: float | str, sigma: float | str, *, check: bool = True) -> float:
    """Eq. 4, Section 2.1: solvation force as a function of the distance.

    Parameters
    ----------
    f_0 : float or array [N]
        $F_{solv}^0$: amplitude, Eq. 5
    d : float or array [m], > 0
        $d$: distance of the centres
    r_i : float or array [m], > 0
        $R_i$: bare radius of i
    r_j : float or array [m], > 0
        $R_j$: bare radius of j
    sigma : float or array [m], > 0
        $\\sigma_{solv}$: period and decay length
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_solv : float or array [N]
        $F_{solv}$: solvation force

    Formula as printed
    ------------------
        F_{solv} = F_{solv}^0 \\cos\\left(\\frac{2\\pi (d - R_i - R_j)}{\\sigma_{solv}}\\right) e^{-\\frac{d - R_i - R_j}{\\sigma_{solv}}}

    Reading
    -------
    As printed, with bare radii: period and decay length are the same. Eq. 3 defines the meaning of the sign.

    Laws
    ----
    * is the amplitude where bare surfaces touch
    * a period on it is smaller by e and half a period on it has the other sign
    * vanishes at odd quarters of the period

    titania-4, spec/titania/eq04_solvation.rs, rounding error at most 1 ULP
    """
@overload
def solvation_force(f_0: ArrayLike | str, d: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, sigma: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def solvation_integral(f_0: float | str, x: float | str, sigma: float | str, *, check: bool = True) -> float:
    """Section 2.1, unnumbered: integral of the solvation force from infinity to a gap.

    Parameters
    ----------
    f_0 : float or array [N]
        $F_{solv}^0$: amplitude, Eq. 5
    x : float or array [m]
        $x$: distance of the bare surfaces
    sigma : float or array [m], > 0
        $\\sigma_{solv}$: period and decay length
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u : float or array [J]
        $U$: integral, zero for a large gap

    Formula as printed
    ------------------
        \\int_\\infty^x F_{solv} \\, dx = \\frac{F_{solv}^0 \\sigma}{1 + 4\\pi^2} \\, e^{-x/\\sigma}
          \\left(2\\pi \\sin\\frac{2\\pi x}{\\sigma} - \\cos\\frac{2\\pi x}{\\sigma}\\right)

    Laws
    ----
    * the force is its slope
    * all the work from contact is the amplitude times the decay length over one plus four pi squared

    titania-04-int, spec/titania/eq04_solvation.rs, rounding error at most 1 ULP
    """
@overload
def solvation_integral(f_0: ArrayLike | str, x: ArrayLike | str, sigma: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def solvation_slope(f_0: float | str, x: float | str, sigma: float | str, *, check: bool = True) -> float:
    """Section 2.1, unnumbered: slope of the solvation force.

    Parameters
    ----------
    f_0 : float or array [N]
        $F_{solv}^0$: amplitude, Eq. 5
    x : float or array [m]
        $x$: distance of the bare surfaces
    sigma : float or array [m], > 0
        $\\sigma_{solv}$: period and decay length
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    slope : float or array [N/m]
        $F'_{solv}$: change of the force with the distance

    Formula as printed
    ------------------
        \\frac{d F_{solv}}{d d} = -\\frac{F_{solv}^0}{\\sigma_{solv}} e^{-x/\\sigma} \\left(\\cos\\frac{2\\pi x}{\\sigma} + 2\\pi \\sin\\frac{2\\pi x}{\\sigma}\\right)

    Laws
    ----
    * is the derivative of the force

    titania-04-slope, spec/titania/eq04_solvation.rs, rounding error at most 1 ULP
    """
@overload
def solvation_slope(f_0: ArrayLike | str, x: ArrayLike | str, sigma: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _EffectiveRadius(NamedTuple):
    r_star: Any
    r_eff: Any

def effective_radius(r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> _EffectiveRadius:
    """Section 2.1, unnumbered: effective radius of a pair.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $R_i$: radius of i
    r_j : float or array [m], > 0
        $R_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    r_star : float or array [m]
        $R^*$: harmonic mean of the radii
    r_eff : float or array [m]
        $R_\\text{eff}$: half of it

    Formula as printed
    ------------------
        R^* = \\frac{2 R_i R_j}{R_i + R_j}

    Reading
    -------
    The harmonic mean: the radius itself for equal spheres, twice the radius against a plane. The effective radius of contact
    mechanics, $R_i R_j / (R_i + R_j)$, is half of it.

    Laws
    ----
    * is the radius of equal spheres and twice the radius on a plane
    * does not depend on which sphere is first
    * lies between the smaller radius and its double
    * scales with the radii

    titania-Rstar, spec/titania/def_radius.rs, rounding error at most 1 ULP
    """

@overload
def overlap(r_i: float | str, r_j: float | str, h_n: float | str, d: float | str, *, check: bool = True) -> float:
    """Section 2.3, unnumbered: overlap of the compressed water layers.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $R_i$: bare radius of i
    r_j : float or array [m], > 0
        $R_j$: bare radius of j
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    d : float or array [m], > 0
        $d$: distance of the centres
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_n : float or array [m]
        $\\delta_n$: overlap, positive in contact

    Formula as printed
    ------------------
        \\delta_n = R_i + R_j + 2 h_n - d

    Reading
    -------
    The paper draws the overlap and does not define it. Eq. 8 acts below the onset of the repulsion, where the compressed layers of thickness
    $h_n$ meet. `h_n` is not the thickness $h$ of the free layer, of which it is 0.88.

    Laws
    ----
    * falls as the distance grows
    * does not depend on which sphere is first

    titania-deltan, spec/titania/def_radius.rs, rounding error at most 0.5 ULP
    """
@overload
def overlap(r_i: ArrayLike | str, r_j: ArrayLike | str, h_n: ArrayLike | str, d: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Radii(NamedTuple):
    core: Any
    nominal: Any
    contact: Any

def radii(d_nom: ArrayLike | str, gap: ArrayLike | str, h_n: ArrayLike | str, *, check: bool = True) -> _Radii:
    """Not in the paper: the three radii of a particle of a nominal diameter.

    Parameters
    ----------
    d_nom : float or array [m], > 0
        $d_\\text{nom}$: nominal diameter
    gap : float or array [m], >= 0
        $\\Delta$: distance of two cores at equilibrium
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    core : float or array [m]
        $R$: bare radius
    nominal : float or array [m]
        $R_\\text{nom}$: half the nominal diameter
    contact : float or array [m]
        $r$: radius of the contact sphere

    Formula as printed
    ------------------
        R = \\frac{d_\\text{nom} - \\Delta}{2}, \\quad R_\\text{nom} = \\frac{d_\\text{nom}}{2}, \\quad r = R + h_n

    Reading
    -------
    The paper's $R$ is the bare radius, that of the oxide core. Published results are labelled by nominal diameters $d_\\text{nom}$ in steps
    of one nanometre. The authors' program takes a core gap $\\Delta$ of 0.57 nm for every size, so that two particles at equilibrium are
    exactly their mean nominal diameter apart. The contact acts between spheres of radius $R + h_n$, with $h_n$ = 0.36 nm; their overlap at
    equilibrium, $2 h_n - \\Delta$ = 0.15 nm, is the same for every pair. Masses and moments of inertia are those of the contact spheres.

    Laws
    ----
    * nominal radii add up to the distance at equilibrium of any two sizes

    titania-radii, spec/titania/def_radius.rs, rounding error at most 1 ULP
    """

@overload
def amplitude(r_star: float | str, f_00: float | str, slope: float | str, *, check: bool = True) -> float:
    """Eq. 5, Section 2.1: amplitude of the solvation force.

    Parameters
    ----------
    r_star : float or array [m], > 0
        $R^*$: effective radius of the bare particles
    f_00 : float or array [N]
        $F_{00}$: amplitude of vanishing particles, -11 nN
    slope : float or array [N/m]
        $F_{01}$: growth with the effective radius, -2.4 nN/nm
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_0 : float or array [N]
        $F_{solv}^0$: amplitude

    Formula as printed
    ------------------
        F_{solv}^0 = -11 \\, \\text{nN} - R^* \\cdot 2.4 \\, \\text{nN/nm}

    Reading
    -------
    As printed, fitted for bare radii of 4 to 8 nm. The two constants carry units and are arguments: -11 nN and -2.4 nN/nm.

    Laws
    ----
    * is 20 6 and 30 2 nanonewton for 4 and 8 nanometre
    * grows with the particles

    titania-5, spec/titania/eq05_amplitude.rs, rounding error at most 0.5 ULP
    """
@overload
def amplitude(r_star: ArrayLike | str, f_00: ArrayLike | str, slope: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def normal_damping(gamma_n: ArrayLike | str, v_i: ArrayLike, v_j: ArrayLike, x_i: ArrayLike, x_j: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 6, Section 2.2: dashpot along the normal.

    Parameters
    ----------
    gamma_n : float or array [kg/s], >= 0
        $\\gamma_n$: damping coefficient, Eq. 7
    v_i : array (..., 3) [m/s]
        $\\mathbf{v}_i$: velocity of i
    v_j : array (..., 3) [m/s]
        $\\mathbf{v}_j$: velocity of j
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_nd : array (..., 3) [N]
        $\\mathbf{F}_{nd}$: force on i

    Formula as printed
    ------------------
        \\mathbf{F}_{nd} = -\\gamma_n \\mathbf{v}_n

    Reading
    -------
    As printed, with $\\mathbf{v}_n = ((\\mathbf{v}_i - \\mathbf{v}_j) \\cdot \\mathbf{n}) \\mathbf{n}$. It acts in contact only, so it starts
    discontinuously at first touch.

    Laws
    ----
    * never delivers power
    * a sphere that leaves its partner is pulled by the coefficient times its speed
    * vanishes for a rigid motion of the pair

    titania-6, spec/titania/eq06_normal_damping.rs, rounding error at most 1 ULP
    """

@overload
def damping_coefficient(r_star: float | str, gamma_0: float | str, *, check: bool = True) -> float:
    """Eq. 7, Section 2.2: damping coefficient of a pair.

    Parameters
    ----------
    r_star : float or array [m], > 0
        $R^*$: effective radius
    gamma_0 : float or array [N s/m^3], >= 0
        $\\gamma_0$: damping constant, 0.5e6 N s/m³
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    gamma_n : float or array [kg/s]
        $\\gamma_n$: damping coefficient

    Formula as printed
    ------------------
        \\gamma_n = 0.5 \\cdot 10^6 \\, \\text{Ns/m}^3 \\cdot R^{*2}

    Reading
    -------
    The constant is an argument, because two are in use: 0.5e6 N s/m³ in the paper and 5e6 N s/m³ in the authors' program. Linearised about
    equilibrium the former gives a damping ratio of 0.04, the latter 0.4 and with it the quick approach to
    equilibrium that Fig. 3 shows. The paper's is the default. The program takes $R^*$ of the contact spheres instead of the bare ones.

    Laws
    ----
    * is quadratic in the effective radius
    * is 8e12 and 32e12 kilogram per second for 4 and 8 nanometre

    titania-7, spec/titania/eq07_damping_coefficient.rs, rounding error at most 0.5 ULP
    """
@overload
def damping_coefficient(r_star: ArrayLike | str, gamma_0: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Repulsion(NamedTuple):
    rhn_star: Any
    f_nr: Any
    stiffness: Any
    energy: Any

def repulsion(k_n: ArrayLike | str, delta_n: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, h_n: ArrayLike | str, *, check: bool = True) -> _Repulsion:
    """Eq. 8, Section 2.3: repulsion of overlapping particles, with its slope and its energy.

    Parameters
    ----------
    k_n : float or array [Pa], > 0
        $k_n$: contact stiffness, Eq. 9
    delta_n : float or array [m]
        $\\delta_n$: overlap
    r_i : float or array [m], > 0
        $R_i$: bare radius of i
    r_j : float or array [m], > 0
        $R_j$: bare radius of j
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    rhn_star : float or array [m]
        $(R + h_n)^*$: effective radius of the contact spheres
    f_nr : float or array [N]
        $F_{nr}$: force, positive when it repels
    stiffness : float or array [N/m]
        $dF_{nr}/d\\delta_n$: slope of the force
    energy : float or array [J]
        $V_{nr}$: energy stored

    Formula as printed
    ------------------
        F_{nr} = k_n \\delta_n^{3/2} \\sqrt{0.5 (R + h_n)^*}

    Reading
    -------
    As printed; zero without overlap. The stiffness is that of Hertz, $\\frac{4}{3} E^*$, a pressure. The law is fitted to forces below 5 nN.

    Laws
    ----
    * sets in smoothly at first touch
    * is minus the gradient of the energy
    * the stiffness is the slope
    * grows with the power three halves of the overlap
    * does not depend on which particle is first
    * a plane is an infinite sphere

    titania-8, spec/titania/eq08_repulsion.rs, rounding error at most 1 ULP
    """

@overload
def stiffness(f_na_0: float | str, delta_n_0: float | str, r_i: float | str, r_j: float | str, h_n: float | str, *, check: bool = True) -> float:
    """Eq. 9, Section 2.3: contact stiffness that keeps a pair in equilibrium at a given overlap.

    Parameters
    ----------
    f_na_0 : float or array [N], < 0
        $F_{na}(0)$: attraction at equilibrium, along the normal
    delta_n_0 : float or array [m], > 0
        $\\delta_n(0)$: overlap at equilibrium
    r_i : float or array [m], > 0
        $R_i$: bare radius of i
    r_j : float or array [m], > 0
        $R_j$: bare radius of j
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_n : float or array [Pa]
        $k_n$: contact stiffness

    Formula as printed
    ------------------
        k_n = \\frac{-F_{na}(0)}{\\delta_n(0)^{3/2} \\sqrt{0.5 (R + h_n)}}

    Reading
    -------
    Erratum: the star is missing, the radius is the $(R + h_n)^*$ of Eq. 8 that the equation inverts. The paper tabulates a stiffness per size; here each pair of sizes
    has its own, as in the authors' program, which alone is exact for all pairs. $F_{na}(0)$ is the component along the normal,
    negative because it attracts.

    Effect: without the star two unlike particles are not in equilibrium at the distance of which the equation is derived. For equal ones it makes no difference.

    Proof: `balances_repulsion_and_attraction_which_bare_radii_without_star_do_not`.

    Laws
    ----
    * balances repulsion and attraction which bare radii without star do not
    * does not depend on which particle is first

    titania-9, spec/titania/eq09_stiffness.rs, rounding error at most 0.5 ULP
    """
@overload
def stiffness(f_na_0: ArrayLike | str, delta_n_0: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, h_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def mixed_stiffness(k_i: float | str, k_j: float | str, *, check: bool = True) -> float:
    """Section 2.3, unnumbered: contact stiffness of unlike particles, from the stiffnesses of equal pairs of either size.

    Parameters
    ----------
    k_i : float or array [Pa], > 0
        $k_i$: stiffness of two particles like i
    k_j : float or array [Pa], > 0
        $k_j$: stiffness of two particles like j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_n : float or array [Pa]
        $k_n$: contact stiffness

    Formula as printed
    ------------------
        \\frac{1}{k_n} = \\frac{1}{2} \\left(\\frac{1}{k_i} + \\frac{1}{k_j}\\right)

    Reading
    -------
    Ambiguous: the paper speaks of the stiffness of a particle size, for which the star that Eq. 9 lacks makes no difference, and does not define the stiffness of two different sizes. Hertz adds the
    compliances of two bodies. The equilibrium distance of unlike particles then differs slightly from the nominal one, and the default is the stiffness of the pair.

    Laws
    ----
    * unlike particles are as stiff as half the sum of their compliances

    titania-9-mixed, spec/titania/eq09_stiffness.rs, rounding error at most 1 ULP
    """
@overload
def mixed_stiffness(k_i: ArrayLike | str, k_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Relaxation(NamedTuple):
    delta_0: Any
    k_lin: Any
    m_eff: Any
    gamma_n: Any
    omega_0: Any
    zeta: Any
    tau: Any

def relaxation(k_n: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, h_n: ArrayLike | str, f_a: ArrayLike | str, rho: ArrayLike | str, gamma_0: ArrayLike | str, *, check: bool = True) -> _Relaxation:
    """Section 2.2, unnumbered: equilibrium under a constant attraction, linearised.

    Parameters
    ----------
    k_n : float or array [Pa], > 0
        $k_n$: contact stiffness
    r_i : float or array [m], > 0
        $R_i$: bare radius of i
    r_j : float or array [m], > 0
        $R_j$: bare radius of j
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    f_a : float or array [N], > 0
        $F_a$: constant attraction
    rho : float or array [kg/m^3], > 0
        $\\rho$: density
    gamma_0 : float or array [N s/m^3], > 0
        $\\gamma_0$: damping constant of Eq. 7
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_0 : float or array [m]
        $\\delta_0$: overlap at equilibrium
    k_lin : float or array [N/m]
        $k$: stiffness there
    m_eff : float or array [kg]
        $m_\\text{eff}$: effective mass
    gamma_n : float or array [kg/s]
        $\\gamma_n$: damping coefficient
    omega_0 : float or array [rad/s]
        $\\omega_0$: natural frequency
    zeta : float or array
        $\\zeta$: damping ratio
    tau : float or array [s]
        $\\tau$: time in which the amplitude decays by a factor of e

    Formula as printed
    ------------------
        \\delta_0 = \\left(\\frac{F_a}{k_n \\sqrt{R_\\text{eff}}}\\right)^{2/3}, \\quad k = \\frac{3 F_a}{2 \\delta_0}, \\quad
        \\omega_0 = \\sqrt{\\frac{k}{m_\\text{eff}}}, \\quad \\zeta = \\frac{\\gamma_n}{2 \\sqrt{k \\, m_\\text{eff}}}

    Reading
    -------
    The motion shown in Fig. 3, for small displacements and an attraction independent of the distance. The masses are those of the bare spheres. The
    power is evaluated for a dimensionless number, $\\delta_0 = R_\\text{eff} \\exp\\left(\\frac{2}{3} \\ln \\frac{F_a}{k_n R_\\text{eff}^2}\\right)$.

    Laws
    ----
    * repulsion balances the attraction with that stiffness
    * both sizes of the figure are damped alike and ten times more by the program

    titania-relax-lin, spec/titania/def_relaxation.rs, rounding error at most 5 ULP
    """

@type_check_only
class _PeakFriction(NamedTuple):
    f_ts: Any
    f_tr: Any

def peak_friction(a: ArrayLike | str, tau_s: ArrayLike | str, tau_r: ArrayLike | str, *, check: bool = True) -> _PeakFriction:
    """Eq. 10, Section 2.4: largest tangential force of sliding and of rolling.

    Parameters
    ----------
    a : float or array [m^2], >= 0
        $A_{ij}$: contact area, Eq. 11
    tau_s : float or array [Pa], >= 0
        $\\tau_S$: shear strength of sliding, 0.65 GPa
    tau_r : float or array [Pa], >= 0
        $\\tau_R$: shear strength of rolling, 0.25 GPa
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_ts : float or array [N]
        $F_{t,max}^S$: largest force of sliding
    f_tr : float or array [N]
        $F_{t,max}^R$: largest force of rolling

    Formula as printed
    ------------------
        F_{t,max}^S = \\tau_S A_{ij}; \\quad F_{t,max}^R = \\tau_R A_{ij}

    Reading
    -------
    As printed. The paper calls $\\tau$ a shear stiffness; it is a stress.

    Laws
    ----
    * is proportional to the area and not to the load
    * over the area it is the shear strength

    titania-10, spec/titania/eq10_peak_friction.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _ContactArea(NamedTuple):
    a: Any
    delta_n: Any

def contact_area(r_i: ArrayLike | str, r_j: ArrayLike | str, h_n: ArrayLike | str, d: ArrayLike | str, *, check: bool = True) -> _ContactArea:
    """Eq. 11, Section 2.4: area of the circle in which two contact spheres meet.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $R_i$: bare radius of i
    r_j : float or array [m], > 0
        $R_j$: bare radius of j
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    d : float or array [m], > 0
        $d$: distance of the centres
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a : float or array [m^2]
        $A_{ij}$: contact area
    delta_n : float or array [m]
        $\\delta_n$: overlap

    Formula as printed
    ------------------
        A_{ij} = \\pi \\left[R_i^2 - \\frac{(R_i^2 - R_j^2 + d^2)^2}{4 d^2}\\right]

    Reading
    -------
    Erratum: bare spheres in contact are further apart than the sum of their radii. The spheres
    that meet have the radii $R + h_n$ of Eq. 8: with them the area is positive exactly where there is an overlap.

    Effect: the printed area is negative in the whole range of the contact, and friction in proportion to it would drive the sliding.

    Proof: `positive_exactly_in_contact_which_bare_radii_are_not`.

    The printed difference cancels. With $a = R_i + h_n$ and $b = R_j + h_n$ it factors into

    $$
    A_{ij} = \\frac{\\pi}{4 d^2} (a + b - d)(d - a + b)(d + a - b)(d + a + b)
    $$

    of which the first factor is the overlap. The outer two are $(a + b)^2 - d^2$ and the inner two $d^2 - (a - b)^2$: where the distance is known only by its
    square, the area needs no root. It is zero for spheres that do not meet.

    Laws
    ----
    * the factors are the printed difference
    * positive exactly in contact which bare radii are not
    * for a small overlap it is pi times the effective radius times the overlap
    * never exceeds the section of the smaller sphere
    * is zero where one sphere contains the other
    * does not depend on which particle is first

    titania-11, spec/titania/eq11_contact_area.rs, rounding error at most 2 ULP
    """

@overload
def plane_area(r: float | str, h_n: float | str, delta: float | str, *, check: bool = True) -> float:
    """Section 2.4, unnumbered: area of the circle in which a contact sphere and a plane meet.

    Parameters
    ----------
    r : float or array [m], > 0
        $R$: bare radius
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    delta : float or array [m], >= 0
        $\\delta_n$: overlap, at most the diameter
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a : float or array [m^2]
        $A$: contact area

    Formula as printed
    ------------------
        A = \\pi (2 a \\delta_n - \\delta_n^2), \\quad a = R + h_n

    Laws
    ----
    * a plane is an infinite sphere

    titania-11-plane, spec/titania/eq11_contact_area.rs, rounding error at most 1 ULP
    """
@overload
def plane_area(r: ArrayLike | str, h_n: ArrayLike | str, delta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Sawtooth(NamedTuple):
    frac: Any
    f_t: NDArray[np.float64]

def sawtooth(tau_s: ArrayLike | str, a: ArrayLike | str, delta_t: ArrayLike | str, lambda_t: ArrayLike | str, t: ArrayLike, *, check: bool = True) -> _Sawtooth:
    """Eq. 12, Section 2.4: tangential force as a function of the distance slid along a straight line.

    Parameters
    ----------
    tau_s : float or array [Pa], >= 0
        $\\tau_S$: shear strength of sliding
    a : float or array [m^2], >= 0
        $A_{ij}$: contact area
    delta_t : float or array [m], >= 0
        $\\delta_t$: distance slid
    lambda_t : float or array [m], > 0
        $\\lambda_t$: period, 0.5 nm
    t : array (..., 3), a unit vector
        $\\mathbf{t}_{ij}$: direction of sliding
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    frac : float or array
        $\\delta_t / \\lambda_t - \\lfloor\\delta_t / \\lambda_t\\rfloor$: fraction of the period
    f_t : array (..., 3) [N]
        $\\mathbf{F}_t$: force on i

    Formula as printed
    ------------------
        \\mathbf{F}_t = -\\tau_S A_{ij} \\left(\\frac{\\delta_t}{\\lambda_t} - \\left\\lfloor\\frac{\\delta_t}{\\lambda_t}\\right\\rfloor\\right) \\mathbf{t}_{ij}

    Reading
    -------
    Erratum: the formula is valid for continued sliding in one direction, and no law for general motion. The
    paper calls it a spring and a slider, which [`sliding_spring`] implements; here it is as printed.

    Effect: a function of the displacement alone loses nothing on a closed path, and below zero the floor gives the full force at once.

    Proof: `as_printed_it_is_not_odd_and_loses_nothing_on_a_closed_path_which_the_spring_does`.

    Laws
    ----
    * is a saw tooth whose mean is half its peak
    * as printed it is not odd and loses nothing on a closed path which the spring does

    titania-12, spec/titania/eq12_sliding.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _SlidingSpring(NamedTuple):
    f_t: NDArray[np.float64]
    xi_next: NDArray[np.float64]

def sliding_spring(tau_s: ArrayLike | str, a: ArrayLike | str, lambda_t: ArrayLike | str, xi: ArrayLike, slip: ArrayLike | str, *, check: bool = True) -> _SlidingSpring:
    """Eq. 12 as a spring and a slider in three dimensions: force of the spring and its remaining elongation.

    Parameters
    ----------
    tau_s : float or array [Pa], >= 0
        $\\tau_S$: shear strength of sliding
    a : float or array [m^2], >= 0
        $A_{ij}$: contact area
    lambda_t : float or array [m], > 0
        $\\lambda_t$: period
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring, advanced
    slip : float or array, [0, 1]
        $s$: 1 to keep the remainder, 0 to start from zero
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_t : array (..., 3) [N]
        $\\mathbf{F}_t$: force on i
    xi_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring that remains

    Formula as printed
    ------------------
        \\mathbf{F}_t = -\\frac{\\tau_S A_{ij}}{\\lambda_t} \\boldsymbol{\\xi}, \\quad
        |\\boldsymbol{\\xi}| \\ge \\lambda_t: \\; \\boldsymbol{\\xi} := \\boldsymbol{\\xi} - \\lambda_t \\left\\lfloor\\frac{|\\boldsymbol{\\xi}|}{\\lambda_t}\\right\\rfloor \\hat{\\boldsymbol{\\xi}}

    Reading
    -------
    The spring $\\boldsymbol{\\xi}$ lies in the contact plane and was advanced to this instant. Below one period it is elastic. At one period the surfaces slip, in
    one of two ways, see [`Slip`]: with `slip` 1 the spring keeps the remainder, and for steady sliding along a line the force is the printed one; with `slip` 0 the
    force is the peak force $-\\tau_S A_{ij} \\hat{\\boldsymbol{\\xi}}$ of this step and nothing remains. The energy lost by the spring is dissipated.

    The stiffness follows the area, without a corresponding normal force: a spring loaded at one area and released at
    another delivers $\\tau_S \\, \\Delta A \\, \\xi^2 / 2 \\lambda_t$. That is the paper's law; the contact law records it as
    lost to the contact area.

    Laws
    ----
    * steady sliding is the printed saw tooth
    * the force never exceeds the peak
    * a closed path costs what the slips lose
    * changing the area under load delivers work
    * a spring slips when it is as long as a period

    titania-12-spring, spec/titania/eq12_sliding.rs, rounding error at most 1 ULP
    """

def spring_energy(tau_s: ArrayLike | str, a: ArrayLike | str, lambda_t: ArrayLike | str, xi: ArrayLike, *, check: bool = True) -> Any:
    """Section 2.4, unnumbered: energy stored in the tangential spring.

    Parameters
    ----------
    tau_s : float or array [Pa], >= 0
        $\\tau_S$: shear strength of sliding
    a : float or array [m^2], >= 0
        $A_{ij}$: contact area
    lambda_t : float or array [m], > 0
        $\\lambda_t$: period
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_t : float or array [J]
        $V_t$: energy

    Formula as printed
    ------------------
        V_t = \\frac{\\tau_S A_{ij}}{2 \\lambda_t} |\\boldsymbol{\\xi}|^2

    Laws
    ----
    * a slip loses half the peak force times the period

    titania-12-energy, spec/titania/eq12_sliding.rs, rounding error at most 1 ULP
    """

@overload
def rolling_resistance(r_i: float | str, r_j: float | str, h_n: float | str, tau_r: float | str, a: float | str, *, check: bool = True) -> float:
    """Eq. 13, Section 2.4: magnitude of the rolling torque.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $R_i$: bare radius of i
    r_j : float or array [m], > 0
        $R_j$: bare radius of j
    h_n : float or array [m], >= 0
        $h_n$: thickness of the compressed layer
    tau_r : float or array [Pa], >= 0
        $\\tau_R$: shear strength of rolling
    a : float or array [m^2], >= 0
        $A_{ij}$: contact area
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    m_r : float or array [N m]
        $M_r$: magnitude of the rolling torque

    Formula as printed
    ------------------
        \\mathbf{M}_r = 0.5 (R + h_n)^* \\tau_R A_{ij}

    Reading
    -------
    Ambiguous: the left side is a vector and the right side is not. This is the magnitude, [`rolling_torque`] gives the direction.

    Laws
    ----
    * on a plane the arm is the radius
    * the arms of two spheres on a plane add up inversely

    titania-13, spec/titania/eq13_rolling.rs, rounding error at most 0.5 ULP
    """
@overload
def rolling_resistance(r_i: ArrayLike | str, r_j: ArrayLike | str, h_n: ArrayLike | str, tau_r: ArrayLike | str, a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def rolling_torque(m_r: ArrayLike | str, omega_i: ArrayLike, omega_j: ArrayLike, n: ArrayLike, inertia: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 13 with a direction: rolling torque on i over a step.

    Parameters
    ----------
    m_r : float or array [N m], >= 0
        $M_r$: magnitude, Eq. 13
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    n : array (..., 3), a unit vector
        $\\mathbf{n}_{ij}$: normal, from j to i
    inertia : float or array [kg m^2], > 0
        $I$: reduced moment of inertia of the two
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    torque : array (..., 3) [N m]
        $-\\mathbf{M}_r$: torque on i; the torque on j is its negative

    Formula as printed
    ------------------
        -\\mathbf{M}_r = -\\min\\left(M_r, \\frac{I |\\boldsymbol{\\omega}_r|}{\\Delta t}\\right) \\hat{\\boldsymbol{\\omega}}_r, \\quad
        \\boldsymbol{\\omega}_r = (\\boldsymbol{\\omega}_i - \\boldsymbol{\\omega}_j)_{\\perp \\mathbf{n}}, \\quad
        \\frac{1}{I} = \\frac{1}{I_i} + \\frac{1}{I_j}

    Reading
    -------
    Ambiguous: a "pure slider" has no value at rest. The torque opposes the relative rolling velocity, which excludes the spin about the normal,
    and is zero at rest. A step of constant torque may stop the rolling but not reverse it: without the limit the
    spin would change its sign every step ([`Rolling::Unlimited`]: an infinite moment of inertia). The authors' program has no limit and divides by the length of the whole
    relative angular velocity, so that twisting weakens its resistance to rolling.

    Laws
    ----
    * opposes rolling and ignores twisting
    * a step stops rolling and never reverses it which the torque without limit does
    * is zero at rest

    titania-13-torque, spec/titania/eq13_rolling.rs, rounding error at most 1 ULP
    """

def rolling_share(omega_i: ArrayLike, omega_j: ArrayLike, n: ArrayLike, *, check: bool = True) -> Any:
    """Eq. 13 in the authors' program: the share of rolling in a relative spin, by which twisting weakens the resistance to rolling.

    Parameters
    ----------
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    n : array (..., 3), a unit vector
        $\\mathbf{n}_{ij}$: normal, from j to i
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    share : float or array
        $s$: factor of the rolling torque

    Formula as printed
    ------------------
        \\frac{|\\boldsymbol{\\omega}_r|}{|\\boldsymbol{\\omega}_i - \\boldsymbol{\\omega}_j|}

    Reading
    -------
    The paper does not define the direction of the torque. The program divides the rolling part of the relative angular velocity by the length of the whole. One at rest, where there is no torque.

    Laws
    ----
    * twisting weakens the resistance of the program

    titania-13-share, spec/titania/eq13_rolling.rs, rounding error at most 1.5 ULP
    """

@overload
def rayleigh_time(r: float | str, rho: float | str, g: float | str, nu: float | str, *, check: bool = True) -> float:
    """Section 2.5, unnumbered: Rayleigh time of a sphere.

    Parameters
    ----------
    r : float or array [m], > 0
        $R$: radius
    rho : float or array [kg/m^3], > 0
        $\\rho$: density
    g : float or array [Pa], > 0
        $G$: shear modulus
    nu : float or array, (-1, 0.5]
        $\\nu$: Poisson's ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    t_r : float or array [s]
        $T_R$: Rayleigh time

    Formula as printed
    ------------------
        T_R = \\frac{\\pi R \\sqrt{\\rho / G}}{0.1631 \\, \\nu + 0.8766}

    Reading
    -------
    The time of a surface wave across half the sphere, with the customary coefficients, which the paper does not print. For rutile and the
    smallest particles of 3 nm it is the 1 ps of the paper, half of which is the time step.

    Laws
    ----
    * is a picosecond for the smallest particles
    * half the way round takes as long as the wave of rayleigh
    * the customary line has its four digits

    titania-rayleigh, spec/titania/def_rayleigh.rs, rounding error at most 1 ULP
    """
@overload
def rayleigh_time(r: ArrayLike | str, rho: ArrayLike | str, g: ArrayLike | str, nu: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Tip(NamedTuple):
    v: Any
    z: Any

def tip(v_0: ArrayLike | str, t_turn: ArrayLike | str, t: ArrayLike | str, *, check: bool = True) -> _Tip:
    """Section 5.4, unnumbered: motion of the tip after the setpoint.

    Parameters
    ----------
    v_0 : float or array [m/s], >= 0
        $v_0$: speed of approach and retraction, 0.5 m/s
    t_turn : float or array [s], > 0
        $T$: duration of the reversal, 0.2 µs
    t : float or array [s]
        $t$: time since the setpoint
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v : float or array [m/s]
        $v$: velocity
    z : float or array [m]
        $z$: height relative to the setpoint

    Formula as printed
    ------------------
        v(t) = \\begin{cases} -v_0 & t \\le 0 \\\\ v_0 (2t/T - 1) & 0 < t \\le T \\\\ v_0 & t > T \\end{cases}, \\quad z(t) = \\int_0^t v \\, dt

    Reading
    -------
    "Slowly decreased, reversed, and then again increased" within 0.2 µs: linearly, the simplest reading. At $t = 0$ the force reaches its setpoint. The
    tip continues by $v_0 T / 4$, 25 nm, before it returns.

    Laws
    ----
    * the velocity of the tip is the rate of its height
    * the tip goes on by a quarter of speed times duration

    titania-tip-linear, spec/mechanics/drive.rs, rounding error at most 0.5 ULP
    """

@overload
def steering(k: float | str, z: float | str, z_0: float | str, v: float | str, t: float | str, *, check: bool = True) -> float:
    """Section 3.1, unnumbered: harmonic constraint that pulls an agglomerate.

    Parameters
    ----------
    k : float or array [N/m], >= 0
        $k$: stiffness, 160 N/m
    z : float or array [m]
        $z$: place of the centre of mass
    z_0 : float or array [m]
        $z_0$: its place at the start
    v : float or array [m/s]
        $v$: velocity of the constraint, 5 m/s
    t : float or array [s], >= 0
        $t$: time
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $F$: force on the group

    Formula as printed
    ------------------
        F = -k (z - z_0 - v t)

    Laws
    ----
    * a group that moves with the constraint feels nothing
    * the constraint has its stiffness

    titania-harmonic, spec/mechanics/drive.rs, rounding error at most 1 ULP
    """
@overload
def steering(k: ArrayLike | str, z: ArrayLike | str, z_0: ArrayLike | str, v: ArrayLike | str, t: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def ramped_time(t: float | str, ramp: float | str, *, check: bool = True) -> float:
    """Section 3.1, unnumbered: time for which a constraint of full velocity has moved as far as one whose velocity grows.

    Parameters
    ----------
    t : float or array [s], >= 0
        $t$: time
    ramp : float or array [s], >= 0
        $T$: time in which the velocity grows
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    tau : float or array [s]
        $\\tau$: displacement over full velocity

    Formula as printed
    ------------------
        \\tau(t) = \\begin{cases} t^2 / 2T & t < T \\\\ t - T/2 & \\text{otherwise} \\end{cases}

    Reading
    -------
    The paper pulls at full velocity from the beginning, $T = 0$ and $\\tau = t$. A velocity that grows linearly makes less of an oscillation.

    Laws
    ----
    * the velocity grows to its full value

    titania-ramp, spec/mechanics/drive.rs, rounding error at most 0.5 ULP
    """
@overload
def ramped_time(t: ArrayLike | str, ramp: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def drag(eta: ArrayLike | str, v: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 5.4, unnumbered: environmental viscosity of the first relaxation.

    Parameters
    ----------
    eta : float or array [kg/s], >= 0
        $\\eta$: drag coefficient of each particle, 10 pN s/m
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity of the particle
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force on the particle

    Formula as printed
    ------------------
        \\mathbf{F} = -\\eta \\mathbf{v}

    Laws
    ----
    * drag takes power

    titania-viscous, spec/mechanics/drive.rs, rounding error at most 0.5 ULP
    """

@overload
def lognormal_share(d: float | str, median: float | str, s_g: float | str, lo: float | str, hi: float | str, *, check: bool = True) -> float:
    """Section 5.3, unnumbered: fraction of the particles in a class of the discretised log-normal distribution.

    Parameters
    ----------
    d : float or array, >= 3
        $d$: diameter of the class
    median : float or array, >= 3
        $m$: median before the discretisation
    s_g : float or array, [1.2, 3]
        $\\sigma_G$: geometric standard deviation
    lo : float or array, >= 3
        $d_{lo}$: smallest diameter
    hi : float or array, >= 3
        $d_{hi}$: largest diameter, up to 31 above the smallest
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    p : float or array
        $p$: fraction of the particles in the class

    Formula as printed
    ------------------
        p(d) = \\frac{g(d)}{\\sum_k g(d_k)}, \\quad g(d) = \\frac{1}{d} \\exp\\left(-\\frac{\\ln^2(d / m)}{2 \\ln^2 \\sigma_G}\\right), \\quad
        d_k = d_{lo}, d_{lo} + 1, \\dots, d_{hi}

    Reading
    -------
    The diameters go from 3 to 23 nm in steps of 1 nm with a median $m$ of 9.0 nm and $\\sigma_G$ = 1.45. The paper does not define the discretisation of a class: here it
    is the density at its diameter. Diameters are numbers, multiples of the step, from three on; at most 32 classes. The resulting Sauter diameter is 12.2 nm, not the
    11.3 nm implied by the box of "140 $\\bar{d}_s$".

    Laws
    ----
    * the shares of all classes are one
    * the shares of the paper are the independent values
    * there may be 32 classes

    titania-lognormal-share, spec/mechanics/discretised_lognormal.rs, rounding error at most 1.5 ULP
    """
@overload
def lognormal_share(d: ArrayLike | str, median: ArrayLike | str, s_g: ArrayLike | str, lo: ArrayLike | str, hi: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Lognormal(NamedTuple):
    mean: Any
    sauter: Any
    d_30: Any

def lognormal(median: ArrayLike | str, s_g: ArrayLike | str, lo: ArrayLike | str, hi: ArrayLike | str, *, check: bool = True) -> _Lognormal:
    """Section 5.3, unnumbered: mean, Sauter and volume-mean diameter of the discretised log-normal distribution.

    Parameters
    ----------
    median : float or array, >= 3
        $m$: median before the discretisation
    s_g : float or array, [1.2, 3]
        $\\sigma_G$: geometric standard deviation
    lo : float or array, >= 3
        $d_{lo}$: smallest diameter
    hi : float or array, >= 3
        $d_{hi}$: largest diameter, up to 31 above the smallest
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    mean : float or array
        $\\langle d \\rangle$: mean diameter
    sauter : float or array
        $\\bar{d}_s$: Sauter diameter
    d_30 : float or array
        $d_{30}$: diameter of the mean volume

    Formula as printed
    ------------------
        \\langle d \\rangle = \\sum p \\, d, \\quad \\bar{d}_s = \\frac{\\sum p \\, d^3}{\\sum p \\, d^2}, \\quad d_{30} = \\Big(\\sum p \\, d^3\\Big)^{1/3}

    Laws
    ----
    * the sauter diameter of the paper is not that of its box

    titania-lognormal, spec/mechanics/discretised_lognormal.rs, rounding error at most 1.5 ULP
    """

@overload
def fractal_number(k_f: float | str, d_g: float | str, d_s: float | str, d_f: float | str, *, check: bool = True) -> float:
    """Section 5.3, unnumbered: number of particles in an aggregate of a given diameter of gyration.

    Parameters
    ----------
    k_f : float or array, > 0
        $k_f$: fractal prefactor
    d_g : float or array [m], > 0
        $d_g$: diameter of gyration
    d_s : float or array [m], > 0
        $\\bar{d}_s$: Sauter diameter of the particles
    d_f : float or array, > 0
        $D_f$: fractal dimension
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    n_p : float or array
        $N_p$: number of particles

    Formula as printed
    ------------------
        N_p = k_f \\left(\\frac{d_g}{\\bar{d}_s}\\right)^{D_f}

    Reading
    -------
    As printed, with $k_f$ = 1.0 and $D_f$ = 1.8.

    Laws
    ----
    * one particle has its own diameter

    titania-kf, spec/titania/def_aggregate.rs, rounding error at most 0.5 ULP
    """
@overload
def fractal_number(k_f: ArrayLike | str, d_g: ArrayLike | str, d_s: ArrayLike | str, d_f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def fractal_diameter(k_f: float | str, n_p: float | str, d_s: float | str, d_f: float | str, *, check: bool = True) -> float:
    """Section 5.3, unnumbered: diameter of gyration of an aggregate of a given number of particles.

    Parameters
    ----------
    k_f : float or array, > 0
        $k_f$: fractal prefactor
    n_p : float or array, > 0
        $N_p$: number of particles
    d_s : float or array [m], > 0
        $\\bar{d}_s$: Sauter diameter of the particles
    d_f : float or array, > 0
        $D_f$: fractal dimension
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    d_g : float or array [m]
        $d_g$: diameter of gyration

    Formula as printed
    ------------------
        d_g = \\bar{d}_s \\left(\\frac{N_p}{k_f}\\right)^{1/D_f}

    Laws
    ----
    * number and diameter of gyration are inverse

    titania-kf-inv, spec/titania/def_aggregate.rs, rounding error at most 1 ULP
    """
@overload
def fractal_diameter(k_f: ArrayLike | str, n_p: ArrayLike | str, d_s: ArrayLike | str, d_f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def mobility_number(k_m: float | str, d_m: float | str, d_s: float | str, d_fm: float | str, *, check: bool = True) -> float:
    """Section 5.3, unnumbered: number of particles in an aggregate of a given mobility diameter.

    Parameters
    ----------
    k_m : float or array, > 0
        $k_m$: mass mobility prefactor
    d_m : float or array [m], > 0
        $d_m$: mobility diameter
    d_s : float or array [m], > 0
        $\\bar{d}_s$: Sauter diameter of the particles
    d_fm : float or array, > 0
        $D_{fm}$: mass mobility dimension
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    n_p : float or array
        $N_p$: number of particles

    Formula as printed
    ------------------
        N_p = k_m \\left(\\frac{d_m}{\\bar{d}_s}\\right)^{D_{fm}}

    Reading
    -------
    As printed, with $k_m$ = 1.0 and $D_{fm}$ = 2.15.

    Laws
    ----
    * at the same diameter a mobility sphere holds more

    titania-km, spec/titania/def_aggregate.rs, rounding error at most 1 ULP
    """
@overload
def mobility_number(k_m: ArrayLike | str, d_m: ArrayLike | str, d_s: ArrayLike | str, d_fm: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def sauter_diameter(v_tot: float | str, a_tot: float | str, *, check: bool = True) -> float:
    """Section 5.3, unnumbered: Sauter diameter of a collection of particles.

    Parameters
    ----------
    v_tot : float or array [m^3], > 0
        $V_{p,tot}$: volume of all particles
    a_tot : float or array [m^2], > 0
        $A_{p,tot}$: surface of all particles
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    d_s : float or array [m]
        $\\bar{d}_s$: Sauter diameter

    Formula as printed
    ------------------
        \\bar{d}_s = \\frac{6 V_{p,tot}}{A_{p,tot}} = \\frac{\\sum d^3}{\\sum d^2}

    Laws
    ----
    * the sauter diameter lies between the mean and the largest
    * mixtures of spheres have the diameter of the independent values

    titania-sauter, spec/titania/def_aggregate.rs, rounding error at most 0.5 ULP
    """
@overload
def sauter_diameter(v_tot: ArrayLike | str, a_tot: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _FreeRotation(NamedTuple):
    q_0_next: Any
    q_next: NDArray[np.float64]
    l_next: NDArray[np.float64]

def free_rotation(q_0: ArrayLike | str, q: ArrayLike, l: ArrayLike, i: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> _FreeRotation:
    """Section 5.3, unnumbered: free motion of a rigid aggregate over a time step.

    Parameters
    ----------
    q_0 : float or array
        $q_0$: scalar part of the orientation
    q : array (..., 3)
        $\\mathbf{q}$: vector part of the orientation
    l : array (..., 3) [kg m^2/s]
        $\\mathbf{L}$: angular momentum in the frame of the body
    i : array (..., 3) [kg m^2], > 0
        $I$: principal moments of inertia
    dt : float or array [s]
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    q_0_next : float or array
        $q_0$: scalar part of the orientation now
    q_next : array (..., 3)
        $\\mathbf{q}$: vector part of the orientation now
    l_next : array (..., 3) [kg m^2/s]
        $\\mathbf{L}$: angular momentum now

    Formula as printed
    ------------------
        A_3\\left(\\tfrac{\\Delta t}{2}\\right) A_2\\left(\\tfrac{\\Delta t}{2}\\right) A_1(\\Delta t) \\, A_2\\left(\\tfrac{\\Delta t}{2}\\right) A_3\\left(\\tfrac{\\Delta t}{2}\\right), \\quad
        A_k(t): \\; \\text{rotation about the principal axis } k \\text{ by } 4 \\arctan \\frac{L_k t}{4 I_k}

    Reading
    -------
    The paper says only "rigid aggregates". The kinetic energy is a sum of three terms, one for each principal axis, and each alone generates a rotation that
    can be evaluated exactly; in symmetric order they form a symplectic, reversible step of second order that preserves the lengths of the angular momentum
    and of the quaternion to rounding and the energy without drift (Dullweber, Leimkuhler & McLachlan; "no squish" of Miller et al.).

    The exact angle is $L_k t / I_k$. With the arctangent, which differs from it in the third order, sine and cosine are ratios, and the rate still depends
    on $L_k$ alone: the rotation belongs to a slightly different kinetic energy, so the step stays symplectic, reversible and of second order.

    Laws
    ----
    * energy and angular momentum of a free top do not drift
    * the step is reversible
    * of second order
    * a tennis racket flips
    * a sphere turns at a constant rate

    titania-free-rotation, spec/mechanics/rotation.rs, rounding error at most 5 ULP
    """

def to_space(q_0: ArrayLike | str, q: ArrayLike, v: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 5.3, unnumbered: a vector of the body in the frame of space.

    Parameters
    ----------
    q_0 : float or array
        $q_0$: scalar part of the orientation
    q : array (..., 3)
        $\\mathbf{q}$: vector part of the orientation
    v : array (..., 3) [m]
        $\\mathbf{v}$: vector in the frame of the body
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_space : array (..., 3) [m]
        $\\mathbf{v}'$: the vector in the frame of space

    Formula as printed
    ------------------
        \\mathbf{v}' = \\mathbf{v} + 2 q_0 \\, \\mathbf{q} \\times \\mathbf{v} + 2 \\, \\mathbf{q} \\times (\\mathbf{q} \\times \\mathbf{v})

    Reading
    -------
    For a quaternion of length one. With $-\\mathbf{q}$ it is the inverse, from space to the body: a torque $\\mathbf{M}$ in the frame of space changes
    $\\mathbf{L}$ by the transformed $\\mathbf{M} \\Delta t$.

    Laws
    ----
    * a vector keeps its length and comes back
    * a right angle turns as the right hand does

    titania-to-space, spec/mechanics/rotation.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _Spin(NamedTuple):
    omega: NDArray[np.float64]
    energy: Any

def spin(q_0: ArrayLike | str, q: ArrayLike, l: ArrayLike, i: ArrayLike, *, check: bool = True) -> _Spin:
    """Section 5.3, unnumbered: angular velocity and kinetic energy of rotation of a rigid aggregate.

    Parameters
    ----------
    q_0 : float or array
        $q_0$: scalar part of the orientation
    q : array (..., 3)
        $\\mathbf{q}$: vector part of the orientation
    l : array (..., 3) [kg m^2/s]
        $\\mathbf{L}$: angular momentum in the frame of the body
    i : array (..., 3) [kg m^2], > 0
        $I$: principal moments of inertia
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}$: angular velocity in the frame of space
    energy : float or array [J]
        $K$: kinetic energy of rotation

    Formula as printed
    ------------------
        \\omega_k = \\frac{L_k}{I_k}, \\quad K = \\frac{1}{2} \\sum_k \\frac{L_k^2}{I_k}

    Reading
    -------
    Both in the frame of the body; the angular velocity is then rotated to the space frame.

    Laws
    ----
    * the energy is half the product of angular velocity and momentum
    * moments of inertia times angular velocity are the angular momentum

    titania-spin, spec/mechanics/body.rs, rounding error at most 1 ULP
    """

def member_velocity(v: ArrayLike, omega: ArrayLike, r: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 5.3, unnumbered: velocity of a sphere of a rigid aggregate.

    Parameters
    ----------
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity of the centre of mass
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}$: angular velocity
    r : array (..., 3) [m]
        $\\mathbf{r}$: centre of the sphere from the centre of mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_p : array (..., 3) [m/s]
        $\\mathbf{v}_p$: velocity of the sphere

    Formula as printed
    ------------------
        \\mathbf{v}_p = \\mathbf{v} + \\boldsymbol{\\omega} \\times \\mathbf{r}

    Reading
    -------
    The sphere turns with the aggregate, at $\\boldsymbol{\\omega}$.

    Laws
    ----
    * spheres neither approach nor slide over each other

    titania-member-velocity, spec/mechanics/body.rs, rounding error at most 1 ULP
    """

@type_check_only
class _AggregateDrag(NamedTuple):
    force: NDArray[np.float64]
    torque: NDArray[np.float64]

def aggregate_drag(eta: ArrayLike | str, count: ArrayLike | str, s: ArrayLike, d_x: ArrayLike, d_y: ArrayLike, d_z: ArrayLike, v: ArrayLike, omega: ArrayLike, *, check: bool = True) -> _AggregateDrag:
    """Section 5.4, unnumbered: environmental viscosity on a rigid aggregate.

    Parameters
    ----------
    eta : float or array [kg/s], >= 0
        $\\eta$: drag coefficient of each sphere
    count : float or array, >= 1
        $N$: number of spheres
    s : array (..., 3) [m]
        $\\mathbf{s}$: sum of the places of the spheres from the centre of mass
    d_x : array (..., 3) [m^2]
        $\\mathbf{D}_x$: first row of the tensor
    d_y : array (..., 3) [m^2]
        $\\mathbf{D}_y$: second row
    d_z : array (..., 3) [m^2]
        $\\mathbf{D}_z$: third row
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity of the centre of mass
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}$: angular velocity
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force on the aggregate
    torque : array (..., 3) [N m]
        $\\mathbf{M}$: torque about its centre of mass

    Formula as printed
    ------------------
        \\mathbf{F} = -\\eta \\sum_p \\mathbf{v}_p = -\\eta \\left(N \\mathbf{v} + \\boldsymbol{\\omega} \\times \\mathbf{s}\\right), \\quad
        \\mathbf{M} = -\\eta \\sum_p \\mathbf{r}_p \\times \\mathbf{v}_p = -\\eta \\left(\\mathbf{s} \\times \\mathbf{v} + \\mathbf{D} \\, \\boldsymbol{\\omega}\\right)

    Reading
    -------
    "Acting on all particles": the drag of each sphere, summed over the aggregate, with $\\mathbf{s} = \\sum_p \\mathbf{r}_p$ and
    $\\mathbf{D} = \\sum_p (r_p^2 \\, \\mathbf{1} - \\mathbf{r}_p \\mathbf{r}_p)$, all in one frame.

    Laws
    ----
    * is the sum of the drags on the spheres

    titania-aggregate-drag, spec/mechanics/body.rs, rounding error at most 1 ULP
    """

def member_inertia(m: ArrayLike | str, r: ArrayLike | str, x: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 5.3, unnumbered: contribution of a sphere to the inertia tensor of its aggregate.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass of the sphere
    r : float or array [m], > 0
        $r$: radius of the sphere
    x : array (..., 3) [m]
        $\\mathbf{x}$: its centre, from the centre of mass of the aggregate
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    inertia : array (..., 3, 3) [kg m^2]
        $\\mathbf{I}$: inertia tensor about that centre of mass

    Formula as printed
    ------------------
        \\mathbf{I} = \\frac{2}{5} m r^2 \\, \\mathbf{1} + m \\left(x^2 \\, \\mathbf{1} - \\mathbf{x} \\mathbf{x}\\right)

    Reading
    -------
    "Rigid aggregates": the parallel-axis theorem. The spheres of an aggregate hardly overlap, and overlaps are ignored. The sum over the spheres, about
    the centre of mass, is the tensor of the aggregate; its eigenvalues are the principal moments.

    Laws
    ----
    * the kinetic energy of a turning dumbbell is half the product with the tensor
    * a sphere at the centre has its own moment
    * turning the place turns the tensor

    titania-inertia, spec/mechanics/body_inertia.rs, rounding error at most 1 ULP
    """

def member_momentum(m: ArrayLike | str, r: ArrayLike | str, x: ArrayLike, v: ArrayLike, omega: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 5.3, unnumbered: contribution of a sphere to the angular momentum of its aggregate.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass of the sphere
    r : float or array [m], > 0
        $r$: radius of the sphere
    x : array (..., 3) [m]
        $\\mathbf{x}$: its centre, from the centre of mass of the aggregate
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: its velocity
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}$: its angular velocity
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    l : array (..., 3) [kg m^2/s]
        $\\mathbf{L}$: angular momentum about that centre of mass

    Formula as printed
    ------------------
        \\mathbf{L} = m \\, \\mathbf{x} \\times \\mathbf{v} + \\frac{2}{5} m r^2 \\, \\boldsymbol{\\omega}

    Reading
    -------
    Spheres that become rigid while they move keep the sum of their angular momenta about the centre of mass, as they keep that of their momenta.

    Laws
    ----
    * the momentum of a turning body is the product with the tensor

    titania-angular-momentum, spec/mechanics/body_inertia.rs, rounding error at most 0.5 ULP
    """

@overload
def capacity(p: float | str, radius: float | str, *, check: bool = True) -> float:
    """Not in the paper: electrostatic capacity of a body, from the fraction of walks that hit it.

    Parameters
    ----------
    p : float or array, [0, 1]
        $p$: share of the walks that hit
    radius : float or array [m], > 0
        $R$: radius of the sphere on which they begin
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c : float or array [m]
        $C$: capacity

    Formula as printed
    ------------------
        C = p \\, R

    Reading
    -------
    The paper takes the hydrodynamic radius $R_H$ from the program ZENO (Mansfield, Douglas & Garboczi, Phys. Rev. E 64, 061401, 2001), which takes the
    capacity for it: Brownian walks start uniformly distributed on a sphere around the body; a fraction $p$ of them hits the body, the others escape.

    Laws
    ----
    * the capacity of a sphere is its radius wherever the walks begin

    titania-capacity, spec/mechanics/capacity.rs, rounding error at most 0.5 ULP
    """
@overload
def capacity(p: ArrayLike | str, radius: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def return_probability(radius: float | str, rho: float | str, *, check: bool = True) -> float:
    """Not in the paper: probability that a Brownian walk outside a sphere comes back to it.

    Parameters
    ----------
    radius : float or array [m], > 0
        $R$: radius of the sphere
    rho : float or array [m], > 0
        $\\rho$: distance from its centre, not below the radius
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    q : float or array
        $q$: probability

    Formula as printed
    ------------------
        q = \\frac{R}{\\rho}

    Laws
    ----
    * the capacity of a sphere is its radius wherever the walks begin

    titania-return, spec/mechanics/capacity.rs, rounding error at most 0.5 ULP
    """
@overload
def return_probability(radius: ArrayLike | str, rho: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def return_cosine(u: float | str, q: float | str, *, check: bool = True) -> float:
    """Not in the paper: point at which a returning walk meets a sphere.

    Parameters
    ----------
    u : float or array, [0, 1]
        $u$: random number, uniform
    q : float or array, (0, 1)
        $q$: radius over distance
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    cosine : float or array
        $\\cos\\theta$: cosine of the angle

    Formula as printed
    ------------------
        \\cos\\theta = \\frac{2 u (1 + q)^2 (1 - q + q u)}{(1 - q + 2 q u)^2} - 1

    Reading
    -------
    The density of $\\cos\\theta$ is Poisson's kernel, in proportion to $(1 + q^2 - 2 q \\cos\\theta)^{-3/2}$; this is the inverse of its integral,
    written without cancellation. $\\theta$ is the angle at the centre between the walk and the place.

    Laws
    ----
    * returns are distributed by the kernel of poisson
    * the mean cosine of returns is that of the field of a dipole

    titania-return-cosine, spec/mechanics/capacity.rs, rounding error at most 4 ULP
    """
@overload
def return_cosine(u: ArrayLike | str, q: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _FrictionFactor(NamedTuple):
    kn: Any
    cc: Any
    f: Any

def friction_factor(mu: ArrayLike | str, lam: ArrayLike | str, r_h: ArrayLike | str, pa: ArrayLike | str, *, check: bool = True) -> _FrictionFactor:
    """Eq. 14, Section 5.3: friction factor of an aggregate in a gas.

    Parameters
    ----------
    mu : float or array [Pa s], > 0
        $\\mu$: viscosity of the gas
    lam : float or array [m], > 0
        $\\lambda$: mean free path of the gas
    r_h : float or array [m], > 0
        $R_H$: hydrodynamic radius
    pa : float or array [m^2], > 0
        $PA$: mean projected area
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    kn : float or array
        $\\text{Kn}$: Knudsen number
    cc : float or array
        $C_C$: slip correction
    f : float or array [kg/s]
        $f$: friction factor

    Formula as printed
    ------------------
        f = \\frac{6\\pi\\mu R_H}{C_C\\left(\\frac{\\lambda\\pi R_H}{PA}\\right)}

    Reading
    -------
    Ambiguous: $C_C$ is a function of the Knudsen number in the parentheses, not a factor. The paper does not give it; with the coefficients of Davies,
    $C_C = 1 + \\text{Kn} (1.257 + 0.4 \\, e^{-1.1/\\text{Kn}})$.

    Laws
    ----
    * of a sphere the knudsen number is the free path over the radius
    * in a dense gas it is the drag of stokes
    * in a thin gas it depends on the projected area alone
    * between thin and dense gas the slip is that of cunningham

    titania-14, spec/titania/eq14_friction_factor.rs, rounding error at most 1 ULP
    """

@overload
def diffusion(kt: float | str, f: float | str, *, check: bool = True) -> float:
    """Section 5.3, unnumbered: diffusion coefficient of an aggregate.

    Parameters
    ----------
    kt : float or array [J], > 0
        $k_B T$: Boltzmann's constant times the temperature of the gas
    f : float or array [kg/s], > 0
        $f$: friction factor
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    d : float or array [m^2/s]
        $D$: coefficient of diffusion

    Formula as printed
    ------------------
        D = \\frac{k_B T}{f}

    Reading
    -------
    The relation of Einstein and Smoluchowski with the friction factor of Eq. 14.

    Laws
    ----
    * twice the friction is half the diffusion
    * the walk of a settling cloud balances its fall

    titania-diffusion, spec/mechanics/diffusion.rs, rounding error at most 0.5 ULP
    """
@overload
def diffusion(kt: ArrayLike | str, f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def exit_cosine(u: float | str, v: float | str, ell: float | str, d: float | str, *, check: bool = True) -> float:
    """Not in the paper: point at which a drifting Brownian walk leaves a sphere at whose centre it starts.

    Parameters
    ----------
    u : float or array, (0, 1]
        $u$: random number, uniform
    v : float or array [m/s], > 0
        $v$: velocity of the drift
    ell : float or array [m], > 0
        $\\ell$: radius of the ball
    d : float or array [m^2/s], > 0
        $D$: coefficient of diffusion
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    cosine : float or array
        $\\cos\\theta$: cosine of the angle between the drift and the place

    Formula as printed
    ------------------
        \\cos\\theta = 1 + \\frac{\\ln\\left(u + (1 - u) \\, e^{-2\\kappa}\\right)}{\\kappa}, \\quad \\kappa = \\frac{v \\ell}{2 D}

    Reading
    -------
    Without drift the exit point is distributed uniformly, independent of the exit time. By Girsanov's theorem a drift weights the paths with $e^{\\mathbf{v} \\cdot \\mathbf{x} / 2D}$
    and a function of that time: the density of $\\cos\\theta$, the inverse of whose integral this is, is proportional to $e^{\\kappa \\cos\\theta}$. A walk may therefore jump between
    spheres that are as large as the free space allows, without error. Written with $\\tanh \\kappa$ where the logarithm is that of a number near 1.

    Laws
    ----
    * exits are weighted with the exponential of the drift
    * the random number is the share of exits behind
    * a slow walk goes anywhere and a fast one ahead
    * the mean cosine of exits is that of langevin
    * exits behind keep their digits

    titania-exit, spec/mechanics/diffusion.rs, rounding error at most 5 ULP
    """
@overload
def exit_cosine(u: ArrayLike | str, v: ArrayLike | str, ell: ArrayLike | str, d: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...
