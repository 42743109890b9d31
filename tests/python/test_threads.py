"""How many threads a call may use."""

import asyncio
import threading
import unittest

from hair_for_tests import LIGHT, wavy

import libhair

STRANDS = libhair.Strands(wavy())


class Limits(unittest.TestCase):
    def test_limits_nest(self):
        before = libhair.thread_count()
        with libhair.thread_limit(3):
            self.assertEqual(libhair.thread_count(), 3)
            with libhair.thread_limit(1):
                self.assertEqual(libhair.thread_count(), 1)
            self.assertEqual(libhair.thread_count(), 3)
        self.assertEqual(libhair.thread_count(), before)

    def test_a_limit_is_entered_once_at_a_time(self):
        limit = libhair.thread_limit(2)
        with limit:
            with self.assertRaisesRegex(RuntimeError, "twice"):
                limit.__enter__()
        with self.assertRaisesRegex(RuntimeError, "not entered"):
            limit.__exit__(None, None, None)
        with limit:
            self.assertEqual(libhair.thread_count(), 2)

    def test_limits_may_be_left_in_any_order(self):
        before = libhair.thread_count()
        a, b, c = (libhair.thread_limit(n) for n in (5, 6, 7))
        for limit in (a, b, c):
            limit.__enter__()
        b.__exit__(None, None, None)
        self.assertEqual(libhair.thread_count(), 7)
        c.__exit__(None, None, None)
        self.assertEqual(libhair.thread_count(), 5)
        b.__enter__()
        a.__exit__(None, None, None)
        self.assertEqual(libhair.thread_count(), 6)
        b.__exit__(None, None, None)
        del a, b, c
        self.assertEqual(libhair.thread_count(), before)
        libhair.shadow(STRANDS, LIGHT)

    def test_tasks_have_limits_of_their_own(self):
        seen = []

        async def task(threads, turns):
            with libhair.thread_limit(threads):
                for _ in range(turns):
                    await asyncio.sleep(0)
                    libhair.shadow(STRANDS, LIGHT)
                    seen.append((threads, libhair.thread_count()))

        async def both():
            await asyncio.gather(task(5, 2), task(6, 4))

        before = libhair.thread_count()
        asyncio.run(both())
        self.assertEqual(len(seen), 6)
        self.assertEqual([asked for asked, _ in seen], [had for _, had in seen])
        self.assertEqual(libhair.thread_count(), before)

    def test_generators_end_in_any_order(self):
        def limited(threads):
            with libhair.thread_limit(threads):
                yield libhair.thread_count()

        before = libhair.thread_count()
        a, b = limited(5), limited(6)
        self.assertEqual((next(a), next(b)), (5, 6))
        a.close()
        self.assertEqual(libhair.thread_count(), 6)
        b.close()
        self.assertEqual(libhair.thread_count(), before)

    def test_what_another_thread_ends_or_collects_is_over(self):
        before = libhair.thread_count()
        entered, dropped = libhair.thread_limit(5), [libhair.thread_limit(6)]
        entered.__enter__()
        dropped[0].__enter__()
        counts = []

        def end(work):
            def run():
                counts.append(libhair.thread_count())
                work()
                counts.append(libhair.thread_count())

            thread = threading.Thread(target=run)
            thread.start()
            thread.join()
            return libhair.thread_count()

        self.assertEqual(end(dropped.clear), 5)
        self.assertEqual(end(lambda: entered.__exit__(None, None, None)), before)
        # Limits are of the thread that entered them.
        self.assertEqual(counts, [before] * 4)

    def test_numbers_that_cannot_be_are_refused(self):
        for threads in (-1, 1025):
            with self.assertRaises(libhair.Error):
                libhair.thread_limit(threads)


if __name__ == "__main__":
    unittest.main()
