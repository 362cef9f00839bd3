//! Sums of forces, separated by cause.

use crate::spec::Vec3;
use crate::system::Forces;

impl Forces {
    /// No force.
    pub fn zero() -> Self {
        Self { contact: Vec3::zero(), friction: Vec3::zero(), van_der_waals: Vec3::zero() }
    }

    /// Both together.
    pub fn and(self, other: Self) -> Self {
        Self {
            contact: self.contact + other.contact,
            friction: self.friction + other.friction,
            van_der_waals: self.van_der_waals + other.van_der_waals,
        }
    }

    /// Those of the other side.
    pub fn reversed(self) -> Self {
        Self { contact: -self.contact, friction: -self.friction, van_der_waals: -self.van_der_waals }
    }

    /// Whatever the cause.
    pub fn total(&self) -> Vec3<f64> {
        self.contact + self.friction + self.van_der_waals
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_are_added_and_reversed_cause_by_cause_and_all_count() {
        let of = |f: f64| {
            let along = |x, y, z| Vec3([x, y, z]) * f;
            Forces {
                contact: along(1.0, 0.0, 0.0),
                friction: along(0.0, 1.0, 0.0),
                van_der_waals: along(0.0, 0.0, 1.0),
            }
        };
        assert_eq!(of(3.0).and(of(4.0)), of(7.0));
        assert_eq!(of(3.0).and(Forces::zero()), of(3.0));
        assert_eq!(of(3.0).reversed(), of(-3.0));
        assert_eq!(of(3.0).total(), Vec3([3.0, 3.0, 3.0]));
    }
}
