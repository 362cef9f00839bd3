# Written by stubs.py.
# mypy: disable-error-code="overload-overlap"
"""Mechanics that the papers share. The equations, by the names of their functions."""

from typing import Any, NamedTuple, overload, type_check_only

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "axial_energy",
    "axial_work",
    "box_inertia",
    "box_strain_rate",
    "box_stress",
    "box_work",
    "cap_volume",
    "carried_spring",
    "contact_rest",
    "coordinated_time_step",
    "drag_loss",
    "drift",
    "elongation",
    "excess_of_a_kick",
    "growing_rate",
    "growth",
    "gyration_term",
    "hcp_cell",
    "inertia_share",
    "joined_distance",
    "kick",
    "kinetic_energy",
    "largest_displacement",
    "momentum_flux",
    "own_gyration",
    "path_work",
    "period",
    "product",
    "rolled_path",
    "rotation_vector",
    "speed_of_fall",
    "sphere_volume",
    "thermal_energy",
    "translational_energy",
    "weibull_quantile",
    "work",
]

def kick(v: ArrayLike, force: ArrayLike, m: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Velocity after a constant force has acted on a mass for a time step.

    Parameters
    ----------
    v : array (..., 3) [m/s]
        $\\mathbf{v}_n$: velocity before
    force : array (..., 3) [N]
        $\\mathbf{F}$: force
    m : float or array [kg], > 0
        $m$: mass
    dt : float or array [s]
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v_next : array (..., 3) [m/s]
        $\\mathbf{v}_{n+1}$: velocity after

    Formula as printed
    ------------------
        \\mathbf{v}_{n+1} = \\mathbf{v}_n + \\frac{\\mathbf{F}}{m} \\Delta t

    Reading
    -------
    An angular velocity changes in the same way, with the torque for the force and the moment of inertia for the mass. The time step is divided
    by the mass first: one division serves the three components.

    Laws
    ----
    * the momentum gains force times time
    * a kick back in time undoes a kick

    mechanics-kick, spec/mechanics/kick_and_drift.rs, rounding error at most 1 ULP
    """

def drift(x: ArrayLike, v: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Position after a time step at a constant velocity.

    Parameters
    ----------
    x : array (..., 3) [m]
        $\\mathbf{x}_n$: position before
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity
    dt : float or array [s]
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    x_next : array (..., 3) [m]
        $\\mathbf{x}_{n+1}$: position after

    Formula as printed
    ------------------
        \\mathbf{x}_{n+1} = \\mathbf{x}_n + \\mathbf{v} \\Delta t

    Laws
    ----
    * two drifts of half a step are one of a whole step
    * the rate of a drift is the velocity

    mechanics-drift, spec/mechanics/kick_and_drift.rs, rounding error at most 0.5 ULP
    """

def kinetic_energy(m: ArrayLike | str, v: ArrayLike, i: ArrayLike | str, omega: ArrayLike, *, check: bool = True) -> Any:
    """Kinetic energy of translation and rotation of a sphere.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity
    i : float or array [kg m^2], > 0
        $I$: moment of inertia
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}$: angular velocity
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    energy : float or array [J]
        $K$: kinetic energy

    Formula as printed
    ------------------
        K = \\frac{1}{2} \\left(m v^2 + I \\omega^2\\right)

    Reading
    -------
    Evaluated with the changes of both velocities in a kick, it is the energy by which the kick exceeds the work of force and torque at the
    velocities before it, see [`excess_of_a_kick`].

    Laws
    ----
    * a force changes it by its work

    mechanics-kinetic-energy, spec/mechanics/kinetic_energy.rs, rounding error at most 1 ULP
    """

def translational_energy(m: ArrayLike | str, v: ArrayLike, *, check: bool = True) -> Any:
    """Kinetic energy of a centre of mass.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    energy : float or array [J]
        $K$: kinetic energy

    Formula as printed
    ------------------
        K = \\frac{1}{2} m v^2

    Laws
    ----
    * it is that of a sphere without spin

    mechanics-translational-energy, spec/mechanics/kinetic_energy.rs, rounding error at most 1 ULP
    """

@overload
def axial_energy(m: float | str, v_a: float | str, *, check: bool = True) -> float:
    """Kinetic energy of motion along one axis.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    v_a : float or array [m/s]
        $v_a$: velocity along the axis
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    energy : float or array [J]
        $K_a$: kinetic energy

    Formula as printed
    ------------------
        K_a = \\frac{1}{2} m v_a^2

    Reading
    -------
    For a wall driven by a load along some axes, with prescribed motion along the others.

    Laws
    ----
    * those along the three axes are the whole

    mechanics-axial-energy, spec/mechanics/kinetic_energy.rs, rounding error at most 0.5 ULP
    """
@overload
def axial_energy(m: ArrayLike | str, v_a: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def excess_of_a_kick(force: ArrayLike, m: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> Any:
    """Kinetic energy by which a kick exceeds the work of its force at the velocity before.

    Parameters
    ----------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force
    m : float or array [kg], > 0
        $m$: mass
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    excess : float or array [J]
        $\\Delta K$: excess

    Formula as printed
    ------------------
        K(\\mathbf{v} + \\mathbf{F} \\Delta t / m) - K(\\mathbf{v}) - \\mathbf{F} \\cdot \\mathbf{v} \\, \\Delta t = \\frac{F^2 \\Delta t^2}{2 m}

    Reading
    -------
    Of first order in the time step over many steps: the effect on an energy balance of velocities half a step behind the positions.

    Laws
    ----
    * a kick exceeds the work by it

    mechanics-kick-excess, spec/mechanics/kinetic_energy.rs, rounding error at most 1 ULP
    """

def work(force: ArrayLike, v: ArrayLike, torque: ArrayLike, omega: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> Any:
    """Work of a force and a torque on a body over a time step.

    Parameters
    ----------
    force : array (..., 3) [N]
        $\\mathbf{F}$: force
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity of the point at which the force acts
    torque : array (..., 3) [N m]
        $\\mathbf{M}$: torque
    omega : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}$: angular velocity
    dt : float or array [s]
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    work : float or array [J]
        $W$: work

    Formula as printed
    ------------------
        W = \\left(\\mathbf{F} \\cdot \\mathbf{v} + \\mathbf{M} \\cdot \\boldsymbol{\\omega}\\right) \\Delta t

    Laws
    ----
    * it does not depend on the point of reference
    * those along the three axes are the whole

    mechanics-work, spec/mechanics/work.rs, rounding error at most 1 ULP
    """

@overload
def axial_work(f_a: float | str, v_a: float | str, dt: float | str, *, check: bool = True) -> float:
    """Work of a force along one axis over a time step.

    Parameters
    ----------
    f_a : float or array [N]
        $F_a$: force along the axis
    v_a : float or array [m/s]
        $v_a$: velocity along the axis
    dt : float or array [s]
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    work : float or array [J]
        $W$: work

    Formula as printed
    ------------------
        W = F_a v_a \\, \\Delta t

    Laws
    ----
    * those along the three axes are the whole

    mechanics-axial-work, spec/mechanics/work.rs, rounding error at most 0.5 ULP
    """
@overload
def axial_work(f_a: ArrayLike | str, v_a: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def drag_loss(c: ArrayLike | str, v: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> Any:
    """Energy that a drag dissipates in a time step.

    Parameters
    ----------
    c : float or array [kg/s], >= 0
        $c$: coefficient of the drag
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    loss : float or array [J]
        $\\Delta E$: energy

    Formula as printed
    ------------------
        \\Delta E = c v^2 \\, \\Delta t

    Reading
    -------
    Evaluated with the velocity before the step, with which [`global_damping`](super::drag::global_damping) acts.

    Laws
    ----
    * a drag takes the work that it does

    mechanics-drag-loss, spec/mechanics/work.rs, rounding error at most 1 ULP
    """

def path_work(before: ArrayLike, after: ArrayLike, path: ArrayLike, *, check: bool = True) -> Any:
    """Work of a force along the path between two steps.

    Parameters
    ----------
    before : array (..., 3) [N]
        $\\mathbf{F}_n$: force before
    after : array (..., 3) [N]
        $\\mathbf{F}_{n+1}$: force after
    path : array (..., 3) [m]
        $\\mathbf{x}_{n+1} - \\mathbf{x}_n$: displacement in between
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    work : float or array [J]
        $W$: work

    Formula as printed
    ------------------
        W = \\frac{1}{2} \\left(\\mathbf{F}_n + \\mathbf{F}_{n+1}\\right) \\cdot \\left(\\mathbf{x}_{n+1} - \\mathbf{x}_n\\right)

    Reading
    -------
    The trapezoidal rule: exact for a force that is linear in the position, such as that of a spring.

    Laws
    ----
    * a spring gives the energy that it held

    mechanics-path-work, spec/mechanics/work.rs, rounding error at most 1 ULP
    """

def momentum_flux(m: ArrayLike | str, v: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """Momentum that a moving mass carries through faces normal to the axes, times the volume.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    v : array (..., 3) [m/s]
        $\\mathbf{v}$: velocity
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    flux : array (..., 3) [J]
        $p_a$: contribution to the diagonal

    Formula as printed
    ------------------
        p_a = m v_a^2

    Laws
    ----
    * it is the kinetic part of the virial stress

    mechanics-momentum-flux, spec/mechanics/box_stress.rs, rounding error at most 0.5 ULP
    """

def box_stress(virial: ArrayLike, flux: ArrayLike, volume: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Diagonal of the stress of a box, positive in tension.

    Parameters
    ----------
    virial : array (..., 3) [J]
        $\\sum r_a f_a$: sum over the pairs
    flux : array (..., 3) [J]
        $\\sum m v_a^2$: sum over the particles
    volume : float or array [m^3], > 0
        $V$: volume of the box
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    sigma : array (..., 3) [Pa]
        $\\sigma_a$: stress

    Formula as printed
    ------------------
        \\sigma_a = \\frac{1}{V} \\left(\\sum r_a f_a - \\sum m v_a^2\\right)

    Reading
    -------
    The sums of [`pair_stress`](super::virial::pair_stress) and [`kinetic_stress`](super::virial::kinetic_stress) over all pairs and particles of the box, divided by
    the volume once. Each pair counts once, with its branch vector from i to j and the force on i.

    Laws
    ----
    * it sums the virial stress of pairs and particles

    mechanics-box-stress, spec/mechanics/box_stress.rs, rounding error at most 0.5 ULP
    """

@overload
def box_inertia(mass: float | str, side: float | str, *, check: bool = True) -> float:
    """Inertia of a homogeneous deformation of a box along one of its sides.

    Parameters
    ----------
    mass : float or array [kg], > 0
        $M$: mass in the box
    side : float or array [m], > 0
        $L$: length of the side
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    inertia : float or array [kg m^2]
        $J$: inertia

    Formula as printed
    ------------------
        J = \\frac{M L^2}{12}

    Reading
    -------
    A slab of uniform density whose points move in proportion to their distance from the middle.

    Laws
    ----
    * it sums the layers of the slab

    mechanics-box-inertia, spec/mechanics/box_relaxation.rs, rounding error at most 0.5 ULP
    """
@overload
def box_inertia(mass: ArrayLike | str, side: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def box_strain_rate(rate: float | str, excess: float | str, modulus: float | str, volume: float | str, inertia: float | str, dt: float | str, *, check: bool = True) -> float:
    """Rate of strain of a side after a time step under the stress of the box.

    Parameters
    ----------
    rate : float or array [1/s]
        $\\dot\\varepsilon_n$: rate of strain before
    excess : float or array [Pa]
        $\\sigma - \\sigma_0$: stress above its target
    modulus : float or array [Pa], >= 0
        $E$: Young's modulus of the material
    volume : float or array [m^3], > 0
        $V$: volume of the box
    inertia : float or array [kg m^2], > 0
        $J$: inertia of the side
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    rate_next : float or array [1/s]
        $\\dot\\varepsilon_{n+1}$: rate of strain after

    Formula as printed
    ------------------
        \\dot\\varepsilon_{n+1} = \\dot\\varepsilon_n - \\left(\\frac{V (\\sigma - \\sigma_0)}{J} + 2 \\sqrt{\\frac{V E}{J}} \\, \\dot\\varepsilon_n\\right) \\Delta t

    Reading
    -------
    The stress, positive in tension, shortens the box; the modulus sets the damping, which is critical for a material of that modulus. A box
    is then never slower than the sound that crosses it.

    Laws
    ----
    * an elastic box comes to rest without overshooting

    mechanics-box-strain-rate, spec/mechanics/box_relaxation.rs, rounding error at most 1 ULP
    """
@overload
def box_strain_rate(rate: ArrayLike | str, excess: ArrayLike | str, modulus: ArrayLike | str, volume: ArrayLike | str, inertia: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def growth(rate: float | str, dt: float | str, *, check: bool = True) -> float:
    """Factor by which a side and all positions along it grow in a time step.

    Parameters
    ----------
    rate : float or array [1/s]
        $\\dot\\varepsilon$: rate of strain
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    factor : float or array
        $g$: factor

    Formula as printed
    ------------------
        g = 1 + \\dot\\varepsilon \\, \\Delta t

    Laws
    ----
    * many short steps are the exponential of the strain

    mechanics-growth, spec/mechanics/box_relaxation.rs, rounding error at most 1 ULP
    """
@overload
def growth(rate: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _GrowingRate(NamedTuple):
    growing: Any
    owed_next: Any

def growing_rate(rate: ArrayLike | str, owed: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> _GrowingRate:
    """Rate of strain at which a side grows in a time step, and the rate that it owes to the next one.

    Parameters
    ----------
    rate : float or array [1/s]
        $\\dot\\varepsilon_n$: rate of strain of the side
    owed : float or array [1/s]
        $\\dot\\varepsilon_o$: rate of the steps before in which it did not grow
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    growing : float or array [1/s]
        $\\dot\\varepsilon$: rate at which it grows
    owed_next : float or array [1/s]
        $\\dot\\varepsilon_o'$: rate that it owes

    Formula as printed
    ------------------
        (\\dot\\varepsilon, \\dot\\varepsilon_o') =
        \\begin{cases}
        (0, \\dot\\varepsilon_n + \\dot\\varepsilon_o) & |\\dot\\varepsilon_n + \\dot\\varepsilon_o| \\, \\Delta t < 2^{-50} \\\\
        (\\dot\\varepsilon_n + \\dot\\varepsilon_o, 0) & \\text{otherwise}
        \\end{cases}

    Reading
    -------
    A box of many spheres comes to rest by strains of less than the rounding of a position in each step. They are added up until they can move
    something: otherwise the box stops while stress remains in it.

    Laws
    ----
    * a strain is only postponed
    * a side that grows grows by more than its rounding

    mechanics-growing-rate, spec/mechanics/box_relaxation.rs, rounding error at most 0.5 ULP
    """

def box_work(virial: ArrayLike, factor: ArrayLike, *, check: bool = True) -> Any:
    """Work of the sides of a box on the spheres inside it in a time step.

    Parameters
    ----------
    virial : array (..., 3) [J]
        $\\sum r_a f_a$: sum over the pairs, by axis
    factor : array (..., 3)
        $g_a$: factors by which the sides grow
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    work : float or array [J]
        $W$: work

    Formula as printed
    ------------------
        W = \\sum_a (g_a - 1) \\sum r_a f_a

    Reading
    -------
    Only the static part of the stress works: velocities are not scaled with the box.

    Laws
    ----
    * the work stretches a spring between two faces
    * each side works alone

    mechanics-box-work, spec/mechanics/box_relaxation.rs, rounding error at most 1 ULP
    """

@type_check_only
class _Product(NamedTuple):
    scalar: Any
    vector: NDArray[np.float64]

def product(a_0: ArrayLike | str, a: ArrayLike, b_0: ArrayLike | str, b: ArrayLike, *, check: bool = True) -> _Product:
    """Product of two quaternions: one rotation after another.

    Parameters
    ----------
    a_0 : float or array
        $a_0$: scalar part of the left factor
    a : array (..., 3)
        $\\mathbf{a}$: its vector part
    b_0 : float or array
        $b_0$: scalar part of the right factor
    b : array (..., 3)
        $\\mathbf{b}$: its vector part
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    scalar : float or array
        $q_0$: scalar part of the product
    vector : array (..., 3)
        $\\mathbf{q}$: vector part of the product

    Formula as printed
    ------------------
        (a_0, \\mathbf{a}) (b_0, \\mathbf{b}) = \\left(a_0 b_0 - \\mathbf{a} \\cdot \\mathbf{b}, \\; a_0 \\mathbf{b} + b_0 \\mathbf{a} + \\mathbf{a} \\times \\mathbf{b}\\right)

    Reading
    -------
    The rotation of $b$ comes first. The inverse of a unit quaternion has the opposite vector part.

    Laws
    ----
    * the product is one rotation after the other
    * the length of the product is the product of the lengths

    mechanics-quaternion-product, spec/mechanics/quaternion.rs, rounding error at most 1 ULP
    """

def rotation_vector(a_0: ArrayLike | str, a: ArrayLike, b_0: ArrayLike | str, b: ArrayLike, *, check: bool = True) -> NDArray[np.float64]:
    """The rotation vector between two nearly equal orientations.

    Parameters
    ----------
    a_0 : float or array
        $a_0$: scalar part of the orientation before
    a : array (..., 3)
        $\\mathbf{a}$: its vector part
    b_0 : float or array
        $b_0$: scalar part of the orientation after
    b : array (..., 3)
        $\\mathbf{b}$: its vector part
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    theta : array (..., 3) [rad]
        $\\boldsymbol{\\theta}$: rotation

    Formula as printed
    ------------------
        \\boldsymbol{\\theta} = 2 \\operatorname{sgn}(q_0) \\, \\mathbf{q}, \\quad (q_0, \\mathbf{q}) = (b_0, \\mathbf{b}) (a_0, -\\mathbf{a})

    Reading
    -------
    Along the axis, with the angle as length up to its third power: $2 \\sin(\\theta / 2)$. Both signs of a quaternion are the same orientation; the shorter way is taken.

    Laws
    ----
    * a small rotation is found again whatever the sign
    * half a turn goes the way of the later orientation

    mechanics-rotation-vector, spec/mechanics/quaternion.rs, rounding error at most 0.5 ULP
    """

def largest_displacement(b_0: ArrayLike | str, b: ArrayLike, a_0: ArrayLike | str, a: ArrayLike, extent: ArrayLike | str, *, check: bool = True) -> Any:
    """Largest displacement of a point of a body that has turned about its centre of mass.

    Parameters
    ----------
    b_0 : float or array
        $b_0$: scalar part of the orientation after
    b : array (..., 3)
        $\\mathbf{b}$: its vector part
    a_0 : float or array
        $a_0$: scalar part of the orientation before
    a : array (..., 3)
        $\\mathbf{a}$: its vector part
    extent : float or array [m], >= 0
        $R$: distance of the farthest point from the centre of mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    d : float or array [m]
        $d$: displacement

    Formula as printed
    ------------------
        d = 2 R \\, |\\mathbf{q}|, \\quad (q_0, \\mathbf{q}) = (b_0, \\mathbf{b}) (a_0, -\\mathbf{a})

    Reading
    -------
    A rotation by $\\theta$ displaces a point at a distance $R$ from the axis by $2 R \\sin(\\theta / 2)$, and one that is nearer by less.

    Laws
    ----
    * no point has been displaced by more and one across the axis by as much

    mechanics-turned-displacement, spec/mechanics/quaternion.rs, rounding error at most 1 ULP
    """

@overload
def sphere_volume(r: float | str, *, check: bool = True) -> float:
    """Volume of a sphere.

    Parameters
    ----------
    r : float or array [m], >= 0
        $r$: radius
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    volume : float or array [m^3]
        $V$: volume

    Formula as printed
    ------------------
        V = \\frac{4}{3} \\pi r^3

    Laws
    ----
    * two caps that meet are the sphere

    mechanics-sphere-volume, spec/mechanics/solids.rs, rounding error at most 1 ULP
    """
@overload
def sphere_volume(r: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def cap_volume(r: float | str, h: float | str, *, check: bool = True) -> float:
    """Volume of a spherical cap.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius of the sphere
    h : float or array [m], >= 0
        $h$: height of the cap, up to twice the radius
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    volume : float or array [m^3]
        $V$: volume

    Formula as printed
    ------------------
        V = \\frac{\\pi}{3} h^2 (3 r - h)

    Laws
    ----
    * two caps that meet are the sphere
    * it grows with the height by the section

    mechanics-cap-volume, spec/mechanics/solids.rs, rounding error at most 0.5 ULP
    """
@overload
def cap_volume(r: ArrayLike | str, h: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@type_check_only
class _HcpCell(NamedTuple):
    a: Any
    b: Any
    c: Any

def hcp_cell(d: ArrayLike | str, *, check: bool = True) -> _HcpCell:
    """Sides of the orthogonal cell of four spheres of hexagonal close packing.

    Parameters
    ----------
    d : float or array [m], > 0
        $d$: diameter of the spheres
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    a : float or array [m]
        $a$: along a close-packed row
    b : float or array [m]
        $b$: across it in the basal plane
    c : float or array [m]
        $c$: along the hexagonal axis

    Formula as printed
    ------------------
        a = d, \\quad b = \\sqrt{3} \\, d, \\quad c = \\sqrt{\\frac{8}{3}} \\, d

    Laws
    ----
    * four spheres fill 0 74 of the cell

    mechanics-hcp-cell, spec/mechanics/solids.rs, rounding error at most 1 ULP
    """

def gyration_term(x: ArrayLike, m: ArrayLike | str, total: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Contribution of a point mass to the squared radius of gyration, by axis.

    Parameters
    ----------
    x : array (..., 3) [m]
        $\\mathbf{x}$: position relative to the common centre of mass
    m : float or array [kg], > 0
        $m$: mass
    total : float or array [kg], > 0
        $M$: total mass
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    square : array (..., 3) [m^2]
        $g_a^2$: contribution along each axis

    Formula as printed
    ------------------
        g_a^2 = x_a^2 \\frac{m}{M}

    Reading
    -------
    The sum over all masses and the three axes is the squared radius of gyration.

    Laws
    ----
    * two points have their distance weighted with the reduced mass

    mechanics-gyration-term, spec/mechanics/gyration.rs, rounding error at most 1 ULP
    """

@overload
def own_gyration(r: float | str, m: float | str, total: float | str, *, check: bool = True) -> float:
    """Contribution of the size of a sphere to the squared radius of gyration along each axis.

    Parameters
    ----------
    r : float or array [m], > 0
        $r$: radius
    m : float or array [kg], > 0
        $m$: mass
    total : float or array [kg], > 0
        $M$: mass of all spheres
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    square : float or array [m^2]
        $g^2$: contribution along one axis

    Formula as printed
    ------------------
        g^2 = \\frac{1}{3} r^2 \\frac{m}{M}

    Reading
    -------
    With it the radius of gyration of a single sphere is its radius (Filippov, Zurita & Rosner, J. Colloid Interface Sci. 229, 261, 2000). Summed
    over the three axes it is $r^2 m / M$.

    Laws
    ----
    * a single sphere has its radius

    mechanics-own-gyration, spec/mechanics/gyration.rs, rounding error at most 0.5 ULP
    """
@overload
def own_gyration(r: ArrayLike | str, m: ArrayLike | str, total: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def joined_distance(m_a: float | str, m_b: float | str, total: float | str, square_a: float | str, square_b: float | str, radius: float | str, *, check: bool = True) -> float:
    """Distance between the centres of mass of two clusters that together have a given radius of gyration.

    Parameters
    ----------
    m_a : float or array [kg], > 0
        $m_a$: mass of one cluster
    m_b : float or array [kg], > 0
        $m_b$: mass of the other
    total : float or array [kg], > 0
        $M$: their sum
    square_a : float or array [m^2], >= 0
        $R_a^2$: squared gyration radius of one
    square_b : float or array [m^2], >= 0
        $R_b^2$: squared gyration radius of the other
    radius : float or array [m], > 0
        $R$: gyration radius of both together
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    distance : float or array [m]
        $d$: distance

    Formula as printed
    ------------------
        d = \\sqrt{\\frac{M}{m_a m_b} \\left(M R^2 - m_a R_a^2 - m_b R_b^2\\right)}, \\quad M = m_a + m_b

    Reading
    -------
    Steiner's theorem. If the clusters alone already exceed it, the distance is zero.

    Laws
    ----
    * two points at the distance have the gyration radius
    * clusters that are too large coincide

    mechanics-joined-distance, spec/mechanics/gyration.rs, rounding error at most 1 ULP
    """
@overload
def joined_distance(m_a: ArrayLike | str, m_b: ArrayLike | str, total: ArrayLike | str, square_a: ArrayLike | str, square_b: ArrayLike | str, radius: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def period(m: float | str, k: float | str, *, check: bool = True) -> float:
    """Period of the free oscillation of a mass on a spring.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    k : float or array [N/m], > 0
        $k$: stiffness
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    t : float or array [s]
        $T$: period

    Formula as printed
    ------------------
        T = 2 \\pi \\sqrt{\\frac{m}{k}}

    Laws
    ----
    * an oscillator returns after its period

    mechanics-period, spec/mechanics/oscillation.rs, rounding error at most 1 ULP
    """
@overload
def period(m: ArrayLike | str, k: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def speed_of_fall(m: float | str, u_0: float | str, u: float | str, *, check: bool = True) -> float:
    """Speed of a mass that was released from rest, by conservation of energy.

    Parameters
    ----------
    m : float or array [kg], > 0
        $m$: mass
    u_0 : float or array [J]
        $U_0$: potential energy at the start
    u : float or array [J]
        $U$: potential energy now, not above it
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    v : float or array [m/s]
        $v$: speed

    Formula as printed
    ------------------
        v = \\sqrt{\\frac{2 (U_0 - U)}{m}}

    Reading
    -------
    The mass is the reduced mass of two bodies that fall towards each other; the speed is then the relative one.

    Laws
    ----
    * a constant force gives the speed of uniform acceleration

    mechanics-speed-of-fall, spec/mechanics/oscillation.rs, rounding error at most 1 ULP
    """
@overload
def speed_of_fall(m: ArrayLike | str, u_0: ArrayLike | str, u: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def rolled_path(omega_i: ArrayLike, omega_j: ArrayLike, n: ArrayLike, r: ArrayLike | str, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Path by which two spheres roll over each other in a time step.

    Parameters
    ----------
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    n : array (..., 3), a unit vector
        $\\mathbf{n}$: normal, from j to i
    r : float or array [m], > 0
        $r$: effective radius
    dt : float or array [s], > 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    path : array (..., 3) [m]
        $\\Delta \\mathbf{s}$: path

    Formula as printed
    ------------------
        \\Delta \\mathbf{s} = r \\, (\\boldsymbol{\\omega}_i - \\boldsymbol{\\omega}_j) \\times \\mathbf{n} \\, \\Delta t

    Reading
    -------
    For equal spheres the effective radius is half their radius; in general it is the radius of the relative curvature.

    Laws
    ----
    * turning together is no rolling
    * a sphere on a plane rolls by its radius times the angle

    mechanics-rolled-path, spec/mechanics/rolling.rs, rounding error at most 1 ULP
    """

@overload
def coordinated_time_step(dt_c: float | str, z: float | str, *, check: bool = True) -> float:
    """Time step below which a sphere with several contacts or necks is stable.

    Parameters
    ----------
    dt_c : float or array [s], > 0
        $\\Delta t_c$: stability limit of two spheres
    z : float or array, > 0
        $z$: coordination number
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    dt_z : float or array [s]
        $\\Delta t_z$: stable time step

    Formula as printed
    ------------------
        \\Delta t_z = \\frac{\\Delta t_c}{\\sqrt{z}}

    Reading
    -------
    The elastic energy of every pair is at most $\\tfrac{1}{2}\\omega_c^2$ times the inertia of its two spheres, where $\\omega_c = 2 / \\Delta t_c$ is the largest frequency of a pair on its own.
    Summed over all pairs, every sphere counts as often as it has contacts: no frequency of the assembly is above $\\omega_c \\sqrt{z}$, with the largest coordination number $z$.
    It is sufficient, and attained where all neighbours of a sphere move against it, as in a ring of an even number of equal spheres. Without dashpots.

    Laws
    ----
    * no frequency of an assembly is above it
    * an even ring attains it

    mechanics-coordinated-step, spec/mechanics/coordinated_step.rs, rounding error at most 1 ULP
    """
@overload
def coordinated_time_step(dt_c: ArrayLike | str, z: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def inertia_share(i: float | str, n: float | str, *, check: bool = True) -> float:
    """Share of the moment of inertia of a body that is assigned to one of several contacts.

    Parameters
    ----------
    i : float or array [kg m^2], > 0
        $I$: moment of inertia of the body
    n : float or array, >= 0
        $n$: number of its contacts
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    share : float or array [kg m^2]
        $I_c$: moment of inertia for one contact

    Formula as printed
    ------------------
        I_c = \\frac{I}{\\max(n, 1)}

    Reading
    -------
    Friction may stop a rotating body, but not reverse it. Each contact may at most stop a body of this smaller inertia; all of them together
    then stop the whole. For a non-spherical body $I$ is the smallest principal moment.

    Laws
    ----
    * contacts that each stop their share stop the body

    mechanics-inertia-share, spec/mechanics/friction_share.rs, rounding error at most 0.5 ULP
    """
@overload
def inertia_share(i: ArrayLike | str, n: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def thermal_energy(k_b: float | str, t: float | str, *, check: bool = True) -> float:
    """Energy of thermal motion: the Boltzmann constant times a temperature.

    Parameters
    ----------
    k_b : float or array [J], > 0
        $k_B$: Boltzmann constant, per kelvin
    t : float or array, > 0
        $T$: temperature in kelvin
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    kt : float or array [J]
        $k_B T$: energy

    Formula as printed
    ------------------
        k_B T

    Reading
    -------
    The Boltzmann constant is exactly $1.380649 \\times 10^{-23}$ J/K. The tables have no unit of temperature: it is the number of kelvins.

    Laws
    ----
    * at room temperature it is four zeptojoule

    mechanics-thermal-energy, spec/mechanics/thermal.rs, rounding error at most 0.5 ULP
    """
@overload
def thermal_energy(k_b: ArrayLike | str, t: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def elongation(delta: float | str, delta_0: float | str, *, check: bool = True) -> float:
    """Elongation of the normal spring of a neck.

    Parameters
    ----------
    delta : float or array [m]
        $\\delta$: gap, negative for an overlap
    delta_0 : float or array [m]
        $\\delta_0$: gap at rest
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    xi : float or array [m]
        $\\xi_\\mathrm{n}$: elongation of the spring, negative if it is compressed

    Formula as printed
    ------------------
        \\xi_\\mathrm{n} = \\delta - \\delta_0

    Reading
    -------
    A neck between spheres that only touch is at rest at $\\delta_0 = 0$, as in Demidov, Gor & Khalizov 2024. Sintered spheres overlap ($\\delta_0 < 0$), and material may fill a gap between
    others ($\\delta_0 > 0$): their neck is at rest at the gap at which it was made. Arms and torques count with the gap itself.

    Laws
    ----
    * a neck at rest exerts no force and stores no energy
    * the force of a neck is minus the gradient of its energy
    * a neck at rest in touch is the neck of the paper bit for bit
    * a neck without dashpots retraces its motion

    mechanics-elongation, spec/mechanics/neck_rest.rs, rounding error at most 0.5 ULP
    """
@overload
def elongation(delta: ArrayLike | str, delta_0: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

@overload
def contact_rest(delta: float | str, delta_0: float | str, *, check: bool = True) -> float:
    """Gap below which a contact of two spheres repels.

    Parameters
    ----------
    delta : float or array [m]
        $\\delta$: gap, negative for an overlap
    delta_0 : float or array [m]
        $\\delta_0$: gap at rest of the neck, or of the contact before; 0 for whole spheres
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    delta_c : float or array [m]
        $\\delta_\\mathrm{c}$: gap below which the contact repels

    Formula as printed
    ------------------
        \\delta_\\mathrm{c} = \\begin{cases} \\min(\\delta_0, 0) & \\text{if } \\delta < 0 \\\\ 0 & \\text{otherwise} \\end{cases}

    Reading
    -------
    Where a neck between overlapping spheres is missing or has broken, its cross-section is left: two flat faces, which touch at the gap at which the neck was at rest and not where whole spheres would touch. Nothing
    acts between them while they are apart. As soon as the spheres no longer overlap they may turn other places towards each other and are whole again. Nowhere does
    the energy jump: in both cases the spring is relaxed at $\\delta = 0$.

    Laws
    ----
    * what a broken neck leaves repels only below its gap at rest
    * spheres that have parted are whole again
    * the energy of a contact is continuous as spheres part

    mechanics-contact-rest, spec/mechanics/neck_rest.rs, rounding error at most 0 ULP
    """
@overload
def contact_rest(delta: ArrayLike | str, delta_0: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...

def carried_spring(xi: ArrayLike, n: ArrayLike, omega_i: ArrayLike, omega_j: ArrayLike, dt: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]:
    """Not in the papers: a spring in the contact plane after the pair has spun about its normal for a step.

    Parameters
    ----------
    xi : array (..., 3) [m]
        $\\boldsymbol{\\xi}'$: spring before
    n : array (..., 3), a unit vector
        $\\mathbf{n}$: normal, in either direction
    omega_i : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_i$: angular velocity of i
    omega_j : array (..., 3) [rad/s]
        $\\boldsymbol{\\omega}_j$: angular velocity of j
    dt : float or array [s], >= 0
        $\\Delta t$: time step
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    carried : array (..., 3) [m]
        $\\boldsymbol{\\xi}$: spring now, as long as before

    Formula as printed
    ------------------
        \\boldsymbol{\\xi} = \\boldsymbol{\\xi}' + \\frac{\\theta}{2} \\, \\mathbf{n} \\times (\\boldsymbol{\\xi} + \\boldsymbol{\\xi}'), \\quad
        \\theta = \\frac{\\boldsymbol{\\omega}_i + \\boldsymbol{\\omega}_j}{2} \\cdot \\mathbf{n} \\, \\Delta t

    Reading
    -------
    The papers project a spring into the contact plane. It then follows the normal, but not a spin of the pair about it: the bodies turn, and the spring between them stays fixed in
    space. A pair that turns as a body carries its spring only if the spring turns with the mean spin of the two spheres, which is how YADE transports it.
    The midpoint rule turns it by $2 \\arctan(\\theta/2)$, which differs from $\\theta$ in third order, keeps its length, and needs no sine. With $\\mathbf{b} = \\mathbf{n} \\times \\boldsymbol{\\xi}'$
    its solution is

    $$
    \\boldsymbol{\\xi} = \\boldsymbol{\\xi}' + \\frac{\\theta}{1 + \\theta^2/4} \\left(\\mathbf{b} + \\tfrac{\\theta}{2} \\, \\mathbf{n} \\times \\mathbf{b}\\right)
    $$

    What lies along the normal does not change, so it makes no difference whether a spring is turned before or after it is projected.

    Laws
    ----
    * a pair that spins as a body carries its spring
    * a spring keeps its length and what lies along the normal
    * it solves the midpoint rule
    * opposite spins leave the spring
    * swapping i and j changes nothing
    * turning before projecting is turning afterwards

    mechanics-carried-spring, spec/mechanics/carried_spring.rs, rounding error at most 1 ULP
    """

@overload
def weibull_quantile(p: float | str, scale: float | str, shape: float | str, *, check: bool = True) -> float:
    """The strength that a given share of brittle bodies exceeds.

    Parameters
    ----------
    p : float or array, (0, 1)
        $p$: share that is stronger
    scale : float or array, > 0
        $\\lambda$: strength that one body in e exceeds
    shape : float or array, >= 0.1
        $k$: Weibull modulus: the larger, the more alike they are
    check : bool
        refuse values outside their domain, and results that are not finite

    Returns
    -------
    x : float or array
        $x$: strength

    Formula as printed
    ------------------
        x = \\lambda \\, (-\\ln p)^{1/k}

    Reading
    -------
    The distribution of Weibull (1951), $p = e^{-(x/\\lambda)^k}$, solved for the strength. A number that is uniform between zero and one, taken for $p$, gives a strength with this distribution. The power is taken by logarithms.

    Laws
    ----
    * the share that is stronger is given
    * the stronger the rarer
    * one in e exceeds the scale
    * the weakest of many has the same distribution

    mechanics-weibull-quantile, spec/mechanics/weibull.rs, rounding error at most 2.5 ULP
    """
@overload
def weibull_quantile(p: ArrayLike | str, scale: ArrayLike | str, shape: ArrayLike | str, *, check: bool = True) -> NDArray[np.float64]: ...
