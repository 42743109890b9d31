"""How many threads a call may use."""

import threading
import unittest

import libhair


class Limits(unittest.TestCase):
    def test_limits_nest(self):
        before = libhair.thread_count()
        with libhair.thread_limit(3):
            self.assertEqual(libhair.thread_count(), 3)
            with libhair.thread_limit(1):
                self.assertEqual(libhair.thread_count(), 1)
            self.assertEqual(libhair.thread_count(), 3)
        self.assertEqual(libhair.thread_count(), before)

    def test_a_limit_is_left_by_who_entered_it(self):
        limit = libhair.thread_limit(2)
        errors = []

        def leave():
            try:
                limit.__exit__(None, None, None)
            except RuntimeError as error:
                errors.append(error)

        with limit:
            thread = threading.Thread(target=leave)
            thread.start()
            thread.join()
            with self.assertRaisesRegex(RuntimeError, "twice"):
                limit.__enter__()
        self.assertEqual(len(errors), 1)

    def test_numbers_that_cannot_be_are_refused(self):
        for threads in (-1, 1025):
            with self.assertRaises(libhair.Error):
                libhair.thread_limit(threads)


if __name__ == "__main__":
    unittest.main()
