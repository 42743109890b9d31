"""Blender's space and libhair's: the one place where they meet.

Blender: +Z up, a face looks to -Y, units of `scale` metres. libhair: +Y up, a face looks to +Z,
metres. So (x, y, z) of Blender is scale * (x, z, -y) of libhair: coordinates change places and one
its sign, which is exact.
"""

import numpy

# libhair from Blender, without the scale: a turn by a quarter.
TURN = numpy.array([[1, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]], float)


def scale_of(scene):
    """Metres of one of the scene's units."""
    return scene.unit_settings.scale_length


def to_libhair(points, scale=1.0):
    """(N, 3) of Blender's, in metres; float64 stays float64."""
    points = numpy.asarray(points)
    turned = numpy.stack((points[..., 0], points[..., 2], -points[..., 1]), axis=-1)
    return turned if scale == 1 else turned * scale


def from_libhair(points, scale=1.0):
    """The way back."""
    points = numpy.asarray(points)
    turned = numpy.stack((points[..., 0], -points[..., 2], points[..., 1]), axis=-1)
    return turned if scale == 1 else turned / scale


def place(matrix, scale=1.0):
    """A matrix of Blender's as one between libhair's spaces: (4, 4) float64."""
    matrix = TURN @ numpy.array(matrix, float) @ TURN.T
    matrix[:3, 3] *= scale
    return matrix


def move(matrix, points):
    """(N, 3) moved by a (4, 4) matrix, float64."""
    matrix = numpy.asarray(matrix, float)
    return numpy.asarray(points, float) @ matrix[:3, :3].T + matrix[:3, 3]


def packed(points):
    """The same as libhair takes it: float32, C-contiguous."""
    return numpy.ascontiguousarray(points, numpy.float32)
