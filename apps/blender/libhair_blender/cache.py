"""Frames of hair in a file: a header, then as many frames as it says, each all points as float32.

A frame has the same size and place whatever is in it, so playback maps the file and reads one frame.
"""

import contextlib
import json
import os

import numpy

from libhair import Error

HEADER = 256
_MAGIC = b"libhair cache 1\n"


class Output:
    """Writes beside the file and moves there when all is done: half a cache is never seen."""

    def __init__(self, path, magic):
        self.path, self.part, self.magic = path, path + ".part", magic
        self.frames = 0
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            self.file = open(self.part, "wb")
        except OSError as error:
            raise Error(f"{path}: cannot be written ({error.strerror}); choose another cache folder") from error
        self.file.write(b" " * HEADER)

    def append(self, array):
        try:
            self.file.write(numpy.ascontiguousarray(array).data)
        except OSError as error:
            raise Error(f"{self.path}: {error.strerror} after {self.frames} frames") from error

    def close(self, words):
        """words: what the header says."""
        try:
            self.file.seek(0)
            self.file.write((self.magic + json.dumps(words).encode()).ljust(HEADER))
            self.file.close()
            os.replace(self.part, self.path)
        except OSError as error:
            raise Error(f"{self.path}: {error.strerror}") from error

    def abandon(self):
        self.file.close()
        if os.path.exists(self.part):
            os.remove(self.part)


def header_of(path):
    """The header's bytes, and the size of the file."""
    try:
        with open(path, "rb") as file:
            return file.read(HEADER), os.path.getsize(path)
    except OSError as error:
        raise Error(f"{path}: {error.strerror}; simulate again, or free the cache") from error


@contextlib.contextmanager
def parsing(path):
    """Whatever is found inside that cannot be: the file is another, or damaged."""
    try:
        yield
    except (ValueError, KeyError, TypeError) as error:
        raise Error(f"{path}: no cache of hair, or not all of one; simulate again") from error


def words_of(header, magic):
    if not header.startswith(magic):
        raise ValueError
    return json.loads(header[len(magic) :])


class Writer(Output):
    def __init__(self, path, first_frame, point_count):
        super().__init__(path, _MAGIC)
        self.first_frame, self.point_count = first_frame, point_count

    def add(self, points):
        """(N, 3) float32: the next frame."""
        self.append(numpy.asarray(points, numpy.float32))
        self.frames += 1

    def finish(self):
        self.close({"first_frame": self.first_frame, "frames": self.frames, "points": self.point_count})


class Reader:
    """Frames of a file, read when they are asked for."""

    def __init__(self, path):
        header, size = header_of(path)
        with parsing(path):
            words = words_of(header, _MAGIC)
            self.first_frame = int(words["first_frame"])
            shape = (int(words["frames"]), int(words["points"]), 3)
            if min(shape) < 1 or size != HEADER + 4 * shape[0] * shape[1] * shape[2]:
                raise ValueError
        self.frames, self.point_count = shape[:2]
        self._values = numpy.memmap(path, numpy.float32, "r", HEADER, shape)

    @property
    def last_frame(self):
        return self.first_frame + self.frames - 1

    def points(self, frame):
        """(N, 3) float32 at a frame; between two on the line from one to the other, and beyond the
        ends as at the ends."""
        at = min(max(frame - self.first_frame, 0), self.frames - 1)
        before = int(at)
        share = at - before
        if not share:
            return numpy.array(self._values[before])
        return (1 - numpy.float32(share)) * self._values[before] + numpy.float32(share) * self._values[
            before + 1
        ]


_open = {}


def reader(path, kind=Reader):
    """The reader of a file, opened again when the file is another."""
    try:
        state = os.stat(path)
        stamp = (state.st_mtime_ns, state.st_size, state.st_ino)
    except OSError:
        stamp = None
    known = _open.get(path)
    if known is None or known[0] != stamp:
        _open.pop(path, None)
        known = _open[path] = (stamp, kind(path))
    return known[1]


def remove(path):
    _open.pop(path, None)
    if os.path.exists(path):
        os.remove(path)
