"""The fastest way to an error: between the measured steps of each method, in the double logarithm."""
import numpy as np


def curves(rows, side):
    """Errors and seconds of each method that was timed; a method whose error was taken at the end alone is left out."""
    methods = {}
    for row in rows:
        if row["side"] == side and "error" in row and not row["error_at_end_only"]:
            methods.setdefault(row["method"], []).append((row["error"], row["seconds"]))
    return methods


def front_time(rows, side, error):
    """Least seconds for at most this error, and the method: a measured point, or interpolated between neighbours."""
    best = (np.inf, "")
    for method, points in curves(rows, side).items():
        for other, seconds in points:
            if other <= error:
                best = min(best, (seconds, method))
        # steps in their order: the last one above the error and the next one below
        for (high, slow), (low, fast) in zip(points, points[1:]):
            if high > error > low:
                share = np.log(high / error) / np.log(high / low)
                best = min(best, (float(np.exp(np.log(slow) + share * np.log(fast / slow))), method))
    return best


def ratios(rows):
    """Error, best of ours, best of Exudyn's, at each power of ten that both sides reach."""
    found = []
    for exponent in range(-1, -13, -1):
        ours, theirs = (front_time(rows, side, 10.0**exponent) for side in ("ours", "exudyn"))
        if np.isfinite(ours[0]) and np.isfinite(theirs[0]):
            found.append((10.0**exponent, ours, theirs))
    return found
