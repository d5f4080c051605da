"""Memory, references and threads."""
import os
import sys
import threading
import time
import unittest

import numpy as np

from common import arm, leg, rss

Z = np.zeros(7)


class Resources(unittest.TestCase):
    def test_no_memory_is_lost(self):
        many, p = np.zeros((8, 7)), leg.Parameters()
        out = np.zeros(7)
        q = [0.1] * 7

        def calls(count):
            for _ in range(count):
                arm.inverse_dynamics(Z, Z, Z)
                arm.inverse_dynamics(Z, Z, Z, out=out)
                arm.inverse_dynamics(q, Z, many, gravity=[0, 0, -1.0])
                arm.joint_space_inertia(many)
                leg.joint_space_inertia_factor(p, Z[:3])
                leg.Parameters(upperleg_length=0.4).upperleg_length
                leg.kinetic_energy(p, Z[:3], Z[:3])
                try:
                    arm.inverse_dynamics(q, Z, Z[:3])
                except ValueError:
                    pass

        calls(2000)
        before, references = rss(), [sys.getrefcount(x) for x in (Z, many, p, out, q, None, np.float64)]
        # ROBCOGEN_PYTHON_CALLS=10000000 makes the test take minutes.
        calls(int(os.environ.get("ROBCOGEN_PYTHON_CALLS", 320_000)) // 8)
        after = [sys.getrefcount(x) for x in (Z, many, p, out, q, None, np.float64)]
        for old, new in zip(references, after):
            self.assertLess(abs(new - old), 50)
        self.assertLess(rss() - before, 2 << 20)

    def test_threads_run_at_the_same_time(self):
        """Another thread of Python goes on while many states are computed."""
        q = np.zeros((200_000, 7))
        out = np.zeros_like(q)
        started, ticks, stop = threading.Event(), [], threading.Event()

        def tick():
            started.set()
            while not stop.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.0002)

        thread = threading.Thread(target=tick)
        thread.start()
        started.wait()
        # On a busy machine, the other thread may get no turn during a call; if it never gets one, it waits for the
        # lock.
        most = 0
        for _ in range(50):
            begin = time.perf_counter()
            arm.inverse_dynamics(q, Z, Z, out=out)
            end = time.perf_counter()
            most = max(most, sum(begin < t < end for t in list(ticks)))
            if most > 2:
                break
        stop.set()
        thread.join()
        self.assertGreater(most, 2)

    def test_results_of_threads_are_those_of_one(self):
        q = np.random.default_rng(1).uniform(-1, 1, (4, 5000, 7))
        expected = [arm.inverse_dynamics(x, x, x) for x in q]
        results = [None] * 4

        def work(i):
            for _ in range(5):
                results[i] = arm.inverse_dynamics(q[i], q[i], q[i])

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result, wanted in zip(results, expected):
            np.testing.assert_array_equal(result, wanted)


if __name__ == "__main__":
    unittest.main()
