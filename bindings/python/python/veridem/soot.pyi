# Written by stubs.py.
# mypy: disable-error-code="overload-overlap"
"""Demidov, Gor & Khalizov 2024: soot aggregates with necks. The equations, by the names of their functions."""

from typing import Any, NamedTuple, overload, type_check_only

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "acceleration",
    "angular_acceleration",
    "are_neighbours",
    "arm",
    "attenuated",
    "attraction",
    "cantilever_damping",
    "cantilever_force",
    "capillary_energy",
    "capillary_force",
    "contact_torques",
    "convexity",
    "coordination_number",
    "dynamic_friction",
    "edge_curvature",
    "equal_hamaker_energy",
    "equal_hamaker_force",
    "facet_share",
    "facet_share_slope",
    "filter_step",
    "force_of_reading",
    "fractal_number",
    "frictional_contact",
    "gap",
    "gyration_radius",
    "half_step",
    "half_step_start",
    "hamaker_energy",
    "hamaker_force",
    "hollow_inertia",
    "hull_volume",
    "is_dynamic",
    "is_static",
    "lag_limit",
    "mean_arm",
    "natural_frequency",
    "neck",
    "neck_frequencies",
    "neck_stress",
    "normal",
    "normal_velocity",
    "plane_energy",
    "plane_force",
    "preserved",
    "published_contact",
    "relative_spin",
    "relative_velocity",
    "rolling_spin",
    "rotated_spring",
    "rotated_torsion",
    "saturated_hamaker",
    "saturated_plane",
    "slide_and_roll",
    "slipped_spring",
    "solid_inertia",
    "spring_energy",
    "spring_force",
    "spring_with_friction",
    "static_friction",
    "stretched_spring",
    "tangential_velocity",
    "time_response",
    "tip_velocity",
    "tip_way",
    "torsional_spin",
    "transfer_function",
    "turning_rates",
    "verlet_begin",
    "verlet_end",
    "wall_contact",
]

@overload
def solid_inertia(m: float | str, r: float | str, *, check: bool = True) -> float:
    """Section 2.1, unnumbered: moment of inertia of a solid primary particle.

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

    Laws
    ----
    * a solid sphere is a pile of hollow ones

    soot-solid-inertia, spec/mechanics/primary_particle.rs, rounding error at most 1 ULP
    """
