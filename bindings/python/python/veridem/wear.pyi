# Written by stubs.py.
# mypy: disable-error-code="overload-overlap"
"""Pham-Ba & Molinari 2022: adhesive wear of a cohesive solid. The equations, by the names of their functions."""

from typing import Any, NamedTuple, overload, type_check_only

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "amplification_matrix",
    "amplification_power",
    "amplify",
    "body_stress",
    "close_packed_energy",
    "close_packed_volume",
    "constant_11",
    "constant_12",
    "contact",
    "contact_torque",
    "critical_damping",
    "critical_diameter",
    "critical_drag",
    "critical_length",
    "critical_pair_damping",
    "critical_time_step",
    "damped_frequency",
    "damped_limit",
    "damping_of_critical",
    "damping_ratio",
    "damping_ratio_of",
    "effective_mass",
    "effective_radius",
    "eigenvalues",
    "elastic_moduli",
    "elastic_separation",
    "elastic_strain",
    "elastic_stress",
    "exact_damping",
    "explicit_step",
    "final_velocity",
    "force_parameters",
    "fracture_separation",
    "global_damping",
    "impact_duration",
    "impact_separation",
    "impact_velocity",
    "kick_and_drift",
    "kinetic_stress",
    "lognormal",
    "mass_factor",
    "matched_strength",
    "maximum_tangential_force",
    "minimum_diameter",
    "moment_arm",
    "moment_of_inertia",
    "natural_frequency",
    "normal_cross_section",
    "normal_damping",
    "normal_force",
    "normal_stiffness",
    "normal_stiffness_of_body",
    "normal_strain",
    "normal_stress",
    "pair_accelerations",
    "pair_energy",
    "pair_force",
    "pair_restitution",
    "pair_strain_energy",
    "pair_stress",
    "pair_time_step_limit",
    "potential",
    "published_contact",
    "relative_acceleration",
    "rescaled_maximum",
    "rescaled_separation",
    "restitution",
    "scaled_energy",
    "scaled_position",
    "scaled_step",
    "scaled_time_step",
    "scaled_velocity",
    "separation",
    "separation_meridional",
    "separation_of_surface_energy",
    "separation_radial",
    "separation_x",
    "separation_z",
    "separation_zonal",
    "shear_modulus",
    "sliding_damping_ratio",
    "sliding_limit",
    "sliding_mass",
    "sliding_velocity",
    "sphere_mass",
    "spring_energy",
    "stable_time_step",
    "state_after",
    "step_invariant",
    "stiffness_of_force",
    "stiffness_of_stress",
    "stretched_spring",
    "surface_energy",
    "surrounded_energy",
    "symplectic_euler",
    "tangential_cross_section",
    "tangential_damping",
    "tangential_force",
    "tangential_stiffness",
    "tangential_stiffness_of_body",
    "tangential_stress",
    "trimmed_distance",
    "truncated_moments",
    "velocity_at_the_end",
    "velocity_ratio",
    "volume_fraction",
    "wave_velocity",
    "weak_restitution",
    "weaker_restitution",
    "work_of_separation",
    "work_of_strength",
    "zero_force_duration",
    "zero_force_restitution",
]

@type_check_only
class _SymplecticEuler(NamedTuple):
    v_next: NDArray[np.float64]
    x_next: NDArray[np.float64]
    omega_next: NDArray[np.float64]

