#!/usr/bin/env python3
"""Writes results.md, results.json, work_precision.svg and chains.svg. usage: report.py WORK OUT COMMAND

Of what WORK holds: work_precision.json and chains.jsonl; a part that was not run is left out, loudly."""
import datetime
import json
import os
import platform
import sys

import numpy as np

import plots
from fronts import ratios

SLOPE_FROM = 8  # links; shorter chains are all ends
CHECK = 1e-9  # joint accelerations of the pendulum, relative to the largest, among all columns
PENDULUM = "pendulum, "


def machine():
    model = [line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return f"{model[0] if model else platform.processor()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"


def least(path):
    """Least ns per column and number of links; and the accelerations that a column found."""
    columns, checks = {}, {}
    for line in open(path):
        row = json.loads(line)
        times = columns.setdefault(row["column"], {})
        times[row["n"]] = min(times.get(row["n"], np.inf), row["ns"])
        checks.setdefault(row["column"], {})[row["n"]] = row["check"]
    return columns, checks


def slope(times):
    n = [n for n in times if n >= SLOPE_FROM]
    return float(np.polyfit(np.log(n), np.log([times[k] for k in n]), 1)[0])


def disagreement(checks):
    """The largest relative difference of joint accelerations between our pendulum and any other column's."""
    ours = checks[PENDULUM + "ours"]
    others = [found for name, found in checks.items() if name.startswith(PENDULUM) and found is not ours]
    worst = 0.0
    for found in others:
        for n, numbers in found.items():
            difference = np.abs(np.array(numbers) - ours[n]).max() / np.abs(ours[n]).max()
            worst = max(worst, float(difference))
    if worst > CHECK:
        sys.exit(f"the pendulums disagree by {worst:e}")
    return worst if others else None


def chains_text(columns, checks):
    numbers = sorted({n for times in columns.values() for n in times})
    lines = ["## Chains, stars and trees", "", "Time of one evaluation of constrained accelerations, µs, against the number of links; "
             f"slope of the double logarithm from {SLOPE_FROM} links on.", "", f"| column | {' | '.join(map(str, numbers))} | slope |",
             "| --- |" + " --- |" * (len(numbers) + 1)]
    for name, times in columns.items():
        cells = [f"{times[n] / 1e3:.3g}" if n in times else "-" for n in numbers]
        lines.append(f"| {name} | {' | '.join(cells)} | {slope(times):.2f} |")
    others = {name: times for name, times in columns.items() if name.startswith(PENDULUM) and name != PENDULUM + "ours"}
    if others:
        ours = columns[PENDULUM + "ours"]
        cells = [f"{ours[n] / min(times[n] for times in others.values()):.2f}" for n in numbers]
        lines += [f"| rigid pendulum: ours over the best other | {' | '.join(cells)} | |", "",
                  f"All pendulums have the same joint accelerations to {disagreement(checks):.0e} of the largest."]
    return lines


def case_text(case):
    lines = [f"## {case['case']}", "",
             f"{case['duration_s']} s of motion. Errors are relative to the largest deflection, {case['deflection_m']:.2e} m. The references "
             f"of both sides differ by {case['between_references']:.0e} of it.", "",
             "| side | method | step or tolerance | steps | seconds | µs a step | error |", "| --- | --- | --- | --- | --- | --- | --- |"]
    for row in sorted(case["rows"], key=lambda row: (row["side"] != "ours", row["method"], -row["step"])):
        start = f"| {row['side']} | {row['method']} | {row['step']:.4g} "
        if "refused" in row:
            lines.append(start + "| - | - | - | " + row["refused"].removeprefix("Error: ") + " |")
        else:
            end = " (at the end)" if row["error_at_end_only"] else ""
            each = row["seconds"] / row["steps"] * 1e6
            lines.append(start + f"| {row['steps']} | {row['seconds']:.3e} | {each:.3g} | {row['error']:.1e}{end} |")
    lines += ["", "At equal error, the fastest method of each side, interpolated in the double logarithm between its steps:", "",
              "| error | ours, ms | Exudyn, ms | ratio |", "| --- | --- | --- | --- |"]
    for error, ours, theirs in ratios(case["rows"]):
        lines.append(f"| {error:.0e} | {ours[0] * 1e3:.3g} ({ours[1]}) | {theirs[0] * 1e3:.3g} ({theirs[1]}) | {theirs[0] / ours[0]:.1f} |")
    return lines + [""]


def main(work, out, command):
    facts = {"date": datetime.date.today().isoformat(), "machine": machine(), "command": command}
    text = [f"# Mechanisms against other programs, {facts['date']}", "", f"{facts['machine']}. `{command}`. See [README.md](README.md).", ""]
    path = f"{work}/work_precision.json"
    if os.path.exists(path):
        facts["work_precision"] = json.load(open(path))
        for case in facts["work_precision"]:
            text += case_text(case)
        text += ["![Work and precision](work_precision.svg)", ""]
        plots.work_precision(facts["work_precision"], f"{out}/work_precision.svg")
    else:
        print("SKIPPED: work_precision was not run", file=sys.stderr)
    path = f"{work}/chains.jsonl"
    if os.path.exists(path):
        columns, checks = least(path)
        facts["chains_ns"] = columns
        text += chains_text(columns, checks) + ["", "![Chains](chains.svg)", ""]
        plots.chains(columns, {name: slope(times) for name, times in columns.items()}, f"{out}/chains.svg")
    else:
        print("SKIPPED: chains were not run", file=sys.stderr)
    with open(f"{out}/results.json", "w") as file:
        json.dump(facts, file, indent=1)
        file.write("\n")
    with open(f"{out}/results.md", "w") as file:
        file.write("\n".join(text).rstrip() + "\n")
    print("\n".join(text))


if __name__ == "__main__":
    main(*sys.argv[1:])
