"""Shadows on strands of one's own: points in, one number a point out.

usage: shadow_my_strands.py [OUTPUT_FOLDER]
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

import libhair

# A tuft: 2500 strands of 24 points that rise from a disc, spread, and curl. Metres, +Y up.
random = np.random.default_rng(7)
angle, out = random.random((2, 2500, 1)) * [[[2 * np.pi]], [[1]]]
radius = 0.05 * np.sqrt(out)
u = np.linspace(0, 1, 24)[None, :]
lean = radius + 0.09 * u**1.6 * np.sqrt(out) + 0.004 * np.cos(25 * u + 6 * angle)
turn = angle + 0.5 * u + 0.06 * np.sin(25 * u + 6 * angle)
height = (0.16 - 0.07 * out) * u * (1 + 0.1 * random.standard_normal((2500, 1)))
points = np.stack([lean * np.cos(turn), height, lean * np.sin(turn)], axis=-1)

# The three lines that matter:
strands = libhair.Strands(points.astype(np.float32))
light = libhair.Light.parallel((1, -1, -0.3))
transmittance = libhair.shadow(strands, light, footprint=3e-3)
look = libhair.KajiyaKaySettings(root_colour=(0.3, 0.13, 0.05), tip_colour=(0.5, 0.27, 0.11))
eye = (0, 0.2, 1)
lit = libhair.shade(strands, [light], look, eye=eye)
shadowed = libhair.shade(strands, [light], look, eye=eye, transmittance=transmittance[None])
lit, shadowed = libhair.encode_srgb(lit), libhair.encode_srgb(shadowed)


def draw(axes, values, title):
    """Segments back to front, as the eye on +Z sees them; values: (N, 4) colours or (N,)."""
    p = strands.points.reshape(-1, 24, 3)
    segments = np.stack([p[:, :-1], p[:, 1:]], axis=2).reshape(-1, 2, 3)
    of = values.reshape(2500, 24, -1)[:, :-1].reshape(len(segments), -1)
    order = segments[:, 0, 2].argsort()
    lines = LineCollection(1000 * segments[order, :, :2], lw=0.5, cmap="inferno")
    if of.shape[1] == 4:
        lines.set_color(of[order] / 255)
    else:
        lines.set(array=of[order, 0], clim=(0, 1))
    axes.add_collection(lines)
    axes.set(title=title, xlabel="x (mm)", xlim=(-160, 160), ylim=(-10, 190), aspect="equal")
    return lines


figure, axes = plt.subplots(1, 3, figsize=(13, 3.3), sharey=True, layout="constrained")
draw(axes[0], lit, "shaded, no shadows")
draw(axes[1], shadowed, "shaded with shadows")
numbers = draw(axes[2], transmittance, "transmittance, light from the upper left")
axes[0].set_ylabel("y (mm)")
figure.colorbar(numbers, ax=axes[2], label="share of the light that arrives", shrink=0.85)
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out")
folder.mkdir(parents=True, exist_ok=True)
figure.savefig(folder / "shadow_my_strands.png", dpi=100)
