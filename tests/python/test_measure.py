"""Truth, errors and the choice, as the library's own tests have them, from Python."""

import unittest

import numpy
from hair_for_tests import LIGHT, wavy

import libhair

HAIR = libhair.Strands(wavy(3000, seed=3))
FIBRE = libhair.Fibre(hairs_per_strand=3)


def truth_of(count=300, **settings):
    points = libhair.choose_points(HAIR, count)
    return libhair.truth(HAIR, LIGHT, points, fibre=FIBRE, **settings)


class Measure(unittest.TestCase):
    def test_points_are_views_of_the_chosen_strands(self):
        points = libhair.choose_points(HAIR, 100)
        self.assertEqual(len(set(points.strand)), 100)
        numpy.testing.assert_array_equal(points.position, HAIR.points[points.point])
        numpy.testing.assert_array_equal(points.point // 12, points.strand)
        position, copy = points.position, points.position.copy()
        del points
        numpy.testing.assert_array_equal(position, copy)

    def test_the_truth_in_pieces_is_the_truth(self):
        whole, half = truth_of(200, rays=64), truth_of(200, rays=1 << 14)
        self.assertLess(numpy.abs(whole.transmittance - half.transmittance).mean(), 0.03)
        self.assertTrue((half.standard_error <= whole.standard_error + 0.02).all())

    def test_the_density_map_is_near_the_truth(self):
        truth = truth_of(rays=512)
        figures = libhair.error_figures(
            libhair.shadow(HAIR, LIGHT, fibre=FIBRE)[truth.points.point], truth)
        self.assertLess(figures.mean_absolute.value, 0.04)
        self.assertGreater(figures.mean_absolute.standard_error, 0)
        self.assertEqual(float(figures.rms), figures.rms.value)

    def test_the_truth_has_no_error(self):
        truth = truth_of(50, rays=64)
        self.assertEqual(libhair.error_figures(truth.transmittance, truth).rms.value, 0)

    def test_trials_are_of_all_candidates(self):
        truth = truth_of(100, rays=64)
        steps = []
        candidates = libhair.candidates(HAIR, LIGHT)
        own = libhair.Candidate(libhair.OpacityMapSettings(slices=4), "mine")
        trials = libhair.run_trials(candidates + [own], HAIR, LIGHT, truth, 1, fibre=FIBRE,
                                    on_step=lambda: steps.append(1))
        self.assertEqual(len(steps), len(trials))
        self.assertEqual([t.candidate.label for t in trials][0], "auto")
        self.assertEqual(trials[-1].candidate.label, "mine")
        self.assertTrue(all(t.failure == "" and t.milliseconds > 0 for t in trials))
        best = min(trials, key=lambda t: t.error.mean_absolute.value)
        self.assertIs(type(best.candidate.settings), libhair.DensityMapSettings)
        self.assertIn(trials.index(best), libhair.trial_front(trials))

    def test_the_choice_keeps_its_limit(self):
        costs = libhair.calibrate(HAIR, FIBRE, repeats=1)
        kept = libhair.MachineCosts(costs.nanoseconds, costs.threads)
        numpy.testing.assert_array_equal(kept.nanoseconds, costs.nanoseconds)
        choice = libhair.choose_shadow(HAIR, LIGHT, kept, max_error=0.05, fibre=FIBRE)
        self.assertLess(choice.predicted_error.value, 0.05)
        shadow = libhair.shadow(HAIR, LIGHT, method=choice.settings, fibre=FIBRE)
        truth = truth_of(rays=512)
        figures = libhair.error_figures(shadow[truth.points.point], truth)
        self.assertLess(figures.mean_absolute.value, 0.06)
        with self.assertRaisesRegex(libhair.Error, "nearest|infinite|limit|none"):
            libhair.choose_shadow(HAIR, LIGHT, kept, max_error=1e-9, fibre=FIBRE)

    def test_truths_of_other_strands_are_refused(self):
        few = libhair.Strands(wavy(10))
        with self.assertRaisesRegex(libhair.Error, "not of these strands"):
            libhair.truth(few, LIGHT, libhair.choose_points(HAIR, 100))


if __name__ == "__main__":
    unittest.main()
