"""The cost of a call beside the same formula in numpy: Eq. 3 of the wear paper, and its contact law over pairs.

python bench.py
"""

from __future__ import annotations

import timeit
from collections.abc import Callable
from typing import Any

import numpy as np
import veridem


def in_numpy(k_n: Any, delta_e: Any, delta_f: Any, delta_n: Any) -> Any:
    """Eq. 3 as one would write it."""
    weakening = k_n * delta_e * (delta_f - delta_n) / (delta_f - delta_e)
    held = delta_n <= np.minimum(delta_e, delta_f)
    return np.where(held, k_n * delta_n, np.where(delta_n <= delta_f, weakening, 0.0))


def seconds(call: Callable[[], Any]) -> float:
    """The shortest of several measurements, each of which takes long enough."""
    timer = timeit.Timer(call)
    number, _ = timer.autorange()
    return min(timer.repeat(7, number)) / number


def main() -> None:
    print("Eq. 3, k_n and both separations as numbers; ns per value, for one value ns per call")
    print(f"{'values':>9} {'numpy':>9} {'veridem':>9} {'unchecked':>9}")
    for count in (1, 100, 10_000, 1_000_000):
        delta_n = 0.5 if count == 1 else np.linspace(-1.0, 4.0, count)
        arguments = (10.0, 1.0, 3.0, delta_n)
        force = veridem.wear.normal_force
        ways = (
            lambda: in_numpy(*arguments),
            lambda: force(*arguments),
            lambda: force(*arguments, check=False),
        )
        print(f"{count:9} " + " ".join(f"{1e9 * seconds(way) / count:9.2f}" for way in ways))

    print("Contact law of the wear paper; ns per pair")
    material = {"young_modulus": "73 GPa", "poisson_ratio": 0.17, "tensile_strength": "16 GPa", "shear_strength": "11 GPa"}
    material |= {"surface_energy": "1.5 J/m^2", "restitution": 0.8, "density": "2200 kg/m^3", "scaling": 0.5}
    law = veridem.Law({"wear": material})
    rng = np.random.default_rng(1)
    for count in (1, 100, 10_000, 100_000):
        x = rng.normal(size=(count, 3))
        x *= 5.94 / np.linalg.norm(x, axis=1, keepdims=True)
        moving = [1e-3 * rng.normal(size=(count, 3)) for _ in range(4)]
        v, omega_i, omega_j, springs = moving
        sizes = {"r_i": 3.0, "r_j": 3.0, "m_i": 0.25, "m_j": 0.25, "dt": 1e-4}
        time = seconds(lambda: law.pairs(x, v, omega_i, omega_j, springs=springs, **sizes))
        print(f"{count:9} {1e9 * time / count:9.1f}")


if __name__ == "__main__":
    main()
