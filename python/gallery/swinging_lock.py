"""A lock of hair, bound from arrays, swings as the head under it moves to and fro.

usage: swinging_lock.py [OUTPUT_FOLDER]
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

import libhair

# 300 strands of 0.3 m that hang from a patch of 2 cm and come together below. Metres, +Y up.
random = np.random.default_rng(2)
root = 0.02 * (random.random((300, 1, 3)) - 0.5) * [1, 0, 1]
u = np.linspace(0, 1, 24)[None, :, None]
wave = 0.004 * np.sin(14 * u + [0, 0, 1.5]) * [1, 0, 1] * u
points = root * (1 - 0.6 * u) + wave - [0, 0.3, 0] * u
groom = libhair.bind_groom(libhair.Strands(points.astype(np.float32)),
                           libhair.BindSettings(guides=30))

frame = libhair.FrameSettings(shadow=False, shade=False)
simulation = libhair.Simulation(groom, frame)
fps, frames = 60, 150
figure, (upper, lower) = plt.subplots(2, 1, figsize=(9, 6), layout="constrained")
swing = []
for i in range(frames):
    time = (i + 1) / fps
    x = 0.08 * np.sin(2 * np.pi * time) if time < 1 else 0.0  # to and fro once, then still
    simulation.step(1 / fps, world_from_head=libhair.Transform(translation=(x, 0, 0)))
    tips = simulation.points[simulation.first[1:] - 1]
    swing.append((time, x, tips[:, 0].mean(), tips[:, 0].std()))
    if i % 10 == 4 and i < 100:
        lock = [100 * s[:, :2] + [12 * (i // 10), 0] for s in simulation.strands]
        upper.add_collection(LineCollection(lock, colors="saddlebrown", lw=0.15, alpha=0.6))
        upper.text(12 * (i // 10), 1.5, f"{time:.2f} s", ha="center", fontsize=8)
upper.set(title="every tenth frame, each 12 cm to the right", xlabel="x (cm)", ylabel="y (cm)",
         xlim=(-14, 122), ylim=(-33, 4), aspect="equal")
t, head, tip, spread = np.array(swing).T
lower.plot(t, 100 * head, "k--", label="head")
lower.plot(t, 100 * tip, color="saddlebrown", label="tips, mean and deviation")
lower.fill_between(t, 100 * (tip - spread), 100 * (tip + spread), color="saddlebrown", alpha=0.25)
lower.set(title="the tips follow, overshoot and come to rest", xlabel="time (s)", ylabel="x (cm)")
lower.legend(frameon=False)
lower.grid(lw=0.3)
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out")
folder.mkdir(parents=True, exist_ok=True)
figure.savefig(folder / "swinging_lock.png", dpi=100)
