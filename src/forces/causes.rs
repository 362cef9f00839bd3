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
