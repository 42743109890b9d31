"""The density map looked into: hair in slices along the light, and what light gets there.

usage: density_slices.py [OUTPUT_FOLDER]
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import libhair

groom = libhair.make_groom("curly")
strands = libhair.Simulation(groom).strands
light = libhair.Light.parallel((0, -1, 0))  # from above: slices are level
settings = libhair.DensityMapSettings(cells=192, cell_size=4e-3)

density = libhair.DensityMap(settings, light)
density.deposit(strands, groom.fibre)
density.compute_transmittance()
centres = density.cell_centres()  # (I, J, K, 3), I along the light
lit = density.sample(centres.reshape(-1, 3)).reshape(centres.shape[:3])
# Of a cell, optical depth a cubic metre; times its face, optical depth a metre of the way.
grid = np.ma.masked_equal(density.density_grid(), 0) * settings.cell_size**2 / 1000

x, z = 100 * centres[0, :, :, 0], 100 * centres[0, :, :, 2]
figure, axes = plt.subplots(2, 4, figsize=(12.5, 6), sharex=True, sharey=True,
                            layout="constrained")
for column, share in enumerate((0.08, 0.2, 0.45, 0.75)):
    i = int(share * len(centres))
    dense = axes[0, column].pcolormesh(x, z, grid[i], cmap="YlOrBr", vmin=0, vmax=grid.max() / 2)
    light_there = axes[1, column].pcolormesh(x, z, lit[i], cmap="gray", vmin=0, vmax=1)
    axes[0, column].set_title(f"y = {100 * centres[i, 0, 0, 1]:.1f} cm")
    axes[1, column].set_xlabel("x (cm)")
for row in axes:
    row[0].set_ylabel("z (cm), the face is on top")
    for panel in row:
        panel.set(aspect="equal", xlim=(-15, 15), ylim=(-16, 13))
figure.colorbar(dense, ax=axes[0], label="optical depth per mm")
figure.colorbar(light_there, ax=axes[1], label="transmittance")
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out")
folder.mkdir(parents=True, exist_ok=True)
figure.savefig(folder / "density_slices.png", dpi=100)
