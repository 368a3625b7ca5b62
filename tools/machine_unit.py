#!/usr/bin/python3
"""A unit of time of this machine: seconds of 2 000 000 times x = x * 0.999999 + 1e-7, the best of many.

    tools/machine_unit.py
"""

import time


def machine_unit(repetitions=12):
    best = float("inf")
    for _ in range(repetitions):
        x, start = 1.0, time.perf_counter()
        for _ in range(2_000_000):
            x = x * 0.999999 + 1e-7
        best = min(best, time.perf_counter() - start)
    return best


if __name__ == "__main__":
    print(f"{machine_unit():.4f} s")
