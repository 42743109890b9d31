"""Small hair that tests share."""

import functools

import numpy

import libhair


def wavy(strands=200, points=12, seed=1):
    """(S, P, 3) float32: strands of 0.3 m that hang from a square of 0.2 m."""
    random = numpy.random.default_rng(seed)
    roots = random.random((strands, 1, 3)) * [0.2, 0, 0.2]
    down = numpy.linspace(0, 1, points)[None, :, None]
    phase = random.random((strands, 1, 1)) * 6
    return (roots + [0, 1, 0] - down * [0, 0.3, 0] + 0.01 * numpy.sin(6 * down + phase)).astype(
        numpy.float32
    )


@functools.cache
def head_field():
    return libhair.DistanceField(libhair.builtin_head())


@functools.cache
def small_groom():
    settings = libhair.style_settings("smooth").replace(strands=120, wisps=12, points=12)
    return libhair.make_groom(settings, head_field())


def small_simulation(**settings):
    frame = libhair.fit_map(libhair.FrameSettings(**settings), small_groom(), cells=64)
    return libhair.Simulation(small_groom(), frame, head=head_field())


LIGHT = libhair.Light.parallel((0.45, -0.8, -0.4))