def symplectic_euler(x: ArrayLike, v: ArrayLike, omega: ArrayLike, force: ArrayLike, torque: ArrayLike, m: ArrayLike | str, i: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _SymplecticEuler:
    """Eq. 1, Section 2: one step of the symplectic Euler method for a particle.

    Parameters
    ----------
    x : array (..., 3) [m]
        $\\mathbf{x}_n$: position
    v : array (..., 3) [m/s]
        $\\mathbf{v}_n$: velocity
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_n$: angular velocity
    force : array (..., 3) [N]
        $\\mathbf{F}_n$: force on the particle
    torque : array (..., 3) [N m]
        $\\mathbf{T}_n$: torque on the particle about its centre
    m : float or array [kg], > 0
        $m$: mass
    i : float or array [kg m^2], > 0
        $I$: moment of inertia
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_next : array (..., 3) [m/s]
        $\\mathbf{v}_{n+1}$: velocity one step later
    x_next : array (..., 3) [m]
        $\\mathbf{x}_{n+1}$: position one step later
    omega_next : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{n+1}$: angular velocity one step later

    Formula as printed
    ------------------
        \\mathbf{v}_{n+1} = \\mathbf{v}_n + \\frac{\\mathbf{F}_n}{m} \\Delta t, \\quad
        \\mathbf{x}_{n+1} = \\mathbf{x}_n + \\mathbf{v}_{n+1} \\Delta t, \\quad
        \\boldsymbol{\\omega}_{n+1} = \\boldsymbol{\\omega}_n + \\mathbf{T}_n \\Delta t

    Reading
    -------
    Erratum: the third line lacks the moment of inertia; a torque times a time is not an angular velocity. It is
    $\\boldsymbol{\\omega}_{n+1} = \\boldsymbol{\\omega}_n + (\\mathbf{T}_n / I) \\Delta t$ with [`moment_of_inertia`](crate::mechanics::sphere::moment_of_inertia).
    Force and torque are those at the positions and velocities of step `n`, dashpots included.

    Effect: the units of the printed line do not balance. Taken in SI it would hardly turn spheres of nanometres, whose moments of inertia are about $10^{-42}$ kg m².

    Proof: `the_spin_gains_torque_times_time_which_the_printed_line_gets_wrong`.

    Laws
    ----
    * exact for a constant force up to half a step
    * the spin gains torque times time which the printed line gets wrong
    * the oscillator conserves its invariant and keeps its energy within bounds
    * the energy error is of first order in the time step
    * areas of phase space are kept
    * six steps of half the critical one return to the start
    * two particles keep momentum and angular momentum for any time step

    wear-1, spec/mechanics/symplectic_euler.rs, rounding error at most 0.5 ULP
    """

def pair_force(f_n: ArrayLike | str, c_n: ArrayLike | str, v_n: ArrayLike | str, n_n: ArrayLike, f_t: ArrayLike | str, c_t: ArrayLike | str, v_t: ArrayLike | str, n_t: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 2, Section 2.1: force on i in the pair of i and j.

    Parameters
    ----------
    f_n : float or array [N]
        $F_N$: normal force, positive when it attracts
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping factor
    v_n : float or array [m/s]
        $v_N$: rate of the separation
    n_n : array (..., 3), a unit vector
        $\\mathbf{n}_N$: normal, from j to i
    f_t : float or array [N], >= 0
        $F_T$: tangential force
    c_t : float or array [kg/s], >= 0
        $c_T$: tangential damping factor
    v_t : float or array [m/s]
        $v_T$: sliding velocity
    n_t : array (..., 3)
        $\\mathbf{n}_T$: unit vector of sliding, or zero for a pair at rest
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force on i

    Formula as printed
    ------------------
        \\mathbf{F} = -(F_N + c_N v_N) \\mathbf{n}_N - (F_T + c_T v_T) \\mathbf{n}_T

    Reading
    -------
    The normal points from j to i, so that a positive (cohesive) $F_N$ pulls i towards j, and the force acts on i; $v_N$ is the rate
    of the separation. In the printed form the spring and the sliding velocity share one direction. In general they do not: the pair
    law adds [`normal_part`] and [`tangential_part`], and this function is their sum for the shared direction. The cap of Eq. 5
    limits only $F_T$, as printed, not the parallel dashpot.

    Laws
    ----
    * reversing the normal reverses the normal part
    * an overlap pushes i away from j
    * dashpots never deliver power

    wear-2, spec/wear/eq02_pair_force.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _Separation(NamedTuple):
    delta_n: Any
    n: NDArray[np.float64]
    v_n: Any

def separation(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> _Separation:
    """Section 2, unnumbered: separation of the surfaces, their normal, and the normal velocity.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    v_i : array (..., 3) [m/s]
        $\\mathbf{v}_i$: velocity of i
    v_j : array (..., 3) [m/s]
        $\\mathbf{v}_j$: velocity of j
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_n : float or array [m]
        $\\delta_N$: separation of the surfaces, negative for an overlap
    n : array (..., 3)
        $\\mathbf{n}_N$: normal, from j to i
    v_n : float or array [m/s]
        $v_N$: rate of the separation

    Formula as printed
    ------------------
        \\delta_N = d_{ij} - r_i - r_j, \\quad \\mathbf{n}_N = \\frac{\\mathbf{x}_i - \\mathbf{x}_j}{d_{ij}}, \\quad
        v_N = (\\mathbf{v}_i - \\mathbf{v}_j) \\cdot \\mathbf{n}_N = \\dot\\delta_N

    Reading
    -------
    The paper does not state the direction of the normal. A positive force of Eq. 2 attracts if it points from j to i.

    Laws
    ----
    * the normal velocity is the rate of the separation
    * radii and separation add up to the distance along the normal
    * swapping the particles turns the normal round

    wear-separation, spec/wear/def_kinematics.rs, rounding error at most 1.5 ULP
    """

def sliding_velocity(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Section 2, unnumbered: sliding velocity of i over j at the contact point.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    v_i : array (..., 3) [m/s]
        $\\mathbf{v}_i$: velocity of i
    v_j : array (..., 3) [m/s]
        $\\mathbf{v}_j$: velocity of j
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_t : array (..., 3) [m/s]
        $\\mathbf{v}_T$: sliding velocity

    Formula as printed
    ------------------
        \\mathbf{v}_T = \\big(\\mathbf{v}_i - \\mathbf{v}_j\\big)_{\\perp \\mathbf{n}} - (a_i \\boldsymbol{\\omega}_i + a_j \\boldsymbol{\\omega}_j) \\times \\mathbf{n}_N

    Reading
    -------
    The paper cites the relative rolling velocity. It means the velocity of one surface relative to the other, which
    vanishes for a pair that rotates as a rigid body. [`moment_arm`] gives the arms.

    Laws
    ----
    * a pair that turns as one body does not slide
    * sliding lies in the contact plane
    * spheres without spin slide by what the gap does not take
    * a spin alone slides by its arm
    * sliding does not depend on the place

    wear-sliding-velocity, spec/wear/def_kinematics.rs, rounding error at most 4 ULP
    """

@overload
def moment_arm(r: float | str, delta_n: float | str, *, check: bool = True) -> float:
    """Section 2.1, unnumbered: distance of the contact point from the centre of a particle.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius of the particle
    delta_n : float or array [m]
        $\\delta_N$: separation of the surfaces, negative for an overlap
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    arm : float or array [m]
        $a$: moment arm

    Formula as printed
    ------------------
        a = r + \\frac{\\delta_N}{2}

    Reading
    -------
    Erratum: "the force acts on the surface of the particles" (Section 2.1, of Eq. 2) would give arms of $r$, which do not add up to the distance between the
    centres. With a contact point halfway between the surfaces they do.

    Effect: with arms of $r$ a force in the contact plane creates angular momentum at the rate $\\delta_N \\mathbf{n} \\times \\mathbf{F}$.

    Proof: `the_arms_add_up_to_the_distance_of_the_centres_which_the_radii_do_not`.

    Laws
    ----
    * the arms add up to the distance of the centres which the radii do not

    wear-arm, spec/wear/def_kinematics.rs, rounding error at most 0.5 ULP
    """
@overload
def moment_arm(r: ArrayLike | str, delta_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def contact_torque(arm: ArrayLike | str, force_t: ArrayLike, n: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 2.1, unnumbered: torque that the tangential force exerts on a particle.

    Parameters
    ----------
    arm : float or array [m]
        $a$: moment arm of the particle
    force_t : array (..., 3) [N]
        $\\mathbf{F}_T$: force on i in the contact plane
    n : array (..., 3), a unit vector
        $\\mathbf{n}_N$: normal, from j to i
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    torque : array (..., 3) [N m]
        $\\mathbf{T}$: torque on the particle about its centre

    Formula as printed
    ------------------
        \\mathbf{T}_i = a_i \\, \\mathbf{F}_T \\times \\mathbf{n}_N, \\quad \\mathbf{T}_j = a_j \\, \\mathbf{F}_T \\times \\mathbf{n}_N

    Reading
    -------
    "Computed directly from F and the appropriate moment arms". The contact point of i lies at $-a_i \\mathbf{n}_N$ and
    experiences $\\mathbf{F}_T$, the one of j at $+a_j \\mathbf{n}_N$ and experiences $-\\mathbf{F}_T$: both torques have the
    same sign.

    Laws
    ----
    * the torques balance the couple of the forces

    wear-torque, spec/wear/def_kinematics.rs, rounding error at most 0.5 ULP
    """

@overload
def normal_force(k_n: float | str, delta_e: float | str, delta_f: float | str, delta_n: float | str, *, check: bool = True) -> float:
    """Eq. 3, Section 2.1: normal force between two particles as a function of their separation.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    delta_e : float or array [m], > 0
        $\\delta_e$: elastic separation
    delta_f : float or array [m], > 0
        $\\delta_f$: fracture separation
    delta_n : float or array [m]
        $\\delta_N$: separation of the surfaces, negative for an overlap
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_n : float or array [N]
        $F_N$: force along the normal, positive when it attracts

    Formula as printed
    ------------------
        F_N = \\begin{cases} k_N \\delta_N & \\delta_N \\le \\delta_e \\\\
          -\\dfrac{k_N \\delta_e}{\\delta_f - \\delta_e} (\\delta_N - \\delta_f) & \\delta_e < \\delta_N \\le \\delta_f \\\\
          0 & \\text{otherwise} \\end{cases}

    Reading
    -------
    Erratum: for spheres larger than the critical diameter, Eq. 10 gives `delta_f < delta_e`, and the first case, read literally,
    reaches `delta_e`. Figure A.2 shows the intended law: Hooke's law up to `min(delta_e, delta_f)`, nothing beyond `delta_f`.

    Effect: read literally the scaling of the strength has no effect; large spheres would hold as much as small ones.

    Proof: `breaks_while_it_grows_if_the_fracture_separation_is_the_smaller_which_the_printed_cases_do_not`.

    Laws
    ----
    * hookean up to the elastic separation
    * weakens linearly from there to the fracture separation
    * zero beyond the fracture separation
    * continuous if it weakens before it breaks
    * breaks while it grows if the fracture separation is the smaller which the printed cases do not
    * reversible a closed loop through the whole range does no work at any speed
    * a passage leaves with the velocity it came with

    wear-3, spec/wear/eq03_normal_force.rs, rounding error at most 0.5 ULP
    """
@overload
def normal_force(k_n: ArrayLike | str, delta_e: ArrayLike | str, delta_f: ArrayLike | str, delta_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def potential(k_n: float | str, delta_e: float | str, delta_f: float | str, delta_n: float | str, *, check: bool = True) -> float:
    """Section 2.1, unnumbered: potential of the normal force of Eq. 3, zero for particles far apart.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    delta_e : float or array [m], > 0
        $\\delta_e$: elastic separation
    delta_f : float or array [m], > 0
        $\\delta_f$: fracture separation
    delta_n : float or array [m]
        $\\delta_N$: separation of the surfaces, negative for an overlap
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v : float or array [J]
        $V$: potential

    Formula as printed
    ------------------
        V = \\begin{cases} \\frac{1}{2} k_N \\left(\\delta_N^2 - \\min(\\delta_e, \\delta_f) \\, \\delta_f\\right) & \\delta_N \\le \\min(\\delta_e, \\delta_f) \\\\
          -\\dfrac{k_N \\delta_e (\\delta_f - \\delta_N)^2}{2 (\\delta_f - \\delta_e)} & \\delta_e < \\delta_N \\le \\delta_f \\\\
          0 & \\text{otherwise} \\end{cases}

    Reading
    -------
    The integral of Eq. 3 as read in its module. It is continuous even where the force jumps.

    Laws
    ----
    * the force is its slope
    * continuous whatever the force does
    * the work to part two particles is half the stiffness times both separations

    wear-potential, spec/wear/def_potential.rs, rounding error at most 0.5 ULP
    """
@overload
def potential(k_n: ArrayLike | str, delta_e: ArrayLike | str, delta_f: ArrayLike | str, delta_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tangential_force(k_t: float | str, delta_t: float | str, f_mt_rescaled: float | str, *, check: bool = True) -> float:
    """Eq. 4, Section 2.1: tangential force between two particles as a function of the sliding distance.

    Parameters
    ----------
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    delta_t : float or array [m], >= 0
        $\\delta_T$: sliding distance
    f_mt_rescaled : float or array [N], >= 0
        $F'_{m,T}$: largest tangential force at this separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_t : float or array [N]
        $F_T$: magnitude of the tangential force

    Formula as printed
    ------------------
        F_T = \\min(k_T \\delta_T, F_{m,T})

    Reading
    -------
    Erratum: a prime is missing. The cap is $F'_{m,T}$ of Eq. 5, which has no other use, and Figure 3 shows it.

    Effect: with the printed cap the force would not vanish at the fracture separation, where the interaction ends.

    Proof: `vanishes_at_the_fracture_separation_which_the_printed_cap_does_not`.

    A cap alone is not enough: the sliding distance must not grow beyond it, see [`trimmed_distance`].

    Laws
    ----
    * linear then flat
    * continuous at the cap
    * vanishes at the fracture separation which the printed cap does not

    wear-4, spec/wear/eq04_tangential_force.rs, rounding error at most 0.5 ULP
    """
@overload
def tangential_force(k_t: ArrayLike | str, delta_t: ArrayLike | str, f_mt_rescaled: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def trimmed_distance(k_t: float | str, delta_t: float | str, f_mt_rescaled: float | str, *, check: bool = True) -> float:
    """Section 2.1, unnumbered: sliding distance that remains once the force has reached its cap.

    Parameters
    ----------
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    delta_t : float or array [m], >= 0
        $\\delta_T$: sliding distance
    f_mt_rescaled : float or array [N], >= 0
        $F'_{m,T}$: largest tangential force at this separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_t_trimmed : float or array [m]
        $\\delta_T$: sliding distance retained by the spring

    Formula as printed
    ------------------
        \\delta_T := \\min\\left(\\delta_T, \\frac{F'_{m,T}}{k_T}\\right)

    Reading
    -------
    The paper does not define the sliding distance beyond the cap. If it kept growing, a pair could slide at a large
    separation, where the cap is small, and recover the distance in contact, where it is large: such a loop delivers
    work. The slider of the spring must therefore slip. Computed from the retained fraction $F_T / k_T \\delta_T$, one
    without slip, so that `k_t = 0` is allowed.

    Laws
    ----
    * trimming leaves the force
    * trimming never lengthens
    * a closed tangential loop delivers no work which the untrimmed one does

    wear-trim, spec/wear/eq04_tangential_force.rs, rounding error at most 0.5 ULP
    """
@overload
def trimmed_distance(k_t: ArrayLike | str, delta_t: ArrayLike | str, f_mt_rescaled: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def rescaled_maximum(delta_n: float | str, delta_f: float | str, f_mt: float | str, *, check: bool = True) -> float:
    """Eq. 5, Section 2.1: largest tangential force at a given separation.

    Parameters
    ----------
    delta_n : float or array [m]
        $\\delta_N$: separation of the surfaces, negative for an overlap
    delta_f : float or array [m], > 0
        $\\delta_f$: fracture separation
    f_mt : float or array [N], >= 0
        $F_{m,T}$: largest tangential force in contact
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_mt_rescaled : float or array [N]
        $F'_{m,T}$: largest tangential force at this separation

    Formula as printed
    ------------------
        F'_{m,T} = \\min\\left(\\frac{\\delta_f - \\delta_N}{\\delta_f}, 1\\right) F_{m,T}

    Reading
    -------
    Beyond the fracture separation, where the interaction has ended, the printed value is negative; the function returns
    zero.

    Laws
    ----
    * whole in contact
    * zero from the fracture separation on where the printed one is negative
    * never grows with the separation
    * halves half way

    wear-5, spec/wear/eq05_rescaled_maximum.rs, rounding error at most 1 ULP
    """
@overload
def rescaled_maximum(delta_n: ArrayLike | str, delta_f: ArrayLike | str, f_mt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def stretched_spring(xi: ArrayLike, n: ArrayLike, v_t: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Section 2, unnumbered: the tangential spring after a step of sliding.

    Parameters
    ----------
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring before
    n : array (..., 3), a unit vector
        $\\mathbf{n}_N$: normal now
    v_t : array (..., 3) [m/s]
        $\\mathbf{v}_T$: sliding velocity
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    xi_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring now, before it slips

    Formula as printed
    ------------------
        \\boldsymbol{\\xi} := \\boldsymbol{\\xi} - (\\boldsymbol{\\xi} \\cdot \\mathbf{n}_N) \\, \\mathbf{n}_N + \\mathbf{v}_T \\Delta t

    Reading
    -------
    The paper keeps a distance $\\delta_T \\ge 0$ and a direction $\\mathbf{n}_T$ "computed using the evolution of the rolling velocity". Together they
    are one vector in the contact plane, $\\boldsymbol{\\xi} = \\delta_T \\mathbf{n}_T$. It follows the rotating plane by projection; the length lost by
    projection is of second order in the angle and not restored. A spin of the pair about its normal does not rotate it.
    Where $|\\boldsymbol{\\xi}|$ exceeds its cap, it slips, as defined by the contact law.

    Laws
    ----
    * a spring stays in the contact plane
    * a pair at rest keeps its spring
    * sliding back relaxes it

    wear-spring, spec/mechanics/projected_spring.rs, rounding error at most 0.5 ULP
    """

def spring_energy(k_t: ArrayLike | str, xi: ArrayLike, *, check: bool = True) -> Any:
    """Section 2.1, unnumbered: energy stored in the tangential spring.

    Parameters
    ----------
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u_t : float or array [J]
        $U_T$: energy

    Formula as printed
    ------------------
        U_T = \\frac{1}{2} k_T \\, |\\boldsymbol{\\xi}|^2

    Laws
    ----
    * is the work of stretching it

    wear-spring-energy, spec/mechanics/projected_spring.rs, rounding error at most 1 ULP
    """

@type_check_only
class _Contact(NamedTuple):
    force: NDArray[np.float64]
    torque_i: NDArray[np.float64]
    torque_j: NDArray[np.float64]
    xi_next: NDArray[np.float64]

def contact(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, m_i: ArrayLike | str, m_j: ArrayLike | str, e: ArrayLike | str, nu: ArrayLike | str, sigma_mn: ArrayLike | str, sigma_mt: ArrayLike | str, gamma: ArrayLike | str, eta: ArrayLike | str, s: ArrayLike | str, xi: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> _Contact:
    """Section 2: the contact law as a whole, from two particles and a material to their forces.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    v_i : array (..., 3) [m/s]
        $\\mathbf{v}_i$: velocity of i
    v_j : array (..., 3) [m/s]
        $\\mathbf{v}_j$: velocity of j
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    m_i : float or array [kg], > 0
        $m_i$: mass of i
    m_j : float or array [kg], > 0
        $m_j$: mass of j
    e : float or array [Pa], > 0
        $E$: Young's modulus
    nu : float or array, (-1, 0.25]
        $\\nu$: Poisson's ratio
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    sigma_mt : float or array [Pa], >= 0
        $\\sigma_{m,T}$: shear strength
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    eta : float or array, [0, 1]
        $\\eta$: restitution coefficient
    s : float or array, >= 0
        $s$: scaling parameter
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: tangential spring before
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force on i; the force on j is its negative
    torque_i : array (..., 3) [N m]
        $\\mathbf{T}_i$: torque on i about its centre
    torque_j : array (..., 3) [N m]
        $\\mathbf{T}_j$: torque on j about its centre
    xi_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: tangential spring now

    Formula as printed
    ------------------
        (\\mathbf{x}, \\mathbf{v}, \\boldsymbol{\\omega}, r, m)_{i,j}, \\; \\text{material}, \\; \\boldsymbol{\\xi}, \\; \\Delta t \\mapsto
        \\mathbf{F}, \\mathbf{T}_i, \\mathbf{T}_j, \\boldsymbol{\\xi}

    Reading
    -------
    Eqs. 7 to 18 give the force parameters, Eqs. 2 to 5 the force. In this order: the spring follows the contact plane and is
    incremented by the sliding velocity; it slips where its force exceeds the cap of Eq. 5; the updated springs and the dashpots
    give the force. The dashpots act over the whole range, as in Eq. 2, so they start discontinuously at the fracture separation and
    may pull while the particles separate; they never deliver power.

    Laws
    ----
    * swapping i and j reverses the force
    * angular momentum is kept which arms of one radius do not
    * a rigid motion of the pair changes no force
    * turning the world turns the forces
    * beyond its range a pair feels and remembers nothing
    * dashpots never deliver power
    * the spring force never exceeds the cap
    * a spin about the normal leaves the spring
    * a dashpot sets in with a jump and may pull
    * spheres that overlap have the springs and dashpots of their material
    * at its range a pair still slides and is damped

    wear-contact, spec/wear/def_contact.rs, rounding error at most 2 ULP
    """

@type_check_only
class _PublishedContact(NamedTuple):
    force: NDArray[np.float64]
    torque_i: NDArray[np.float64]
    torque_j: NDArray[np.float64]
    xi_next: NDArray[np.float64]

def published_contact(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, m_i: ArrayLike | str, m_j: ArrayLike | str, e: ArrayLike | str, nu: ArrayLike | str, sigma_mn: ArrayLike | str, sigma_mt: ArrayLike | str, gamma: ArrayLike | str, eta: ArrayLike | str, s: ArrayLike | str, xi: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> _PublishedContact:
    """Section 2 as the authors' published program computes it: the contact law as a whole.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    v_i : array (..., 3) [m/s]
        $\\mathbf{v}_i$: velocity of i
    v_j : array (..., 3) [m/s]
        $\\mathbf{v}_j$: velocity of j
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    m_i : float or array [kg], > 0
        $m_i$: mass of i
    m_j : float or array [kg], > 0
        $m_j$: mass of j
    e : float or array [Pa], > 0
        $E$: Young's modulus
    nu : float or array, (-1, 0.25]
        $\\nu$: Poisson's ratio
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    sigma_mt : float or array [Pa], >= 0
        $\\sigma_{m,T}$: shear strength
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    eta : float or array, [0, 1]
        $\\eta$: restitution coefficient
    s : float or array, >= 0
        $s$: scaling parameter
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: tangential spring before
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force on i; the force on j is its negative
    torque_i : array (..., 3) [N m]
        $\\mathbf{T}_i$: torque on i about its centre
    torque_j : array (..., 3) [N m]
        $\\mathbf{T}_j$: torque on j about its centre
    xi_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: tangential spring now

    Formula as printed
    ------------------
        \\mathbf{F}_T = -\\min\\left(1, \\frac{F'_{m,T}}{|k_T \\boldsymbol{\\xi} + c_T \\mathbf{v}_T|}\\right) (k_T \\boldsymbol{\\xi} + c_T \\mathbf{v}_T), \\quad
        a = r

    Reading
    -------
    The program is a pair style of LAMMPS. It differs from [`contact`](super::def_contact::contact) twice. The cap of Eq. 5 limits the
    force of spring and dashpot together, where Eq. 2 adds the dashpot to the limited force of the spring; a pair that slips keeps the
    spring with which both have the limited force. And the arms, of the torques as of the sliding velocity, are the radii, so that a
    tangential force creates angular momentum. At every rebuild of its neighbour list it also forgets the springs of pairs that do not
    touch.

    Laws
    ----
    * without dashpots a touching pair that does not spin feels the same force
    * the whole tangential force never exceeds the cap which ours does
    * a pair that sticks has the spring of the paper
    * a tangential force creates angular momentum at the rate of the gap
    * what spring and dashpot lose is the work of the force
    * spheres that stick without spin act as in the paper but for the arms
    * at its range a pair is damped and without a stiffness nothing lags

    wear-published-contact, spec/wear/def_published.rs, rounding error at most 4 ULP
    """

@overload
def critical_time_step(m: float | str, k_n: float | str, *, check: bool = True) -> float:
    """Eq. 6, Section 2.1: critical time step of two equal particles in the elastic range.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass of either particle
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    dt_c : float or array [s]
        $\\Delta t_c$: critical time step

    Formula as printed
    ------------------
        \\Delta t_c = \\sqrt{\\frac{2m}{k_N}}

    Reading
    -------
    Erratum: a simulation does not remain stable at this time step. At the limit itself the motion grows linearly; and for a
    damped pair ([`damped_limit`](super::def_stable_step::damped_limit)) or one that slides and rotates
    ([`sliding_limit`](super::def_stable_step::sliding_limit)) the limit is lower. This is the critical time step of which the
    paper takes fractions; the pair law reports the smallest of the three limits.

    Effect: a simulation at the printed limit gains energy without bound.

    Proof: `not_stable_at_it_the_motion_grows_linearly`.

    Eq. A.18 repeats it.

    Laws
    ----
    * is twice the inverse frequency of the pair
    * stable below it bounded at 0 99
    * not stable at it the motion grows linearly
    * unstable above it the motion grows exponentially
    * the spectral radius crosses one there

    wear-6, spec/wear/eq06_critical_time_step.rs, rounding error at most 0.5 ULP
    """
@overload
def critical_time_step(m: ArrayLike | str, k_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def damped_limit(zeta: float | str, *, check: bool = True) -> float:
    """Appendix A.1, unnumbered: stability limit of a damped pair, as a fraction of Eq. 6.

    Parameters
    ----------
    zeta : float or array, >= 0
        $\\zeta$: damping ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    ratio : float or array
        $\\Delta t_{\\max} / \\Delta t_c$: largest stable fraction

    Formula as printed
    ------------------
        \\frac{\\Delta t_{\\max}}{\\Delta t_c} = \\sqrt{1 + \\zeta^2} - \\zeta

    Reading
    -------
    The dashpot of Eq. 2 acts with the old velocity, which lowers the limit. Evaluated as $1 / (\\sqrt{1 + \\zeta^2} + \\zeta)$,
    which avoids cancellation.

    Laws
    ----
    * no damping no reduction
    * is the damped fraction of eq 6

    wear-dtlim-damped, spec/wear/def_stable_step.rs, rounding error at most 1.5 ULP
    """
@overload
def damped_limit(zeta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _SlidingLimit(NamedTuple):
    ratio: Any
    k_ratio: Any

def sliding_limit(nu: ArrayLike | str, *, check: bool = True) -> _SlidingLimit:
    """Appendix A.1, unnumbered: stability limit of two equal solid spheres that slide and rotate, as a fraction of Eq. 6.

    Parameters
    ----------
    nu : float or array, (-1, 0.25)
        $\\nu$: Poisson's ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    ratio : float or array
        $\\Delta t_{\\max} / \\Delta t_c$: largest stable fraction
    k_ratio : float or array
        $k_T / k_N$: ratio of the stiffnesses

    Formula as printed
    ------------------
        \\frac{\\Delta t_{\\max}}{\\Delta t_c} = \\left(\\frac{7}{2} \\frac{k_T}{k_N}\\right)^{-1/2}, \\quad \\frac{k_T}{k_N} = \\frac{1 - 4\\nu}{1 + \\nu}

    Reading
    -------
    The effective mass of the tangential spring is 2/7 of the pair's. Below a Poisson's ratio of 1/6 this is the
    tighter limit.

    Laws
    ----
    * tighter than eq 6 below one sixth
    * is the sliding fraction of eq 6

    wear-dtlim-tang, spec/wear/def_stable_step.rs, rounding error at most 1 ULP
    """

@overload
def stable_time_step(m: float | str, k: float | str, c: float | str, *, check: bool = True) -> float:
    """Appendix A.1, unnumbered: largest stable time step of a mass on a spring and a dashpot.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    k : float or array [N/m], >= 0
        $k$: stiffness
    c : float or array [kg/s], >= 0
        $c$: damping factor
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    dt_max : float or array [s]
        $\\Delta t_{\\max}$: largest stable time step

    Formula as printed
    ------------------
        \\Delta t_{\\max} = \\frac{2}{\\sqrt{k/m + (c/2m)^2} + c/2m}

    Reading
    -------
    For the symplectic Euler method, whose dashpot acts with the old velocity. With $m = m_{\\mathrm{eff}}$ it is
    $\\Delta t_c (\\sqrt{1 + \\zeta^2} - \\zeta)$, with $\\tfrac{2}{7} m_{\\mathrm{eff}}$ and the tangential spring it is the limit of sliding.
    Written so that a missing spring or dashpot needs no exception.

    Laws
    ----
    * there the spectral radius of the step crosses one

    wear-dtlim, spec/mechanics/stable_step.rs, rounding error at most 1 ULP
    """
@overload
def stable_time_step(m: ArrayLike | str, k: ArrayLike | str, c: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def normal_stiffness(a_n: float | str, e: float | str, r_i: float | str, r_j: float | str, *, check: bool = True) -> float:
    """Eq. 7, Section 2.2: normal stiffness of a pair, equal to the stiffness of a bar of its cross-section between the two centres.

    Parameters
    ----------
    a_n : float or array [m^2], > 0
        $A_N$: normal cross section
    e : float or array [Pa], > 0
        $E$: Young's modulus
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_n : float or array [N/m]
        $k_N$: normal stiffness

    Formula as printed
    ------------------
        k_N = \\frac{A_N E}{r_i + r_j}

    Reading
    -------
    As printed; Eq. A.26 repeats it.

    Laws
    ----
    * swapping the particles changes nothing
    * the stress on the cross section is young s modulus times the strain
    * of equal spheres grows with the radius

    wear-7, spec/wear/eq07_normal_stiffness.rs, rounding error at most 0.5 ULP
    """
@overload
def normal_stiffness(a_n: ArrayLike | str, e: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tangential_stiffness(a_t: float | str, e: float | str, r_i: float | str, r_j: float | str, *, check: bool = True) -> float:
    """Eq. 8, Section 2.2: tangential stiffness of a pair.

    Parameters
    ----------
    a_t : float or array [m^2], >= 0
        $A_T$: tangential cross section
    e : float or array [Pa], > 0
        $E$: Young's modulus
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_t : float or array [N/m]
        $k_T$: tangential stiffness

    Formula as printed
    ------------------
        k_T = \\frac{A_T E}{r_i + r_j}

    Reading
    -------
    Eq. 7 with the tangential cross section. It contains Young's modulus, not the shear modulus: the cross section of
    Eq. 16 compensates for this.

    Eq. A.27 repeats it.

    Laws
    ----
    * its ratio to the normal stiffness depends on poisson s ratio alone
    * swapping the particles changes nothing

    wear-8, spec/wear/eq08_tangential_stiffness.rs, rounding error at most 0.5 ULP
    """
@overload
def tangential_stiffness(a_t: ArrayLike | str, e: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def elastic_separation(r_i: float | str, r_j: float | str, sigma_mn: float | str, e: float | str, *, check: bool = True) -> float:
    """Eq. 9, Section 2.2: separation up to which a pair is elastic.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    e : float or array [Pa], > 0
        $E$: Young's modulus
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_e : float or array [m]
        $\\delta_e$: elastic separation

    Formula as printed
    ------------------
        \\delta_e = \\frac{(r_i + r_j) \\sigma_{m,N}}{E}

    Reading
    -------
    As printed; Eq. A.29 repeats it.

    Laws
    ----
    * there the cross section carries the tensile strength
    * grows with the size of the particles

    wear-9, spec/wear/eq09_elastic_separation.rs, rounding error at most 0.5 ULP
    """
@overload
def elastic_separation(r_i: ArrayLike | str, r_j: ArrayLike | str, sigma_mn: ArrayLike | str, e: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def fracture_separation(gamma: float | str, sigma_mn: float | str, r_i: float | str, r_j: float | str, d_c: float | str, delta_e: float | str, s: float | str, *, check: bool = True) -> float:
    """Eq. 10, Section 2.2: separation at which the interaction of a pair ends.

    Parameters
    ----------
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    d_c : float or array [m], > 0
        $d_c$: critical diameter
    delta_e : float or array [m], > 0
        $\\delta_e$: elastic separation
    s : float or array, >= 0
        $s$: scaling parameter
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_f : float or array [m]
        $\\delta_f$: fracture separation

    Formula as printed
    ------------------
        \\delta_f = \\begin{cases} \\dfrac{4 \\gamma}{\\sigma_{m,N}} & r_i + r_j \\le d_c \\\\
          \\delta_e \\left(\\dfrac{r_i + r_j}{d_c}\\right)^{-s} & \\text{otherwise} \\end{cases}

    Reading
    -------
    The power is $e^{-s \\ln(\\cdot)}$. For large particles and `s > 0` the fracture separation is smaller than the elastic
    one: the pair then breaks while the force of Eq. 3 is still increasing.

    Laws
    ----
    * continuous at the critical diameter for every scaling
    * of small particles does not depend on their size
    * of large particles is the elastic separation if nothing scales
    * of large particles grows with the root of the size for a scaling of one half
    * of large particles does not depend on their size for a scaling of one
    * the work of separation is twice the surface energy for a scaling of one half

    wear-10, spec/wear/eq10_fracture_separation.rs, rounding error at most 1 ULP
    """
@overload
def fracture_separation(gamma: ArrayLike | str, sigma_mn: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, d_c: ArrayLike | str, delta_e: ArrayLike | str, s: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def maximum_tangential_force(a_t: float | str, sigma_mt: float | str, *, check: bool = True) -> float:
    """Eq. 11, Section 2.2: largest tangential force of a pair in contact.

    Parameters
    ----------
    a_t : float or array [m^2], >= 0
        $A_T$: tangential cross section
    sigma_mt : float or array [Pa], >= 0
        $\\sigma_{m,T}$: shear strength
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_mt : float or array [N]
        $F_{m,T}$: largest tangential force in contact

    Formula as printed
    ------------------
        F_{m,T} = A_T \\sigma_{m,T}

    Reading
    -------
    As printed; Eq. A.30 repeats it.

    Laws
    ----
    * the cross section carries the shear strength
    * none is left at a poisson s ratio of one quarter

    wear-11, spec/wear/eq11_maximum_tangential_force.rs, rounding error at most 0.5 ULP
    """
@overload
def maximum_tangential_force(a_t: ArrayLike | str, sigma_mt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def normal_damping(eta: float | str, k_n: float | str, m_eff: float | str, *, check: bool = True) -> float:
    """Eq. 12, Section 2.2: damping factor of the normal dashpot for a desired restitution coefficient.

    Parameters
    ----------
    eta : float or array, [0, 1]
        $\\eta$: restitution coefficient wanted
    k_n : float or array [N/m], >= 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\mathrm{eff}}$: effective mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_n : float or array [kg/s]
        $c_N$: normal damping factor

    Formula as printed
    ------------------
        c_N = \\frac{2 (1 - \\eta)}{\\pi} \\sqrt{k_N m_{\\mathrm{eff}}}

    Reading
    -------
    Erratum: the formula holds for weak damping only, as it inverts the approximation A.44 and not A.42. It is used as printed;
    [`damping_ratio`](super::def_restitution::damping_ratio) is exact.

    Effect: the actual restitution exceeds `eta` by about $(1 - \\eta)^2 / 2$: 0.9512 for 0.95, 0.603 for 0.5.

    Proof: `more_comes_back_than_wanted_by_half_the_square_of_the_loss`.

    Eq. A.45 repeats it.

    Laws
    ----
    * nothing is damped if everything comes back
    * the damping ratio is one less eta over pi
    * more comes back than wanted by half the square of the loss

    wear-12, spec/wear/eq12_normal_damping.rs, rounding error at most 1 ULP
    """
@overload
def normal_damping(eta: ArrayLike | str, k_n: ArrayLike | str, m_eff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def damping_ratio_of(c: float | str, k: float | str, m_eff: float | str, *, check: bool = True) -> float:
    """Appendix A.1.2, unnumbered: damping ratio of a spring and a dashpot in parallel.

    Parameters
    ----------
    c : float or array [kg/s], >= 0
        $c$: damping factor
    k : float or array [N/m], > 0
        $k$: stiffness
    m_eff : float or array [kg], > 0
        $m_{\\mathrm{eff}}$: effective mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    zeta : float or array
        $\\zeta$: damping ratio

    Formula as printed
    ------------------
        \\zeta = \\frac{c}{2 \\sqrt{k m_{\\mathrm{eff}}}}

    Laws
    ----
    * one for the critical damping of a pair

    wear-damping-ratio, spec/wear/def_restitution.rs, rounding error at most 0.5 ULP
    """
@overload
def damping_ratio_of(c: ArrayLike | str, k: ArrayLike | str, m_eff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def restitution(zeta: float | str, *, check: bool = True) -> float:
    """Appendix A.2, unnumbered: exact restitution coefficient for a given damping ratio (A.42).

    Parameters
    ----------
    zeta : float or array, [0, 1)
        $\\zeta$: damping ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    eta : float or array
        $\\eta$: restitution coefficient

    Formula as printed
    ------------------
        \\eta = e^{-\\pi \\zeta / \\sqrt{1 - \\zeta^2}}

    Reading
    -------
    The contact ends when the particles stop touching, as in the paper, not when the force vanishes.

    Laws
    ----
    * everything comes back without damping
    * less comes back the stronger the damping
    * is what an integrated collision gives

    wear-restitution, spec/wear/def_restitution.rs, rounding error at most 1 ULP
    """
@overload
def restitution(zeta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def damping_ratio(eta: float | str, *, check: bool = True) -> float:
    """Appendix A.2, unnumbered: exact damping ratio for a desired restitution coefficient.

    Parameters
    ----------
    eta : float or array, [0, 1]
        $\\eta$: desired restitution coefficient
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    zeta : float or array
        $\\zeta$: damping ratio

    Formula as printed
    ------------------
        \\zeta = \\frac{-\\ln \\eta}{\\sqrt{\\pi^2 + \\ln^2 \\eta}}

    Reading
    -------
    Its limit for $\\eta = 0$ is critical damping, $\\zeta = 1$, at which A.42 lets nothing come back.

    Laws
    ----
    * inverts the restitution
    * approaches eq 12 for weak damping
    * nothing comes back of critical damping

    wear-damping-ratio-exact, spec/wear/def_restitution.rs, rounding error at most 1 ULP
    """
@overload
def damping_ratio(eta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def exact_damping(eta: float | str, k: float | str, m_eff: float | str, *, check: bool = True) -> float:
    """Appendix A.2, unnumbered: exact damping factor for a desired restitution coefficient.

    Parameters
    ----------
    eta : float or array, [0, 1]
        $\\eta$: desired restitution coefficient
    k : float or array [N/m], >= 0
        $k$: stiffness
    m_eff : float or array [kg], > 0
        $m_{\\mathrm{eff}}$: effective mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c : float or array [kg/s]
        $c$: damping factor

    Formula as printed
    ------------------
        c = 2 \\zeta(\\eta) \\sqrt{k m_{\\mathrm{eff}}}

    Laws
    ----
    * gives the wanted restitution
    * nothing comes back of critical damping

    wear-damping-exact, spec/wear/def_restitution.rs, rounding error at most 1 ULP
    """
@overload
def exact_damping(eta: ArrayLike | str, k: ArrayLike | str, m_eff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tangential_damping(eta: float | str, k_t: float | str, m_eff: float | str, *, check: bool = True) -> float:
    """Eq. 13, Section 2.2: damping factor of the tangential dashpot.

    Parameters
    ----------
    eta : float or array, [0, 1]
        $\\eta$: restitution coefficient wanted
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    m_eff : float or array [kg], > 0
        $m_{\\mathrm{eff}}$: effective mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_t : float or array [kg/s]
        $c_T$: tangential damping factor

    Formula as printed
    ------------------
        c_T = \\frac{2 (1 - \\eta)}{\\pi} \\sqrt{k_T m_{\\mathrm{eff}}}

    Reading
    -------
    Erratum: the formula is Eq. 12 with the tangential stiffness, as if the spheres could not rotate. They can: solid spheres slide with 2/7 of
    the effective mass, see [`sliding_damping_ratio`]. Used as printed.

    Effect: the damping ratio of sliding is $\\sqrt{7/2}$ times as large as wanted.

    Proof: `is_the_damping_ratio_of_the_mass_that_slides`.

    Eq. A.47 repeats it.

    Laws
    ----
    * is to the normal damping as the roots of the stiffnesses

    wear-13, spec/wear/eq13_tangential_damping.rs, rounding error at most 1 ULP
    """
@overload
def tangential_damping(eta: ArrayLike | str, k_t: ArrayLike | str, m_eff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def sliding_damping_ratio(eta: float | str, *, check: bool = True) -> float:
    """Eq. 13, unnumbered: the actual damping ratio of two equal solid spheres that slide and rotate.

    Parameters
    ----------
    eta : float or array, [0, 1]
        $\\eta$: restitution coefficient wanted
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    zeta_t : float or array
        $\\zeta_T$: damping ratio of sliding

    Formula as printed
    ------------------
        \\zeta_T = \\sqrt{\\frac{7}{2}} \\, \\frac{1 - \\eta}{\\pi}

    Reading
    -------
    The effective mass of a solid sphere at its contact point is 2/7 of its mass: $1/m + r^2/I = 7/(2m)$.

    Laws
    ----
    * is the damping ratio of the mass that slides

    wear-sliding-damping, spec/wear/eq13_tangential_damping.rs, rounding error at most 1 ULP
    """
@overload
def sliding_damping_ratio(eta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def effective_radius(r_i: float | str, r_j: float | str, *, check: bool = True) -> float:
    """Eq. 14, Section 2.2: effective radius of a pair.

    Parameters
    ----------
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    r_eff : float or array [m]
        $r_{\\mathrm{eff}}$: effective radius

    Formula as printed
    ------------------
        r_{\\mathrm{eff}} = \\min(r_i, r_j)

    Reading
    -------
    As printed, and again in Eq. A.66: a choice.

    Laws
    ----
    * swapping the particles changes nothing
    * is the radius of equal spheres
    * no larger than either and equal to one

    wear-14, spec/wear/eq14_effective_radius.rs, rounding error at most 0 ULP
    """
@overload
def effective_radius(r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def normal_cross_section(r_eff: float | str, nu: float | str, *, check: bool = True) -> float:
    """Eq. 15, Section 2.2: effective cross section of a pair for the normal force.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $r_{\\mathrm{eff}}$: effective radius
    nu : float or array, (-1, 0.25]
        $\\nu$: Poisson's ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a_n : float or array [m^2]
        $A_N$: normal cross section

    Formula as printed
    ------------------
        A_N = \\sqrt{2} \\, r_{\\mathrm{eff}}^2 \\, \\frac{1}{1 - 2\\nu}

    Reading
    -------
    As printed; Eq. A.64 derives it for equal radii.

    Laws
    ----
    * grows with the square of the radius
    * doubles from a poisson s ratio of zero to one quarter
    * grows with poisson s ratio
    * a body of such pairs has the young s modulus of the material

    wear-15, spec/wear/eq15_normal_cross_section.rs, rounding error at most 1 ULP
    """
@overload
def normal_cross_section(r_eff: ArrayLike | str, nu: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tangential_cross_section(r_eff: float | str, nu: float | str, *, check: bool = True) -> float:
    """Eq. 16, Section 2.2: effective cross section of a pair for the tangential force.

    Parameters
    ----------
    r_eff : float or array [m], > 0
        $r_{\\mathrm{eff}}$: effective radius
    nu : float or array, (-1, 0.25]
        $\\nu$: Poisson's ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a_t : float or array [m^2]
        $A_T$: tangential cross section

    Formula as printed
    ------------------
        A_T = \\sqrt{2} \\, r_{\\mathrm{eff}}^2 \\, \\frac{1 - 4\\nu}{(1 - 2\\nu)(1 + \\nu)}

    Reading
    -------
    Negative above a Poisson's ratio of 1/4, where the model ends, as the paper says. Eq. A.65 derives it for equal
    radii.

    Laws
    ----
    * equals the normal one without lateral contraction
    * vanishes at one quarter and is negative beyond
    * shrinks as poisson s ratio grows

    wear-16, spec/wear/eq16_tangential_cross_section.rs, rounding error at most 0.5 ULP
    """
@overload
def tangential_cross_section(r_eff: ArrayLike | str, nu: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def effective_mass(m_i: float | str, m_j: float | str, *, check: bool = True) -> float:
    """Eq. 17, Section 2.2: effective mass of two particles that oscillate against each other.

    Parameters
    ----------
    m_i : float or array [kg], > 0
        $m_i$: mass of i
    m_j : float or array [kg], > 0
        $m_j$: mass of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    m_eff : float or array [kg]
        $m_{\\mathrm{eff}}$: effective mass

    Formula as printed
    ------------------
        m_{\\mathrm{eff}} = \\frac{m_i m_j}{m_i + m_j}

    Reading
    -------
    As printed; Eq. A.3 repeats it.

    Laws
    ----
    * swapping the particles changes nothing
    * half the mass of equal particles
    * below either mass and that of the lighter one against a wall

    wear-17, spec/mechanics/reduced_mass.rs, rounding error at most 1 ULP
    """
@overload
def effective_mass(m_i: ArrayLike | str, m_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def sphere_mass(rho: float | str, r: float | str, *, check: bool = True) -> float:
    """Section 2, unnumbered: mass of a sphere.

    Parameters
    ----------
    rho : float or array [kg/m^3], > 0
        $\\rho$: density
    r : float or array [m], > 0
        $r$: radius
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    m : float or array [kg]
        $m$: mass

    Formula as printed
    ------------------
        m = \\frac{4}{3} \\pi \\rho r^3

    Laws
    ----
    * eight times the mass for twice the radius
    * sums the shells of the sphere

    wear-sphere-mass, spec/mechanics/sphere.rs, rounding error at most 1 ULP
    """
@overload
def sphere_mass(rho: ArrayLike | str, r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def moment_of_inertia(m: float | str, r: float | str, *, check: bool = True) -> float:
    """Section 2, unnumbered: moment of inertia of a solid sphere about its centre.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    r : float or array [m], > 0
        $r$: radius
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    i : float or array [kg m^2]
        $I$: moment of inertia

    Formula as printed
    ------------------
        I = \\frac{2}{5} m r^2

    Reading
    -------
    Missing in Eq. 1. The paper's particles are solid spheres of the material.

    Laws
    ----
    * sums the shells of the sphere

    wear-inertia, spec/mechanics/sphere.rs, rounding error at most 1 ULP
    """
@overload
def moment_of_inertia(m: ArrayLike | str, r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def sliding_mass(m_eff: float | str, *, check: bool = True) -> float:
    """Appendix A.1, unnumbered: mass that resists the sliding of two equal solid spheres over each other.

    Parameters
    ----------
    m_eff : float or array [kg], > 0
        $m_{\\mathrm{eff}}$: effective mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    m_t : float or array [kg]
        $m_T$: mass that slides

    Formula as printed
    ------------------
        m_T = \\frac{2}{7} m_{\\mathrm{eff}}

    Reading
    -------
    The paper uses the effective mass of Eq. 17 for sliding. But a force on the surface of a sphere also rotates it, and the surface moves with
    $1/m + r^2/I = 7/(2m)$.

    Laws
    ----
    * is what a force on the two surfaces accelerates

    wear-sliding-mass, spec/mechanics/sphere.rs, rounding error at most 1 ULP
    """
@overload
def sliding_mass(m_eff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def critical_diameter(gamma: float | str, e: float | str, sigma_mn: float | str, *, check: bool = True) -> float:
    """Eq. 18, Section 2.2: critical diameter of the particles.

    Parameters
    ----------
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    e : float or array [Pa], > 0
        $E$: Young's modulus
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    d_c : float or array [m]
        $d_c$: critical diameter

    Formula as printed
    ------------------
        d_c = \\frac{4 \\gamma E}{\\sigma_{m,N}^2}

    Reading
    -------
    As printed; Eq. A.48 repeats it.

    Laws
    ----
    * there the elastic separation is the range
    * of the patch tests is 150 and of silica 1 7 nm

    wear-18, spec/wear/eq18_critical_diameter.rs, rounding error at most 0.5 ULP
    """
@overload
def critical_diameter(gamma: ArrayLike | str, e: ArrayLike | str, sigma_mn: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def minimum_diameter(gamma: float | str, sigma_mn: float | str, *, check: bool = True) -> float:
    """Eq. 19, Section 2.2: smallest reasonable diameter, at which the range of a particle equals its diameter.

    Parameters
    ----------
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    d_min : float or array [m]
        $d_{\\min}$: smallest diameter

    Formula as printed
    ------------------
        d_{\\min} = \\frac{4 \\gamma}{\\sigma_{m,N}}

    Reading
    -------
    As printed: the separation of A.34, at which small particles break, as a diameter.

    Laws
    ----
    * is to the critical diameter as the strength to young s modulus
    * is the range of small particles
    * of the patch tests is 30 and of silica 0 375 nm

    wear-19, spec/wear/eq19_minimum_diameter.rs, rounding error at most 0.5 ULP
    """
@overload
def minimum_diameter(gamma: ArrayLike | str, sigma_mn: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _ForceParameters(NamedTuple):
    k_n: Any
    k_t: Any
    delta_e: Any
    delta_f: Any
    f_mt: Any
    c_n: Any
    c_t: Any

def force_parameters(e: ArrayLike | str, nu: ArrayLike | str, sigma_mn: ArrayLike | str, sigma_mt: ArrayLike | str, gamma: ArrayLike | str, eta: ArrayLike | str, s: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, m_i: ArrayLike | str, m_j: ArrayLike | str, *, check: bool = True) -> _ForceParameters:
    """Table 2 and Section 2.2, Eqs. 7 to 18 in sequence: the force parameters of a pair that match a given material.

    Parameters
    ----------
    e : float or array [Pa], > 0
        $E$: Young's modulus
    nu : float or array, (-1, 0.25]
        $\\nu$: Poisson's ratio
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    sigma_mt : float or array [Pa], >= 0
        $\\sigma_{m,T}$: shear strength
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    eta : float or array, [0, 1]
        $\\eta$: restitution coefficient
    s : float or array, >= 0
        $s$: scaling parameter
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    m_i : float or array [kg], > 0
        $m_i$: mass of i
    m_j : float or array [kg], > 0
        $m_j$: mass of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_n : float or array [N/m]
        $k_N$: normal stiffness
    k_t : float or array [N/m]
        $k_T$: tangential stiffness
    delta_e : float or array [m]
        $\\delta_e$: elastic separation
    delta_f : float or array [m]
        $\\delta_f$: fracture separation
    f_mt : float or array [N]
        $F_{m,T}$: largest tangential force in contact
    c_n : float or array [kg/s]
        $c_N$: normal damping factor
    c_t : float or array [kg/s]
        $c_T$: tangential damping factor

    Formula as printed
    ------------------
        (E, \\nu, \\sigma_{m,N}, \\sigma_{m,T}, \\gamma, \\eta, s; \\; r_i, r_j, m_i, m_j) \\mapsto (k_N, k_T, \\delta_e, \\delta_f, F_{m,T}, c_N, c_T)

    Laws
    ----
    * swapping the particles changes nothing
    * of small particles the work of separation is twice the surface energy
    * a larger material of larger particles is the same material

    wear-parameters, spec/wear/def_parameters.rs, rounding error at most 0.5 ULP
    """

@overload
def matched_strength(sigma_mn: float | str, r_i: float | str, r_j: float | str, d_c: float | str, s: float | str, *, check: bool = True) -> float:
    """Eq. 20, Section 2.2: tensile strength that is matched.

    Parameters
    ----------
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    d_c : float or array [m], > 0
        $d_c$: critical diameter
    s : float or array, >= 0
        $s$: scaling parameter
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma_mn_matched : float or array [Pa]
        $\\sigma'_{m,N}$: matched tensile strength

    Formula as printed
    ------------------
        \\sigma'_{m,N} = \\sigma_{m,N} \\left(\\frac{r_i + r_j}{d_c}\\right)^{-s}

    Reading
    -------
    Stated for particles beyond the critical diameter; below it the strength itself is matched, and the function returns
    it.

    Laws
    ----
    * is the largest force on the cross section only if large particles break while elastic
    * continuous at the critical diameter
    * falls with the size by the power of the scaling

    wear-20, spec/wear/eq20_matched_strength.rs, rounding error at most 0.5 ULP
    """
@overload
def matched_strength(sigma_mn: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, d_c: ArrayLike | str, s: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _ElasticModuli(NamedTuple):
    nu: Any
    e: Any

def elastic_moduli(c11: ArrayLike | str, c12: ArrayLike | str, *, check: bool = True) -> _ElasticModuli:
    """Section 3, unnumbered: moduli of a cubic or isotropic solid from the stresses of a confined sample.

    Parameters
    ----------
    c11 : float or array [Pa], > 0
        $C_{11}$: stress over strain along the load
    c12 : float or array [Pa]
        $C_{12}$: stress across the load over the same strain
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    nu : float or array
        $\\nu$: Poisson's ratio
    e : float or array [Pa]
        $E$: Young's modulus

    Formula as printed
    ------------------
        \\nu = \\frac{C_{12}}{C_{11} + C_{12}}, \\quad E = \\frac{(C_{11} - C_{12})(C_{11} + 2 C_{12})}{C_{11} + C_{12}}

    Laws
    ----
    * hooke s law gives the coefficients back
    * a sample that does not push sideways has no lateral contraction

    wear-EnuFromC, spec/wear/def_elastic_constants.rs, rounding error at most 1 ULP
    """

@overload
def critical_damping(k_n: float | str, m: float | str, *, check: bool = True) -> float:
    """Eq. 21, Section 3: critical damping of a system of two equal particles.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m : float or array [kg], > 0
        $m$: mass of either particle
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_c : float or array [kg/s]
        $c_c$: critical damping

    Formula as printed
    ------------------
        c_c = \\sqrt{2 k_N m}

    Reading
    -------
    Erratum: this value is critical for the dashpot between the two particles. The paper measures its *global* damping, a drag on each particle, in
    units of it; for a drag the critical value is [`critical_drag`], twice as large. As a unit it is used as printed.

    Effect: a global damping of $0.2 c_c$ is a tenth of the critical one, not a fifth.

    Proof: `a_drag_of_eq_21_lets_the_pair_overshoot`.

    Laws
    ----
    * a dashpot of less lets the pair overshoot and of more does not

    wear-21, spec/wear/eq21_critical_damping.rs, rounding error at most 0.5 ULP
    """
@overload
def critical_damping(k_n: ArrayLike | str, m: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def critical_drag(k_n: float | str, m: float | str, *, check: bool = True) -> float:
    """Section 3, unnumbered: critical coefficient of a drag on each of two equal particles.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m : float or array [kg], > 0
        $m$: mass of either particle
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_g : float or array [kg/s]
        $c_g$: critical coefficient of the drag

    Formula as printed
    ------------------
        c_g = 2 c_c = 2 \\sqrt{2 k_N m}

    Reading
    -------
    Drags on both particles act on the separation like a dashpot of half the coefficient.

    Laws
    ----
    * a drag of less lets the pair overshoot and of more does not
    * a drag of eq 21 lets the pair overshoot

    wear-critical-drag, spec/wear/eq21_critical_damping.rs, rounding error at most 0.5 ULP
    """
@overload
def critical_drag(k_n: ArrayLike | str, m: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def global_damping(c: ArrayLike | str, v: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 3, unnumbered: global damping, a drag on every particle.

    Parameters
    ----------
    c : float or array [kg/s], >= 0
        $c$: coefficient of the drag
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force on the particle

    Formula as printed
    ------------------
        \\mathbf{F} = -c \\mathbf{v}

    Reading
    -------
    Not printed: the paper states the coefficient $c$ of a "global damping", in units of Eq. 21. It acts on velocities, not on spins.

    Laws
    ----
    * a drag takes power

    wear-global-damping, spec/mechanics/drag.rs, rounding error at most 0.5 ULP
    """

def pair_stress(volume: ArrayLike | str, r: ArrayLike, f: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 3, unnumbered: contribution of one pair to the virial stress, positive in tension.

    Parameters
    ----------
    volume : float or array [m^3], > 0
        $V$: volume
    r : array (..., 3) [m]
        $\\mathbf{r}$: from the centre of i to that of j
    f : array (..., 3) [N]
        $\\mathbf{f}$: force of j on i
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma : array (..., 3, 3) [Pa]
        $\\sigma_{ab}$: stress

    Formula as printed
    ------------------
        \\sigma_{ab} = \\frac{1}{V} r_a f_b

    Reading
    -------
    The paper refers to a citation. The stress of a volume is the sum over its pairs, each counted once; `r` leads from i to j and `f`
    is the force on i, so that attraction is tension.

    Laws
    ----
    * swapping the particles changes nothing
    * attraction is tension
    * the stress does the work of the pair
    * a central force gives a symmetric stress

    wear-virial, spec/mechanics/virial.rs, rounding error at most 0.5 ULP
    """

def kinetic_stress(volume: ArrayLike | str, m: ArrayLike | str, v: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 3, unnumbered: contribution of one particle's motion to the virial stress.

    Parameters
    ----------
    volume : float or array [m^3], > 0
        $V$: volume
    m : float or array [kg], > 0
        $m$: mass
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity relative to the mean motion
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma : array (..., 3, 3) [Pa]
        $\\sigma_{ab}$: stress

    Formula as printed
    ------------------
        \\sigma_{ab} = -\\frac{1}{V} m v_a v_b

    Reading
    -------
    With the velocity relative to the mean motion; otherwise the stress would depend on the observer.

    Laws
    ----
    * motion is pressure
    * the pressure of motion is two thirds of its energy density and along the velocity

    wear-virial-kinetic, spec/mechanics/virial.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _Lognormal(NamedTuple):
    mu: Any
    sigma: Any

def lognormal(d_0: ArrayLike | str, d_s: ArrayLike | str, d_l: ArrayLike | str, *, check: bool = True) -> _Lognormal:
    """Section 3.2, unnumbered: parameters of the log-normal distribution of the diameters.

    Parameters
    ----------
    d_0 : float or array, > 0
        $d_0$: mode of the diameters
    d_s : float or array, > 0
        $d_s$: smallest diameter
    d_l : float or array, > 0
        $d_l$: largest diameter, above the smallest
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    mu : float or array
        $\\mu$: mean of the logarithm
    sigma : float or array
        $\\sigma$: standard deviation of the logarithm

    Formula as printed
    ------------------
        e^{\\mu - \\sigma^2} = d_0, \\quad e^{2\\mu + \\sigma^2} (e^{\\sigma^2} - 1) = \\big(0.2 \\, (d_l - d_s)\\big)^2

    Reading
    -------
    The paper gives the mode and the standard deviation. This deviation is taken before the truncation to $[d_s, d_l]$: with this reading, the volumes
    of Table 6 hold the particles it counts. With $u = e^{\\sigma^2} - 1$ the two conditions leave
    $u (1 + u)^3 = (0.2 (d_l - d_s) / d_0)^2$, which Newton's method solves from above, where it converges monotonically: ten steps are
    more than enough for any number. $\\ln(1 + u)$ is evaluated as $u \\ln w / (w - 1)$ with $w = 1 + u$ rounded, which
    loses nothing for small `u`; where `w` is one, it is `u`.

    A logarithm requires a dimensionless argument: diameters are multiples of any one unit of length.

    Laws
    ----
    * has the mode and the standard deviation
    * does not depend on the unit of length
    * narrow and wide distributions have the standard deviation

    wear-lognormal, spec/mechanics/truncated_lognormal.rs, rounding error at most 1.5 ULP
    """

@type_check_only
class _TruncatedMoments(NamedTuple):
    kept: Any
    mean: Any
    std: Any
    m3: Any

def truncated_moments(d_0: ArrayLike | str, d_s: ArrayLike | str, d_l: ArrayLike | str, *, check: bool = True) -> _TruncatedMoments:
    """Section 3.2, unnumbered: fraction, mean, standard deviation and mean cube of the diameters that the truncation keeps.

    Parameters
    ----------
    d_0 : float or array [m], > 0
        $d_0$: mode of the diameters
    d_s : float or array [m], > 0
        $d_s$: smallest diameter, below the mode
    d_l : float or array [m], > 0
        $d_l$: largest diameter, above the mode
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    kept : float or array
        $K$: fraction of the drawn diameters that is kept
    mean : float or array [m]
        $\\langle d \\rangle$: mean diameter
    std : float or array [m]
        $\\sqrt{\\langle d^2 \\rangle - \\langle d \\rangle^2}$: standard deviation of the diameters
    m3 : float or array [m^3]
        $\\langle d^3 \\rangle$: mean cube of the diameters

    Formula as printed
    ------------------
        \\langle d^k \\rangle = \\frac{e^{k\\mu + k^2 \\sigma^2 / 2}}{K} \\Big[\\Phi\\big(z_l - k\\sigma\\big) - \\Phi\\big(z_s - k\\sigma\\big)\\Big], \\quad
        z = \\frac{\\ln d - \\mu}{\\sigma}, \\quad K = \\Phi(z_l) - \\Phi(z_s)

    Reading
    -------
    $\\Phi$ is the normal distribution. All diameters are taken relative to the mode, with $e^\\mu = d_0 e^{\\sigma^2}$:
    $z = \\ln(d / d_0) / \\sigma - \\sigma$. The mode lies between the bounds: without $d_s < d_0 < d_l$ there is no value.

    Where both limits of a moment, shifted by a multiple of $\\sigma$, are beyond 2.5 on one side, the complements of $\\Phi$ are subtracted, as a continued fraction: values near one half would lose digits.
    The variance is a difference of nearly equal moments where the distribution is narrow. Up to $\\sigma = 1/2$ it is that of $e^{\\sigma z} - 1$, expanded in powers of $\\sigma$: with
    $t_n = \\frac{\\sigma^n}{n!} \\int_{z_s}^{z_l} z^n \\varphi(z) \\, dz$ its first two moments are $\\frac{1}{K} \\sum_{n \\ge 1} t_n$ and $\\frac{1}{K} \\sum_{n \\ge 2} (2^n - 2) \\, t_n$, and
    $t_n = \\frac{\\sigma^2}{n} t_{n-2} + \\frac{\\sigma^n}{n!} \\big[z_s^{n-1} \\varphi(z_s) - z_l^{n-1} \\varphi(z_l)\\big]$.

    Laws
    ----
    * the moments are those of the density
    * the deviation of a narrow distribution keeps its digits
    * the moments far in one tail keep their digits
    * gives the numbers of particles of table 6
    * without a mode between the bounds there is no value

    wear-lognormal-truncated, spec/mechanics/truncated_lognormal.rs, rounding error at most 100 ULP
    """

@overload
def volume_fraction(sum_d3: float | str, volume: float | str, *, check: bool = True) -> float:
    """Section 3.2, unnumbered: volume fraction of spheres in a box.

    Parameters
    ----------
    sum_d3 : float or array [m^3], >= 0
        $\\sum d^3$: sum of the cubes of the diameters
    volume : float or array [m^3], > 0
        $V$: volume of the box
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    phi : float or array
        $\\phi$: volume fraction

    Formula as printed
    ------------------
        \\phi = \\frac{1}{V} \\frac{\\pi}{6} \\sum d^3

    Reading
    -------
    Overlaps count twice: a sample is filled to 0.75 before it is relaxed.

    Laws
    ----
    * of close packed spheres is 0 74

    wear-volume-fraction, spec/mechanics/packing.rs, rounding error at most 1 ULP
    """
@overload
def volume_fraction(sum_d3: ArrayLike | str, volume: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def mass_factor(rho: float | str, volume: float | str, sum_m: float | str, *, check: bool = True) -> float:
    """Section 3.2, unnumbered: factor by which all masses are changed after the relaxation.

    Parameters
    ----------
    rho : float or array [kg/m^3], > 0
        $\\rho$: density of the material
    volume : float or array [m^3], > 0
        $V$: volume of the system
    sum_m : float or array [kg], > 0
        $\\sum m$: mass of all particles
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    alpha : float or array
        $\\alpha$: factor of the masses

    Formula as printed
    ------------------
        \\alpha = \\frac{\\rho V}{\\sum m}

    Laws
    ----
    * gives the system the density of the material
    * of spheres of the material is the inverse volume fraction

    wear-mass-factor, spec/mechanics/packing.rs, rounding error at most 0.5 ULP
    """
@overload
def mass_factor(rho: ArrayLike | str, volume: ArrayLike | str, sum_m: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def critical_length(gamma: float | str, g: float | str, sigma_mt: float | str, *, check: bool = True) -> float:
    """Eq. 22, Section 4: critical length scale of a sheared cylindrical junction.

    Parameters
    ----------
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    g : float or array [Pa], > 0
        $G$: shear modulus
    sigma_mt : float or array [Pa], > 0
        $\\sigma_{m,T}$: shear strength
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    d_star : float or array [m]
        $d^*$: critical length scale

    Formula as printed
    ------------------
        d^* \\approx \\frac{32 \\gamma G}{\\sigma_{m,T}^2}

    Reading
    -------
    For silica it is 18.487 nm, which the paper truncates to 18 nm.

    Laws
    ----
    * of silica lies between the two junctions
    * quarters for twice the strength

    wear-22, spec/wear/eq22_critical_length.rs, rounding error at most 0.5 ULP
    """
@overload
def critical_length(gamma: ArrayLike | str, g: ArrayLike | str, sigma_mt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def shear_modulus(e: float | str, nu: float | str, *, check: bool = True) -> float:
    """Section 4, unnumbered: shear modulus of an isotropic solid.

    Parameters
    ----------
    e : float or array [Pa], > 0
        $E$: Young's modulus
    nu : float or array, (-1, 0.5)
        $\\nu$: Poisson's ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    g : float or array [Pa]
        $G$: shear modulus

    Formula as printed
    ------------------
        G = \\frac{E}{2 (1 + \\nu)}

    Reading
    -------
    Not printed: Eq. 22 uses $G$, Table 5 states $E$ and $\\nu$.

    Laws
    ----
    * half the difference of the elastic constants

    wear-shear-modulus, spec/wear/eq22_critical_length.rs, rounding error at most 1 ULP
    """
@overload
def shear_modulus(e: ArrayLike | str, nu: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def wave_velocity(e: float | str, rho: float | str, *, check: bool = True) -> float:
    """Section 4, unnumbered: velocity of a pressure wave in a bar, which must far exceed the sliding velocity.

    Parameters
    ----------
    e : float or array [Pa], > 0
        $E$: Young's modulus
    rho : float or array [kg/m^3], > 0
        $\\rho$: density
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c : float or array [m/s]
        $c$: wave velocity

    Formula as printed
    ------------------
        c = \\sqrt{\\frac{E}{\\rho}}

    Reading
    -------
    The paper calls it the velocity in the medium; it is the velocity in a thin bar. In bulk silica it would be 5972
    m/s.

    Laws
    ----
    * of silica is 5760 m per s

    wear-wave-velocity, spec/wear/eq22_critical_length.rs, rounding error at most 0.5 ULP
    """
@overload
def wave_velocity(e: ArrayLike | str, rho: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _PairAccelerations(NamedTuple):
    a_i: Any
    a_j: Any

def pair_accelerations(m_i: ArrayLike | str, m_j: ArrayLike | str, c_n: ArrayLike | str, k_n: ArrayLike | str, x_i: ArrayLike | str, x_j: ArrayLike | str, v_i: ArrayLike | str, v_j: ArrayLike | str, *, check: bool = True) -> _PairAccelerations:
    """Eq. A.1, Appendix A.1: motion of two spheres along the line of their centres.

    Parameters
    ----------
    m_i : float or array [kg], > 0
        $m_i$: mass of i
    m_j : float or array [kg], > 0
        $m_j$: mass of j
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    x_i : float or array [m]
        $x_i$: displacement of i
    x_j : float or array [m]
        $x_j$: displacement of j
    v_i : float or array [m/s]
        $\\dot x_i$: velocity of i
    v_j : float or array [m/s]
        $\\dot x_j$: velocity of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a_i : float or array [m/s^2]
        $\\ddot x_i$: acceleration of i
    a_j : float or array [m/s^2]
        $\\ddot x_j$: acceleration of j

    Formula as printed
    ------------------
        m_i \\ddot x_i + c_N (\\dot x_i - \\dot x_j) + k_N (x_i - x_j) = 0, \\qquad
        m_j \\ddot x_j + c_N (\\dot x_j - \\dot x_i) + k_N (x_j - x_i) = 0

    Reading
    -------
    Solved for the two accelerations. The coordinates are displacements from the positions in which the spheres just
    touch, so that `x_i - x_j` is the separation of the surfaces.

    Laws
    ----
    * momentum is conserved
    * a common motion goes unnoticed
    * is the difference of the two accelerations

    wear-A1, spec/wear/a01_pair_motion.rs, rounding error at most 1 ULP
    """

@overload
def relative_acceleration(m_eff: float | str, c_n: float | str, k_n: float | str, x: float | str, v: float | str, *, check: bool = True) -> float:
    """Eq. A.2, Appendix A.1: motion of the separation.

    Parameters
    ----------
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    x : float or array [m]
        $x$: separation, `x_i - x_j`
    v : float or array [m/s]
        $\\dot x$: rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a : float or array [m/s^2]
        $\\ddot x$: acceleration of the separation

    Formula as printed
    ------------------
        m_{\\text{eff}} \\ddot x + c_N \\dot x + k_N x = 0

    Reading
    -------
    Erratum: the paper obtains the equation "by subtracting one to the other"; that holds only after each line of A.1 has been divided by its mass.
    The equation itself is right; here it is solved for the acceleration.

    Effect: subtracted as printed, the lines do not close in `x_i - x_j` unless the masses are equal.

    Proof: `subtracting_before_dividing_is_wrong_for_unequal_masses`.

    Laws
    ----
    * is the difference of the two accelerations
    * subtracting before dividing is wrong for unequal masses

    wear-A2, spec/wear/a01_pair_motion.rs, rounding error at most 0.5 ULP
    """
@overload
def relative_acceleration(m_eff: ArrayLike | str, c_n: ArrayLike | str, k_n: ArrayLike | str, x: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _KickAndDrift(NamedTuple):
    v_next: Any
    x_next: Any

def kick_and_drift(k_n: ArrayLike | str, m_eff: ArrayLike | str, dt: ArrayLike | str, x: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> _KickAndDrift:
    """Eq. A.4, Appendix A.1.1: one step of Eq. 1 for two undamped spheres.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    dt : float or array [s], > 0
        $\\Delta t$: time step
    x : float or array [m]
        $x_n$: separation
    v : float or array [m/s]
        $v_n$: rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_next : float or array [m/s]
        $v_{n+1}$: rate of separation after the step
    x_next : float or array [m]
        $x_{n+1}$: separation after the step

    Formula as printed
    ------------------
        v_{n+1} = v_n - \\frac{k_N x_n}{m_{\\text{eff}}} \\Delta t, \\qquad x_{n+1} = x_n + v_{n+1} \\Delta t

    Reading
    -------
    As printed: kick, then drift with the new velocity.

    Laws
    ----
    * a free pair drifts
    * drifting back and kicking back undoes a step

    wear-A4, spec/wear/a04_time_step.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _ExplicitStep(NamedTuple):
    v_next: Any
    x_next: Any

def explicit_step(k_n: ArrayLike | str, m_eff: ArrayLike | str, dt: ArrayLike | str, x: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> _ExplicitStep:
    """Eq. A.5, Appendix A.1.1: the same step with the new velocity eliminated.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    dt : float or array [s], > 0
        $\\Delta t$: time step
    x : float or array [m]
        $x_n$: separation
    v : float or array [m/s]
        $v_n$: rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_next : float or array [m/s]
        $v_{n+1}$: rate of separation after the step
    x_next : float or array [m]
        $x_{n+1}$: separation after the step

    Formula as printed
    ------------------
        v_{n+1} = v_n - \\frac{k_N}{m_{\\text{eff}}} \\Delta t\\, x_n, \\qquad
        x_{n+1} = \\left(1 - \\frac{k_N}{m_{\\text{eff}}} \\Delta t^2\\right) x_n + \\Delta t\\, v_n

    Reading
    -------
    As printed.

    Laws
    ----
    * is the same step

    wear-A5, spec/wear/a04_time_step.rs, rounding error at most 0.5 ULP
    """

@overload
def pair_energy(k_n: float | str, m_eff: float | str, x: float | str, v: float | str, *, check: bool = True) -> float:
    """Eq. A.6, Appendix A.1.1: energy of two spheres about their common centre of mass.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    x : float or array [m]
        $x_n$: separation
    v : float or array [m/s]
        $v_n$: rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    energy : float or array [J]
        $E_n$: total energy

    Formula as printed
    ------------------
        E_n = \\frac12 k_N x_n^2 + \\frac12 m_{\\text{eff}} v_n^2

    Reading
    -------
    As printed. The scheme does not keep this energy constant: below the critical time step it oscillates about its mean.
    One step of A.4 conserves `E - dt/2 k_n x v` instead.

    Laws
    ----
    * positive except at rest
    * a step conserves it but for half a kick
    * a step does not conserve it

    wear-A6, spec/wear/a06_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def pair_energy(k_n: ArrayLike | str, m_eff: ArrayLike | str, x: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def scaled_position(k_n: float | str, e_0: float | str, x: float | str, *, check: bool = True) -> float:
    """Eq. A.7, Appendix A.1.1: scaled position.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    e_0 : float or array [J], > 0
        $E_0$: initial energy
    x : float or array [m]
        $x_n$: separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    x_hat : float or array
        $\\hat x_n$: scaled separation

    Formula as printed
    ------------------
        \\hat x_n = \\sqrt{\\frac{k_N}{2 E_0}}\\, x_n

    Reading
    -------
    As printed; the initial energy must not be zero.

    Laws
    ----
    * the start lies on the unit circle
    * the squares add up to the energy ratio

    wear-A7, spec/wear/a07_scaled_variables.rs, rounding error at most 0.5 ULP
    """
@overload
def scaled_position(k_n: ArrayLike | str, e_0: ArrayLike | str, x: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def scaled_velocity(m_eff: float | str, e_0: float | str, v: float | str, *, check: bool = True) -> float:
    """Eq. A.8, Appendix A.1.1: scaled velocity.

    Parameters
    ----------
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    e_0 : float or array [J], > 0
        $E_0$: initial energy
    v : float or array [m/s]
        $v_n$: rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_hat : float or array
        $\\hat v_n$: scaled rate of separation

    Formula as printed
    ------------------
        \\hat v_n = \\sqrt{\\frac{m_{\\text{eff}}}{2 E_0}}\\, v_n

    Reading
    -------
    As printed; the initial energy must not be zero.

    Laws
    ----
    * the start lies on the unit circle
    * the squares add up to the energy ratio

    wear-A8, spec/wear/a07_scaled_variables.rs, rounding error at most 0.5 ULP
    """
@overload
def scaled_velocity(m_eff: ArrayLike | str, e_0: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def scaled_energy(x_hat: float | str, v_hat: float | str, *, check: bool = True) -> float:
    """Eq. A.9, Appendix A.1.1: the scaled initial energy.

    Parameters
    ----------
    x_hat : float or array
        $\\hat x_0$: scaled separation
    v_hat : float or array
        $\\hat v_0$: scaled rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    norm : float or array
        $\\hat x_0^2 + \\hat v_0^2$: energy as a multiple of the initial energy

    Formula as printed
    ------------------
        1 = \\hat x_0^2 + \\hat v_0^2

    Reading
    -------
    Evaluates the right-hand side; a law checks that it is one at the start.

    Laws
    ----
    * the start lies on the unit circle
    * the squares add up to the energy ratio

    wear-A9, spec/wear/a07_scaled_variables.rs, rounding error at most 0.5 ULP
    """
@overload
def scaled_energy(x_hat: ArrayLike | str, v_hat: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def scaled_time_step(k_n: float | str, m_eff: float | str, dt: float | str, *, check: bool = True) -> float:
    """Eq. A.10, Appendix A.1.1: scaled time step.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    h : float or array
        $\\hat{\\Delta t}$: scaled time step

    Formula as printed
    ------------------
        \\hat{\\Delta t} = \\sqrt{\\frac{k_N}{m_{\\text{eff}}}}\\, \\Delta t

    Reading
    -------
    As printed. It is called `h` in the rest of this appendix.

    Laws
    ----
    * is the phase that passes in a step

    wear-A10, spec/wear/a07_scaled_variables.rs, rounding error at most 0.5 ULP
    """
@overload
def scaled_time_step(k_n: ArrayLike | str, m_eff: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _ScaledStep(NamedTuple):
    v_next: Any
    x_next: Any

def scaled_step(h: ArrayLike | str, x: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> _ScaledStep:
    """Eq. A.11, Appendix A.1.1: the step of A.5 in scaled variables.

    Parameters
    ----------
    h : float or array, >= 0
        $\\hat{\\Delta t}$: scaled time step
    x : float or array
        $\\hat x_n$: scaled separation
    v : float or array
        $\\hat v_n$: scaled rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_next : float or array
        $\\hat v_{n+1}$: scaled rate of separation after the step
    x_next : float or array
        $\\hat x_{n+1}$: scaled separation after the step

    Formula as printed
    ------------------
        \\hat v_{n+1} = \\hat v_n - \\hat{\\Delta t}\\, \\hat x_n, \\qquad
        \\hat x_{n+1} = (1 - \\hat{\\Delta t}^2)\\, \\hat x_n + \\hat{\\Delta t}\\, \\hat v_n

    Reading
    -------
    As printed.

    Laws
    ----
    * is the time step in scaled variables

    wear-A11, spec/wear/a11_scaled_step.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _AmplificationMatrix(NamedTuple):
    a_xx: Any
    a_xv: Any
    a_vx: Any
    a_vv: Any

def amplification_matrix(h: ArrayLike | str, *, check: bool = True) -> _AmplificationMatrix:
    """Eq. A.12, Appendix A.1.1: the amplification matrix.

    Parameters
    ----------
    h : float or array, >= 0
        $\\hat{\\Delta t}$: scaled time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a_xx : float or array
        $A_{11}$: position from position
    a_xv : float or array
        $A_{12}$: position from velocity
    a_vx : float or array
        $A_{21}$: velocity from position
    a_vv : float or array
        $A_{22}$: velocity from velocity

    Formula as printed
    ------------------
        \\begin{bmatrix} \\hat x_{n+1} \\\\ \\hat v_{n+1} \\end{bmatrix} =
        \\begin{bmatrix} 1 - \\hat{\\Delta t}^2 & \\hat{\\Delta t} \\\\ -\\hat{\\Delta t} & 1 \\end{bmatrix}
        \\begin{bmatrix} \\hat x_n \\\\ \\hat v_n \\end{bmatrix}

    Reading
    -------
    The matrix, row by row. The state is ordered position first, while A.11 computes the velocity first.

    Laws
    ----
    * the matrix does the scaled step
    * the matrix keeps areas

    wear-A12, spec/wear/a11_scaled_step.rs, rounding error at most 1 ULP
    """

@type_check_only
class _Amplify(NamedTuple):
    x_next: Any
    v_next: Any

def amplify(a_xx: ArrayLike | str, a_xv: ArrayLike | str, a_vx: ArrayLike | str, a_vv: ArrayLike | str, x: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> _Amplify:
    """Eq. A.13, Appendix A.1.1: one application of the matrix.

    Parameters
    ----------
    a_xx : float or array
        $A_{11}$: position from position
    a_xv : float or array
        $A_{12}$: position from velocity
    a_vx : float or array
        $A_{21}$: velocity from position
    a_vv : float or array
        $A_{22}$: velocity from velocity
    x : float or array
        $\\hat x_n$: scaled separation
    v : float or array
        $\\hat v_n$: scaled rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    x_next : float or array
        $\\hat x_{n+1}$: scaled separation after the step
    v_next : float or array
        $\\hat v_{n+1}$: scaled rate of separation after the step

    Formula as printed
    ------------------
        \\mathbf p_{n+1} = A \\mathbf p_n

    Reading
    -------
    As printed, for any matrix.

    Laws
    ----
    * the matrix does the scaled step

    wear-A13, spec/wear/a11_scaled_step.rs, rounding error at most 0.5 ULP
    """

@overload
def step_invariant(h: float | str, x: float | str, v: float | str, *, check: bool = True) -> float:
    """Unnumbered, after Eq. A.13: the quantity that the step conserves instead of the energy.

    Parameters
    ----------
    h : float or array, >= 0
        $\\hat{\\Delta t}$: scaled time step
    x : float or array
        $\\hat x$: scaled separation
    v : float or array
        $\\hat v$: scaled rate of separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    invariant : float or array
        $I$: conserved quantity

    Formula as printed
    ------------------
        I = \\hat x^2 + \\hat v^2 - \\hat{\\Delta t}\\, \\hat x \\hat v

    Reading
    -------
    Not in the paper. Below a scaled step of two its level curves are ellipses, which bound the energy; at two they are
    pairs of straight lines and above it hyperbolas, along which the energy grows without limit.

    Laws
    ----
    * a step leaves the invariant unchanged
    * without a step it is twice the scaled energy and at two a square

    wear-invariant, spec/wear/a11_scaled_step.rs, rounding error at most 0.5 ULP
    """
@overload
def step_invariant(h: ArrayLike | str, x: ArrayLike | str, v: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _StateAfter(NamedTuple):
    x: Any
    v: Any

def state_after(h: ArrayLike | str, n: ArrayLike | str, x_0: ArrayLike | str, v_0: ArrayLike | str, *, check: bool = True) -> _StateAfter:
    """Eq. A.14, Appendix A.1.1: the state after `n` steps.

    Parameters
    ----------
    h : float or array, >= 0
        $\\hat{\\Delta t}$: scaled time step
    n : float or array, [0, 4294967295]
        $n$: number of steps
    x_0 : float or array
        $\\hat x_0$: scaled separation at the start
    v_0 : float or array
        $\\hat v_0$: scaled rate of separation at the start
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    x : float or array
        $\\hat x_n$: scaled separation
    v : float or array
        $\\hat v_n$: scaled rate of separation

    Formula as printed
    ------------------
        \\mathbf p_n = A^n \\mathbf p_0

    Reading
    -------
    As printed, with the power of A.15; `n` is truncated to an integer.

    Laws
    ----
    * is as many single steps
    * bounded below the limit
    * grows linearly at the limit
    * grows exponentially above the limit

    wear-A14, spec/wear/a14_many_steps.rs, rounding error at most 2 ULP
    """

@type_check_only
class _AmplificationPower(NamedTuple):
    a_xx: Any
    a_xv: Any
    a_vx: Any
    a_vv: Any

def amplification_power(h: ArrayLike | str, n: ArrayLike | str, *, check: bool = True) -> _AmplificationPower:
    """Eq. A.15, Appendix A.1.1: power of the amplification matrix.

    Parameters
    ----------
    h : float or array, >= 0
        $\\hat{\\Delta t}$: scaled time step
    n : float or array, [0, 4294967295]
        $n$: number of steps
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a_xx : float or array
        $(A^n)_{11}$: position from position
    a_xv : float or array
        $(A^n)_{12}$: position from velocity
    a_vx : float or array
        $(A^n)_{21}$: velocity from position
    a_vv : float or array
        $(A^n)_{22}$: velocity from velocity

    Formula as printed
    ------------------
        A^n = Q \\Lambda^n Q^{-1}

    Reading
    -------
    Computed by squaring: the binary digits of `n` select the factors among `A, A^2, A^4, ...`. The eigendecomposition
    does not exist at a scaled step of two, where both eigenvalues are -1 and there is only one eigenvector; squaring
    works there too. `n` is truncated to an integer.

    Laws
    ----
    * is the eigendecomposition where there is one
    * six half critical steps return
    * four steps of root two return

    wear-A15, spec/wear/a14_many_steps.rs, rounding error at most 12 ULP
    """

@type_check_only
class _Eigenvalues(NamedTuple):
    re_1: Any
    im_1: Any
    re_2: Any
    im_2: Any

def eigenvalues(h: ArrayLike | str, *, check: bool = True) -> _Eigenvalues:
    """Eq. A.16, Appendix A.1.1: eigenvalues of the amplification matrix.

    Parameters
    ----------
    h : float or array, >= 0
        $\\hat{\\Delta t}$: scaled time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    re_1 : float or array
        $\\operatorname{Re} \\lambda_1$: real part of the eigenvalue with the plus sign
    im_1 : float or array
        $\\operatorname{Im} \\lambda_1$: its imaginary part
    re_2 : float or array
        $\\operatorname{Re} \\lambda_2$: real part of the eigenvalue with the minus sign
    im_2 : float or array
        $\\operatorname{Im} \\lambda_2$: its imaginary part

    Formula as printed
    ------------------
        \\lambda_{1,2} = \\frac{2 - \\hat{\\Delta t}^2 \\pm \\hat{\\Delta t} \\sqrt{\\hat{\\Delta t}^2 - 4}}{2}

    Reading
    -------
    Real and imaginary parts. With $s = \\sqrt{|h^2 - 4|}$ the printed form is $-((h \\mp s)/2)^2$ for real $s$, since
    $(h \\mp s)^2 = 2 h^2 - 4 \\mp 2 h s$. That is what the code computes above two: $\\lambda_2$ from its square, which is a
    sum of terms of one sign, and $\\lambda_1$ as its inverse, because their product is the determinant, one. In the
    printed form $\\lambda_1$ would suffer from cancellation.

    Laws
    ----
    * are those that faer finds
    * are the printed roots
    * their product is one
    * lie on the unit circle up to a step of two
    * one leaves the unit circle above a step of two

    wear-A16, spec/wear/a16_eigenvalues.rs, rounding error at most 1 ULP
    """

@overload
def pair_time_step_limit(m_eff: float | str, k_n: float | str, *, check: bool = True) -> float:
    """Eq. A.17, Appendix A.1.1: limit of the time step for two spheres.

    Parameters
    ----------
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    dt : float or array [s]
        $\\Delta t$: limit below which a time step is stable

    Formula as printed
    ------------------
        \\Delta t \\le 2 \\sqrt{\\frac{m_{\\text{eff}}}{k_N}}

    Reading
    -------
    Erratum: the comparison must be strict. The function returns the right-hand side. At the limit both eigenvalues are -1,
    but the matrix has only one eigenvector. The same holds for A.18.

    Effect: at the limit the motion grows linearly and the energy without bound.

    Proof: `the_limit_itself_is_not_stable`.

    Laws
    ----
    * is a scaled step of two
    * a step just below stays bounded
    * the limit itself is not stable
    * equal masses give the critical time step

    wear-A17, spec/wear/a17_stability.rs, rounding error at most 0.5 ULP
    """
@overload
def pair_time_step_limit(m_eff: ArrayLike | str, k_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def critical_pair_damping(k_n: float | str, m_eff: float | str, *, check: bool = True) -> float:
    """Eq. A.19, Appendix A.1.2: critical damping of two spheres.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_c : float or array [kg/s]
        $c_c$: critical damping

    Formula as printed
    ------------------
        c_c = 2 \\sqrt{k_N m_{\\text{eff}}}

    Reading
    -------
    As printed: critical for the dashpot between the two spheres. For equal masses it is Eq. 21.

    Laws
    ----
    * the characteristic roots coincide
    * equal masses give equation 21

    wear-A19, spec/wear/a19_critical_damping.rs, rounding error at most 0.5 ULP
    """
@overload
def critical_pair_damping(k_n: ArrayLike | str, m_eff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def normal_stress(f_n: float | str, a_n: float | str, *, check: bool = True) -> float:
    """Eq. A.20, Appendix A.2: normal stress of a pair.

    Parameters
    ----------
    f_n : float or array [N]
        $F_N$: normal force, positive when it attracts
    a_n : float or array [m^2], > 0
        $A_N$: cross section in the normal direction
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma_n : float or array [Pa]
        $\\sigma_N$: normal stress, positive in tension

    Formula as printed
    ------------------
        \\sigma_N = \\frac{F_N}{A_N}

    Reading
    -------
    As printed. The cross section follows from A.64.

    Laws
    ----
    * stress times cross section is the force

    wear-A20, spec/wear/a20_stress.rs, rounding error at most 0.5 ULP
    """
@overload
def normal_stress(f_n: ArrayLike | str, a_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tangential_stress(f_t: float | str, a_t: float | str, *, check: bool = True) -> float:
    """Eq. A.21, Appendix A.2: tangential stress of a pair.

    Parameters
    ----------
    f_t : float or array [N]
        $F_T$: tangential force
    a_t : float or array [m^2], > 0
        $A_T$: cross section in the tangential direction
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma_t : float or array [Pa]
        $\\sigma_T$: tangential stress

    Formula as printed
    ------------------
        \\sigma_T = \\frac{F_T}{A_T}

    Reading
    -------
    As printed. The cross section vanishes at a Poisson's ratio of 1/4.

    Laws
    ----
    * stress times cross section is the force

    wear-A21, spec/wear/a20_stress.rs, rounding error at most 0.5 ULP
    """
@overload
def tangential_stress(f_t: ArrayLike | str, a_t: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def normal_strain(delta_n: float | str, r_i: float | str, r_j: float | str, *, check: bool = True) -> float:
    """Eq. A.22, Appendix A.2: normal strain of a pair.

    Parameters
    ----------
    delta_n : float or array [m]
        $\\delta_N$: separation of the surfaces, negative for an overlap
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    epsilon_n : float or array
        $\\varepsilon_N$: normal strain, positive in tension

    Formula as printed
    ------------------
        \\varepsilon_N = \\frac{\\delta_N}{r_i + r_j}

    Reading
    -------
    As printed: the spheres are at rest when they just touch.

    Laws
    ----
    * does not depend on the scale
    * is the stress of the elastic force

    wear-A22, spec/wear/a20_stress.rs, rounding error at most 0.5 ULP
    """
@overload
def normal_strain(delta_n: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def elastic_stress(e: float | str, epsilon_n: float | str, *, check: bool = True) -> float:
    """Eq. A.23, Appendix A.2: Hooke's law of a pair.

    Parameters
    ----------
    e : float or array [Pa], > 0
        $E$: Young's modulus
    epsilon_n : float or array
        $\\varepsilon_N$: normal strain
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma_n : float or array [Pa]
        $\\sigma_N$: normal stress

    Formula as printed
    ------------------
        \\sigma_N = E \\varepsilon_N

    Reading
    -------
    As printed; valid in the elastic range.

    Laws
    ----
    * is the stress of the elastic force

    wear-A23, spec/wear/a20_stress.rs, rounding error at most 0.5 ULP
    """
@overload
def elastic_stress(e: ArrayLike | str, epsilon_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def stiffness_of_force(f_n: float | str, delta_n: float | str, *, check: bool = True) -> float:
    """Eq. A.24, Appendix A.2: the stiffness from the force.

    Parameters
    ----------
    f_n : float or array [N]
        $F_N$: normal force, positive when it attracts
    delta_n : float or array [m]
        $\\delta_N$: separation of the surfaces, not zero
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_n : float or array [N/m]
        $k_N$: normal stiffness

    Formula as printed
    ------------------
        k_N = \\frac{F_N}{\\delta_N}

    Reading
    -------
    As printed; valid in the elastic range, except at zero separation.

    Laws
    ----
    * the three lines are one stiffness

    wear-A24, spec/wear/a24_stiffness.rs, rounding error at most 0.5 ULP
    """
@overload
def stiffness_of_force(f_n: ArrayLike | str, delta_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def stiffness_of_stress(a_n: float | str, sigma_n: float | str, r_i: float | str, r_j: float | str, epsilon_n: float | str, *, check: bool = True) -> float:
    """Eq. A.25, Appendix A.2: the stiffness from stress and strain.

    Parameters
    ----------
    a_n : float or array [m^2], > 0
        $A_N$: cross section in the normal direction
    sigma_n : float or array [Pa]
        $\\sigma_N$: normal stress
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    epsilon_n : float or array
        $\\varepsilon_N$: normal strain, not zero
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_n : float or array [N/m]
        $k_N$: normal stiffness

    Formula as printed
    ------------------
        k_N = \\frac{A_N \\sigma_N}{(r_i + r_j)\\, \\varepsilon_N}

    Reading
    -------
    As printed: A.20 and A.22 substituted into A.24. The next line, A.26, substitutes Hooke's law A.23 and is Eq. 7; A.27
    is Eq. 8. The tangential stiffness also contains Young's modulus, not the shear modulus: A.65 compensates for this.

    Laws
    ----
    * the three lines are one stiffness

    wear-A25, spec/wear/a24_stiffness.rs, rounding error at most 0.5 ULP
    """
@overload
def stiffness_of_stress(a_n: ArrayLike | str, sigma_n: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, epsilon_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def elastic_strain(sigma_mn: float | str, e: float | str, *, check: bool = True) -> float:
    """Eq. A.28, Appendix A.2: elastic limit as a strain.

    Parameters
    ----------
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    e : float or array [Pa], > 0
        $E$: Young's modulus
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    epsilon_e : float or array
        $\\varepsilon_e$: elastic strain

    Formula as printed
    ------------------
        \\varepsilon_e = \\frac{\\sigma_{m,N}}{E}

    Reading
    -------
    As printed. Multiplied by the distance between the centres it is A.29, which is Eq. 9; the limit of the tangential force,
    A.30, is Eq. 11.

    Laws
    ----
    * is the strain of the elastic separation
    * the stress there is the tensile strength

    wear-A28, spec/wear/a28_elastic_limit.rs, rounding error at most 0.5 ULP
    """
@overload
def elastic_strain(sigma_mn: ArrayLike | str, e: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def work_of_separation(k_n: float | str, delta_e: float | str, delta_f: float | str, *, check: bool = True) -> float:
    """Eq. A.31, Appendix A.2: work to separate two touching spheres.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    delta_e : float or array [m], > 0
        $\\delta_e$: elastic separation
    delta_f : float or array [m], > 0
        $\\delta_f$: fracture separation
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u_gamma : float or array [J]
        $U_\\gamma$: work of separation

    Formula as printed
    ------------------
        U_\\gamma = \\frac12 \\delta_f k_N \\delta_e

    Reading
    -------
    Erratum: the area under Eq. 3 is this triangle only if `delta_f >= delta_e`. Otherwise the force ends at `delta_f`, before
    the peak, and the triangle is $\\frac12 k_N \\delta_f^2$. Both cases are $\\frac12 \\delta_f k_N \\min(\\delta_e, \\delta_f)$.

    Effect: for spheres larger than the critical diameter the printed energy is too large, by $\\delta_e / \\delta_f$.

    Proof: `the_printed_area_is_too_large_when_the_force_is_cut_off`.

    Laws
    ----
    * is the area under the force
    * the printed area is too large when the force is cut off
    * is the depth of the potential

    wear-A31, spec/wear/a31_fracture_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def work_of_separation(k_n: ArrayLike | str, delta_e: ArrayLike | str, delta_f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def work_of_strength(a_n: float | str, sigma_mn: float | str, delta_f: float | str, *, check: bool = True) -> float:
    """Eq. A.32, Appendix A.2: the same work in terms of the strength.

    Parameters
    ----------
    a_n : float or array [m^2], > 0
        $A_N$: cross section in the normal direction
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    delta_f : float or array [m], > 0
        $\\delta_f$: fracture separation, at least the elastic one
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u_gamma : float or array [J]
        $U_\\gamma$: work of separation

    Formula as printed
    ------------------
        U_\\gamma = \\frac{A_N \\sigma_{m,N} \\delta_f}{2}

    Reading
    -------
    As printed; like A.31 as printed it needs `delta_f >= delta_e`.

    Laws
    ----
    * strength and stiffness give one work

    wear-A32, spec/wear/a31_fracture_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def work_of_strength(a_n: ArrayLike | str, sigma_mn: ArrayLike | str, delta_f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def surface_energy(u_gamma: float | str, a_n: float | str, *, check: bool = True) -> float:
    """Eq. A.33, Appendix A.2: surface energy of a broken pair.

    Parameters
    ----------
    u_gamma : float or array [J], >= 0
        $U_\\gamma$: work of separation
    a_n : float or array [m^2], > 0
        $A_N$: cross section in the normal direction
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    gamma : float or array [J/m^2]
        $\\gamma$: surface energy

    Formula as printed
    ------------------
        \\gamma = \\frac{U_\\gamma}{2 A_N}

    Reading
    -------
    As printed: fracture creates two surfaces. Solved for the separation it is A.34,
    $\\delta_f = 4 \\gamma / \\sigma_{m,N}$.

    Laws
    ----
    * the fracture separation gives back the surface energy

    wear-A33, spec/wear/a31_fracture_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def surface_energy(u_gamma: ArrayLike | str, a_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def separation_of_surface_energy(gamma: float | str, sigma_mn: float | str, *, check: bool = True) -> float:
    """Eq. A.34, Appendix A.2: fracture separation for a desired surface energy.

    Parameters
    ----------
    gamma : float or array [J/m^2], > 0
        $\\gamma$: surface energy
    sigma_mn : float or array [Pa], > 0
        $\\sigma_{m,N}$: tensile strength
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_f : float or array [m]
        $\\delta_f$: separation at which the pair breaks

    Formula as printed
    ------------------
        \\delta_f = \\frac{4 \\gamma}{\\sigma_{m,N}}

    Reading
    -------
    As printed: A.32 and A.33 solved for the separation. Eq. 19 takes the same length as a diameter, at which the range of a particle is its size.

    Laws
    ----
    * the fracture separation gives back the surface energy

    wear-A34, spec/wear/a31_fracture_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def separation_of_surface_energy(gamma: ArrayLike | str, sigma_mn: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def impact_separation(k_n: float | str, m_eff: float | str, c_n: float | str, v_0: float | str, t: float | str, *, check: bool = True) -> float:
    """Eq. A.35, Appendix A.2: separation after two spheres have collided.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    v_0 : float or array [m/s]
        $v_0$: rate of separation at first touch, at time zero
    t : float or array [s], >= 0
        $t$: time
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    x : float or array [m]
        $x$: separation

    Formula as printed
    ------------------
        x = \\frac{v_0}{\\omega} e^{-\\frac{c_N}{2 m_{\\text{eff}}} t} \\sin(\\omega t)

    Reading
    -------
    Exact with the damped frequency A.37, and continued beyond critical damping, where the frequency is imaginary. With
    $\\beta = c_N / 2 m_{\\text{eff}}$ and $\\omega$ the magnitude,

    $$
    \\frac{x}{v_0} = \\begin{cases} e^{-\\beta t} \\sin(\\omega t) / \\omega & c_N < c_c \\\\ t\\, e^{-\\beta t} & c_N = c_c \\\\
      e^{-\\beta t} \\sinh(\\omega t) / \\omega & c_N > c_c \\end{cases}
    $$

    The last case is computed as $e^{-(\\beta - \\omega) t} \\tau / \\omega (1 + \\tau)$ with $\\tau = \\tanh(\\omega t)$, since
    $\\sinh = e^{\\omega t} \\tau / (1 + \\tau)$, and $\\beta - \\omega$ as $k_N / m_{\\text{eff}} (\\beta + \\omega)$: nothing
    overflows or cancels.

    Laws
    ----
    * starts at rest length with the given velocity
    * solves the equation of motion
    * the natural frequency does not solve it
    * continuous through critical damping
    * swings back below critical damping and never above

    wear-A35, spec/wear/a35_impact.rs, rounding error at most 1 ULP
    """
@overload
def impact_separation(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, v_0: ArrayLike | str, t: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def impact_velocity(k_n: float | str, m_eff: float | str, c_n: float | str, v_0: float | str, t: float | str, *, check: bool = True) -> float:
    """Eq. A.36, Appendix A.2: rate of separation after two spheres have collided.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    v_0 : float or array [m/s]
        $v_0$: rate of separation at first touch, at time zero
    t : float or array [s], >= 0
        $t$: time
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v : float or array [m/s]
        $\\dot x$: rate of separation

    Formula as printed
    ------------------
        \\dot x = -\\frac{c_N v_0}{2 \\omega m_{\\text{eff}}} e^{-\\frac{c_N}{2 m_{\\text{eff}}} t} \\sin(\\omega t)
          + v_0 e^{-\\frac{c_N}{2 m_{\\text{eff}}} t} \\cos(\\omega t)

    Reading
    -------
    The first term is $-\\beta x$. At and beyond critical damping the motion obeys
    $\\dot x = v_0 e^{-(\\beta + \\omega) t} - (\\beta - \\omega) x$, which is evaluated in that range.

    Laws
    ----
    * starts at rest length with the given velocity
    * is the slope of the separation
    * continuous through critical damping

    wear-A36, spec/wear/a35_impact.rs, rounding error at most 1 ULP
    """
@overload
def impact_velocity(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, v_0: ArrayLike | str, t: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def damped_frequency(k_n: float | str, m_eff: float | str, c_n: float | str, *, check: bool = True) -> float:
    """Eq. A.37, Appendix A.2: frequency of a damped pair.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega : float or array [rad/s]
        $\\omega$: damped frequency

    Formula as printed
    ------------------
        \\omega = \\sqrt{\\frac{k_N}{m_{\\text{eff}}}} \\sqrt{1 - \\frac{c_N^2}{4 k_N m_{\\text{eff}}}}

    Reading
    -------
    Erratum: the paper calls it the natural frequency; it is the damped one, with which A.35 is exact.

    Effect: none on what follows, which uses the damped frequency. The natural one is larger by $1 / \\sqrt{1 - (c_N / c_c)^2}$.

    Proof: `zero_at_critical_damping_and_only_there`, `undamped_it_is_the_natural_frequency`.

    With
    $c_c = 2 \\sqrt{k_N m_{\\text{eff}}}$ it is $\\sqrt{(c_c - c_N)(c_c + c_N)} / 2 m_{\\text{eff}}$, which is evaluated because
    the printed difference suffers from cancellation close to critical damping. Beyond critical damping the frequency is
    imaginary and the motion a sum of two decays; the function then returns the magnitude, the deviation of their rates from
    the mean rate.

    Laws
    ----
    * is the printed frequency
    * zero at critical damping and only there
    * undamped it is the natural frequency

    wear-A37, spec/wear/a37_frequency.rs, rounding error at most 1 ULP
    """
@overload
def damped_frequency(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def natural_frequency(k_n: float | str, m_eff: float | str, *, check: bool = True) -> float:
    """Eq. A.38, Appendix A.2: frequency of an undamped pair.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega_0 : float or array [rad/s]
        $\\omega_0$: natural frequency

    Formula as printed
    ------------------
        \\omega \\approx \\sqrt{\\frac{k_N}{m_{\\text{eff}}}}

    Reading
    -------
    This is the natural frequency; as an approximation of A.37 it is too large by half the square of the damping ratio.

    Laws
    ----
    * undamped it is the natural frequency
    * too large by half the square of the damping ratio

    wear-A38, spec/wear/a37_frequency.rs, rounding error at most 0.5 ULP
    """
@overload
def natural_frequency(k_n: ArrayLike | str, m_eff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def impact_duration(omega: float | str, *, check: bool = True) -> float:
    """Unnumbered, before Eq. A.39: duration of an impact.

    Parameters
    ----------
    omega : float or array [rad/s], > 0
        $\\omega$: damped frequency
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    t_f : float or array [s]
        $t_f$: duration of the impact

    Formula as printed
    ------------------
        t_f = \\frac{\\pi}{\\omega}

    Reading
    -------
    "Approximately", according to the paper; it is exact with the damped frequency if the impact ends when the spheres stop
    touching.

    Laws
    ----
    * the spheres just touch after it

    wear-impact-duration, spec/wear/a39_impact_end.rs, rounding error at most 0.5 ULP
    """
@overload
def impact_duration(omega: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def velocity_at_the_end(k_n: float | str, m_eff: float | str, c_n: float | str, v_0: float | str, *, check: bool = True) -> float:
    """Eq. A.39, Appendix A.2: rate of separation after the impact.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    v_0 : float or array [m/s]
        $v_0$: rate of separation before the impact
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_f : float or array [m/s]
        $v_f$: rate of separation after the impact

    Formula as printed
    ------------------
        v_f = \\dot x(t_f)

    Reading
    -------
    As printed, with A.36. At and beyond critical damping the spheres never separate, and the value is zero.

    Laws
    ----
    * the closed form is the velocity at the end
    * without return the final velocity is zero

    wear-A39, spec/wear/a39_impact_end.rs, rounding error at most 1 ULP
    """
@overload
def velocity_at_the_end(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, v_0: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def final_velocity(k_n: float | str, m_eff: float | str, c_n: float | str, v_0: float | str, *, check: bool = True) -> float:
    """Eq. A.40, Appendix A.2: the same in closed form.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    v_0 : float or array [m/s]
        $v_0$: rate of separation before the impact
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_f : float or array [m/s]
        $v_f$: rate of separation after the impact

    Formula as printed
    ------------------
        v_f = v_0 e^{-\\frac{\\pi c_N}{2 \\omega m_{\\text{eff}}}}

    Reading
    -------
    Erratum: the minus sign is missing. The spheres separate in the direction from which they came:
    $v_f = -v_0 e^{-\\pi c_N / 2 \\omega m_{\\text{eff}}}$.

    Effect: as printed the spheres would leave the impact through each other.

    Proof: `the_velocity_turns_round`.

    Laws
    ----
    * the closed form is the velocity at the end
    * the velocity turns round

    wear-A40, spec/wear/a39_impact_end.rs, rounding error at most 0.5 ULP
    """
@overload
def final_velocity(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, v_0: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def velocity_ratio(v_0: float | str, v_f: float | str, *, check: bool = True) -> float:
    """Eq. A.41, Appendix A.2: restitution coefficient.

    Parameters
    ----------
    v_0 : float or array [m/s], > 0
        $v_0$: rate of separation before the impact
    v_f : float or array [m/s]
        $v_f$: rate of separation after the impact
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    eta : float or array
        $\\eta$: restitution coefficient

    Formula as printed
    ------------------
        \\eta = \\frac{v_0}{v_f}

    Reading
    -------
    Erratum: the ratio is upside down. Section 2.2 defines it as final over initial velocity, and A.42 is below one:
    $\\eta = -v_f / v_0$, with the minus sign of A.40.

    Effect: as printed the ratio is above one; an impact would create energy.

    Proof: `is_final_over_initial_velocity`.

    Laws
    ----
    * is final over initial velocity

    wear-A41, spec/wear/a39_impact_end.rs, rounding error at most 0.5 ULP
    """
@overload
def velocity_ratio(v_0: ArrayLike | str, v_f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def pair_restitution(k_n: float | str, m_eff: float | str, c_n: float | str, *, check: bool = True) -> float:
    """Eq. A.42, Appendix A.2: restitution coefficient for a given damping.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    eta : float or array
        $\\eta$: restitution coefficient

    Formula as printed
    ------------------
        \\eta = e^{-\\frac{\\pi c_N}{2 \\omega m_{\\text{eff}}}}

    Reading
    -------
    Exact with the damped frequency A.37; zero at and beyond critical damping. In terms of the damping ratio it is
    $e^{-\\pi \\zeta / \\sqrt{1 - \\zeta^2}}$.

    Laws
    ----
    * is that of the damping ratio
    * nothing comes back beyond critical damping

    wear-A42, spec/wear/a42_restitution.rs, rounding error at most 1 ULP
    """
@overload
def pair_restitution(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def weak_restitution(k_n: float | str, m_eff: float | str, c_n: float | str, *, check: bool = True) -> float:
    """Eq. A.43, Appendix A.2: restitution coefficient for weak damping.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    eta : float or array
        $\\eta$: restitution coefficient, approximately

    Formula as printed
    ------------------
        \\eta \\approx 1 - \\frac{\\pi c_N}{2 \\omega m_{\\text{eff}}}

    Reading
    -------
    The first two terms of the series of A.42, hence never above it; below critical damping only.

    Laws
    ----
    * both approximations are below by half the square of the loss

    wear-A43, spec/wear/a42_restitution.rs, rounding error at most 2.5 ULP
    """
@overload
def weak_restitution(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def weaker_restitution(k_n: float | str, m_eff: float | str, c_n: float | str, *, check: bool = True) -> float:
    """Eq. A.44, Appendix A.2: the same with the natural frequency.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_N$: normal stiffness
    m_eff : float or array [kg], > 0
        $m_{\\text{eff}}$: effective mass of the pair
    c_n : float or array [kg/s], >= 0
        $c_N$: normal damping
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    eta : float or array
        $\\eta$: restitution coefficient, approximately

    Formula as printed
    ------------------
        \\eta \\approx 1 - \\frac{\\pi c_N}{2 \\sqrt{k_N m_{\\text{eff}}}}

    Reading
    -------
    As printed: A.38 substituted into A.43. It becomes negative above 0.318 of the critical damping.

    Laws
    ----
    * both approximations are below by half the square of the loss

    wear-A44, spec/wear/a42_restitution.rs, rounding error at most 1 ULP
    """
@overload
def weaker_restitution(k_n: ArrayLike | str, m_eff: ArrayLike | str, c_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def zero_force_duration(omega: float | str, zeta: float | str, *, check: bool = True) -> float:
    """Unnumbered, cf. Eq. A.39: duration of an impact up to the first instant of zero force.

    Parameters
    ----------
    omega : float or array [rad/s], > 0
        $\\omega$: damped frequency
    zeta : float or array, [0, 1)
        $\\zeta$: damping ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    t_f : float or array [s]
        $t_f$: duration of the impact

    Formula as printed
    ------------------
        t_f = \\frac{2 \\arccos \\zeta}{\\omega}

    Reading
    -------
    The paper ends the impact at the return to `x = 0` instead, where the dashpot still pulls; the total force
    $k_N x + c_N \\dot x$ vanishes earlier, where $\\tan \\omega t = -2 \\zeta \\sqrt{1 - \\zeta^2} / (1 - 2 \\zeta^2)$, that is at
    $\\omega t = 2 \\arccos \\zeta$.

    Laws
    ----
    * the force vanishes then and not before
    * undamped both ends coincide

    wear-zero-force-duration, spec/wear/def_zero_force_end.rs, rounding error at most 1 ULP
    """
@overload
def zero_force_duration(omega: ArrayLike | str, zeta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def zero_force_restitution(zeta: float | str, *, check: bool = True) -> float:
    """Unnumbered, cf. Eq. A.42: restitution coefficient of this impact.

    Parameters
    ----------
    zeta : float or array, [0, 1)
        $\\zeta$: damping ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    eta : float or array
        $\\eta$: restitution coefficient

    Formula as printed
    ------------------
        \\eta = e^{-2 \\zeta \\arccos \\zeta / \\sqrt{1 - \\zeta^2}}

    Reading
    -------
    At that instant the velocity is exactly $-v_0 e^{-\\beta t}$. The coefficient is larger than A.42, because the dashpot does not
    pull at the end.

    Laws
    ----
    * is the velocity at that end
    * undamped both ends coincide
    * more comes back than to the last touch

    wear-zero-force-restitution, spec/wear/def_zero_force_end.rs, rounding error at most 1.5 ULP
    """
@overload
def zero_force_restitution(zeta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def damping_of_critical(eta: float | str, c_c: float | str, *, check: bool = True) -> float:
    """Eq. A.46, Appendix A.2: normal damping as a fraction of critical damping.

    Parameters
    ----------
    eta : float or array, [0, 1]
        $\\eta$: desired restitution coefficient
    c_c : float or array [kg/s], > 0
        $c_c$: critical damping
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_n : float or array [kg/s]
        $c_N$: normal damping

    Formula as printed
    ------------------
        c_N \\approx \\frac{1 - \\eta}{\\pi} c_c

    Reading
    -------
    As printed. A.45 is Eq. 12 and A.47 is Eq. 13. All three invert A.44, so the resulting restitution, A.42, is larger than
    the desired one, which the `exact_damping` of [`def_restitution`](super::def_restitution) gives.

    Laws
    ----
    * is the damping of equation 12
    * inverts the weaker approximation
    * the restitution that comes out is larger than wanted
    * the exact damping gives the wanted restitution

    wear-A46, spec/wear/a45_damping.rs, rounding error at most 0.5 ULP
    """
@overload
def damping_of_critical(eta: ArrayLike | str, c_c: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def rescaled_separation(delta_e: float | str, r_i: float | str, r_j: float | str, d_c: float | str, s: float | str, *, check: bool = True) -> float:
    """Eq. A.49, Appendix A.2.1: fracture separation of spheres larger than the critical diameter of A.48, which is Eq. 18.

    Parameters
    ----------
    delta_e : float or array [m], > 0
        $\\delta_e$: elastic separation
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    d_c : float or array [m], > 0
        $d_c$: critical diameter
    s : float or array, >= 0
        $s$: scaling parameter
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_f : float or array [m]
        $\\delta'_f$: fracture separation

    Formula as printed
    ------------------
        \\delta'_f = \\delta_e \\left(\\frac{r_i + r_j}{d_c}\\right)^{-s}

    Reading
    -------
    As printed, for `r_i + r_j > d_c`: the second case of Eq. 10. The power is $e^{-s \\ln(\\cdot)}$.

    Laws
    ----
    * is the fracture separation of large spheres
    * without scaling the elastic limit is matched
    * a scaling of one half matches the surface energy
    * no scaling at all would match neither

    wear-A49, spec/wear/a49_rescaled_separation.rs, rounding error at most 1 ULP
    """
@overload
def rescaled_separation(delta_e: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, d_c: ArrayLike | str, s: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def separation_x(r: float | str, epsilon_x: float | str, phi: float | str, theta: float | str, *, check: bool = True) -> float:
    """Eq. A.50, Appendix A.2.2: separation of a pair along x in a body strained by `epsilon_x`.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    epsilon_x : float or array
        $\\varepsilon_x$: strain along x
    phi : float or array [rad]
        $\\phi$: azimuth of the neighbour
    theta : float or array [rad], [-1.5707963267948966, 1.5707963267948966]
        $\\theta$: latitude of the neighbour
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_x : float or array [m]
        $\\delta_x$: separation along x

    Formula as printed
    ------------------
        \\delta_x = 2 r \\varepsilon_x \\cos\\phi \\cos\\theta

    Reading
    -------
    Erratum: the paper calls $\\theta$ the polar angle, but in every formula from here to A.56 it is the latitude, which is
    zero on the equator. The neighbour lies at $2r (\\cos\\phi \\cos\\theta, \\sin\\phi \\cos\\theta, \\sin\\theta)$.

    Effect: with a polar angle a neighbour on the third axis would be taken for one in the plane of the other two.

    Proof: `theta_is_a_latitude`.

    Laws
    ----
    * theta is a latitude
    * a uniform strain in the plane stretches its pairs alike

    wear-A50, spec/wear/a50_pair_strain.rs, rounding error at most 0.5 ULP
    """
@overload
def separation_x(r: ArrayLike | str, epsilon_x: ArrayLike | str, phi: ArrayLike | str, theta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def separation_z(r: float | str, epsilon_z: float | str, theta: float | str, *, check: bool = True) -> float:
    """Eq. A.51, Appendix A.2.2: separation of a pair along z in a body strained by `epsilon_z`.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    epsilon_z : float or array
        $\\varepsilon_z$: strain along z
    theta : float or array [rad], [-1.5707963267948966, 1.5707963267948966]
        $\\theta$: latitude of the neighbour
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_z : float or array [m]
        $\\delta_z$: separation along z

    Formula as printed
    ------------------
        \\delta_z = 2 r \\varepsilon_z \\sin\\theta

    Reading
    -------
    As printed, with the latitude.

    Laws
    ----
    * theta is a latitude
    * a uniform strain in the plane stretches its pairs alike

    wear-A51, spec/wear/a50_pair_strain.rs, rounding error at most 1 ULP
    """
@overload
def separation_z(r: ArrayLike | str, epsilon_z: ArrayLike | str, theta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def separation_radial(delta_x: float | str, delta_z: float | str, phi: float | str, theta: float | str, *, check: bool = True) -> float:
    """Eq. A.52, Appendix A.2.2: radial component of the separation.

    Parameters
    ----------
    delta_x : float or array [m]
        $\\delta_x$: separation along x
    delta_z : float or array [m]
        $\\delta_z$: separation along z
    phi : float or array [rad]
        $\\phi$: azimuth of the neighbour
    theta : float or array [rad], [-1.5707963267948966, 1.5707963267948966]
        $\\theta$: latitude of the neighbour
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_r : float or array [m]
        $\\delta_r$: radial separation

    Formula as printed
    ------------------
        \\delta_r = \\delta_x \\cos\\phi \\cos\\theta + \\delta_z \\sin\\theta

    Reading
    -------
    As printed; it is the normal separation of the pair.

    Laws
    ----
    * the spherical components keep the length
    * the components point outwards north and east
    * a uniform strain in the plane stretches its pairs alike

    wear-A52, spec/wear/a50_pair_strain.rs, rounding error at most 1 ULP
    """
@overload
def separation_radial(delta_x: ArrayLike | str, delta_z: ArrayLike | str, phi: ArrayLike | str, theta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def separation_meridional(delta_x: float | str, delta_z: float | str, phi: float | str, theta: float | str, *, check: bool = True) -> float:
    """Eq. A.53, Appendix A.2.2: component of the separation towards the north.

    Parameters
    ----------
    delta_x : float or array [m]
        $\\delta_x$: separation along x
    delta_z : float or array [m]
        $\\delta_z$: separation along z
    phi : float or array [rad]
        $\\phi$: azimuth of the neighbour
    theta : float or array [rad], [-1.5707963267948966, 1.5707963267948966]
        $\\theta$: latitude of the neighbour
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_theta : float or array [m]
        $\\delta_\\theta$: separation along the meridian

    Formula as printed
    ------------------
        \\delta_\\theta = -\\delta_x \\cos\\phi \\sin\\theta + \\delta_z \\cos\\theta

    Reading
    -------
    As printed.

    Laws
    ----
    * the spherical components keep the length
    * the components point outwards north and east
    * a uniform strain in the plane stretches its pairs alike

    wear-A53, spec/wear/a50_pair_strain.rs, rounding error at most 0.5 ULP
    """
@overload
def separation_meridional(delta_x: ArrayLike | str, delta_z: ArrayLike | str, phi: ArrayLike | str, theta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def separation_zonal(delta_x: float | str, phi: float | str, *, check: bool = True) -> float:
    """Eq. A.54, Appendix A.2.2: component of the separation towards the east.

    Parameters
    ----------
    delta_x : float or array [m]
        $\\delta_x$: separation along x
    phi : float or array [rad]
        $\\phi$: azimuth of the neighbour
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_phi : float or array [m]
        $\\delta_\\phi$: separation along the parallel

    Formula as printed
    ------------------
        \\delta_\\phi = -\\delta_x \\sin\\phi

    Reading
    -------
    As printed.

    Laws
    ----
    * the spherical components keep the length
    * the components point outwards north and east

    wear-A54, spec/wear/a50_pair_strain.rs, rounding error at most 1 ULP
    """
@overload
def separation_zonal(delta_x: ArrayLike | str, phi: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def pair_strain_energy(k_n: float | str, k_t: float | str, delta_n: float | str, delta_theta: float | str, delta_phi: float | str, *, check: bool = True) -> float:
    """Eq. A.55, Appendix A.2.2: energy of a pair in the elastic range.

    Parameters
    ----------
    k_n : float or array [N/m], >= 0
        $k_N$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    delta_n : float or array [m]
        $\\delta_N$: radial separation
    delta_theta : float or array [m]
        $\\delta_\\theta$: separation along the meridian
    delta_phi : float or array [m]
        $\\delta_\\phi$: separation along the parallel
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u_pair : float or array [J]
        $U_{\\text{pair}}$: energy of the pair

    Formula as printed
    ------------------
        U_{\\text{pair}} = \\frac12 k_N \\delta_N^2 + \\frac12 k_T (\\delta_\\theta^2 + \\delta_\\phi^2)

    Reading
    -------
    As printed.

    Laws
    ----
    * equal stiffnesses store the square of the length

    wear-A55, spec/wear/a50_pair_strain.rs, rounding error at most 1 ULP
    """
@overload
def pair_strain_energy(k_n: ArrayLike | str, k_t: ArrayLike | str, delta_n: ArrayLike | str, delta_theta: ArrayLike | str, delta_phi: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def surrounded_energy(r: float | str, k_n: float | str, k_t: float | str, epsilon_x: float | str, epsilon_z: float | str, *, check: bool = True) -> float:
    """Eq. A.56, Appendix A.2.2: energy of a particle with neighbours in every direction.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    k_n : float or array [N/m], >= 0
        $k_N$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    epsilon_x : float or array
        $\\varepsilon_x$: strain along x
    epsilon_z : float or array
        $\\varepsilon_z$: strain along z
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u : float or array [J]
        $U$: energy with neighbours in all directions

    Formula as printed
    ------------------
        U = \\frac12 \\int_{\\phi=0}^{2\\pi} \\int_{\\theta=-\\pi/2}^{\\pi/2} U_{\\text{pair}} \\cos\\theta \\, d\\theta \\, d\\phi

    Reading
    -------
    The integral of A.50 to A.55, evaluated: with the latitude and its weight $\\cos\\theta$ it is

    $$
    U = 4 \\pi r^2 \\left[\\frac{3 k_N + 2 k_T}{15} (\\varepsilon_x^2 + \\varepsilon_z^2) +
      \\frac{2 (k_N - k_T)}{15} \\varepsilon_x \\varepsilon_z\\right]
    $$

    Laws
    ----
    * is the integral over all directions
    * x and z are alike
    * a polar angle would give nothing

    wear-A56, spec/wear/a56_body_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def surrounded_energy(r: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, epsilon_x: ArrayLike | str, epsilon_z: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def close_packed_energy(u: float | str, *, check: bool = True) -> float:
    """Eq. A.57, Appendix A.2.2: energy of a particle with twelve neighbours.

    Parameters
    ----------
    u : float or array [J], >= 0
        $U$: energy with neighbours in all directions
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u_prime : float or array [J]
        $U'$: energy with twelve neighbours

    Formula as printed
    ------------------
        U' = \\frac{12}{4\\pi} U

    Reading
    -------
    As printed.

    Laws
    ----
    * twelve times the mean of half a pair

    wear-A57, spec/wear/a56_body_energy.rs, rounding error at most 1 ULP
    """
@overload
def close_packed_energy(u: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def close_packed_volume(r: float | str, *, check: bool = True) -> float:
    """Eq. A.58, Appendix A.2.2: volume of a particle and its share of the voids, in close packing.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v : float or array [m^3]
        $V$: volume of the body per particle

    Formula as printed
    ------------------
        V = 4 \\sqrt2 r^3

    Reading
    -------
    As printed. The twelve neighbours "at the edges of a cube" are those of cubic close packing; hexagonal packing has the same
    volume.

    Laws
    ----
    * is a quarter of the cubic cell
    * spheres fill seventy four percent

    wear-A58, spec/wear/a56_body_energy.rs, rounding error at most 1 ULP
    """
@overload
def close_packed_volume(r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def body_stress(r: float | str, k_n: float | str, k_t: float | str, epsilon_x: float | str, epsilon_z: float | str, *, check: bool = True) -> float:
    """Eq. A.59, Appendix A.2.2: stress along x of the strained body.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    k_n : float or array [N/m], >= 0
        $k_N$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    epsilon_x : float or array
        $\\varepsilon_x$: strain along x
    epsilon_z : float or array
        $\\varepsilon_z$: strain along z
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma_x : float or array [Pa]
        $\\sigma_x$: stress along x

    Formula as printed
    ------------------
        \\frac1V \\frac{\\partial U'}{\\partial \\varepsilon_x} = C_{11} \\varepsilon_x + C_{12} \\varepsilon_z

    Reading
    -------
    Evaluates the right-hand side, with A.60 and A.61; a law checks that it is the derivative.

    Laws
    ----
    * the stress is the slope of the energy

    wear-A59, spec/wear/a56_body_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def body_stress(r: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, epsilon_x: ArrayLike | str, epsilon_z: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def constant_11(r: float | str, k_n: float | str, k_t: float | str, *, check: bool = True) -> float:
    """Eq. A.60, Appendix A.2.2: stress per strain in the same direction.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    k_n : float or array [N/m], >= 0
        $k_N$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_11 : float or array [Pa]
        $C_{11}$: elastic constant

    Formula as printed
    ------------------
        C_{11} = \\frac{\\sqrt2}{5 r} (3 k_N + 2 k_T)

    Reading
    -------
    As printed. Averaged over all directions of contacts, with every particle displaced affinely: an upper bound for packings whose contacts have no preferred
    direction. A crystal may exceed it along an axis: without tangential springs a face-centred cubic one has 10/9 of it along \\[111\\].

    Laws
    ----
    * the energy has these second derivatives
    * without tangential springs the ratio is three
    * a cubic crystal exceeds it by a ninth along its diagonal

    wear-A60, spec/wear/a60_elastic_constants.rs, rounding error at most 1 ULP
    """
@overload
def constant_11(r: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def constant_12(r: float | str, k_n: float | str, k_t: float | str, *, check: bool = True) -> float:
    """Eq. A.61, Appendix A.2.2: stress per transverse strain.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    k_n : float or array [N/m], >= 0
        $k_N$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_T$: tangential stiffness
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c_12 : float or array [Pa]
        $C_{12}$: elastic constant

    Formula as printed
    ------------------
        C_{12} = \\frac{\\sqrt2}{5 r} (k_N - k_T)

    Reading
    -------
    As printed.

    Laws
    ----
    * the energy has these second derivatives
    * without tangential springs the ratio is three
    * equal springs do not push sideways

    wear-A61, spec/wear/a60_elastic_constants.rs, rounding error at most 1 ULP
    """
@overload
def constant_12(r: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def normal_stiffness_of_body(e: float | str, r: float | str, nu: float | str, *, check: bool = True) -> float:
    """Eq. A.62, Appendix A.2.2: normal stiffness for desired elastic properties.

    Parameters
    ----------
    e : float or array [Pa], > 0
        $E$: Young's modulus
    r : float or array [m], > 0
        $r$: radius
    nu : float or array, (-1, 0.5)
        $\\nu$: Poisson's ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_n : float or array [N/m]
        $k_N$: normal stiffness

    Formula as printed
    ------------------
        k_N = \\frac{\\sqrt2 E r}{2 (1 - 2\\nu)}

    Reading
    -------
    As printed, for equal radii. As a cross section, through A.26, it is A.64, which is Eq. 15.

    Laws
    ----
    * the stiffnesses reproduce the wanted constants
    * the cross sections give these stiffnesses

    wear-A62, spec/wear/a60_elastic_constants.rs, rounding error at most 1 ULP
    """
@overload
def normal_stiffness_of_body(e: ArrayLike | str, r: ArrayLike | str, nu: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tangential_stiffness_of_body(e: float | str, r: float | str, nu: float | str, *, check: bool = True) -> float:
    """Eq. A.63, Appendix A.2.2: tangential stiffness for desired elastic properties.

    Parameters
    ----------
    e : float or array [Pa], > 0
        $E$: Young's modulus
    r : float or array [m], > 0
        $r$: radius
    nu : float or array, (-1, 0.25]
        $\\nu$: Poisson's ratio
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    k_t : float or array [N/m]
        $k_T$: tangential stiffness

    Formula as printed
    ------------------
        k_T = \\frac{\\sqrt2 E r (1 - 4\\nu)}{2 (1 + \\nu) (1 - 2\\nu)}

    Reading
    -------
    As printed, for equal radii; negative above a Poisson's ratio of 1/4, which the model therefore excludes. As a cross
    section, through A.27, it is A.65, which is Eq. 16. A.66, which replaces the radius there, is Eq. 14.

    Laws
    ----
    * the stiffnesses reproduce the wanted constants
    * the cross sections give these stiffnesses
    * no tangential spring at a poisson ratio of one quarter

    wear-A63, spec/wear/a60_elastic_constants.rs, rounding error at most 0.5 ULP
    """
@overload
def tangential_stiffness_of_body(e: ArrayLike | str, r: ArrayLike | str, nu: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...
