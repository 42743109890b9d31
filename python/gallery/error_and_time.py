"""What each shadow method costs, and how far from the truth it is, on one head of hair.

usage: error_and_time.py [OUTPUT_FOLDER]
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import libhair

# The smooth style at rest with three times the strands, so that each is a fibre of few hairs.
style = libhair.style_settings("smooth").replace(strands=10050)
groom = libhair.make_groom(style)
fibre = groom.fibre.replace(width=groom.fibre.width * groom.fibre.hairs_per_strand,
                            hairs_per_strand=1)
strands = libhair.Simulation(groom).strands
light = libhair.Light.parallel((0.45, -0.8, -0.4))
footprint = 3e-3

points = libhair.choose_points(strands, 1000)
truth = libhair.truth(strands, light, points, footprint, rays=512, fibre=fibre)
candidates = libhair.candidates(strands, light, footprint, "all")
trials = libhair.run_trials(candidates, strands, light, truth, 1, fibre=fibre)
trials = [t for t in trials if not t.failure]

figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
markers = iter("*osD^vP")
for method in dict.fromkeys(t.candidate.method for t in trials):
    own = [t for t in trials if t.candidate.method == method]
    axes.scatter([t.milliseconds for t in own], [t.error.mean_absolute.value for t in own],
                 s=90 if method == "auto" else 22, marker=next(markers), alpha=0.8,
                 zorder=3 if method == "auto" else 2, label=method)
front = [trials[i] for i in libhair.trial_front(trials)]
axes.plot([t.milliseconds for t in front], [t.error.mean_absolute.value for t in front],
          "k-", lw=0.8, zorder=1, label="no other is better in both")
axes.set(xscale="log", yscale="log", xlabel="build and sample at all points (ms)",
         ylabel="mean absolute error of transmittance",
         title=f"{len(strands)} strands, {strands.point_count} points, footprint 3 mm, "
               f"{libhair.thread_count()} threads")
axes.yaxis.set_minor_formatter("{x:.3f}")
axes.yaxis.set_major_formatter("{x:.2f}")
axes.grid(which="both", lw=0.3)
axes.legend(frameon=False)
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out")
folder.mkdir(parents=True, exist_ok=True)
figure.savefig(folder / "error_and_time.png", dpi=100)
