"""The C interface from another language, without a compiler: from_python.py LIBRARY."""
import ctypes as c
import math
import sys

hair = c.CDLL(sys.argv[1])
hair.hair_last_error.restype = c.c_char_p


class Strands(c.Structure):
    _fields_ = [("points", c.POINTER(c.c_float)), ("first", c.POINTER(c.c_uint32)),
                ("point_count", c.c_uint32), ("strand_count", c.c_uint32)]


class Light(c.Structure):
    _fields_ = [("kind", c.c_uint32), ("direction", c.c_float * 3), ("position", c.c_float * 3),
                ("colour", c.c_float * 3)]


# A wall of level strands, a millimetre apart; light from above.
n = 60
points = [x for i in range(n * n) for k in range(2)
          for x in (0.1 * k, -1e-3 * (i // n), 1e-3 * (i % n))]
strands = Strands((c.c_float * len(points))(*points),
                  (c.c_uint32 * (n * n + 1))(*range(0, 2 * n * n + 1, 2)), 2 * n * n, n * n)
fibre = (c.c_float * 3)(1e-4, 0.5, 1)
light = Light(0, (0, -1, 0), (0, 0, 0), (1, 1, 1))
left = (c.c_float * (2 * n * n))()
shadow = c.c_void_p()
assert hair.hair_shadow_create(c.byref(shadow)) == 0
assert hair.hair_shadow_compute(shadow, c.byref(strands), fibre, c.byref(light), None, left) == 0
middle = c.c_float()
for depth in (0, 0.015, 0.03, 0.05):
    at = (c.c_float * 3)(0.05, -depth, 0.03)
    assert hair.hair_shadow_sample(shadow, at, c.c_size_t(1), c.byref(middle)) == 0
    expected = math.exp(-depth * 1e-4 * 0.5 / 1e-6)
    print(f"{1e3 * depth:.0f} mm deep: light {middle.value:.3f}, Beer's law {expected:.3f}")
    assert abs(middle.value - expected) < 0.12
hair.hair_shadow_destroy(shadow)
assert hair.hair_step(None, None, c.c_float(1)) == 1
print("refused:", hair.hair_last_error().decode())
