#!/usr/bin/env python3
"""Writes results.json and results.md. usage: report.py columns.jsonl exudyn.jsonl FOLDER ROUNDS"""
import datetime
import json
import platform
import statistics
import subprocess
import sys


def lines(path):
    with open(path) as file:
        return [json.loads(line) for line in file if line.startswith("{")]


def output(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout
    except OSError:
        return ""


def merged(passes):
    """One column at one number of modes from its passes: the smallest minimum, the medians of medians and of ratios."""
    result = {**passes[0], "error": max(p["error"] for p in passes)}
    for kind in ("equations", "accelerations"):
        if kind in result:
            values = lambda key: [p[kind][key] for p in passes]
            result[kind] = {
                "minimum_ns": min(values("minimum_ns")),
                "median_ns": round(statistics.median(values("median_ns")), 1),
                "ratio": round(statistics.median(values("ratio")), 3),
            }
    return result


exudyn, folder, rounds = lines(sys.argv[2]), sys.argv[3], sys.argv[4]
passes = {}
for line in lines(sys.argv[1]):
    passes.setdefault((line["modes"], line["column"]), []).append(line)
columns = [merged(group) for group in passes.values()]
count = max(len(group) for group in passes.values())
cpu = [line.split(":")[1].strip() for line in output("lscpu").splitlines() if line.startswith(("Model name", "L1d", "L2 "))]
versions = [output(*c).splitlines()[:1] for c in (("rustc", "-V"), ("gcc", "--version"), ("clang", "--version"))]
about = {
    "date": datetime.date.today().isoformat(),
    "machine": f"{platform.machine()}, {', '.join(cpu)}",
    "compilers": [line for version in versions for line in version],
    "command": f"ROUNDS={rounds} benches/peers/run.sh",
    "unit": "ns per call",
}
with open(f"{folder}/results.json", "w") as file:
    json.dump({**about, "columns": columns, "exudyn": exudyn}, file, indent=1)

modes = sorted({c["modes"] for c in columns})
names = list(dict.fromkeys(c["column"] for c in columns))
find = {(c["column"], c["modes"]): c for c in columns}
own = ("ours", "ours-default-cpu")


def table(kind, key):
    rows = [f"| {'column':20} |" + "".join(f" {m} |" for m in modes), "|---|" + "---|" * len(modes)]
    value = lambda name, m: find.get((name, m), {}).get(kind, {}).get(key)
    for name in names:
        cells = [value(name, m) for m in modes]
        if any(cells):
            rows.append(f"| {name:20} |" + "".join(f" {c:.0f} |" if c else " - |" for c in cells))
    best = [min((value(n, m) for n in names if n not in own and value(n, m)), default=None) for m in modes]
    ratios = [value("ours", m) / b if b and value("ours", m) else None for m, b in zip(modes, best)]
    rows.append("| ours / best other     |" + "".join(f" {r:.2f} |" if r else " - |" for r in ratios))
    return "\n".join(rows)


def round_by_round(kind):
    """The largest over the other columns of the median ratio, and which column it was."""
    cells = []
    for m in modes:
        ratios = [(find[n, m][kind]["ratio"], n) for n in names if n not in own and kind in find.get((n, m), {})]
        cells.append("{:.2f} ({})".format(*max(ratios)) if ratios else "-")
    return "| " + " | ".join(cells) + " |"


with open(f"{folder}/results.md", "w") as file:
    print(f"# Peers, {about['date']}\n\n{about['machine']}; {'; '.join(about['compilers'])}.", file=file)
    print(f"Command: `{about['command']}`, {count} passes. Nanoseconds per call, by number of modes.", file=file)
    worst = max(c["error"] for c in columns)
    print(f"Largest deviation of any column from the reference: {worst:.0e}.", file=file)
    for kind, title in (
        ("equations", "Mass matrix, quadratic velocity vector and accelerations"),
        ("accelerations", "Accelerations alone"),
    ):
        for key, word in (("minimum_ns", "minimum"), ("median_ns", "median")):
            print(f"\n## {title}, {word} of {rounds} rounds\n\n{table(kind, key)}", file=file)
    print("\n## Ours / best other, median of the ratios round by round\n", file=file)
    print("Within a round (milliseconds) the columns meet the same load, so this is steadier than the ratio of medians.\n", file=file)
    print("| kernels |" + "".join(f" {m} |" for m in modes) + "\n|---|" + "---|" * len(modes), file=file)
    print(f"| all three {round_by_round('equations')}\n| accelerations {round_by_round('accelerations')}", file=file)
    if exudyn:
        print("\n## Exudyn, one right-hand side inside its own solver, µs\n", file=file)
        print("| M |" + "".join(f" {e['modes']} |" for e in exudyn), file=file)
        print("|---|" + "---|" * len(exudyn), file=file)
        print("| µs |" + "".join(f" {e['microseconds']:.1f} |" for e in exudyn), file=file)
