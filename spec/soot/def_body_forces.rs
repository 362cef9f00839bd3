//! Van der Waals and capillary attraction together, up to a cutoff.

use super::eq18_hamaker::hamaker_force;
use super::eq19_equal_hamaker::saturated_hamaker;
use super::eq23_capillary::{capillary_energy, capillary_force};
use crate::equation::Equation;
use crate::real::ln_one_plus;
use crate::{Real, equation, flat_struct};

/// Below this, half of what changes the argument of the exponential, the capillary energy is one logarithm.
const NEAR: f64 = 1.0 / 32.0;

flat_struct! {
    /// The attractions that act at a distance.
    pub struct Attraction {
        /// Hamaker constant, J.
        pub a,
        /// Saturation distance of the van der Waals force, m.
        pub delta_0,
        /// Largest capillary force, N.
        pub psi,
        /// Sharpness of its decrease, 1/m.
        pub kappa,
        /// Centre distance at which it has fallen to one half, m.
        pub d_cutoff,
        /// Distance of centres beyond which neither force acts, m.
        pub cutoff,
    }
}

impl<R: Real> Attraction<R> {
    /// Force between two spheres whose centres are `d` apart.
    #[inline(always)]
    pub fn force(&self, d: R, gap: R, r_i: R, r_j: R) -> R {
        let van_der_waals = hamaker_force(r_i, r_j, gap.max(self.delta_0), self.a);
        self.within(d, van_der_waals + capillary_force(self.psi, self.kappa, d, self.d_cutoff))
    }

    /// Energies of two spheres whose centres are `d` apart: van der Waals, capillary, zero at the cutoff and beyond.
    #[inline(always)]
    pub fn energies(&self, d: R, r_i: R, r_j: R) -> (R, R) {
        let van_der_waals = |d: R| saturated_hamaker(r_i, r_j, d - r_i - r_j, self.a, self.delta_0);
        let ((force, near), (_, far)) = (van_der_waals(d), van_der_waals(self.cutoff));
        // Within saturation the potential is a straight line.
        let straight = (self.cutoff - r_i - r_j).lt(self.delta_0);
        let van_der_waals = R::select(straight, force * (d - self.cutoff), near - far);
        (self.within(d, van_der_waals), self.within(d, self.capillary(d)))
    }

    /// The capillary energy, zero at the cutoff.
    #[inline(always)]
    fn capillary(&self, d: R) -> R {
        let [one, two] = [1.0, 2.0].map(R::lit);
        let half = self.kappa * (self.cutoff - d);
        let middle = self.kappa * ((d - self.d_cutoff) + (self.cutoff - self.d_cutoff));
        let t = half.tanh() / (one + two * middle.exp() / (half.exp() + (-half).exp()));
        let near = -(self.psi / (two * self.kappa)) * ln_one_plus(two * t / (one - t));
        let uncut = |d: R| capillary_energy(self.psi, self.kappa, d, self.d_cutoff);
        R::select(half.lt(R::lit(NEAR)), near, uncut(d) - uncut(self.cutoff))
    }

    #[inline(always)]
    fn within(&self, d: R, value: R) -> R {
        R::select(d.le(self.cutoff), value, R::zero())
    }
}

/// **Sections 2.1.4 and 2.1.5**, unnumbered: attraction of two spheres up to a cutoff, and its two energies.
///
/// ```math
/// f = \begin{cases} f_{\mathrm{vdW}} + f_{\mathrm{cap}} & d \le d_\mathrm{max} \\ 0 & \text{otherwise} \end{cases}, \quad
/// U = \begin{cases} U(d) - U(d_\mathrm{max}) & d \le d_\mathrm{max} \\ 0 & \text{otherwise} \end{cases}
/// ```
///
/// # Reading
///
/// The paper has no cutoff other than that of its neighbour list, 42 nm or 70 nm between centres. Here the cutoff is a distance that does not depend on the rebuilds of the list.
/// The force is not shifted and drops to zero at the cutoff; the energies are shifted so that they end at zero. For two spheres of 14 nm the van der Waals force left out is at
/// most 1.1e-13 N (0.1 %) beyond 42 nm and 1.4e-15 N (14 parts in a million) beyond 70 nm, the capillary force of $\kappa d_{\mathrm{cutoff}} = 10$ at most 0.7 % beyond 70 nm.
///
/// If the cutoff is within saturation the van der Waals energy is $f \, (d - d_\mathrm{max})$. With $h = \kappa (d_\mathrm{max} - d)$ and $m = \kappa (d + d_\mathrm{max} - 2 d_{\mathrm{cutoff}})$ the
/// capillary energy is $-\frac{\psi}{\kappa} \operatorname{artanh} \frac{\tanh h}{1 + e^m / \cosh h}$, which is evaluated below $h = 1/32$: a difference of nearly equal energies would lose digits.
///
/// | name | symbol | unit | domain | meaning |
/// |---|---|---|---|---|
/// | `d` | $d$ | m | > 0 | distance of the centres |
/// | `r_i` | $r_i$ | m | > 0 | radius of i |
/// | `r_j` | $r_j$ | m | > 0 | radius of j |
/// | `a` | $A$ | J | >= 0 | Hamaker constant |
/// | `delta_0` | $\delta_0$ | m | > 0 | saturation distance |
/// | `psi` | $\psi$ | N | >= 0 | largest capillary force |
/// | `kappa` | $\kappa$ | 1/m | > 0 | sharpness of its drop |
/// | `d_cutoff` | $d_{\mathrm{cutoff}}$ | m | > 0 | distance at which half of it is left |
/// | `cutoff` | $d_\mathrm{max}$ | m | > 0 | distance beyond which nothing acts |
/// | → `f` | $f$ | N | | attraction |
/// | → `u_vdw` | $U_{\mathrm{vdW}}$ | J | | van der Waals energy |
/// | → `u_cap` | $U_{\mathrm{cap}}$ | J | | capillary energy |
///
/// Rounding: at most 8 ULP.
///
/// # Laws
///
/// * `up_to_the_cutoff_the_force_is_the_slope_of_the_energies`
/// * `the_energies_end_at_zero_and_the_force_with_the_stated_error`
/// * `the_energies_keep_their_digits_up_to_the_cutoff`
#[inline(always)]
pub fn attraction<R: Real>(
    d: R,
    r_i: R,
    r_j: R,
    a: R,
    delta_0: R,
    psi: R,
    kappa: R,
    d_cutoff: R,
    cutoff: R,
) -> (R, R, R) {
    let attraction = Attraction { a, delta_0, psi, kappa, d_cutoff, cutoff };
    let (u_vdw, u_cap) = attraction.energies(d, r_i, r_j);
    (attraction.force(d, d - r_i - r_j, r_i, r_j), u_vdw, u_cap)
}