@overload
def solid_inertia(m: ArrayLike | str, r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def hollow_inertia(m: float | str, r: float | str, *, check: bool = True) -> float:
    """Section 2.1, unnumbered: moment of inertia of a hollow primary particle, such as soot oxidised from within.

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
        I = \\frac{2}{3} m r^2

    Reading
    -------
    The wall is thin. A wall of finite thickness lies between this and the solid sphere.

    Laws
    ----
    * averages the squared distance from the axis

    soot-hollow-inertia, spec/mechanics/primary_particle.rs, rounding error at most 1 ULP
    """
@overload
def hollow_inertia(m: ArrayLike | str, r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def acceleration(force: ArrayLike, m: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 1, Section 2.1: acceleration of a particle.

    Parameters
    ----------
    force : array (..., 3) [N]
        $\\mathbf{f}$: force on the particle
    m : float or array [kg], > 0
        $m$: mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a : array (..., 3) [m/s^2]
        $\\ddot{\\mathbf{x}}$: acceleration

    Formula as printed
    ------------------
        m \\ddot{\\mathbf{x}} = \\mathbf{f}

    Reading
    -------
    Solved for the acceleration. The force is the sum over all partners.

    Laws
    ----
    * a force and its reaction keep the momentum
    * the power of a force is the rate of the kinetic energy

    soot-1, spec/mechanics/newton.rs, rounding error at most 0.5 ULP
    """

def angular_acceleration(torque: ArrayLike, i: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 2, Section 2.1: angular acceleration of a particle.

    Parameters
    ----------
    torque : array (..., 3) [N m]
        $\\boldsymbol{\\tau}$: torque on the particle about its centre
    i : float or array [kg m^2], > 0
        $I$: moment of inertia
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    alpha : array (..., 3) [rad/s^2]
        $\\ddot{\\boldsymbol{\\theta}}$: angular acceleration

    Formula as printed
    ------------------
        I \\ddot{\\boldsymbol{\\theta}} = \\boldsymbol{\\tau}

    Reading
    -------
    A sphere has the same moment of inertia about every axis, so there is no gyroscopic term, and no force depends on its
    orientation: the angular velocity is all that needs to be integrated. The moment of inertia is that of
    [`primary_particle`](super::primary_particle).

    Laws
    ----
    * a torque turns a hollow sphere more slowly
    * the power of a torque is the rate of the kinetic energy

    soot-2, spec/mechanics/newton.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _HalfStep(NamedTuple):
    v_next: NDArray[np.float64]
    x_next: NDArray[np.float64]
    omega_next: NDArray[np.float64]

def half_step(x: ArrayLike, v: ArrayLike, omega: ArrayLike, force: ArrayLike, torque: ArrayLike, m: ArrayLike | str, i: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _HalfStep:
    """Section 2.1, unnumbered: one step of the half-step scheme for a particle.

    Parameters
    ----------
    x : array (..., 3) [m]
        $\\mathbf{x}_n$: position
    v : array (..., 3) [m/s]
        $\\mathbf{v}_{n-1/2}$: velocity half a step before
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{n-1/2}$: angular velocity half a step before
    force : array (..., 3) [N]
        $\\mathbf{f}_n$: force on the particle
    torque : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_n$: torque on the particle about its centre
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
        $\\mathbf{v}_{n+1/2}$: velocity half a step later
    x_next : array (..., 3) [m]
        $\\mathbf{x}_{n+1}$: position one step later
    omega_next : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{n+1/2}$: angular velocity half a step later

    Formula as printed
    ------------------
        \\mathbf{v}_{n+1/2} = \\mathbf{v}_{n-1/2} + \\frac{\\mathbf{f}_n}{m} \\Delta t, \\quad
        \\mathbf{x}_{n+1} = \\mathbf{x}_n + \\mathbf{v}_{n+1/2} \\Delta t, \\quad
        \\boldsymbol{\\omega}_{n+1/2} = \\boldsymbol{\\omega}_{n-1/2} + \\frac{\\boldsymbol{\\tau}_n}{I} \\Delta t

    Reading
    -------
    The text leaves the integration of Eqs. 1 and 2 open; this is the scheme its results were computed with. Velocities are half a step behind the positions. Forces are evaluated
    with $\\mathbf{x}_n$ and $\\mathbf{v}_{n-1/2}$: a spring that grows by $\\dot{\\boldsymbol{\\xi}}_{n-1/2} \\Delta t$ before it is used is then synchronous with the positions: its
    length at $n$ is the displacement up to $\\mathbf{x}_n$, and the dashpot is half a step late. A contact that exists at the start has springs longer by
    $\\dot{\\boldsymbol{\\xi}}_{-1/2} \\Delta t$: the first step stretches them while the positions still are $\\mathbf{x}_0$. The first velocity comes from [`half_step_start`]; a system
    that starts at rest, or with one common velocity, may use the given velocity instead.

    Laws
    ----
    * the half step scheme undoes itself when time is turned round
    * without springs both schemes lead to the same positions

    soot-half-step, spec/mechanics/verlet.rs, rounding error at most 1 ULP
    """

@type_check_only
class _HalfStepStart(NamedTuple):
    v_before: NDArray[np.float64]
    omega_before: NDArray[np.float64]

def half_step_start(v: ArrayLike, omega: ArrayLike, force: ArrayLike, torque: ArrayLike, m: ArrayLike | str, i: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _HalfStepStart:
    """Section 2.1, unnumbered: velocities half a step before the start.

    Parameters
    ----------
    v : array (..., 3) [m/s]
        $\\mathbf{v}_0$: velocity at the start
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_0$: angular velocity at the start
    force : array (..., 3) [N]
        $\\mathbf{f}_0$: force at the start
    torque : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_0$: torque at the start
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
    v_before : array (..., 3) [m/s]
        $\\mathbf{v}_{-1/2}$: velocity half a step before
    omega_before : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{-1/2}$: angular velocity half a step before

    Formula as printed
    ------------------
        \\mathbf{v}_{-1/2} = \\mathbf{v}_0 - \\frac{\\mathbf{f}_0}{2m} \\Delta t, \\quad
        \\boldsymbol{\\omega}_{-1/2} = \\boldsymbol{\\omega}_0 - \\frac{\\boldsymbol{\\tau}_0}{2I} \\Delta t

    Reading
    -------
    The force is that at the start. It must not advance the springs: the springs of a contact that exists at the start would
    otherwise be stretched by two steps of its initial velocity before anything has moved, instead of the one step of the first
    [`half_step`].

    Laws
    ----
    * without springs both schemes lead to the same positions

    soot-half-step-start, spec/mechanics/verlet.rs, rounding error at most 1 ULP
    """

@type_check_only
class _VerletBegin(NamedTuple):
    v_half: NDArray[np.float64]
    x_next: NDArray[np.float64]
    omega_half: NDArray[np.float64]

def verlet_begin(x: ArrayLike, v: ArrayLike, omega: ArrayLike, force: ArrayLike, torque: ArrayLike, m: ArrayLike | str, i: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _VerletBegin:
    """Section 2.1, unnumbered: first part of a step of velocity Verlet, up to the positions at which the next forces are evaluated.

    Parameters
    ----------
    x : array (..., 3) [m]
        $\\mathbf{x}_n$: position
    v : array (..., 3) [m/s]
        $\\mathbf{v}_n$: velocity
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_n$: angular velocity
    force : array (..., 3) [N]
        $\\mathbf{f}_n$: force on the particle
    torque : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_n$: torque on the particle about its centre
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
    v_half : array (..., 3) [m/s]
        $\\mathbf{v}_{n+1/2}$: velocity half a step later
    x_next : array (..., 3) [m]
        $\\mathbf{x}_{n+1}$: position one step later
    omega_half : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{n+1/2}$: angular velocity half a step later

    Formula as printed
    ------------------
        \\mathbf{v}_{n+1/2} = \\mathbf{v}_n + \\frac{\\mathbf{f}_n}{2m} \\Delta t, \\quad
        \\mathbf{x}_{n+1} = \\mathbf{x}_n + \\mathbf{v}_{n+1/2} \\Delta t, \\quad
        \\boldsymbol{\\omega}_{n+1/2} = \\boldsymbol{\\omega}_n + \\frac{\\boldsymbol{\\tau}_n}{2I} \\Delta t

    Reading
    -------
    An alternative to [`half_step`] with velocities at the full step. The next forces are evaluated with $\\mathbf{x}_{n+1}$ and $\\mathbf{v}_{n+1/2}$; a spring grows by
    $\\dot{\\boldsymbol{\\xi}}_{n+1/2} \\Delta t$ before it is used, once per step. For forces without springs, and for contacts formed later, [`half_step`] evaluates the same: the positions are the
    same, except for dashpots at the start, and only the velocity reported with a position differs. The forces at the start are evaluated with $\\mathbf{x}_0$ and $\\mathbf{v}_0$, and do not advance
    the springs: the springs of a contact that exists at the start match the displacement, one step of their initial rate shorter than with [`half_step`]. Positions then differ in first order: for
    an undamped spring by $\\dot{\\xi}_0 \\Delta t \\, (1 - \\cos \\omega t)$, at most by the displacement of two steps, and where it comes to rest by one. From rest, or with one common velocity, no
    first-order difference remains.

    Laws
    ----
    * velocity verlet undoes itself when time is turned round
    * a spring from the start sets the schemes apart by its first step
    * the energy of an oscillator stays within bounds and errs in second order

    soot-verlet-begin, spec/mechanics/verlet.rs, rounding error at most 1 ULP
    """

@type_check_only
class _VerletEnd(NamedTuple):
    v: NDArray[np.float64]
    omega: NDArray[np.float64]

def verlet_end(v_half: ArrayLike, omega_half: ArrayLike, force: ArrayLike, torque: ArrayLike, m: ArrayLike | str, i: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _VerletEnd:
    """Section 2.1, unnumbered: second part of a step of velocity Verlet, with the new forces.

    Parameters
    ----------
    v_half : array (..., 3) [m/s]
        $\\mathbf{v}_{n+1/2}$: velocity half a step before
    omega_half : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{n+1/2}$: angular velocity half a step before
    force : array (..., 3) [N]
        $\\mathbf{f}_{n+1}$: force now
    torque : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_{n+1}$: torque now
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
    v : array (..., 3) [m/s]
        $\\mathbf{v}_{n+1}$: velocity
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{n+1}$: angular velocity

    Formula as printed
    ------------------
        \\mathbf{v}_{n+1} = \\mathbf{v}_{n+1/2} + \\frac{\\mathbf{f}_{n+1}}{2m} \\Delta t, \\quad
        \\boldsymbol{\\omega}_{n+1} = \\boldsymbol{\\omega}_{n+1/2} + \\frac{\\boldsymbol{\\tau}_{n+1}}{2I} \\Delta t

    Laws
    ----
    * velocity verlet undoes itself when time is turned round
    * a force and its reaction keep momentum and angular momentum

    soot-verlet-end, spec/mechanics/verlet.rs, rounding error at most 1 ULP
    """

def normal(x_i: ArrayLike, x_j: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 3, Section 2.1.1: unit normal of a pair.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    n : array (..., 3)
        $\\mathbf{n}$: normal, from i to j

    Formula as printed
    ------------------
        \\mathbf{n} = \\frac{\\mathbf{x}_j - \\mathbf{x}_i}{\\lVert \\mathbf{x}_j - \\mathbf{x}_i \\rVert}

    Reading
    -------
    From i to j: the opposite of the normal of a [`Contact`](crate::Contact). All equations of this paper are in the convention of the
    paper; [`ContactKinematics`](super::contact_kinematics::ContactKinematics) is the one place where one is turned into the other.

    Laws
    ----
    * swapping the particles turns the normal round

    soot-3, spec/mechanics/pair_geometry.rs, rounding error at most 1 ULP
    """

@overload
def arm(r: float | str, delta: float | str, *, check: bool = True) -> float:
    """Eq. 5, Section 2.1.1: distance of the contact point from the centre of a particle.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius of the particle
    delta : float or array [m]
        $\\delta$: gap, negative for an overlap
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a : float or array [m]
        $a$: arm

    Formula as printed
    ------------------
        a = r + \\frac{1}{2} \\delta

    Reading
    -------
    For unequal spheres each has its own, $a_i = r_i + \\delta/2$ and $a_j = r_j + \\delta/2$: the contact point lies halfway between the surfaces,
    and the arms add up to the distance between the centres; otherwise no force in the contact plane could conserve angular momentum.

    Laws
    ----
    * the arms add up to the distance of the centres

    soot-5, spec/mechanics/pair_geometry.rs, rounding error at most 0.5 ULP
    """
@overload
def arm(r: ArrayLike | str, delta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def gap(x_i: ArrayLike, x_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> Any:
    """Eq. 6, Section 2.1.1: gap between two surfaces.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta : float or array [m]
        $\\delta$: gap, negative for an overlap

    Formula as printed
    ------------------
        \\delta = \\lVert \\mathbf{x}_j - \\mathbf{x}_i \\rVert - 2r

    Reading
    -------
    Negative for an overlap. For unequal spheres $2r$ is $r_i + r_j$.

    Laws
    ----
    * the gap closes with the normal velocity

    soot-6, spec/mechanics/pair_geometry.rs, rounding error at most 1 ULP
    """

@overload
def mean_arm(a_i: float | str, a_j: float | str, *, check: bool = True) -> float:
    """Section 2.1.1, unnumbered: the radius that represents both spheres in rolling and torsion.

    Parameters
    ----------
    a_i : float or array [m], > 0
        $a_i$: arm or radius of i
    a_j : float or array [m], > 0
        $a_j$: arm or radius of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a_mean : float or array [m]
        $\\bar{a}$: arm of the pair

    Formula as printed
    ------------------
        \\bar{a} = \\frac{2 a_i a_j}{a_i + a_j}

    Reading
    -------
    The paper has equal radii and writes $a$ and $r$. The rates of the rolling and the torsion spring must be the same seen from both particles, and
    a torque and its reaction must be opposite, so one length has to serve both. The harmonic mean is the one for which the rolling spring measures twice the displacement
    of the contact point over the surfaces, as it does for equal spheres.

    Laws
    ----
    * equal spheres have the arm of the paper
    * the rolling spring measures twice the way of the contact point

    soot-mean-arm, spec/mechanics/pair_geometry.rs, rounding error at most 1 ULP
    """
@overload
def mean_arm(a_i: ArrayLike | str, a_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def relative_velocity(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 4, Section 2.1.1: velocity of j relative to i at their contact point.

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
    v_ij : array (..., 3) [m/s]
        $\\mathbf{v}_{ij}$: relative velocity

    Formula as printed
    ------------------
        \\mathbf{v}_{ij} = \\mathbf{v}_j - \\mathbf{v}_i + \\boldsymbol{\\omega}_j \\times a \\mathbf{n} + \\boldsymbol{\\omega}_i \\times a \\mathbf{n}

    Reading
    -------
    Erratum: both angular velocities have the wrong sign for the normal of Eq. 3. The contact point lies at $+a\\mathbf{n}$ from the centre of i and at $-a\\mathbf{n}$ from that of j, so
    $\\mathbf{v}_{ij} = \\mathbf{v}_j - \\mathbf{v}_i - \\boldsymbol{\\omega}_j \\times a_j \\mathbf{n} - \\boldsymbol{\\omega}_i \\times a_i \\mathbf{n}$.

    Effect: with the printed signs a pair that rotates as one body slides, and a necked pair that is pushed aside accelerates without bound.

    Proof: `a_pair_that_turns_as_one_body_has_no_relative_velocity_which_the_printed_signs_give_it`.

    Laws
    ----
    * a pair that turns as one body has no relative velocity which the printed signs give it
    * rolling on each other without sliding is no relative velocity
    * swapping the particles reverses it

    soot-4, spec/mechanics/relative_velocity.rs, rounding error at most 2 ULP
    """

def normal_velocity(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 7, Section 2.1.1: normal part of the relative velocity, the rate of the normal spring.

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
    v_n : array (..., 3) [m/s]
        $\\mathbf{v}_{ij,\\mathrm{n}}$: normal velocity

    Formula as printed
    ------------------
        \\mathbf{v}_{ij,\\mathrm{n}} = (\\mathbf{v}_{ij} \\cdot \\mathbf{n}) \\, \\mathbf{n}

    Reading
    -------
    As printed, with the relative velocity of Eq. 4 as read there. The contribution of the spins is perpendicular to the normal, whatever the radii: they cancel
    and are omitted, so that rounding does not let a rotating sphere approach. The normal part is that of $\\mathbf{v}_j - \\mathbf{v}_i$.

    Laws
    ----
    * the two parts are perpendicular and add up
    * spheres that turn on the spot do not approach

    soot-7, spec/mechanics/relative_velocity.rs, rounding error at most 2 ULP
    """

def tangential_velocity(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 8, Section 2.1.1: tangential part of the relative velocity, the rate of the tangential spring.

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
        $\\mathbf{v}_{ij,\\mathrm{t}}$: sliding velocity

    Formula as printed
    ------------------
        \\mathbf{v}_{ij,\\mathrm{t}} = \\mathbf{v}_{ij} - (\\mathbf{v}_{ij} \\cdot \\mathbf{n}) \\, \\mathbf{n}

    Reading
    -------
    As printed, with the relative velocity of Eq. 4 as read there.

    Laws
    ----
    * the two parts are perpendicular and add up

    soot-8, spec/mechanics/relative_velocity.rs, rounding error at most 11 ULP
    """

def relative_spin(omega_i: ArrayLike, omega_j: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 9, Section 2.1.1: angular velocity of j relative to i.

    Parameters
    ----------
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega_ij : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{ij}$: relative angular velocity

    Formula as printed
    ------------------
        \\boldsymbol{\\omega}_{ij} = \\boldsymbol{\\omega}_j - \\boldsymbol{\\omega}_i

    Reading
    -------
    As printed: a spin that both share drops out.

    Laws
    ----
    * a common spin drops out

    soot-9, spec/mechanics/relative_spin.rs, rounding error at most 0.5 ULP
    """

def torsional_spin(x_i: ArrayLike, x_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 10, Section 2.1.1: torsion, the part of the relative angular velocity along the normal.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega_n : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{ij,\\mathrm{n}}$: torsional angular velocity

    Formula as printed
    ------------------
        \\boldsymbol{\\omega}_{ij,\\mathrm{n}} = (\\boldsymbol{\\omega}_{ij} \\cdot \\mathbf{n}) \\, \\mathbf{n}

    Reading
    -------
    As printed.

    Laws
    ----
    * torsion and rolling are perpendicular and add up

    soot-10, spec/mechanics/relative_spin.rs, rounding error at most 2 ULP
    """

def rolling_spin(x_i: ArrayLike, x_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 11, Section 2.1.1: rolling, the part of the relative angular velocity in the contact plane.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega_r : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_{ij,\\mathrm{r}}$: rolling angular velocity

    Formula as printed
    ------------------
        \\boldsymbol{\\omega}_{ij,\\mathrm{r}} = \\boldsymbol{\\omega}_{ij} - (\\boldsymbol{\\omega}_{ij} \\cdot \\mathbf{n}) \\, \\mathbf{n}

    Reading
    -------
    As printed.

    Where the axis and a component of the spin nearly agree, little of that component is left: such pairs determine the rounding bound.

    Laws
    ----
    * torsion and rolling are perpendicular and add up

    soot-11, spec/mechanics/relative_spin.rs, rounding error at most 14 ULP
    """

@type_check_only
class _TurningRates(NamedTuple):
    rate_rolling: NDArray[np.float64]
    rate_torsion: NDArray[np.float64]

def turning_rates(x_i: ArrayLike, x_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, *, check: bool = True) -> _TurningRates:
    """Section 2.1.1, unnumbered: rates at which rotation stretches the rolling and the torsion spring.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
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
    rate_rolling : array (..., 3) [m/s]
        $\\dot{\\boldsymbol{\\xi}}_\\mathrm{r}$: rate of the rolling spring, in the contact plane
    rate_torsion : array (..., 3) [m/s]
        $\\dot{\\boldsymbol{\\xi}}_\\mathrm{o}$: rate of the torsion spring, along the normal

    Formula as printed
    ------------------
        \\dot{\\boldsymbol{\\xi}}_\\mathrm{r} = \\boldsymbol{\\omega}_{ij,\\mathrm{r}} \\times a \\mathbf{n}, \\quad
        \\dot{\\boldsymbol{\\xi}}_\\mathrm{o} = r \\boldsymbol{\\omega}_{ij,\\mathrm{n}}

    Reading
    -------
    For unequal spheres $a$ and $r$ are the [`mean_arm`]s of the two arms and of the two radii. The rates of the normal and the tangential spring are Eqs. 7 and 8.

    Laws
    ----
    * seen from the other particle rolling is the same and torsion reversed
    * equal spheres in touch roll against the ways of both contact points

    soot-rates, spec/mechanics/relative_spin.rs, rounding error at most 3 ULP
    """

def rotated_spring(xi: ArrayLike, n: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 2.1.1, step 2, unnumbered: a tangential or rolling spring after the contact plane has turned.

    Parameters
    ----------
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}'$: spring before
    n : array (..., 3), a unit vector
        $\\mathbf{n}$: normal now
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    rotated : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring in the contact plane, as long as before

    Formula as printed
    ------------------
        \\boldsymbol{\\xi} = \\boldsymbol{\\xi}'_\\perp \\frac{|\\boldsymbol{\\xi}'|}{|\\boldsymbol{\\xi}'_\\perp|}, \\quad
        \\boldsymbol{\\xi}'_\\perp = \\boldsymbol{\\xi}' - (\\boldsymbol{\\xi}' \\cdot \\mathbf{n}) \\, \\mathbf{n}

    Reading
    -------
    "Rotating to be orthogonal to n and re-scaling". In the limit of small steps this is the parallel transport of the spring with the contact plane.
    A spin of the pair about its normal does not turn it. A spring without a component in the plane, which cannot result from small steps, vanishes.

    Laws
    ----
    * turning keeps the length of a spring and puts it into the plane
    * a spring in the plane stays as it is
    * a spring carried round with its pair turns with it
    * a spring along the normal is lost and a torsion across it counts as positive

    soot-rotated, spec/mechanics/rotated_spring.rs, rounding error at most 2 ULP
    """

def rotated_torsion(xi: ArrayLike, n: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 2.1.1, step 2, unnumbered: a torsion spring after the normal has turned.

    Parameters
    ----------
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}'$: spring before
    n : array (..., 3), a unit vector
        $\\mathbf{n}$: normal now
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    rotated : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring along the normal, as long as before

    Formula as printed
    ------------------
        \\boldsymbol{\\xi} = \\operatorname{sgn}(\\boldsymbol{\\xi}' \\cdot \\mathbf{n}) \\, |\\boldsymbol{\\xi}'| \\, \\mathbf{n}

    Reading
    -------
    Erratum: the text rotates all three springs to be orthogonal to the normal. The torsion spring lies along the normal; its projection
    onto the contact plane is only rounding, or the rotation of the normal in one step, and rescaling it to the full length makes a spring in an arbitrary direction, or none. It must stay parallel.
    Then only its signed length needs to be remembered, $\\xi_\\mathrm{o} = \\boldsymbol{\\xi} \\cdot \\mathbf{n}$, which rotation does not change; the models do that.

    Effect: as printed the torsion is lost and never resisted, and the remaining spring bends the pair. Aggregates all of whose contacts are necks, which would be rigid, then compact under a coating by 9 %.

    Proof: `a_torsion_spring_turns_with_its_pair_which_the_published_step_forgets`.

    Laws
    ----
    * a torsion spring turns with its pair which the published step forgets

    soot-rotated-torsion, spec/mechanics/rotated_spring.rs, rounding error at most 1 ULP
    """

def stretched_spring(xi: ArrayLike, n: ArrayLike, xi_dot: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Section 2.1.1, steps 2 and 3, unnumbered: a tangential or rolling spring after a time step.

    Parameters
    ----------
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}'$: spring before
    n : array (..., 3), a unit vector
        $\\mathbf{n}$: normal now
    xi_dot : array (..., 3) [m/s]
        $\\dot{\\boldsymbol{\\xi}}$: rate, in the contact plane
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    xi_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring now

    Formula as printed
    ------------------
        \\boldsymbol{\\xi} := \\boldsymbol{\\xi} + \\dot{\\boldsymbol{\\xi}} \\Delta t

    Reading
    -------
    [`rotated_spring`], then the increment, and only then the force (step 4). Used before it is incremented, the spring lags by one step behind the
    positions, and $k\\boldsymbol{\\xi} + \\eta\\dot{\\boldsymbol{\\xi}}$ acts like a dashpot of $\\eta - k \\Delta t$, which may be negative.

    Laws
    ----
    * moving back relaxes a spring
    * an undamped spring keeps the energy which the lagged order raises

    soot-spring, spec/mechanics/rotated_spring.rs, rounding error at most 2 ULP
    """

@overload
def lag_limit(k: float | str, eta: float | str, *, check: bool = True) -> float:
    """Section 2.1.1, steps 3 and 4, unnumbered: largest stable time step of a spring that acts before it is stretched.

    Parameters
    ----------
    k : float or array [N/m], > 0
        $k$: stiffness
    eta : float or array [kg/s], >= 0
        $\\eta$: damping coefficient
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    dt_max : float or array [s]
        $\\Delta t_{\\max}$: largest stable time step

    Formula as printed
    ------------------
        \\Delta t_{\\max} = \\frac{\\eta}{k}

    Reading
    -------
    The springs of the published program lag, see [`stretched_spring`]: above this step the effective damping coefficient is negative and drives the pair. This limit holds in addition to the
    frequency limits, and does not depend on masses: where all springs have the same ratio it holds for any number of necks.

    Laws
    ----
    * beyond its limit a spring that lags gains energy

    soot-lag-limit, spec/mechanics/rotated_spring.rs, rounding error at most 0.5 ULP
    """
@overload
def lag_limit(k: ArrayLike | str, eta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def spring_force(k: ArrayLike | str, xi: ArrayLike, eta: ArrayLike | str, xi_dot: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 12, Section 2.1.2: force of a spring and its dashpot on i.

    Parameters
    ----------
    k : float or array [N/m], >= 0
        $k$: stiffness
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring
    eta : float or array [kg/s], >= 0
        $\\eta$: damping coefficient
    xi_dot : array (..., 3) [m/s]
        $\\dot{\\boldsymbol{\\xi}}$: rate
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : array (..., 3) [N]
        $\\mathbf{f}$: force on i

    Formula as printed
    ------------------
        \\mathbf{f} = k \\boldsymbol{\\xi} + \\eta \\dot{\\boldsymbol{\\xi}}

    Reading
    -------
    On i, with the velocity of j relative to i: the spring pulls i after j. For the normal spring, $\\boldsymbol{\\xi} = \\delta \\mathbf{n}$: a neck is at rest where the
    surfaces touch, whatever the gap at which it was made. The dashpot acts from the onset of a contact, discontinuously.

    Laws
    ----
    * a spring returns its work and a dashpot does not

    soot-12, spec/mechanics/spring_force.rs, rounding error at most 0.5 ULP
    """

def spring_energy(k: ArrayLike | str, xi: ArrayLike, *, check: bool = True) -> Any:
    """Section 2.1.2, unnumbered: energy stored in a spring.

    Parameters
    ----------
    k : float or array [N/m], >= 0
        $k$: stiffness
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u : float or array [J]
        $U$: energy

    Formula as printed
    ------------------
        U = \\frac{1}{2} k \\, |\\boldsymbol{\\xi}|^2

    Laws
    ----
    * a spring returns its work and a dashpot does not

    soot-spring-energy, spec/mechanics/spring_force.rs, rounding error at most 1 ULP
    """

@type_check_only
class _ContactTorques(NamedTuple):
    tau_i: NDArray[np.float64]
    tau_j: NDArray[np.float64]

def contact_torques(x_i: ArrayLike, x_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, f_t: ArrayLike, f_r: ArrayLike, f_o: ArrayLike, *, check: bool = True) -> _ContactTorques:
    """Section 2.1.2, unnumbered: torques of the tangential force and of the rolling and torsion quasi-forces.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, distinct from `x_i`
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    f_t : array (..., 3) [N]
        $\\mathbf{f}_\\mathrm{t}$: tangential force on i
    f_r : array (..., 3) [N]
        $\\mathbf{f}_\\mathrm{r}$: rolling quasi-force
    f_o : array (..., 3) [N]
        $\\mathbf{f}_\\mathrm{o}$: torsion quasi-force
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    tau_i : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_i$: torque on i about its centre
    tau_j : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_j$: torque on j about its centre

    Formula as printed
    ------------------
        \\boldsymbol{\\tau}_i = a_i \\mathbf{n} \\times \\mathbf{f}_\\mathrm{t} + \\mathbf{m}, \\quad
        \\boldsymbol{\\tau}_j = a_j \\mathbf{n} \\times \\mathbf{f}_\\mathrm{t} - \\mathbf{m}, \\quad
        \\mathbf{m} = a \\mathbf{n} \\times \\mathbf{f}_\\mathrm{r} + r \\, (\\mathbf{f}_\\mathrm{o} \\cdot \\mathbf{n}) \\, \\mathbf{n}

    Reading
    -------
    The paper gives no formula. The tangential force acts on both surfaces at the contact point, in opposite directions and at opposite arms: its torques have the same sign and balance the
    couple of the two forces. Rolling and torsion are pure torques. Their arms are those of their rates, so that their power is
    $-\\mathbf{f} \\cdot \\dot{\\boldsymbol{\\xi}}$; for unequal spheres $a$ and $r$ are the [`mean_arm`]s.

    Laws
    ----
    * torques balance the couple of the tangential force
    * the power of torques and forces is that of the springs

    soot-torques, spec/mechanics/spring_force.rs, rounding error at most 4 ULP
    """

@type_check_only
class _NeckStress(NamedTuple):
    sigma: Any
    tau: Any

def neck_stress(f_n: ArrayLike | str, f_t: ArrayLike, m: ArrayLike, n: ArrayLike, r_b: ArrayLike | str, *, check: bool = True) -> _NeckStress:
    """Not in the paper: the largest tensile and the largest shear stress in a neck, which decide when it breaks.

    Parameters
    ----------
    f_n : float or array [N]
        $f_\\mathrm{n}$: force along the normal, positive where it pulls
    f_t : array (..., 3) [N]
        $\\mathbf{f}_\\mathrm{t}$: force across the normal
    m : array (..., 3) [N m]
        $\\mathbf{m}$: torque that bends and twists
    n : array (..., 3), a unit vector
        $\\mathbf{n}$: normal
    r_b : float or array [m], > 0
        $r_\\mathrm{b}$: radius of the neck
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma : float or array [Pa]
        $\\sigma$: largest tensile stress
    tau : float or array [Pa]
        $\\tau$: largest shear stress

    Formula as printed
    ------------------
        \\sigma = \\frac{f_\\mathrm{n}}{\\pi r_\\mathrm{b}^2} + \\frac{4 |\\mathbf{m}_\\perp|}{\\pi r_\\mathrm{b}^3}, \\quad
        \\tau = \\frac{|\\mathbf{f}_\\mathrm{t}|}{\\pi r_\\mathrm{b}^2} + \\frac{2 |\\mathbf{m} \\cdot \\mathbf{n}|}{\\pi r_\\mathrm{b}^3}

    Reading
    -------
    The paper's bonds have a tensile strength, but neither its value nor a cross-section is given. The neck is taken as a short elastic beam of circular cross-section, the bonded particles of
    Potyondy and Cundall (2004): normal and shear force are distributed uniformly, the stresses of bending and torsion increase linearly with the distance from the axis. Both stresses are evaluated on the
    circumference, where they are largest. If compression outweighs bending, no part of the neck is in tension and $\\sigma$ is negative.

    Laws
    ----
    * stresses over the section add up to what the neck carries

    soot-neck-stress, spec/soot/def_neck_stress.rs, rounding error at most 0.5 ULP
    """

@type_check_only
class _NeckFrequencies(NamedTuple):
    omega_n: Any
    omega_t: Any
    omega_r: Any
    omega_o: Any

def neck_frequencies(k_n: ArrayLike | str, k_t: ArrayLike | str, k_r: ArrayLike | str, k_o: ArrayLike | str, m: ArrayLike | str, i: ArrayLike | str, r: ArrayLike | str, *, check: bool = True) -> _NeckFrequencies:
    """Section 2.1.2, unnumbered: frequencies of two equal spheres in the four degrees of freedom of their neck.

    Parameters
    ----------
    k_n : float or array [N/m], > 0
        $k_\\mathrm{n}$: normal stiffness
    k_t : float or array [N/m], > 0
        $k_\\mathrm{t}$: tangential stiffness
    k_r : float or array [N/m], > 0
        $k_\\mathrm{r}$: rolling stiffness
    k_o : float or array [N/m], > 0
        $k_\\mathrm{o}$: torsional stiffness
    m : float or array [kg], > 0
        $m$: mass of each sphere
    i : float or array [kg m^2], > 0
        $I$: its moment of inertia
    r : float or array [m], > 0
        $r$: its radius
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega_n : float or array [rad/s]
        $\\omega_\\mathrm{n}$: normal
    omega_t : float or array [rad/s]
        $\\omega_\\mathrm{t}$: tangential
    omega_r : float or array [rad/s]
        $\\omega_\\mathrm{r}$: rolling
    omega_o : float or array [rad/s]
        $\\omega_\\mathrm{o}$: torsion

    Formula as printed
    ------------------
        \\omega_\\mathrm{n} = \\sqrt{\\frac{2k_\\mathrm{n}}{m}}, \\quad \\omega_\\mathrm{t} = \\sqrt{2k_\\mathrm{t} \\left(\\frac{1}{m} + \\frac{r^2}{I}\\right)}, \\quad
        \\omega_\\mathrm{r} = \\sqrt{\\frac{2k_\\mathrm{r} r^2}{I}}, \\quad \\omega_\\mathrm{o} = \\sqrt{\\frac{2k_\\mathrm{o} r^2}{I}}

    Reading
    -------
    Eqs. 1, 2 and 12 for small motions about rest, without damping. Solid spheres have $7k_\\mathrm{t}/m$ and $5k_\\mathrm{r}/m$ under the roots, hollow ones $5k_\\mathrm{t}/m$ and $3k_\\mathrm{r}/m$.
    With the printed signs of Eq. 4 the second would be imaginary.

    Laws
    ----
    * solid and hollow spheres have the stated frequencies

    soot-frequencies, spec/mechanics/pair_frequency.rs, rounding error at most 1 ULP
    """

@overload
def slide_and_roll(s_t: float | str, s_r: float | str, r_i: float | str, r_j: float | str, m_i: float | str, m_j: float | str, *, check: bool = True) -> float:
    """Section 2.1.1, unnumbered: time step relative to the stability limit of sliding and rolling of two spheres.

    Parameters
    ----------
    s_t : float or array [kg], >= 0
        $s_\\mathrm{t}$: spring and dashpot of sliding in a step
    s_r : float or array [kg], >= 0
        $s_\\mathrm{r}$: spring and dashpot of rolling in a step
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
    lambda : float or array
        $\\lambda$: stable below 4

    Formula as printed
    ------------------
        \\lambda = \\tfrac{1}{2} \\left(a + b + \\sqrt{(a - b)^2 + 4c^2}\\right), \\quad a = s_\\mathrm{t} \\left(\\tfrac{1}{m_i} + \\tfrac{1}{m_j} + \\tfrac{r_i^2}{I_i} + \\tfrac{r_j^2}{I_j}\\right), \\quad
        b = s_\\mathrm{r} \\bar{a}^2 \\left(\\tfrac{1}{I_i} + \\tfrac{1}{I_j}\\right), \\quad c^2 = s_\\mathrm{t} s_\\mathrm{r} \\bar{a}^2 \\left(\\tfrac{r_i}{I_i} - \\tfrac{r_j}{I_j}\\right)^2, \\quad
        s = k \\Delta t^2 + 2 \\eta \\Delta t

    Reading
    -------
    Eqs. 1, 2 and 12 for small motions about rest; dashpots act with the velocity of the step before. The largest eigenvalue of the map of the two springs over a step; the step is stable below 4.
    Equal spheres slide and roll independently, and each motion has the limit of a mass on a spring. Unequal spheres do not: undamped, the limit of a sphere against one of three times its radius
    is nine tenths of the limit against an equal one, against an infinite one three quarters.

    Laws
    ----
    * equal spheres slide and roll independently
    * a large partner couples sliding and rolling

    soot-slide-and-roll, spec/mechanics/pair_frequency.rs, rounding error at most 1 ULP
    """
@overload
def slide_and_roll(s_t: ArrayLike | str, s_r: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, m_i: ArrayLike | str, m_j: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def is_static(f_0: ArrayLike, f_cs: ArrayLike | str, *, check: bool = True) -> Any:
    """Eq. 13, Section 2.1.3: whether friction is static.

    Parameters
    ----------
    f_0 : array (..., 3) [N]
        $\\mathbf{f}_0$: test force
    f_cs : float or array [N], >= 0
        $f_{\\mathrm{C,s}}$: static friction force
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    holds : float or array
        $$: one if friction is static, else zero

    Formula as printed
    ------------------
        \\lVert \\mathbf{f}_0 \\rVert \\le f_{\\mathrm{C,s}}

    Reading
    -------
    As printed; at equality the contact holds. The test force is Eq. 12 with the spring of this step.

    Laws
    ----
    * a contact either holds or slips
    * at the largest static force a contact holds

    soot-13, spec/mechanics/friction.rs, rounding error at most 0 ULP
    """

def is_dynamic(f_0: ArrayLike, f_cs: ArrayLike | str, *, check: bool = True) -> Any:
    """Eq. 14, Section 2.1.3: whether friction is dynamic.

    Parameters
    ----------
    f_0 : array (..., 3) [N]
        $\\mathbf{f}_0$: test force
    f_cs : float or array [N], >= 0
        $f_{\\mathrm{C,s}}$: static friction force
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    slips : float or array
        $$: one if friction is dynamic, else zero

    Formula as printed
    ------------------
        \\lVert \\mathbf{f}_0 \\rVert > f_{\\mathrm{C,s}}

    Reading
    -------
    As printed.

    Laws
    ----
    * a contact either holds or slips

    soot-14, spec/mechanics/friction.rs, rounding error at most 0 ULP
    """

@overload
def static_friction(mu_s: float | str, f_n: float | str, *, check: bool = True) -> float:
    """Eq. 15, Section 2.1.3: largest force of static friction.

    Parameters
    ----------
    mu_s : float or array, >= 0
        $\\mu_\\mathrm{s}$: static friction coefficient
    f_n : float or array [N], >= 0
        $f_\\mathrm{n}$: normal force of the contact
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_cs : float or array [N]
        $f_{\\mathrm{C,s}}$: static friction force

    Formula as printed
    ------------------
        f_{\\mathrm{C,s}} = \\mu_\\mathrm{s} f_\\mathrm{n}

    Reading
    -------
    $f_\\mathrm{n}$ is the repulsion of the contact, spring and dashpot, without van der Waals and capillary forces, which act
    through the overlap; where their sum would pull, it is zero and so is all friction.

    Laws
    ----
    * no normal force no friction
    * friction grows by its coefficient with the normal force

    soot-15, spec/mechanics/friction.rs, rounding error at most 0.5 ULP
    """
@overload
def static_friction(mu_s: ArrayLike | str, f_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def dynamic_friction(mu_d: float | str, f_n: float | str, *, check: bool = True) -> float:
    """Eq. 16, Section 2.1.3: force of dynamic friction.

    Parameters
    ----------
    mu_d : float or array, >= 0
        $\\mu_\\mathrm{d}$: dynamic friction coefficient, at most the static one
    f_n : float or array [N], >= 0
        $f_\\mathrm{n}$: normal force of the contact
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f_cd : float or array [N]
        $f_{\\mathrm{C,d}}$: dynamic friction force

    Formula as printed
    ------------------
        f_{\\mathrm{C,d}} = \\mu_\\mathrm{d} f_\\mathrm{n}

    Reading
    -------
    The normal force is that of Eq. 15. With $\\mu_\\mathrm{d} < \\mu_\\mathrm{s}$ a steadily driven contact does not slide at $f_{\\mathrm{C,d}}$: it slips
    back to it and sticks again, so that its force is a sawtooth between the two.

    Laws
    ----
    * friction grows by its coefficient with the normal force

    soot-16, spec/mechanics/friction.rs, rounding error at most 0.5 ULP
    """
@overload
def dynamic_friction(mu_d: ArrayLike | str, f_n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def slipped_spring(k: ArrayLike | str, eta: ArrayLike | str, f_cd: ArrayLike | str, f_0: ArrayLike, xi_dot: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Eq. 17, Section 2.1.3: the spring after it has slipped.

    Parameters
    ----------
    k : float or array [N/m], >= 0
        $k$: stiffness
    eta : float or array [kg/s], >= 0
        $\\eta$: damping coefficient
    f_cd : float or array [N], >= 0
        $f_{\\mathrm{C,d}}$: dynamic friction force
    f_0 : array (..., 3) [N]
        $\\mathbf{f}_0$: test force, above the static friction force
    xi_dot : array (..., 3) [m/s]
        $\\dot{\\boldsymbol{\\xi}}$: rate
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    xi_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}'$: spring after the step

    Formula as printed
    ------------------
        \\boldsymbol{\\xi}' = -\\frac{1}{k} \\left(f_{\\mathrm{C,d}} \\frac{\\mathbf{f}_0}{\\lVert \\mathbf{f}_0 \\rVert} + \\eta \\dot{\\boldsymbol{\\xi}}\\right)

    Reading
    -------
    Erratum: the signs belong to a force $-k\\boldsymbol{\\xi} - \\eta\\dot{\\boldsymbol{\\xi}}$. The spring is meant to continue with the force that was applied, which with Eq. 12 is
    $\\boldsymbol{\\xi}' = \\frac{1}{k} \\big(f_{\\mathrm{C,d}} \\mathbf{f}_0 / \\lVert \\mathbf{f}_0 \\rVert - \\eta\\dot{\\boldsymbol{\\xi}}\\big)$. Without stiffness there is no spring, and its length is zero.

    Effect: the printed spring pulls the other way in the step after a slip. Driven steadily, friction would
    jump from $f_{\\mathrm{C,s}}$ to $-f_{\\mathrm{C,d}}$ at every slip and be $(f_{\\mathrm{C,s}} - f_{\\mathrm{C,d}})/2$ on average, zero if the two are equal.

    Proof: `the_spring_goes_on_with_the_force_that_was_applied_which_the_printed_one_reverses`, `a_steady_drive_is_held_by_half_the_difference_of_static_and_dynamic_friction_as_printed`.

    Laws
    ----
    * the spring goes on with the force that was applied which the printed one reverses
    * a steady drive is held by half the difference of static and dynamic friction as printed
    * a dashpot alone keeps no spring

    soot-17, spec/mechanics/friction.rs, rounding error at most 1 ULP
    """

@type_check_only
class _SpringWithFriction(NamedTuple):
    slip: Any
    f_cs: Any
    f_cd: Any
    f: NDArray[np.float64]
    xi_next: NDArray[np.float64]

def spring_with_friction(xi: ArrayLike, xi_dot: ArrayLike, k: ArrayLike | str, eta: ArrayLike | str, mu_s: ArrayLike | str, mu_d: ArrayLike | str, f_n: ArrayLike | str, *, check: bool = True) -> _SpringWithFriction:
    """Section 2.1.3, Eqs. 12 to 17 together, unnumbered: force of a spring with friction, and the spring after the step.

    Parameters
    ----------
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring, incremented
    xi_dot : array (..., 3) [m/s]
        $\\dot{\\boldsymbol{\\xi}}$: rate
    k : float or array [N/m], > 0
        $k$: stiffness
    eta : float or array [kg/s], >= 0
        $\\eta$: damping coefficient
    mu_s : float or array, >= 0
        $\\mu_\\mathrm{s}$: static friction coefficient
    mu_d : float or array, >= 0
        $\\mu_\\mathrm{d}$: dynamic friction coefficient, at most the static one
    f_n : float or array [N], >= 0
        $f_\\mathrm{n}$: normal force of the contact
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    slip : float or array
        $$: one if the spring slips, else zero
    f_cs : float or array [N]
        $f_{\\mathrm{C,s}}$: static friction force
    f_cd : float or array [N]
        $f_{\\mathrm{C,d}}$: dynamic friction force
    f : array (..., 3) [N]
        $\\mathbf{f}$: force on i
    xi_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}'$: spring after the step

    Formula as printed
    ------------------
        (\\mathbf{f}, \\boldsymbol{\\xi}') = \\begin{cases} (\\mathbf{f}_0, \\boldsymbol{\\xi}) & \\lVert \\mathbf{f}_0 \\rVert \\le f_{\\mathrm{C,s}} \\\\
          \\big(f_{\\mathrm{C,d}} \\mathbf{f}_0 / \\lVert \\mathbf{f}_0 \\rVert, \\; \\text{Eq. 17}\\big) & \\text{otherwise} \\end{cases}

    Reading
    -------
    The spring has already been incremented, see [`stretched_spring`](super::rotated_spring::stretched_spring).

    Laws
    ----
    * friction never exceeds its cap
    * friction driven in a closed path delivers no work
    * a steady drive makes a sawtooth between static and dynamic friction

    soot-friction, spec/mechanics/friction.rs, rounding error at most 1 ULP
    """

@type_check_only
class _Neck(NamedTuple):
    force: NDArray[np.float64]
    torque_i: NDArray[np.float64]
    torque_j: NDArray[np.float64]
    xi_t_next: NDArray[np.float64]
    xi_r_next: NDArray[np.float64]
    xi_o_next: Any

def neck(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, k_r: ArrayLike | str, k_o: ArrayLike | str, eta_n: ArrayLike | str, eta_t: ArrayLike | str, eta_r: ArrayLike | str, eta_o: ArrayLike | str, xi_t: ArrayLike, xi_r: ArrayLike, xi_o: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _Neck:
    """Section 2.1.2, Eqs. 3 to 12 together, unnumbered: a neck, from two particles and their springs to forces and springs.

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
    k_n : float or array [N/m], >= 0
        $k_\\mathrm{n}$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_\\mathrm{t}$: tangential stiffness
    k_r : float or array [N/m], >= 0
        $k_\\mathrm{r}$: rolling stiffness
    k_o : float or array [N/m], >= 0
        $k_\\mathrm{o}$: torsional stiffness
    eta_n : float or array [kg/s], >= 0
        $\\eta_\\mathrm{n}$: normal damping
    eta_t : float or array [kg/s], >= 0
        $\\eta_\\mathrm{t}$: tangential damping
    eta_r : float or array [kg/s], >= 0
        $\\eta_\\mathrm{r}$: rolling damping
    eta_o : float or array [kg/s], >= 0
        $\\eta_\\mathrm{o}$: torsional damping
    xi_t : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring before
    xi_r : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring before
    xi_o : float or array [m]
        $\\xi_\\mathrm{o}$: torsion spring before, along the normal
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{f}$: force on i; the force on j is its negative
    torque_i : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_i$: torque on i about its centre
    torque_j : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_j$: torque on j about its centre
    xi_t_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring now
    xi_r_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring now
    xi_o_next : float or array [m]
        $\\xi_\\mathrm{o}$: torsion spring now

    Formula as printed
    ------------------
        (\\mathbf{x}, \\mathbf{v}, \\boldsymbol{\\omega}, r)_{i,j}, \\; (k, \\eta)_{\\mathrm{n,t,r,o}}, \\; \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}, \\; \\Delta t \\mapsto
        \\mathbf{f}, \\boldsymbol{\\tau}_i, \\boldsymbol{\\tau}_j, \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}

    Reading
    -------
    In the order of Section 2.1.1: the springs rotate with the pair and are stretched by their rates, then they act. The neck is relaxed where the surfaces touch, and acts in tension and compression without
    limit. Force on i and springs are in the convention of the paper, with the normal from i to j; seen from j the tangential spring is reversed, the other two are the same.

    Laws
    ----
    * a neck keeps momentum and angular momentum
    * a rigid motion of a necked pair changes no force
    * turning the world turns the forces
    * seen from the other particle the pair is the same
    * dashpots never deliver power
    * a neck has its four springs and dashpots

    soot-neck, spec/soot/def_contact.rs, rounding error at most 40 ULP
    """

@type_check_only
class _FrictionalContact(NamedTuple):
    force: NDArray[np.float64]
    torque_i: NDArray[np.float64]
    torque_j: NDArray[np.float64]
    xi_t_next: NDArray[np.float64]
    xi_r_next: NDArray[np.float64]
    xi_o_next: Any

def frictional_contact(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, k_r: ArrayLike | str, k_o: ArrayLike | str, eta_n: ArrayLike | str, eta_t: ArrayLike | str, eta_r: ArrayLike | str, eta_o: ArrayLike | str, mu_t: ArrayLike | str, mu_r: ArrayLike | str, mu_o: ArrayLike | str, phi: ArrayLike | str, xi_t: ArrayLike, xi_r: ArrayLike, xi_o: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _FrictionalContact:
    """Section 2.1.3, Eqs. 3 to 17 together, unnumbered: a frictional contact, from two particles and their springs to forces and springs.

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
    k_n : float or array [N/m], >= 0
        $k_\\mathrm{n}$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_\\mathrm{t}$: tangential stiffness
    k_r : float or array [N/m], >= 0
        $k_\\mathrm{r}$: rolling stiffness
    k_o : float or array [N/m], >= 0
        $k_\\mathrm{o}$: torsional stiffness
    eta_n : float or array [kg/s], >= 0
        $\\eta_\\mathrm{n}$: normal damping
    eta_t : float or array [kg/s], >= 0
        $\\eta_\\mathrm{t}$: tangential damping
    eta_r : float or array [kg/s], >= 0
        $\\eta_\\mathrm{r}$: rolling damping
    eta_o : float or array [kg/s], >= 0
        $\\eta_\\mathrm{o}$: torsional damping
    mu_t : float or array, >= 0
        $\\mu_\\mathrm{s}$: static friction coefficient of sliding
    mu_r : float or array, >= 0
        $\\mu_\\mathrm{s,r}$: static friction coefficient of rolling
    mu_o : float or array, >= 0
        $\\mu_\\mathrm{s,o}$: static friction coefficient of torsion
    phi : float or array, [0, 1]
        $\\mu_\\mathrm{d} / \\mu_\\mathrm{s}$: ratio of the dynamic to the static coefficients
    xi_t : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring before
    xi_r : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring before
    xi_o : float or array [m]
        $\\xi_\\mathrm{o}$: torsion spring before, along the normal
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{f}$: force on i; the force on j is its negative
    torque_i : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_i$: torque on i about its centre
    torque_j : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_j$: torque on j about its centre
    xi_t_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring now
    xi_r_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring now
    xi_o_next : float or array [m]
        $\\xi_\\mathrm{o}$: torsion spring now

    Formula as printed
    ------------------
        (\\mathbf{x}, \\mathbf{v}, \\boldsymbol{\\omega}, r)_{i,j}, \\; (k, \\eta)_{\\mathrm{n,t,r,o}}, \\; \\mu, \\; \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}, \\; \\Delta t \\mapsto
        \\mathbf{f}, \\boldsymbol{\\tau}_i, \\boldsymbol{\\tau}_j, \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}

    Reading
    -------
    "Only enabled when the normal force is repulsive": along the normal the contact pushes with $\\max(0, -k_\\mathrm{n}\\delta - \\eta_\\mathrm{n}\\dot\\delta)$ and never pulls. The same force caps the
    friction of all three springs, each with its own coefficient, of which the paper names one. As soon as the spheres do not overlap, nothing acts and the springs are reset.

    Laws
    ----
    * without overlap a contact feels and remembers nothing
    * a contact never pulls and rubs no more than its normal force allows
    * with friction without limit a contact is a neck
    * turning the world turns the forces
    * seen from the other particle the pair is the same
    * dashpots never deliver power
    * a contact that sticks has its four springs and dashpots
    * spheres that just touch feel and remember nothing

    soot-contact, spec/soot/def_contact.rs, rounding error at most 4 ULP
    """

@type_check_only
class _PublishedContact(NamedTuple):
    force: NDArray[np.float64]
    torque_i: NDArray[np.float64]
    torque_j: NDArray[np.float64]
    xi_t_next: NDArray[np.float64]
    xi_r_next: NDArray[np.float64]
    xi_o_next: NDArray[np.float64]

def published_contact(x_i: ArrayLike, x_j: ArrayLike, v_i: ArrayLike, v_j: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, k_r: ArrayLike | str, k_o: ArrayLike | str, eta_n: ArrayLike | str, eta_t: ArrayLike | str, eta_r: ArrayLike | str, eta_o: ArrayLike | str, mu_t: ArrayLike | str, mu_r: ArrayLike | str, mu_o: ArrayLike | str, phi: ArrayLike | str, xi_t: ArrayLike, xi_r: ArrayLike, xi_o: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> _PublishedContact:
    """Section 2.1.3, Eqs. 3 to 17 together, unnumbered: a frictional contact as the published program reads its springs.

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
    k_n : float or array [N/m], >= 0
        $k_\\mathrm{n}$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_\\mathrm{t}$: tangential stiffness
    k_r : float or array [N/m], >= 0
        $k_\\mathrm{r}$: rolling stiffness
    k_o : float or array [N/m], >= 0
        $k_\\mathrm{o}$: torsional stiffness
    eta_n : float or array [kg/s], >= 0
        $\\eta_\\mathrm{n}$: normal damping
    eta_t : float or array [kg/s], >= 0
        $\\eta_\\mathrm{t}$: tangential damping
    eta_r : float or array [kg/s], >= 0
        $\\eta_\\mathrm{r}$: rolling damping
    eta_o : float or array [kg/s], >= 0
        $\\eta_\\mathrm{o}$: torsional damping
    mu_t : float or array, >= 0
        $\\mu_\\mathrm{s}$: static friction coefficient of sliding
    mu_r : float or array, >= 0
        $\\mu_\\mathrm{s,r}$: static friction coefficient of rolling
    mu_o : float or array, >= 0
        $\\mu_\\mathrm{s,o}$: static friction coefficient of torsion
    phi : float or array, [0, 1]
        $\\mu_\\mathrm{d} / \\mu_\\mathrm{s}$: ratio of the dynamic to the static coefficients
    xi_t : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring before
    xi_r : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring before
    xi_o : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{o}$: torsion spring before
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{f}$: force on i; the force on j is its negative
    torque_i : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_i$: torque on i about its centre
    torque_j : array (..., 3) [N m]
        $\\boldsymbol{\\tau}_j$: torque on j about its centre
    xi_t_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring now
    xi_r_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring now
    xi_o_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{o}$: torsion spring now

    Formula as printed
    ------------------
        (\\mathbf{x}, \\mathbf{v}, \\boldsymbol{\\omega}, r)_{i,j}, \\; (k, \\eta)_{\\mathrm{n,t,r,o}}, \\; \\mu, \\; \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}, \\; \\Delta t \\mapsto
        \\mathbf{f}, \\boldsymbol{\\tau}_i, \\boldsymbol{\\tau}_j, \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}

    Reading
    -------
    As [`frictional_contact`], but for two steps, in which the program differs: springs act before they are stretched, so that they lag by one step; and the torsion spring is turned into the contact plane, as the text says of
    all three, where it acts like a rolling spring. Each of [`Along`](super::law::Along), [`Printed`](super::law::Printed) and [`Lagging`](super::law::Lagging) keeps one or both steps; what else the program does otherwise is listed at
    [`Programmed`](super::law::Programmed).

    Laws
    ----
    * published springs act before they are stretched
    * a published contact has the springs of the step before
    * a published contact that slips goes on with the friction that it feels

    soot-published-contact, spec/soot/def_contact.rs, rounding error at most 5 ULP
    """

@type_check_only
class _WallContact(NamedTuple):
    force: NDArray[np.float64]
    torque: NDArray[np.float64]
    xi_t_next: NDArray[np.float64]
    xi_r_next: NDArray[np.float64]
    xi_o_next: Any

def wall_contact(n: ArrayLike, delta: ArrayLike | str, v: ArrayLike, omega: ArrayLike, r: ArrayLike | str, k_n: ArrayLike | str, k_t: ArrayLike | str, k_r: ArrayLike | str, k_o: ArrayLike | str, eta_n: ArrayLike | str, eta_t: ArrayLike | str, eta_r: ArrayLike | str, eta_o: ArrayLike | str, mu_t: ArrayLike | str, mu_r: ArrayLike | str, mu_o: ArrayLike | str, phi: ArrayLike | str, xi_t: ArrayLike, xi_r: ArrayLike, xi_o: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _WallContact:
    """Section 3.1, unnumbered: frictional contact of a sphere with a wall of given velocity.

    Parameters
    ----------
    n : array (..., 3), a unit vector
        $-\\mathbf{n}$: normal from the wall to the sphere
    delta : float or array [m]
        $\\delta$: gap, negative for an overlap
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity of the sphere relative to the wall at the contact point
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}$: angular velocity of the sphere
    r : float or array [m], > 0
        $r$: radius
    k_n : float or array [N/m], >= 0
        $k_\\mathrm{n}$: normal stiffness
    k_t : float or array [N/m], >= 0
        $k_\\mathrm{t}$: tangential stiffness
    k_r : float or array [N/m], >= 0
        $k_\\mathrm{r}$: rolling stiffness
    k_o : float or array [N/m], >= 0
        $k_\\mathrm{o}$: torsional stiffness
    eta_n : float or array [kg/s], >= 0
        $\\eta_\\mathrm{n}$: normal damping
    eta_t : float or array [kg/s], >= 0
        $\\eta_\\mathrm{t}$: tangential damping
    eta_r : float or array [kg/s], >= 0
        $\\eta_\\mathrm{r}$: rolling damping
    eta_o : float or array [kg/s], >= 0
        $\\eta_\\mathrm{o}$: torsional damping
    mu_t : float or array, >= 0
        $\\mu_\\mathrm{s}$: static friction coefficient of sliding
    mu_r : float or array, >= 0
        $\\mu_\\mathrm{s,r}$: of rolling
    mu_o : float or array, >= 0
        $\\mu_\\mathrm{s,o}$: of torsion
    phi : float or array, [0, 1]
        $\\mu_\\mathrm{d} / \\mu_\\mathrm{s}$: ratio of the dynamic to the static coefficients
    xi_t : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring before
    xi_r : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring before
    xi_o : float or array [m]
        $\\xi_\\mathrm{o}$: torsion spring before, along the normal
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    force : array (..., 3) [N]
        $\\mathbf{f}$: force on the sphere
    torque : array (..., 3) [N m]
        $\\boldsymbol{\\tau}$: torque on the sphere about its centre
    xi_t_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{t}$: tangential spring now
    xi_r_next : array (..., 3) [m]
        $\\boldsymbol{\\xi}_\\mathrm{r}$: rolling spring now
    xi_o_next : float or array [m]
        $\\xi_\\mathrm{o}$: torsion spring now

    Formula as printed
    ------------------
        \\mathbf{n}, \\delta, \\mathbf{v}, \\boldsymbol{\\omega}, r, \\; (k, \\eta)_{\\mathrm{n,t,r,o}}, \\; \\mu, \\; \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}, \\; \\Delta t \\mapsto
        \\mathbf{f}, \\boldsymbol{\\tau}, \\boldsymbol{\\xi}_{\\mathrm{t,r,o}}

    Reading
    -------
    In the paper substrate and tip exert the forces of a contact and never move under them. Normal and gap come from the geometry: the closest point of the wall. The partner is not
    a sphere of infinite radius in every respect: the contact point is on the wall, so that the arm is $r + \\delta$ and not $r + \\delta/2$, also for rolling. A sphere that rolls on the
    wall is not slowed down by the tangential spring. Springs are in the convention of the paper, with the normal from the sphere to the wall.

    Laws
    ----
    * a sphere that rolls on a wall does not slide
    * gross sliding takes the tangential velocity and gives the spin of the closed form
    * a sliding sphere rolls with five sevenths of its velocity
    * a spinning sphere comes to rest in the time of its torsional friction
    * a rolling sphere slows down as its rolling friction says

    soot-wall, spec/soot/def_wall.rs, rounding error at most 2 ULP
    """

@overload
def hamaker_energy(r_1: float | str, r_2: float | str, delta: float | str, a: float | str, *, check: bool = True) -> float:
    """Eq. 18, Section 2.1.4: energy of two spheres.

    Parameters
    ----------
    r_1 : float or array [m], > 0
        $r_1$: radius of one sphere
    r_2 : float or array [m], > 0
        $r_2$: radius of the other
    delta : float or array [m], > 0
        $\\delta$: gap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u : float or array [J]
        $U$: energy, zero for spheres far apart

    Formula as printed
    ------------------
        U = -\\frac{A}{6} \\left[\\frac{2 r_1 r_2}{(2r_1 + 2r_2 + \\delta) \\delta} + \\frac{2 r_1 r_2}{(2r_1 + \\delta)(2r_2 + \\delta)} +
        \\ln \\frac{(2r_1 + 2r_2 + \\delta) \\delta}{(2r_1 + \\delta)(2r_2 + \\delta)}\\right]

    Reading
    -------
    Cancellation: for spheres a hundred radii apart the printed terms leave five of the sixteen digits of a double, at a thousand radii none. With the two denominators
    $p < q$ and $t = (q - p)/(q + p) = 4 r_1 r_2/(p + q)$ the bracket is $2t/(1 - t^2) - 2 \\operatorname{artanh} t = 4 \\sum_{k \\ge 1} \\frac{k}{2k + 1} t^{2k + 1}$, a sum of positive terms that is
    used below $t = 1/2$; above, the printed form loses a factor of six at most.

    Laws
    ----
    * is the printed energy
    * depends on the shape alone
    * lost digits of the printed form are kept

    soot-18, spec/soot/eq18_hamaker.rs, rounding error at most 2.5 ULP
    """
@overload
def hamaker_energy(r_1: ArrayLike | str, r_2: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def hamaker_force(r_1: float | str, r_2: float | str, delta: float | str, a: float | str, *, check: bool = True) -> float:
    """Section 2.1.4, unnumbered: force between two unequal spheres.

    Parameters
    ----------
    r_1 : float or array [m], > 0
        $r_1$: radius of one sphere
    r_2 : float or array [m], > 0
        $r_2$: radius of the other
    delta : float or array [m], > 0
        $\\delta$: gap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $f$: attraction

    Formula as printed
    ------------------
        f = \\frac{\\mathrm{d}U}{\\mathrm{d}\\delta} = \\frac{32 A \\, r_1^3 r_2^3 \\, (r_1 + r_2 + \\delta)}{3 \\, (2r_1 + 2r_2 + \\delta)^2 \\delta^2 (2r_1 + \\delta)^2 (2r_2 + \\delta)^2}

    Reading
    -------
    The slope of Eq. 18, all terms over one denominator. Positive for attraction, along the normal on i.

    Laws
    ----
    * the force is the slope of the energy
    * attraction falls with the gap

    soot-hamaker-force, spec/soot/eq18_hamaker.rs, rounding error at most 1 ULP
    """
@overload
def hamaker_force(r_1: ArrayLike | str, r_2: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def equal_hamaker_energy(r: float | str, delta: float | str, a: float | str, *, check: bool = True) -> float:
    """Eq. 19, Section 2.1.4: energy of two equal spheres.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius of both spheres
    delta : float or array [m], > 0
        $\\delta$: gap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u : float or array [J]
        $U$: energy, zero for spheres far apart

    Formula as printed
    ------------------
        U = -\\frac{A}{6} \\left[\\frac{2 r^2}{(4r + \\delta) \\delta} + \\frac{2 r^2}{(2r + \\delta)^2} + \\ln \\frac{(4r + \\delta) \\delta}{(2r + \\delta)^2}\\right]

    Reading
    -------
    Eq. 18 for $r_1 = r_2$, and evaluated as such.

    Laws
    ----
    * equal spheres are a case of unequal ones
    * near spheres attract as the inverse gap and far ones as its sixth power

    soot-19, spec/soot/eq19_equal_hamaker.rs, rounding error at most 2.5 ULP
    """
@overload
def equal_hamaker_energy(r: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def equal_hamaker_force(r: float | str, delta: float | str, a: float | str, *, check: bool = True) -> float:
    """Eq. 20, Section 2.1.4: force between two equal spheres.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius of both spheres
    delta : float or array [m], > 0
        $\\delta$: gap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $\\mathbf{f} \\cdot \\mathbf{n}$: attraction

    Formula as printed
    ------------------
        \\mathbf{f} = -\\frac{A}{6} \\left[\\frac{4r + 2\\delta}{(4r + \\delta) \\delta} - \\frac{2}{2r + \\delta} - \\frac{4 r^2}{(2r + \\delta)^3}
        - \\frac{2 r^2 (4r + 2\\delta)}{(4r + \\delta)^2 \\delta^2}\\right] \\mathbf{n}

    Reading
    -------
    Cancellation: the printed form has no correct digit at a thousand radii. Over one denominator it is
    $\\frac{32 A r^6}{3 \\delta^2 (4r + \\delta)^2 (2r + \\delta)^3}$, which does not cancel. It is the coefficient of the normal: positive, so that i is attracted by j.

    Laws
    ----
    * is the printed force
    * near spheres attract as the inverse gap and far ones as its sixth power

    soot-20, spec/soot/eq19_equal_hamaker.rs, rounding error at most 1 ULP
    """
@overload
def equal_hamaker_force(r: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _SaturatedHamaker(NamedTuple):
    f: Any
    u: Any

def saturated_hamaker(r_1: ArrayLike | str, r_2: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, delta_0: ArrayLike | str, *, check: bool = True) -> _SaturatedHamaker:
    """Section 2.1.4, unnumbered: force and energy with the saturation distance.

    Parameters
    ----------
    r_1 : float or array [m], > 0
        $r_1$: radius of one sphere
    r_2 : float or array [m], > 0
        $r_2$: radius of the other
    delta : float or array [m]
        $\\delta$: gap, negative for an overlap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    delta_0 : float or array [m], > 0
        $\\delta_0$: saturation distance
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $f$: attraction
    u : float or array [J]
        $U$: energy

    Formula as printed
    ------------------
        f(\\delta) = f(\\max(\\delta, \\delta_0)), \\quad U(\\delta) = U(\\max(\\delta, \\delta_0)) - f \\cdot (\\max(\\delta, \\delta_0) - \\delta)

    Reading
    -------
    The text gives a saturation distance $\\delta_0$ from 0.4 to 1 nm, but no formula. Below it the force keeps its value at $\\delta_0$, also for overlapping spheres, and the
    potential continues as a straight line: both are continuous.

    Laws
    ----
    * a saturated force is the slope of its energy
    * force and energy are continuous at saturation

    soot-20-sat, spec/soot/eq19_equal_hamaker.rs, rounding error at most 2 ULP
    """

@overload
def plane_energy(r: float | str, delta: float | str, a: float | str, *, check: bool = True) -> float:
    """Eq. 21, Section 2.1.4: energy of a sphere in front of a plane.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    delta : float or array [m], > 0
        $\\delta$: gap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u : float or array [J]
        $U$: energy, zero for a sphere far away

    Formula as printed
    ------------------
        U = -\\frac{A}{6} \\left[\\frac{r}{\\delta} + \\frac{r}{2r + \\delta} + \\ln \\frac{\\delta}{2r + \\delta}\\right]

    Reading
    -------
    The limit of Eq. 18, and like it evaluated by the series in $t = r/(r + \\delta)$ if the sphere is far from the plane.

    Laws
    ----
    * a plane is the limit of a large sphere
    * is the printed energy of a plane

    soot-21, spec/soot/eq21_hamaker_plane.rs, rounding error at most 2 ULP
    """
@overload
def plane_energy(r: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def plane_force(r: float | str, delta: float | str, a: float | str, *, check: bool = True) -> float:
    """Eq. 22, Section 2.1.4: force on a sphere in front of a plane.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    delta : float or array [m], > 0
        $\\delta$: gap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $\\mathbf{f} \\cdot \\mathbf{n}$: attraction

    Formula as printed
    ------------------
        \\mathbf{f} = \\frac{2A}{3} \\left[\\frac{r^3}{\\delta^2 (\\delta + 2r)^2}\\right] \\mathbf{n}

    Reading
    -------
    The coefficient of the normal, which points from the sphere to the plane: attraction.

    Laws
    ----
    * the force of a plane is the slope of its energy
    * a plane attracts twice as much as an equal sphere at contact

    soot-22, spec/soot/eq21_hamaker_plane.rs, rounding error at most 1 ULP
    """
@overload
def plane_force(r: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _SaturatedPlane(NamedTuple):
    f: Any
    u: Any

def saturated_plane(r: ArrayLike | str, delta: ArrayLike | str, a: ArrayLike | str, delta_0: ArrayLike | str, *, check: bool = True) -> _SaturatedPlane:
    """Section 2.1.4, unnumbered: force and energy in front of a plane with the saturation distance.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    delta : float or array [m]
        $\\delta$: gap, negative for an overlap
    a : float or array [J], >= 0
        $A$: Hamaker constant
    delta_0 : float or array [m], > 0
        $\\delta_0$: saturation distance
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $f$: attraction
    u : float or array [J]
        $U$: energy

    Formula as printed
    ------------------
        f(\\delta) = f(\\max(\\delta, \\delta_0)), \\quad U(\\delta) = U(\\max(\\delta, \\delta_0)) - f \\cdot (\\max(\\delta, \\delta_0) - \\delta)

    Reading
    -------
    As between spheres, see [`saturated_hamaker`](super::eq19_equal_hamaker::saturated_hamaker).

    Laws
    ----
    * saturated in front of a plane the force is the slope of its energy

    soot-22-sat, spec/soot/eq21_hamaker_plane.rs, rounding error at most 2 ULP
    """

def facet_share(d: ArrayLike, d_0: ArrayLike, *, check: bool = True) -> Any:
    """Section 3.1, unnumbered: share of a facet in the attraction beside a nearer facet.

    Parameters
    ----------
    d : array (..., 3) [m]
        $\\mathbf{d}$: from the place on the facet to the centre
    d_0 : array (..., 3) [m]
        $\\mathbf{d}_0$: from a nearer place to the centre
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    s : float or array
        $s$: share

    Formula as printed
    ------------------
        s = 1 - \\min\\left(1, \\max\\left(0, \\frac{\\mathbf{d} \\cdot \\mathbf{d}_0}{d_0^2}\\right)\\right)

    Reading
    -------
    The paper has the force of a plane (Eq. 22) and a tip of three facets, and does not say how facets act together. Here the distance of the centre from the surface decides: every place where this
    distance has a minimum attracts like a half-space. A convex body and a flat wall have one minimum, however finely they are triangulated; a groove has one on either side, and the sphere stays in its middle.
    The share makes the energy $\\sum s U$ a continuous function of the position: where a minimum leaves its facet across the bottom of a groove, the vector $\\mathbf{d}$ from there to the centre ends in the plane through the
    nearer place $\\mathbf{d}_0$ and normal to it, so that $\\mathbf{d} \\cdot \\mathbf{d}_0 = d_0^2$ and the share vanishes. At right or acute angles both sides attract in full; a groove that is nearly flat attracts like a plane.
    Beside several nearer places the smallest share counts.

    Laws
    ----
    * walls at right or acute angles attract in full
    * the share vanishes where the place reaches the bottom of a groove
    * a groove attracts alike when its sides are exchanged
    * the share changes only between all and nothing

    soot-facet-share, spec/soot/def_facets.rs, rounding error at most 1 ULP
    """

def facet_share_slope(d: ArrayLike, d_0: ArrayLike, q_d_0: ArrayLike, q_0_d: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Section 3.1, unnumbered: gradient of the share of a facet.

    Parameters
    ----------
    d : array (..., 3) [m]
        $\\mathbf{d}$: from the place on the facet to the centre
    d_0 : array (..., 3) [m]
        $\\mathbf{d}_0$: from a nearer place to the centre
    q_d_0 : array (..., 3) [m]
        $\\mathbf{Q} \\mathbf{d}_0$: change of `d` when the centre is displaced by `d_0`
    q_0_d : array (..., 3) [m]
        $\\mathbf{Q}_0 \\mathbf{d}$: change of `d_0` when the centre is displaced by `d`
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    slope : array (..., 3) [1/m]
        $\\nabla s$: gradient

    Formula as printed
    ------------------
        \\nabla s = \\frac{2 (\\mathbf{d} \\cdot \\mathbf{d}_0)\\, \\mathbf{d}_0}{d_0^4} - \\frac{\\mathbf{Q} \\mathbf{d}_0 + \\mathbf{Q}_0 \\mathbf{d}}{d_0^2} \\quad (0 < s < 1)

    Reading
    -------
    $\\mathbf{Q} = \\partial \\mathbf{d} / \\partial \\mathbf{x}$ is symmetric: $\\mathbf{n}\\mathbf{n}^\\mathsf{T}$ on a face, $\\mathbf{1} - \\mathbf{t}\\mathbf{t}^\\mathsf{T}$ on an edge, $\\mathbf{1}$ at a corner. The force that follows from the energy $s U$ is
    $-s \\nabla U - U \\nabla s$.

    Laws
    ----
    * the slope is the gradient of the share

    soot-facet-share-slope, spec/soot/def_facets.rs, rounding error at most 1 ULP
    """

@overload
def capillary_force(psi: float | str, kappa: float | str, d: float | str, d_cutoff: float | str, *, check: bool = True) -> float:
    """Eq. 23, Section 2.1.5: capillary force between two spheres.

    Parameters
    ----------
    psi : float or array [N], >= 0
        $\\psi$: largest force
    kappa : float or array [1/m], > 0
        $\\kappa$: sharpness of the drop
    d : float or array [m], >= 0
        $d$: distance of the centres
    d_cutoff : float or array [m], > 0
        $d_{\\mathrm{cutoff}}$: distance at which half the force is left
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $f$: attraction

    Formula as printed
    ------------------
        \\mathbf{f} = \\frac{1}{2} \\psi \\left[1 - \\tanh\\left(\\kappa \\left(\\lVert \\mathbf{x}_j - \\mathbf{x}_i \\rVert - d_{\\mathrm{cutoff}}\\right)\\right)\\right]

    Reading
    -------
    The formula has no direction; the force is attractive, along the normal on i. At $d_{\\mathrm{cutoff}}$ it has not dropped to zero, as the text says, but to
    one half. The distance is measured between centres regardless of the radii, so for spheres larger than in the paper, where they touch at 28 nm, the force at contact is smaller. Evaluated as $\\psi / (1 + e^{2\\kappa(d - d_{\\mathrm{cutoff}})})$, which does not cancel at large distances and needs the exponential of a negative number only.

    Laws
    ----
    * is the printed sigmoid
    * half the force is left at the cutoff distance
    * no distance is too large or too small

    soot-23, spec/soot/eq23_capillary.rs, rounding error at most 1 ULP
    """
@overload
def capillary_force(psi: ArrayLike | str, kappa: ArrayLike | str, d: ArrayLike | str, d_cutoff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def capillary_energy(psi: float | str, kappa: float | str, d: float | str, d_cutoff: float | str, *, check: bool = True) -> float:
    """Section 2.1.5, unnumbered: potential of the capillary force, zero for spheres far apart.

    Parameters
    ----------
    psi : float or array [N], >= 0
        $\\psi$: largest force
    kappa : float or array [1/m], > 0
        $\\kappa$: sharpness of the drop
    d : float or array [m], >= 0
        $d$: distance of the centres
    d_cutoff : float or array [m], > 0
        $d_{\\mathrm{cutoff}}$: distance at which half the force is left
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    u : float or array [J]
        $U$: energy

    Formula as printed
    ------------------
        U = -\\frac{\\psi}{2\\kappa} \\ln\\left(1 + e^{-2\\kappa(d - d_{\\mathrm{cutoff}})}\\right)

    Reading
    -------
    The integral of Eq. 23. Evaluated as $\\max(-x, 0) + \\ln(1 + e^{-|x|})$ with $x = 2\\kappa(d - d_{\\mathrm{cutoff}})$.

    Laws
    ----
    * the capillary force is the slope of its potential
    * no distance is too large or too small

    soot-23-energy, spec/soot/eq23_capillary.rs, rounding error at most 1 ULP
    """
@overload
def capillary_energy(psi: ArrayLike | str, kappa: ArrayLike | str, d: ArrayLike | str, d_cutoff: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _Attraction(NamedTuple):
    f: Any
    u_vdw: Any
    u_cap: Any

def attraction(d: ArrayLike | str, r_i: ArrayLike | str, r_j: ArrayLike | str, a: ArrayLike | str, delta_0: ArrayLike | str, psi: ArrayLike | str, kappa: ArrayLike | str, d_cutoff: ArrayLike | str, cutoff: ArrayLike | str, *, check: bool = True) -> _Attraction:
    """Sections 2.1.4 and 2.1.5, unnumbered: attraction of two spheres up to a cutoff, and its two energies.

    Parameters
    ----------
    d : float or array [m], > 0
        $d$: distance of the centres
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    a : float or array [J], >= 0
        $A$: Hamaker constant
    delta_0 : float or array [m], > 0
        $\\delta_0$: saturation distance
    psi : float or array [N], >= 0
        $\\psi$: largest capillary force
    kappa : float or array [1/m], > 0
        $\\kappa$: sharpness of its drop
    d_cutoff : float or array [m], > 0
        $d_{\\mathrm{cutoff}}$: distance at which half of it is left
    cutoff : float or array [m], > 0
        $d_\\mathrm{max}$: distance beyond which nothing acts
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $f$: attraction
    u_vdw : float or array [J]
        $U_{\\mathrm{vdW}}$: van der Waals energy
    u_cap : float or array [J]
        $U_{\\mathrm{cap}}$: capillary energy

    Formula as printed
    ------------------
        f = \\begin{cases} f_{\\mathrm{vdW}} + f_{\\mathrm{cap}} & d \\le d_\\mathrm{max} \\\\ 0 & \\text{otherwise} \\end{cases}, \\quad
        U = \\begin{cases} U(d) - U(d_\\mathrm{max}) & d \\le d_\\mathrm{max} \\\\ 0 & \\text{otherwise} \\end{cases}

    Reading
    -------
    The paper has no cutoff other than that of its neighbour list, 42 nm or 70 nm between centres. Here the cutoff is a distance that does not depend on the rebuilds of the list.
    The force is not shifted and drops to zero at the cutoff; the energies are shifted so that they end at zero. For two spheres of 14 nm the van der Waals force left out is at
    most 1.1e-13 N (0.1 %) beyond 42 nm and 1.4e-15 N (14 parts in a million) beyond 70 nm, the capillary force of $\\kappa d_{\\mathrm{cutoff}} = 10$ at most 0.7 % beyond 70 nm.

    If the cutoff is within saturation the van der Waals energy is $f \\, (d - d_\\mathrm{max})$. With $h = \\kappa (d_\\mathrm{max} - d)$ and $m = \\kappa (d + d_\\mathrm{max} - 2 d_{\\mathrm{cutoff}})$ the
    capillary energy is $-\\frac{\\psi}{\\kappa} \\operatorname{artanh} \\frac{\\tanh h}{1 + e^m / \\cosh h}$, which is evaluated below $h = 1/32$: a difference of nearly equal energies would lose digits.

    Laws
    ----
    * up to the cutoff the force is the slope of the energies
    * the energies end at zero and the force with the stated error
    * the energies keep their digits up to the cutoff

    soot-attraction, spec/soot/def_body_forces.rs, rounding error at most 8 ULP
    """

@overload
def fractal_number(k_f: float | str, r_g: float | str, r: float | str, d_f: float | str, *, check: bool = True) -> float:
    """Eq. 24, Section 2.1.6: number of primary particles of an aggregate.

    Parameters
    ----------
    k_f : float or array, > 0
        $k_\\mathrm{f}$: prefactor
    r_g : float or array [m], > 0
        $R_\\mathrm{g}$: radius of gyration
    r : float or array [m], > 0
        $r$: radius of the primary particles
    d_f : float or array, > 0
        $D_\\mathrm{f}$: fractal dimension
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    n : float or array
        $N$: number of primary particles

    Formula as printed
    ------------------
        N = k_\\mathrm{f} \\left(\\frac{R_\\mathrm{g}}{r}\\right)^{D_\\mathrm{f}}

    Reading
    -------
    The radius of gyration is the root mean square distance of the centres from their centroid, without the size of the particles. For unequal particles
    both are weighted by mass, and $r$ is the geometric mean of the radii: the median of a log-normal distribution.

    Laws
    ----
    * the fractal dimension is the slope in logarithms

    soot-24, spec/soot/eq24_fractal.rs, rounding error at most 1 ULP
    """
@overload
def fractal_number(k_f: ArrayLike | str, r_g: ArrayLike | str, r: ArrayLike | str, d_f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def gyration_radius(k_f: float | str, n: float | str, r: float | str, d_f: float | str, *, check: bool = True) -> float:
    """Section 2.1.6, unnumbered: radius of gyration of an aggregate with a given number of particles.

    Parameters
    ----------
    k_f : float or array, > 0
        $k_\\mathrm{f}$: prefactor
    n : float or array, > 0
        $N$: number of primary particles
    r : float or array [m], > 0
        $r$: radius of the primary particles
    d_f : float or array, > 0
        $D_\\mathrm{f}$: fractal dimension
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    r_g : float or array [m]
        $R_\\mathrm{g}$: radius of gyration

    Formula as printed
    ------------------
        R_\\mathrm{g} = r \\left(\\frac{N}{k_\\mathrm{f}}\\right)^{1 / D_\\mathrm{f}}

    Reading
    -------
    Eq. 24 solved for the radius of gyration.

    Laws
    ----
    * number and radius of gyration are inverse
    * the aggregates of the paper have a radius of gyration of 188 nm

    soot-24-inv, spec/soot/eq24_fractal.rs, rounding error at most 1 ULP
    """
@overload
def gyration_radius(k_f: ArrayLike | str, n: ArrayLike | str, r: ArrayLike | str, d_f: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tip_velocity(t: float | str, v_tip: float | str, rate: float | str, t_reversal: float | str, *, check: bool = True) -> float:
    """Eq. 25, Section 3.1.2: velocity of the tip.

    Parameters
    ----------
    t : float or array [s]
        $t$: time
    v_tip : float or array [m/s], > 0
        $v$: final velocity, 1.5 m/s
    rate : float or array [1/s], > 0
        $\\lambda$: rate of the turn, $10^8$ 1/s
    t_reversal : float or array [s], >= 0
        $t_\\mathrm{r}$: time of the turn, $1.08 \\cdot 10^{-8}$ s
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v : float or array [m/s]
        $\\dot{z}_{\\mathrm{tip}}$: velocity, negative downwards

    Formula as printed
    ------------------
        \\dot{z}_{\\mathrm{tip}} = 1.5 \\tanh\\left[10^8 (t - 1.08 \\cdot 10^{-8})\\right]

    Reading
    -------
    Erratum: the prose around the equation says something else, a constant 1.5 m/s and a reversal after 10 ns. The equation is followed: the tip starts with 1.19 m/s, never approaches with
    a constant velocity, and reverses at 10.8 ns. Its numbers have units: 1.5 m/s, $10^8$ 1/s, $1.08 \\cdot 10^{-8}$ s.

    Effect: the tip goes 7.44 nm deep, 0.44 nm into a sphere half a radius below it. By the prose it would go 15 nm deep.

    Proof: `the_tip_comes_slowly_turns_and_leaves`, `the_tip_of_the_paper_goes_7_44_nm_deep`.

    Laws
    ----
    * the tip comes slowly turns and leaves

    soot-25, spec/mechanics/approach.rs, rounding error at most 1 ULP
    """
@overload
def tip_velocity(t: ArrayLike | str, v_tip: ArrayLike | str, rate: ArrayLike | str, t_reversal: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def tip_way(t: float | str, v_tip: float | str, rate: float | str, t_reversal: float | str, *, check: bool = True) -> float:
    """Section 3.1.2, unnumbered: displacement of the tip since the start.

    Parameters
    ----------
    t : float or array [s]
        $t$: time
    v_tip : float or array [m/s], > 0
        $v$: final velocity, 1.5 m/s
    rate : float or array [1/s], > 0
        $\\lambda$: rate of the turn, $10^8$ 1/s
    t_reversal : float or array [s], >= 0
        $t_\\mathrm{r}$: time of the turn, $1.08 \\cdot 10^{-8}$ s
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    z : float or array [m]
        $z$: displacement, negative downwards

    Formula as printed
    ------------------
        z = \\frac{v}{\\lambda} \\ln \\frac{\\cosh \\lambda (t - t_\\mathrm{r})}{\\cosh \\lambda t_\\mathrm{r}}

    Reading
    -------
    The integral of Eq. 25. With $p = \\lambda |t|$ and $q = \\lambda |t - 2 t_\\mathrm{r}|$ the logarithm is, up to its sign,
    $\\ln \\frac{1 + e^{-p - q}}{e^{-p} + e^{-q}} = \\min(p, q) + \\ln(1 + e^{-p - q}) - \\ln(1 + e^{-|p - q|})$, in which nothing overflows. For a displacement that is short compared with
    $v/\\lambda$ these terms cancel: where the smaller of $p$ and $q$ is below one, it is evaluated as $2 \\operatorname{artanh} |h| = \\ln(1 + 2|h|/(1 - |h|))$ with
    $h = \\tanh \\frac{\\lambda t}{2} \\tanh \\lambda \\big(\\frac{t}{2} - t_\\mathrm{r}\\big)$, which has the sign of the displacement.

    Laws
    ----
    * the velocity is the rate of the way
    * the tip of the paper goes 7 44 nm deep
    * is the printed way
    * a short way keeps the digits that the difference of two logarithms loses
    * the way keeps its digits where the tip is back

    soot-25-way, spec/mechanics/approach.rs, rounding error at most 1.5 ULP
    """
@overload
def tip_way(t: ArrayLike | str, v_tip: ArrayLike | str, rate: ArrayLike | str, t_reversal: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def coordination_number(sum: float | str, n: float | str, *, check: bool = True) -> float:
    """Eq. 26, Section 3.2: mean coordination number of an aggregate.

    Parameters
    ----------
    sum : float or array, >= 0
        $\\sum N_{\\mathrm{nb},i}$: sum of the numbers of neighbours
    n : float or array, > 0
        $N$: number of primary particles
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    c : float or array
        $c$: mean coordination number

    Formula as printed
    ------------------
        c = \\frac{1}{N} \\sum_{i=1}^{N} N_{\\mathrm{nb},i}

    Reading
    -------
    Every pair of neighbours is counted twice in the sum. The sum is the argument here.

    Laws
    ----
    * a chain has a coordination number just below two

    soot-26, spec/soot/eq26_coordination.rs, rounding error at most 0.5 ULP
    """
@overload
def coordination_number(sum: ArrayLike | str, n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def are_neighbours(x_i: ArrayLike, x_j: ArrayLike, r_i: ArrayLike | str, r_j: ArrayLike | str, threshold: ArrayLike | str, *, check: bool = True) -> Any:
    """Section 3.2, unnumbered: whether two primary particles are neighbours.

    Parameters
    ----------
    x_i : array (..., 3) [m]
        $\\mathbf{x}_i$: position of i
    x_j : array (..., 3) [m]
        $\\mathbf{x}_j$: position of j, another one
    r_i : float or array [m], > 0
        $r_i$: radius of i
    r_j : float or array [m], > 0
        $r_j$: radius of j
    threshold : float or array, > 0
        $$: largest gap as a fraction of the diameter, 0.01
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    neighbours : float or array
        $$: one if they are neighbours, else zero

    Formula as printed
    ------------------
        \\delta < 0.01 \\cdot 2r

    Reading
    -------
    The surfaces are less than one hundredth of a diameter apart; an overlap counts. For unequal spheres $2r$ is $r_i + r_j$.

    Laws
    ----
    * neighbours are less than a hundredth of a diameter apart
    * a gap of just the threshold is too far

    soot-neighbours, spec/soot/eq26_coordination.rs, rounding error at most 0 ULP
    """

@overload
def edge_curvature(length: float | str, theta: float | str, *, check: bool = True) -> float:
    """Section 3.2, unnumbered: contribution of an edge to the mean curvature of a polyhedron.

    Parameters
    ----------
    length : float or array [m], >= 0
        $\\ell$: length of the edge
    theta : float or array [rad], >= 0
        $\\theta$: exterior angle
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    m_0 : float or array [m]
        $M_0$: contribution to the mean curvature

    Formula as printed
    ------------------
        \\frac{1}{2} \\ell \\theta

    Reading
    -------
    $\\theta$ is the angle between the outward normals of the two faces that meet at the edge. A polygon has two faces, back to back, and a segment is an edge with an angle of $2\\pi$.

    Laws
    ----
    * a chain of spheres has the hull of a capsule

    soot-edge-curvature, spec/mechanics/convex_hull.rs, rounding error at most 0.5 ULP
    """
@overload
def edge_curvature(length: ArrayLike | str, theta: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def hull_volume(v_0: float | str, s_0: float | str, m_0: float | str, r: float | str, *, check: bool = True) -> float:
    """Section 3.2, unnumbered: volume of the convex hull of equal spheres, by Steiner's formula.

    Parameters
    ----------
    v_0 : float or array [m^3], >= 0
        $V_0$: volume of the hull of the centres
    s_0 : float or array [m^2], >= 0
        $S_0$: its surface
    m_0 : float or array [m], >= 0
        $M_0$: its mean curvature, summed over its edges
    r : float or array [m], > 0
        $r$: radius of the spheres
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_hull : float or array [m^3]
        $V$: volume of the hull of the spheres

    Formula as printed
    ------------------
        V = V_0 + S_0 r + M_0 r^2 + \\frac{4}{3} \\pi r^3

    Reading
    -------
    The paper takes the hull "constructed around the aggregate" without further definition. It is read as the hull of the spheres: the hull of their centres, a polyhedron, expanded by the
    radius on all sides.

    Laws
    ----
    * a chain of spheres has the hull of a capsule
    * a cube of spheres has the hull of a rounded cube

    soot-hull, spec/mechanics/convex_hull.rs, rounding error at most 1 ULP
    """
@overload
def hull_volume(v_0: ArrayLike | str, s_0: ArrayLike | str, m_0: ArrayLike | str, r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def convexity(v_spheres: float | str, v_hull: float | str, *, check: bool = True) -> float:
    """Section 3.2, unnumbered: convexity of an aggregate.

    Parameters
    ----------
    v_spheres : float or array [m^3], > 0
        $V_{\\mathrm{aggregate}}$: volume of the spheres
    v_hull : float or array [m^3], > 0
        $V_{\\mathrm{hull}}$: volume of their convex hull
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    convexity : float or array
        $$: convexity

    Formula as printed
    ------------------
        \\frac{V_{\\mathrm{aggregate}}}{V_{\\mathrm{hull}}}

    Reading
    -------
    The volume of the aggregate is the sum of the volumes of its spheres: overlaps are small.

    Laws
    ----
    * a sphere is convex and a dimer four fifths

    soot-convexity, spec/soot/def_convexity.rs, rounding error at most 0.5 ULP
    """
@overload
def convexity(v_spheres: ArrayLike | str, v_hull: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def cantilever_force(m_c: float | str, eta_c: float | str, k_c: float | str, u: float | str, u_dot: float | str, u_ddot: float | str, *, check: bool = True) -> float:
    """Eq. 27, Appendix: force that deflects the cantilever.

    Parameters
    ----------
    m_c : float or array [kg], > 0
        $m_\\mathrm{c}$: mass
    eta_c : float or array [kg/s], >= 0
        $\\eta_\\mathrm{c}$: damping coefficient
    k_c : float or array [N/m], > 0
        $k_\\mathrm{c}$: stiffness
    u : float or array [m]
        $u$: deflection
    u_dot : float or array [m/s]
        $\\dot{u}$: its rate
    u_ddot : float or array [m/s^2]
        $\\ddot{u}$: its acceleration
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $f$: force on the tip

    Formula as printed
    ------------------
        m_\\mathrm{c} \\ddot{u} + \\eta_\\mathrm{c} \\dot{u} + k_\\mathrm{c} u = f(t)

    Reading
    -------
    Read from left to right: the force that corresponds to a motion.

    Laws
    ----
    * the reading obeys the equation of the deflection

    soot-27, spec/soot/eq27_cantilever.rs, rounding error at most 1 ULP
    """
@overload
def cantilever_force(m_c: ArrayLike | str, eta_c: ArrayLike | str, k_c: ArrayLike | str, u: ArrayLike | str, u_dot: ArrayLike | str, u_ddot: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def force_of_reading(m_c: float | str, eta_c: float | str, k_c: float | str, g: float | str, g_dot: float | str, g_ddot: float | str, *, check: bool = True) -> float:
    """Eq. 28, Appendix: force that corresponds to a reading of the cantilever.

    Parameters
    ----------
    m_c : float or array [kg], > 0
        $m_\\mathrm{c}$: mass
    eta_c : float or array [kg/s], >= 0
        $\\eta_\\mathrm{c}$: damping coefficient
    k_c : float or array [N/m], > 0
        $k_\\mathrm{c}$: stiffness
    g : float or array [N]
        $g$: reading
    g_dot : float or array [N/s]
        $\\dot{g}$: its rate
    g_ddot : float or array [N/s^2]
        $\\ddot{g}$: its second derivative
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    f : float or array [N]
        $f$: force on the tip

    Formula as printed
    ------------------
        \\frac{m_\\mathrm{c}}{k_\\mathrm{c}} \\ddot{g} + \\frac{\\eta_\\mathrm{c}}{k_\\mathrm{c}} \\dot{g} + g(t) = f(t)

    Reading
    -------
    Eq. 27 for the force derived from the deflection, $g = k_\\mathrm{c} u$.

    Laws
    ----
    * the reading obeys the equation of the deflection

    soot-28, spec/soot/eq27_cantilever.rs, rounding error at most 1 ULP
    """
@overload
def force_of_reading(m_c: ArrayLike | str, eta_c: ArrayLike | str, k_c: ArrayLike | str, g: ArrayLike | str, g_dot: ArrayLike | str, g_ddot: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def cantilever_damping(m_c: float | str, k_c: float | str, *, check: bool = True) -> float:
    """Eq. 29, Appendix: damping coefficient of the cantilever.

    Parameters
    ----------
    m_c : float or array [kg], > 0
        $m_\\mathrm{c}$: mass
    k_c : float or array [N/m], > 0
        $k_\\mathrm{c}$: stiffness
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    eta_c : float or array [kg/s]
        $\\eta_\\mathrm{c}$: damping coefficient

    Formula as printed
    ------------------
        \\eta_\\mathrm{c} = 2 \\sqrt{m_\\mathrm{c} k_\\mathrm{c}}

    Reading
    -------
    Critical damping, as printed.

    Laws
    ----
    * a critically damped cantilever obeys the transfer function

    soot-29, spec/soot/eq27_cantilever.rs, rounding error at most 1 ULP
    """
@overload
def cantilever_damping(m_c: ArrayLike | str, k_c: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def natural_frequency(k_c: float | str, m_c: float | str, *, check: bool = True) -> float:
    """Eq. 31, Appendix: natural frequency of the cantilever.

    Parameters
    ----------
    k_c : float or array [N/m], > 0
        $k_\\mathrm{c}$: stiffness
    m_c : float or array [kg], > 0
        $m_\\mathrm{c}$: mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    omega_0 : float or array [rad/s]
        $\\omega_0$: natural frequency

    Formula as printed
    ------------------
        \\omega_0 = \\sqrt{\\frac{k_\\mathrm{c}}{m_\\mathrm{c}}}

    Reading
    -------
    An angular frequency, as printed. The paper states neither it nor the mass.

    Laws
    ----
    * a critically damped cantilever obeys the transfer function

    soot-31, spec/soot/eq27_cantilever.rs, rounding error at most 1 ULP
    """
@overload
def natural_frequency(k_c: ArrayLike | str, m_c: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _TransferFunction(NamedTuple):
    h_re: Any
    h_im: Any
    gain: Any

def transfer_function(omega_0: ArrayLike | str, s_re: ArrayLike | str, s_im: ArrayLike | str, *, check: bool = True) -> _TransferFunction:
    """Eq. 30, Appendix: transfer function from the force to the reading, for a complex frequency.

    Parameters
    ----------
    omega_0 : float or array [rad/s], > 0
        $\\omega_0$: natural frequency
    s_re : float or array [1/s], >= 0
        $\\operatorname{Re} s$: rate of growth
    s_im : float or array [1/s]
        $\\operatorname{Im} s$: frequency
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    h_re : float or array
        $\\operatorname{Re} G/F$: in phase
    h_im : float or array
        $\\operatorname{Im} G/F$: out of phase
    gain : float or array
        $\\lvert G/F \\rvert$: magnitude

    Formula as printed
    ------------------
        \\frac{G(s)}{F(s)} = \\frac{\\omega_0^2}{(\\omega_0 + s)^2}

    Reading
    -------
    For a cantilever that starts at rest, without deflection. With $\\omega_0 / (\\omega_0 + s) = x + i y$ the parts are $(x - y)(x + y)$ and $2xy$.

    Laws
    ----
    * half of a wave of the natural frequency passes and lags by a right angle
    * a constant force is read as it is

    soot-30, spec/soot/eq30_transfer.rs, rounding error at most 4 ULP
    """

@overload
def preserved(omega_0: float | str, s: float | str, *, check: bool = True) -> float:
    """Eq. 32, Appendix: transfer function of a stiff cantilever.

    Parameters
    ----------
    omega_0 : float or array [rad/s], > 0
        $\\omega_0$: natural frequency
    s : float or array [1/s], >= 0
        $s$: frequency
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    h : float or array
        $G/F$: transmitted fraction

    Formula as printed
    ------------------
        \\lim_{\\omega_0 \\to \\infty} \\frac{\\omega_0^2}{(s + \\omega_0)^2} = 1

    Reading
    -------
    The expression under the limit, Eq. 30 for a real frequency.

    Laws
    ----
    * a stiff cantilever preserves the input

    soot-32, spec/soot/eq30_transfer.rs, rounding error at most 2 ULP
    """
@overload
def preserved(omega_0: ArrayLike | str, s: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def attenuated(omega_0: float | str, s: float | str, *, check: bool = True) -> float:
    """Eq. 33, Appendix: transfer function of a soft cantilever.

    Parameters
    ----------
    omega_0 : float or array [rad/s], > 0
        $\\omega_0$: natural frequency
    s : float or array [1/s], > 0
        $s$: frequency
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    h : float or array
        $G/F$: transmitted fraction

    Formula as printed
    ------------------
        \\lim_{\\omega_0 \\to 0} \\frac{\\omega_0^2}{(s + \\omega_0)^2} = 0

    Reading
    -------
    The expression under the limit. It holds for $s \\ne 0$ only: a constant force is always read without error.

    Laws
    ----
    * a soft cantilever attenuates the input

    soot-33, spec/soot/eq30_transfer.rs, rounding error at most 2 ULP
    """
@overload
def attenuated(omega_0: ArrayLike | str, s: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _TimeResponse(NamedTuple):
    impulse: Any
    step: Any
    ramp: Any

def time_response(omega_0: ArrayLike | str, t: ArrayLike | str, *, check: bool = True) -> _TimeResponse:
    """Appendix, Eq. 30 in time, unnumbered: readings of an impulse, a step and a ramp of the force.

    Parameters
    ----------
    omega_0 : float or array [rad/s], > 0
        $\\omega_0$: natural frequency
    t : float or array [s], >= 0
        $t$: time
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    impulse : float or array [1/s]
        $$: reading of a unit impulse
    step : float or array
        $$: reading of a unit step
    ramp : float or array [s]
        $$: reading of $f = t$

    Formula as printed
    ------------------
        \\omega_0^2 t e^{-\\omega_0 t}, \\quad 1 - (1 + \\omega_0 t) e^{-\\omega_0 t}, \\quad
        t - \\frac{2}{\\omega_0} + \\left(t + \\frac{2}{\\omega_0}\\right) e^{-\\omega_0 t}

    Reading
    -------
    Of the unit impulse, the unit step, and $f = t$. Soon after the start the terms cancel: with $y = \\omega_0 t$ below two, step and ramp are the series
    $e^{-y} \\sum_{n \\ge 2} y^n / n!$ and $t e^{-y} \\sum_{n \\ge 3} (n - 2) y^{n-1} / n!$ of positive terms.

    Laws
    ----
    * impulse step and ramp are integrals of each other
    * a step is reached without overshoot
    * the series are the printed forms

    soot-30-time, spec/soot/def_filter.rs, rounding error at most 1 ULP
    """

@type_check_only
class _FilterStep(NamedTuple):
    g_next: Any
    g_dot_next: Any

def filter_step(omega_0: ArrayLike | str, dt: ArrayLike | str, g: ArrayLike | str, g_dot: ArrayLike | str, f_0: ArrayLike | str, f_1: ArrayLike | str, *, check: bool = True) -> _FilterStep:
    """Appendix, unnumbered: the reading after a time in which the force changes linearly.

    Parameters
    ----------
    omega_0 : float or array [rad/s], > 0
        $\\omega_0$: natural frequency
    dt : float or array [s], > 0
        $\\Delta t$: time between the samples
    g : float or array [N]
        $g_0$: reading before
    g_dot : float or array [N/s]
        $\\dot{g}_0$: its rate before
    f_0 : float or array [N]
        $f_0$: force before
    f_1 : float or array [N]
        $f_1$: force now
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    g_next : float or array [N]
        $g$: reading now
    g_dot_next : float or array [N/s]
        $\\dot{g}$: its rate now

    Formula as printed
    ------------------
        g(\\Delta t) = (S - \\varphi) f_0 + \\varphi f_1 + \\big[(1 + y) g_0 + \\Delta t \\, \\dot{g}_0\\big] e^{-y}, \\quad
        \\dot{g}(\\Delta t) = S \\, \\frac{f_1 - f_0}{\\Delta t} + \\big[(1 - y) \\dot{g}_0 + \\omega_0 y \\, (f_0 - g_0)\\big] e^{-y}, \\quad y = \\omega_0 \\Delta t

    Reading
    -------
    The exact solution of Eq. 28 with Eqs. 29 and 31 for a force that is linear between two samples, by the step response $S$ and the ramp response $\\varphi \\Delta t$ of
    [`time_response`]. It is stable for any time step. After a long one little remains of the earlier force, $S - \\varphi = \\frac{1}{y} \\big(2 - (y^2 + 2y + 2) e^{-y}\\big)$, which is evaluated as such:
    $S f_0 + \\varphi (f_1 - f_0)$ would lose it. Below two it is the difference of the series.

    Laws
    ----
    * two half steps make a step
    * a steady force is read and a steady ramp lags by two time constants
    * the area under the force is the area under the reading
    * a step of any length keeps the digits of the force before
    * responses to short steps keep their digits

    soot-filter, spec/soot/def_filter.rs, rounding error at most 2 ULP
    """
