"""Light through a slab of hair falls off as Beer's law says, and how well each method keeps it.

usage: beers_law.py [OUTPUT_FOLDER]
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import libhair

# 6000 straight fibres along x, anywhere in a slab of 10 x 10 x 10 cm; light falls along z.
count, side = 6000, 0.1
fibre = libhair.Fibre(width=80e-6, opacity=0.6, hairs_per_strand=1)
random = np.random.default_rng(1)
points = np.empty((count, 2, 3), np.float32)
points[:, :, 0] = [0, side]
points[:, :, 1:] = side * random.random((count, 1, 2))
strands = libhair.Strands(points)
light = libhair.Light.parallel((0, 0, 1))

# A fibre takes its opacity of the light that meets its width.
depth = np.linspace(-0.01, 0.11, 121, dtype=np.float32)
law = np.exp(-count * fibre.width * fibre.opacity / side**2 * depth.clip(0, side))

# Look at 400 places at each depth, away from the sides.
places = np.empty((len(depth), 400, 3), np.float32)
places[..., :2] = 0.02 + 0.06 * random.random((1, 400, 2))
places[..., 2] = depth[:, None]
methods = {
    "density map": None,  # as the library chooses it
    "opacity map, 16 slices": libhair.OpacityMapSettings(slices=16),
    "deep opacity map, 7 layers": libhair.DeepOpacityMapSettings(depth=side),
    "deep shadow map": libhair.DeepShadowMapSettings(),
    "shadow map": libhair.ShadowMapSettings(),
}
figure, (axes, off) = plt.subplots(2, 1, figsize=(7.5, 6), sharex=True, height_ratios=(2, 1),
                                   layout="constrained")
for name, method in methods.items():
    seen = libhair.shadow(strands, light, 3e-3, fibre=fibre, method=method,
                          at=places.reshape(-1, 3)).reshape(len(depth), -1).mean(axis=1)
    axes.plot(1000 * depth, seen, lw=1.4, label=name)
    off.plot(1000 * depth, seen - law, lw=1.4)
axes.plot(1000 * depth, law, "k--", lw=1, label="Beer's law")
for panel in (axes, off):
    panel.axvspan(0, 1000 * side, color="0.94", zorder=0)
off.set(xlabel="depth in the slab (mm)", ylabel="seen - law", ylim=(-0.02, 0.02))
axes.set(ylabel="mean transmittance", ylim=(0, 1.03), xlim=(-10, 110), title=f"{count} fibres of {1e6 * fibre.width:.0f} µm in a slab of 10 cm")
axes.legend(frameon=False)
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out")
folder.mkdir(parents=True, exist_ok=True)
figure.savefig(folder / "beers_law.png", dpi=100)
