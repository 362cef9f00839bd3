# SPDX-License-Identifier: GPL-2.0-or-later
"""Small cases of the three papers, and the same laws as pair styles."""

SILICA = """wear: {young_modulus: 73 GPa, poisson_ratio: 0.17, tensile_strength: 16 GPa, shear_strength: 9 GPa,
         surface_energy: 1.5 J/m^2, restitution: 0.9, density: 2.2 g/cm^3, scaling: 0.5}"""
SAMPLE = "amorphous: {diameter: 3 nm, largest: 4.5 nm, size: [24 nm, 24 nm, 18 nm], relaxation: {repulsion_steps: 200, residual_stress: 1e-3 E}}"
WEAR = (
    "veridem/wear young_modulus 73000 poisson_ratio 0.17 tensile_strength 16000 shear_strength 9000 surface_energy 1500 "
    "restitution 0.9 scaling 0.5"
)
SOOT = (
    "veridem/soot neck_springs 1e9 1e10 1e10 1e10 1.25e6 2.5e5 6.25e4 6.25e4 contact 1e7 1e7 1e7 1e7 5e3 1e3 250 250 "
    "capillary_force 1000"
)
TITANIA = "veridem/titania damping_constant 5.0"

JUNCTION = f"""title: A small junction
model:
  {SILICA}
sample:
  {SAMPLE}
experiment:
  junction: {{diameter: 9 nm, walls: 3 nm, shear_velocity: 100 m/s, normal_stress: 100 MPa, duration: 600 steps}}
output: {{digits: all, columns: [torque], frames: 300 steps, checkpoints: 300 steps}}
"""

PATCH = f"""title: A patch in shear
model:
  {SILICA}
sample:
  {SAMPLE}
experiment:
  patch: {{walls: 3 nm, shear: {{strain_per_step: 1e-5, strain: 0.03, damping: 5e-13 kg/s}}}}
output: {{digits: all, columns: [torque], frames: 1000 steps}}
"""

RELAXATION = JUNCTION.replace("repulsion_steps: 200", "repulsion_steps: 100").replace("frames: 300 steps, checkpoints: 300 steps", "series: 20 steps")

PUBLISHED = f"""title: A lattice in shear by the law of the published program
model:
  {SILICA.replace("scaling: 0.5", "scaling: 0.5, readings: as-published")}
sample: {{hcp: {{diameter: 3 nm, size: [6 d_0, 8 d_0, 3 d_0]}}}}
experiment: {{patch: {{shear: {{strain_per_step: 1e-4, strain: 0.3}}}}}}
output: {{series: 20 steps}}
"""

AGGREGATE = """title: A collapsing aggregate, half of whose contacts are necks
model: {soot: {}}
sample: {aggregate: {spheres: 60, growth: spheres, fractal_dimension: 2.2, neck_fraction: 0.5}}
experiment: {restructuring: {dt: 5 fs, duration: 0.505 ns}}
output: {digits: all, columns: [torque], frames: [0.5, 0.505 ns]}
"""

BREAKING = """title: An aggregate whose necks break
model: {{soot: {{necks: S, {strength}}}}}
sample: {{aggregate: {{spheres: 60, growth: spheres, fractal_dimension: 2.2, neck_fraction: 1}}}}
experiment: {{restructuring: {{dt: 50 fs, duration: 10 ns, integrator: {integrator}}}}}
output: {{series: 100 steps}}
"""

FILM = """title: A small film under a small tip
seed: 5
model: {titania: {damping_constant: 5e6 N s/m^3}}
sample:
  film: {particles: 260, sides: [140 nm, 140 nm], aggregates: {median: 12, largest: 24}}
experiment:
  spectroscopy:
    relaxation: 2 ns
    tip: {radius: 10 nm, side: 60 nm}
    speed: 5 m/s
    setpoint: 40 pN
    reversal: 4 ns
    depth: 60 nm
    retraction: 160 nm
    dt: 0.5 ps
output: {digits: all, columns: [torque], frames: 10 ns}
"""

DEPOSITION = """title: An aggregate hits a plane
model: {soot: {necks: S, cutoff: 42 nm}}
sample: {aggregate: {spheres: 20, neck_fraction: 1}}
experiment: {deposition: {velocity: 5 m/s, gap: 0.1 r, duration: 0.6 ns, dt: 50 fs}}
output: {digits: all, columns: [torque], series: 100 steps, frames: 0.6 ns}
"""

NECKS = """title: A film whose necks break
seed: 5
model:
  titania:
    damping_constant: 5e6 N s/m^3
    neck_springs: {normal_stiffness: 91 N/m, tangential_stiffness: 36 N/m, rolling_stiffness: 5.2 N/m, torsional_stiffness: 4.1 N/m,
                   normal_damping: 5e-11 kg/s, tangential_damping: 3e-11 kg/s, rolling_damping: 1e-11 kg/s, torsional_damping: 1e-11 kg/s}
    break_energy: 1e-20 J
sample: {film: {particles: 160, sides: [140 nm, 140 nm], aggregates: {median: 12, largest: 24}}}
experiment:
  spectroscopy: {relaxation: 1 ns, tip: {radius: 10 nm, side: 60 nm}, speed: 10 m/s, setpoint: 100 pN, reversal: 2 ns, average: 0.5 ns,
                 depth: 60 nm, retraction: 100 nm, dt: 0.25 ps}
output: {series: 100 steps}
"""

CHAIN = """title: An agglomerate that a spring pulls
model: {{titania: {{damping_constant: 5e6 N s/m^3}}}}
sample: {{agglomerate: {{particles: 6, length: 32 nm, smallest: 8 nm, largest: 12 nm}}}}
experiment:
  stretching: {{relaxation: 0.1 ns, drawn: 2, hold: {hold}, spring_along: {along}, ramp: 0.2 ns, distance: 2 nm, dt: 0.5 ps}}
output: {{series: 100 steps}}
"""

COLLISION = """title: Two rigid bodies collide
model: {{titania: {{}}}}
sample: {{agglomerate: {{import: {{file: {file}, unit: 1 nm, disconnected: true}}}}}}
experiment: {{release: {{duration: 0.3 ns, dt: {dt} ps}}}}
output: {{digits: all, columns: [torque], frames: 0.3 ns}}
"""
