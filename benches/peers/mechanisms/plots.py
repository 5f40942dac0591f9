"""The pictures of report.py."""
import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "ffrf"  # the same picture from the same numbers
import matplotlib.pyplot as plt  # noqa: E402

from fronts import curves  # noqa: E402

OURS, THEIRS = plt.get_cmap("tab10").colors[:5], plt.get_cmap("Set2").colors
MARKS = "osD^vPXh"


def save(figure, path):
    figure.savefig(path, metadata={"Date": None}, bbox_inches="tight")
    plt.close(figure)


def work_precision(cases, path):
    figure, axes = plt.subplots(1, len(cases), figsize=(6.5 * len(cases), 5.5), squeeze=False)
    for axis, case in zip(axes[0], cases):
        for side, style in [("ours", "-"), ("exudyn", "--")]:
            for index, (method, points) in enumerate(curves(case["rows"], side).items()):
                colours = OURS if side == "ours" else THEIRS
                axis.loglog(
                    [error for error, _ in points], [seconds for _, seconds in points], style, marker=MARKS[index % len(MARKS)],
                    color=colours[index % len(colours)], markersize=4, label=f"{'ffrf' if side == 'ours' else 'Exudyn'}: {method}",
                )
        axis.invert_xaxis()
        axis.set_xlabel("error over largest deflection")
        axis.set_ylabel(f"time of the solve for {case['duration_s']} s, s")
        axis.set_title(case["case"].replace("_", "-"))
        axis.grid(True, which="major", alpha=0.4)
        axis.legend(fontsize=7, ncol=2, loc="upper center", bbox_to_anchor=(0.5, -0.12))
    save(figure, path)


def chains(columns, slopes, path):
    figure, (flexible, rigid) = plt.subplots(1, 2, figsize=(12, 5))
    for name, times in columns.items():
        axis = rigid if name.startswith("pendulum") else flexible
        n = sorted(times)
        axis.loglog(n, [times[k] / 1e3 for k in n], marker="o", markersize=4, label=name if slopes[name] is None else f"{name}, slope {slopes[name]:.2f}")
    for axis, title in [(flexible, "flexible links, four modes"), (rigid, "rigid pendulum")]:
        low, high = axis.get_ylim()
        n = [1, 64]
        axis.loglog(n, [1.0 * k for k in n], color="grey", linestyle=":", label="1 µs a link")
        axis.set_ylim(low, high)
        axis.set_xlabel("links")
        axis.set_ylabel("one evaluation, µs")
        axis.set_title(title)
        axis.grid(True, which="major", alpha=0.4)
        axis.legend(fontsize=8, ncol=2, loc="upper center", bbox_to_anchor=(0.5, -0.12))
    save(figure, path)
