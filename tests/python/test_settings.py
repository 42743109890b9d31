"""Settings: fields by keyword, the library's defaults, words for enumerations."""

import copy
import pickle
import unittest

import numpy

import libhair

CLASSES = [c for c in vars(libhair).values() if isinstance(c, type) and hasattr(c, "_fields")]


class Settings(unittest.TestCase):
    def test_there_are_settings(self):
        self.assertIn(libhair.FrameSettings, CLASSES)
        self.assertGreater(len(CLASSES), 12)

    def test_every_field_can_be_given_read_and_set(self):
        for cls in CLASSES:
            default = cls()
            for field in cls._fields:
                with self.subTest(f"{cls.__name__}.{field}"):
                    value = getattr(default, field)
                    self.assertEqual(cls(**{field: value}), default)
                    other = cls()
                    setattr(other, field, value)
                    self.assertEqual(other, default)
                    self.assertIn(f"{field}=", repr(default))

    def test_a_changed_field_is_another_value(self):
        for cls in CLASSES:
            for field in cls._fields:
                value = getattr(cls(), field)
                if isinstance(value, bool):
                    other = not value
                elif isinstance(value, (int, float)):
                    other = value + 1
                else:
                    continue
                with self.subTest(f"{cls.__name__}.{field}"):
                    changed = cls().replace(**{field: other})
                    self.assertNotEqual(changed, cls())
                    numpy.testing.assert_allclose(getattr(changed, field), other, rtol=1e-6)

    def test_settings_within_settings_are_the_same_object(self):
        frame = libhair.FrameSettings()
        frame.guides.gravity = (0, 0, -1)
        self.assertEqual(frame.guides.gravity, (0, 0, -1))
        other = frame.replace(shadow=False)
        other.guides.gravity = (0, 0, 0)
        self.assertEqual(frame.guides.gravity, (0, 0, -1))

    def test_copies_and_pickles_are_equal_and_share_nothing(self):
        ways = [copy.copy, copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))]
        light = libhair.Light.point((1, 2, 3), (0.1, 0.2, 0.3))
        frame = libhair.FrameSettings(lights=[light], eye=(0.1, 0.2, 0.3))
        frame.guides.skin = 0.0123
        for way in ways:
            self.assertEqual(way(light), light)
            for settings in [frame] + [cls() for cls in CLASSES]:
                with self.subTest(type(settings).__name__):
                    other = way(settings)
                    self.assertIs(type(other), type(settings))
                    self.assertEqual(other, settings)
                    self.assertIsNot(other, settings)
            other = way(frame)
            other.guides.skin = 0.5
            other.lights = []
            self.assertAlmostEqual(frame.guides.skin, 0.0123)
            self.assertEqual(frame.lights, (light,))

    def test_what_is_no_field_or_value_is_refused(self):
        with self.assertRaisesRegex(TypeError, "no field 'gravty'; there are linear_density, "):
            libhair.GuideSettings(gravty=(0, 0, 0))
        with self.assertRaisesRegex(ValueError, "'fine' is none of: none, paper"):
            libhair.DensityMapSettings(filter="fine")
        with self.assertRaises(TypeError):
            libhair.GuideSettings(gravity=(0, 0))
        with self.assertRaises(TypeError):
            libhair.GuideSettings(skin="thick")
        with self.assertRaises(AttributeError):
            libhair.GuideSettings().gravty = 1

    def test_lights_do_not_change(self):
        light = libhair.Light.parallel((0, -1, 0))
        with self.assertRaises(AttributeError):
            light.direction = (1, 0, 0)
        self.assertEqual(libhair.FrameSettings(lights=[light]).lights, (light,))
        self.assertNotEqual(light, libhair.Light.point((0, -1, 0)))


if __name__ == "__main__":
    unittest.main()
