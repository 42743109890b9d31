"""Lines of a simulation's inside in a file beside its frames: as many as each frame has.

A header, then for each frame and each inside the ends of its lines, (2 n, 3) float32, and their
colours, (2 n, 4) uint8; at the end how many ends each has, (frames, insides) int64.
"""

import os

import numpy

from . import cache

_MAGIC = b"libhair lines 1\n"
_END = 16  # bytes of an end and its colour


def file_of(cache_path):
    return cache_path + ".lines"


class Writer(cache.Output):
    """insides: the names of what each frame has."""

    def __init__(self, path, first_frame, insides):
        super().__init__(path, _MAGIC)
        self.first_frame, self.insides, self.counts = first_frame, insides, []

    def add(self, lines):
        """The next frame: of each inside (positions, colours)."""
        for positions, colours in lines:
            self.append(numpy.asarray(positions, numpy.float32))
            self.append(numpy.asarray(colours, numpy.uint8))
        self.counts.append([len(positions) for positions, _ in lines])
        self.frames += 1

    def finish(self):
        self.append(numpy.array(self.counts, "<i8"))
        self.close({"first_frame": self.first_frame, "frames": self.frames, "insides": self.insides})


class Reader:
    def __init__(self, path):
        header, size = cache.header_of(path)
        with cache.parsing(path):
            words = cache.words_of(header, _MAGIC)
            self.first_frame, self.frames = int(words["first_frame"]), int(words["frames"])
            self.insides = [str(name) for name in words["insides"]]
            shape = (self.frames, len(self.insides))
            ends = size - 8 * shape[0] * shape[1]
            if min(shape) < 1 or ends < cache.HEADER:
                raise ValueError
            self._counts = numpy.fromfile(path, "<i8", offset=ends).reshape(shape)
            if (self._counts < 0).any() or cache.HEADER + _END * self._counts.sum() != ends:
                raise ValueError
        before = numpy.cumsum(self._counts.reshape(-1)) - self._counts.reshape(-1)
        self._starts = cache.HEADER + _END * before.reshape(shape)
        self.path = path

    def lines(self, frame, insides):
        """(positions, colours) of those insides that the file has, at the nearest frame."""
        at = min(max(round(frame) - self.first_frame, 0), self.frames - 1)
        positions, colours = [numpy.empty((0, 3), numpy.float32)], [numpy.empty((0, 4), numpy.uint8)]
        with open(self.path, "rb") as file:
            for i, name in enumerate(self.insides):
                if name not in insides:
                    continue
                count = int(self._counts[at, i])
                file.seek(int(self._starts[at, i]))
                positions.append(numpy.fromfile(file, numpy.float32, 3 * count).reshape(-1, 3))
                colours.append(numpy.fromfile(file, numpy.uint8, 4 * count).reshape(-1, 4))
        return numpy.concatenate(positions), numpy.concatenate(colours)


def reader(cache_path):
    """The Reader of what was kept beside a cache; None: nothing was."""
    path = file_of(cache_path)
    return cache.reader(path, Reader) if os.path.exists(path) else None
