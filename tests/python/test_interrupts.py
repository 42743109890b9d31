"""Long calls let other Python threads run, and stop where they are told to."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

from hair_for_tests import LIGHT, small_simulation, wavy

import libhair

# Runs until it is interrupted; says when it has begun and how it ended.
CHILD = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
import libhair
from hair_for_tests import LIGHT, small_simulation, wavy
{setup}
print("begun", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    {after}
    sys.exit(0)
print("went on to its end", flush=True)
sys.exit(1)
"""


def interrupt(setup, call, after="pass"):
    """What a process says that gets SIGINT while it is in `call`."""
    child = subprocess.Popen(
        [sys.executable, "-c", CHILD.format(setup=setup, call=call, after=after)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=os.environ)
    try:
        begun = child.stdout.readline()
        # Some way into the call, without a clock: only the first signal is caught.
        threading.Event().wait(0.3)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=120)
    finally:
        child.kill()
    return begun + out, err, child.returncode


class Interrupts(unittest.TestCase):
    def assertStops(self, *case):
        out, err, code = interrupt(*case)
        self.assertEqual((out.split()[:2], code), (["begun", "interrupted"], 0), out + err)
        return out

    def test_a_run_stops_between_two_frames_and_can_go_on(self):
        out = self.assertStops("s = small_simulation()", "s.run(10**8)",
                               "s.run(1); print('frames', round(s.time * 60) > 1)")
        self.assertIn("frames True", out)

    def test_the_exact_truth_stops(self):
        self.assertStops(
            "h = libhair.Strands(wavy(20000)); p = libhair.choose_points(h, 20000)",
            "libhair.truth(h, LIGHT, p, rays=2**22)")

    def test_trials_stop(self):
        self.assertStops(
            "h = libhair.Strands(wavy(2000)); p = libhair.choose_points(h, 20)\n"
            "t = libhair.truth(h, LIGHT, p, rays=8)",
            "libhair.run_trials(libhair.candidates(h, LIGHT), h, LIGHT, t, repeats=10**6)")

    def test_what_a_callback_throws_stops_a_run(self):
        def stop(frame):
            if frame == 3:
                raise RuntimeError("enough")

        simulation = small_simulation()
        with self.assertRaisesRegex(RuntimeError, "enough"):
            simulation.run(100, on_frame=stop)
        self.assertAlmostEqual(simulation.time, 4 / 60, places=6)


class Enough(Exception):
    """Has been seen."""


class Threads(unittest.TestCase):
    def test_another_python_thread_makes_progress_meanwhile(self):
        simulation = small_simulation()
        seen = [0]
        done = threading.Event()

        def count():
            while not done.is_set():
                seen[0] += 1
                time.sleep(1e-5)  # gives Python's lock back

        thread = threading.Thread(target=count)
        # Python itself hands its lock over only after this time: what is counted below is counted
        # while the call had given it back.
        interval = sys.getswitchinterval()
        sys.setswitchinterval(100)
        try:
            thread.start()
            before = seen[0]

            def look(frame):
                if seen[0] > before + 5:
                    raise Enough

            # As many frames as it takes on a machine that is busy with other things.
            with self.assertRaises(Enough):
                simulation.run(5000, on_frame=look)
        finally:
            done.set()
            sys.setswitchinterval(interval)
            thread.join()

    def test_a_second_thread_cannot_step_the_same_simulation(self):
        simulation = small_simulation()
        errors = []

        def step_once(frame):
            thread = threading.Thread(target=lambda: errors.append(self.refused(simulation)))
            thread.start()
            thread.join()

        # Between two frames it can.
        simulation.run(1, on_frame=step_once)
        self.assertEqual(errors, [None])

        stop, refused = threading.Event(), []

        def try_all_the_time():
            while not stop.is_set() and not refused:
                error = self.refused(simulation)
                if error:
                    refused.append(error)

        thread = threading.Thread(target=try_all_the_time)
        thread.start()
        try:
            for _ in range(20000):
                if refused:
                    break
                try:
                    simulation.step()
                except RuntimeError as error:
                    refused.append(str(error))
        finally:
            stop.set()
            thread.join()
        self.assertIn("in use by another thread", refused[0])

    def test_a_second_thread_cannot_look_into_a_simulation_at_work(self):
        looks = [n for n in vars(libhair.Simulation)
                 if isinstance(vars(libhair.Simulation)[n], property) and n != "settings"]
        looks += ["guide_points", "stats", "state_hash", "save_state"]
        self.assertGreaterEqual(len(looks), 12)
        simulation = small_simulation()
        simulation.step()
        stop = threading.Event()

        def step_on():
            while not stop.is_set():
                try:
                    simulation.restart(0.2)
                except RuntimeError:  # the other thread was looking
                    pass

        thread = threading.Thread(target=step_on)
        thread.start()
        try:
            for name in looks:
                with self.subTest(name):
                    self.assertIn("in use by another thread", self.refused_look(simulation, name))
        finally:
            stop.set()
            thread.join()
        for name in looks:
            self.look(simulation, name)
        self.assertIn("points", repr(simulation))

    @staticmethod
    def look(simulation, name):
        value = getattr(simulation, name)
        return value() if callable(value) else value

    def refused_look(self, simulation, name):
        """What is said to a thread that looks again and again."""
        for _ in range(2000):
            try:
                self.look(simulation, name)
            except RuntimeError as error:
                return str(error)
            time.sleep(1e-3)  # so that the other thread gets back to work
        return "always answered"

    @staticmethod
    def refused(simulation):
        try:
            simulation.step()
        except RuntimeError as error:
            return str(error)


if __name__ == "__main__":
    unittest.main()
