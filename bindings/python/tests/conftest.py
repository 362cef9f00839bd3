"""What several tests need."""

import pytest


@pytest.fixture(scope="session")
def silica():
    """The model of a material."""
    material = {
        "young_modulus": "73 GPa",
        "poisson_ratio": 0.17,
        "tensile_strength": "16 GPa",
        "shear_strength": "11 GPa",
        "surface_energy": "1.5 J/m^2",
        "restitution": 0.8,
        "density": "2200 kg/m^3",
        "scaling": 0.5,
    }
    return {"wear": material}
