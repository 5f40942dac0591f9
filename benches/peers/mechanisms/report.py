#!/usr/bin/env python3
"""Writes results.md, results.json, work_precision.svg and chains.svg. usage: report.py WORK OUT PARTS COMMAND

PARTS, separated by spaces, are what was run: work_precision.json and chains.jsonl in WORK. Results of other parts and cases stay
as results.json in OUT has them, with the date, machine and command of their own; nothing is measured again by writing it."""
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
OURS = PENDULUM + "ours"  # what the names of our columns begin with


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
    """Of the double logarithm; None of a column with too few numbers of links."""
    n = [n for n in times if n >= SLOPE_FROM]
    return float(np.polyfit(np.log(n), np.log([times[k] for k in n]), 1)[0]) if len(n) > 1 else None


def disagreement(checks):
    """The largest relative difference of joint accelerations between our pendulum and any other column's."""
    ours = checks[OURS]
    others = [found for name, found in checks.items() if name.startswith(PENDULUM) and name != OURS]
    worst = 0.0
    for found in others:
        for n, numbers in found.items():
            difference = np.abs(np.array(numbers) - ours[n]).max() / np.abs(ours[n]).max()
            worst = max(worst, float(difference))
    if not worst <= CHECK:  # not a number is no agreement
        sys.exit(f"the pendulums disagree by {worst:e}")
    return worst if others else None


def best(columns, links):
    """Name and time of the fastest of these columns at so many links."""
    return min(((name, times[links]) for name, times in columns.items() if links in times), key=lambda found: found[1])


def pendulum_rows(columns, numbers):
    """The best of ours, the best of the others and their ratio, by name."""
    pendulums = {name: times for name, times in columns.items() if name.startswith(PENDULUM)}
    ours = {name: times for name, times in pendulums.items() if name.startswith(OURS)}
    others = {name: times for name, times in pendulums.items() if name not in ours}
    if not others:
        return []
    pairs = [(best(ours, n), best(others, n)) for n in numbers]
    named = lambda k: " | ".join(pair[k][0].removeprefix(PENDULUM) for pair in pairs)
    return [f"| rigid pendulum: best of ours | {named(0)} | |", f"| rigid pendulum: best other | {named(1)} | |",
            f"| rigid pendulum: ours over the best other | {' | '.join(f'{ours[1] / other[1]:.2f}' for ours, other in pairs)} | |"]


def chains_text(chains):
    columns = {name: {int(n): time for n, time in times.items()} for name, times in chains["ns"].items()}
    numbers = sorted({n for times in columns.values() for n in times})
    lines = ["## Chains, stars and trees", "", measured(chains), "", "Time of one evaluation of constrained accelerations, µs, against the "
             f"number of links; slope of the double logarithm from {SLOPE_FROM} links on.", "",
             f"| column | {' | '.join(map(str, numbers))} | slope |", "| --- |" + " --- |" * (len(numbers) + 1)]
    for name, times in columns.items():
        cells = [f"{times[n] / 1e3:.3g}" if n in times else "-" for n in numbers]
        found = slope(times)
        lines.append(f"| {name} | {' | '.join(cells)} | {'-' if found is None else f'{found:.2f}'} |")
    lines += pendulum_rows(columns, numbers)
    if chains["disagreement"] is not None:
        lines += ["", f"All pendulums have the same joint accelerations to {chains['disagreement']:.0e} of the largest."]
    return lines + ["", "![Chains](chains.svg)", ""]


def measured(facts):
    """When, where and by what."""
    return f"Of {facts['date']}, {facts['machine']}. `{facts['command']}`."


def case_text(case):
    lines = [f"## {case['case']}", "", measured(case), "",
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


def kept(path):
    """Results of earlier runs."""
    if not os.path.exists(path):
        return {"work_precision": [], "chains": None}
    with open(path) as file:
        return json.load(file)


def with_cases(work, before, stamp):
    """Cases of earlier runs and of this one, which take the places of those of the same name."""
    with open(f"{work}/work_precision.json") as file:
        cases = {case["case"]: case for case in before}
        cases.update({case["case"]: {"case": case["case"], **stamp, **case} for case in json.load(file)})
    return list(cases.values())


def of_chains(work, before, stamp):
    """All columns are of one run, so that they met the same load; what an earlier one had and this one has not is told."""
    columns, checks = least(f"{work}/chains.jsonl")
    for name in before["ns"] if before else []:
        if name not in columns:
            print(f"LOST: chains: {name} was not run, its results of {before['date']} are gone", file=sys.stderr)
    return {**stamp, "disagreement": disagreement(checks), "ns": columns}


def main(work, out, parts, command):
    facts = kept(f"{out}/results.json")
    stamp = {"date": datetime.date.today().isoformat(), "machine": machine(), "command": command}
    for part in parts.split():
        if part == "work_precision":
            facts[part] = with_cases(work, facts[part], stamp)
            plots.work_precision(facts[part], f"{out}/work_precision.svg")
        elif part == "chains":
            facts[part] = of_chains(work, facts[part], stamp)
            columns = facts[part]["ns"]
            plots.chains(columns, {name: slope(times) for name, times in columns.items()}, f"{out}/chains.svg")
    text = ["# Mechanisms against other programs", "", "Each part has the date, machine and load of its own. See [README.md](README.md).", ""]
    for case in facts["work_precision"]:
        text += case_text(case)
    if facts["work_precision"]:
        text += ["![Work and precision](work_precision.svg)", ""]
    if facts["chains"]:
        text += chains_text(facts["chains"])
    with open(f"{out}/results.json", "w") as file:
        json.dump(facts, file, indent=1)
        file.write("\n")
    with open(f"{out}/results.md", "w") as file:
        file.write("\n".join(text).rstrip() + "\n")
    print("\n".join(text))


if __name__ == "__main__":
    main(*sys.argv[1:])
