"""Six moments of the built-in dance: simulated, shadowed and shaded hair on head and body.

usage: dance_frames.py [OUTPUT_FOLDER]
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

import libhair

head = libhair.builtin_head()
field = libhair.DistanceField(head)
groom = libhair.make_groom("smooth", field)
motion = libhair.Motion.dance()
light = libhair.Light.parallel((0.45, -0.8, -0.4))
settings = libhair.FrameSettings(lights=[light], body_shadow=True)
simulation = libhair.Simulation(groom, libhair.fit_map(settings, groom), head=field,
                                pose=motion.pose(0))
simulation.restart()


def skin(axes, positions, triangles, colour):
    """Triangles that face +Z, back to front, lit a little from above."""
    corners = positions[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True) + 1e-12
    seen = normal[:, 2] > 0
    order = np.flatnonzero(seen)[corners[seen, :, 2].mean(axis=1).argsort()]
    light = 0.35 + 0.65 * (normal[order] @ [-0.45, 0.8, 0.4]).clip(0, 1)[:, None]
    axes.add_collection(PolyCollection(corners[order, :, :2], lw=0, antialiaseds=False,
                                       facecolors=light * colour))


figure, panels = plt.subplots(1, 6, figsize=(14, 3.7), layout="constrained")
for axes, seconds in zip(panels, (0.5, 3.0, 5.2, 7.4, 9.6, 12.2)):
    simulation.run(round((seconds - simulation.time) * 60), motion=motion)
    pose, points = motion.pose(simulation.time), simulation.points
    body = motion.body_mesh(pose)
    skin(axes, body.positions, body.triangles, np.array([0.36, 0.4, 0.46]))
    skin(axes, pose.world_from_head.apply(head.positions), head.triangles,
         np.array([0.86, 0.66, 0.55]))
    # Segments back to front; none from a tip to the next root, and none behind the head.
    at = np.delete(np.arange(len(points)), simulation.first[1:] - 1)
    at = at[points[at, 2].argsort()]
    front = points[at] + np.array([0, 0, 0.05], np.float32)
    at = at[field.distance(pose.world_from_head.inverse().apply(front)) > 0]
    axes.add_collection(LineCollection(points[np.stack([at, at + 1], 1), :2], lw=0.45,
                                       colors=simulation.colours[at] / 255))
    x, y, _ = pose.world_from_head.translation
    axes.set(xlim=(x - 0.32, x + 0.32), ylim=(y - 0.5, y + 0.35), aspect="equal",
             title=f"{simulation.time:.1f} s", xlabel="x (m)", facecolor="0.93")
panels[0].set_ylabel("y (m)")
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out")
folder.mkdir(parents=True, exist_ok=True)
figure.savefig(folder / "dance_frames.png", dpi=100)
