"""Hair simulated and shadowed on the CPU.

Metres, seconds, radians; +Y up, +Z where the face looks. Large arrays are NumPy arrays of exactly
the stated type, C-contiguous, and are used in place; results are views that keep what they look at.
Small things (a place, a colour, capsules) take any sequence. Error, a ValueError, is the library's
own refusal and says which knob to turn. Long calls let other Python threads run.
"""

from . import _libhair
from ._libhair import *  # noqa: F403: the names below
from ._libhair import __version__

__all__ = [name for name in dir(_libhair) if not name.startswith("_")]