pub(super) fn equations() -> Vec<Equation> {
    vec![equation!("soot/def_body_forces.rs", "soot-attraction", [], attraction)]
}

#[cfg(test)]
mod laws {
    use super::*;
    use crate::numbers::{Dual, Reference};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn up_to_the_cutoff_the_force_is_the_slope_of_the_energies(d in 1.0..5.0, r_i in 0.3..1.0, r_j in 0.3..1.0) {
            let lift = Dual::constant;
            let (f, u_vdw, u_cap) = attraction(
                Dual::variable(d), lift(r_i), lift(r_j), lift(2.0), lift(0.1), lift(0.7), lift(1.5), lift(3.0), lift(5.0),
            );
            prop_assert!((f.value / (u_vdw.slope + u_cap.slope) - 1.0).abs() < 1e-10);
        }

        #[test]
        fn the_energies_end_at_zero_and_the_force_with_the_stated_error(beyond in 1e-3..1e3) {
            // The spheres and the coating of the paper, in nanometres, piconewtons and zeptojoules.
            let at = |d: f64, cutoff: f64| attraction(d, 14.0, 14.0, 100.0, 1.0, 1000.0, 10.0 / 56.0, 56.0, cutoff);
            for (cutoff, van_der_waals) in [(42.0, 0.113), (70.0, 1.38e-3)] {
                prop_assert_eq!(at(cutoff + beyond, cutoff), (0.0, 0.0, 0.0));
                prop_assert_eq!((at(cutoff, cutoff).1, at(cutoff, cutoff).2), (0.0, 0.0));
                let jump = at(cutoff, cutoff).0 - capillary_force(1000.0, 10.0 / 56.0, cutoff, 56.0);
                prop_assert!((jump / van_der_waals - 1.0).abs() < 5e-3);
            }
            prop_assert!((capillary_force(1000.0, 10.0 / 56.0, 70.0, 56.0) - 6.69f64).abs() < 0.01);
        }

        #[test]
        fn the_energies_keep_their_digits_up_to_the_cutoff(log_short in -30.0..2.0f64, kappa in 0.5..3.0, d_cutoff in 1.0..4.0, saturated in prop::bool::ANY) {
            // Short of the cutoff, which is within saturation or not, as differences with digits enough.
            let (r_i, r_j, a, psi, cutoff) = (0.5, 0.75, 2.0, 0.7, 4.0);
            let (d, delta_0) = (cutoff - log_short.exp2().min(2.5), if saturated { 3.0 } else { 0.1 });
            let given = [d, r_i, r_j, a, delta_0, psi, kappa, d_cutoff, cutoff];
            let [x, i, j, a_, saturation, p, k, middle, end] = given.map(Reference::exact);
            let (_, exact_vdw, exact_cap) = attraction(x, i, j, a_, saturation, p, k, middle, end);
            let van_der_waals = |d: Reference| saturated_hamaker(i, j, d - i - j, a_, saturation).1;
            let capillary = |d: Reference| capillary_energy(p, k, d, middle);
            let (_, u_vdw, u_cap) = attraction(d, r_i, r_j, a, delta_0, psi, kappa, d_cutoff, cutoff);
            for (exact, printed) in
                [(exact_vdw, van_der_waals(x) - van_der_waals(end)), (exact_cap, capillary(x) - capillary(end))]
            {
                prop_assert!(((exact - printed) / printed).abs().to_f64() < 1e-34);
            }
            // at 1/32 the capillary energies that are subtracted are 64 times their difference
            prop_assert!((u_cap / exact_cap.to_f64() - 1.0).abs() < 2e-13);
            prop_assert!(!saturated || (u_vdw / exact_vdw.to_f64() - 1.0).abs() < 1e-14);
        }
    }
}
