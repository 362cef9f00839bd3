//! Random vectors for the laws.

use crate::Vec3;
use proptest::prelude::*;

pub(crate) fn vector() -> impl Strategy<Value = Vec3<f64>> {
    prop::array::uniform3(-1.0..1.0).prop_map(Vec3)
}

pub(crate) fn unit() -> impl Strategy<Value = Vec3<f64>> {
    vector().prop_filter("long enough", |v| v.norm() > 0.1).prop_map(|v| v * (1.0 / v.norm()))
}

/// A vector turned about an axis of length one.
pub(crate) fn rotated(v: Vec3<f64>, axis: Vec3<f64>, angle: f64) -> Vec3<f64> {
    v * angle.cos() + axis.cross(v) * angle.sin() + axis * (axis.dot(v) * (1.0 - angle.cos()))
}
