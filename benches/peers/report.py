#!/usr/bin/env python3
"""Writes results.json and results.md. usage: report.py columns.jsonl exudyn.jsonl FOLDER ROUNDS"""
import datetime
import json
import platform
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


columns, exudyn, folder, rounds = lines(sys.argv[1]), lines(sys.argv[2]), sys.argv[3], sys.argv[4]
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


with open(f"{folder}/results.md", "w") as file:
    print(f"# Peers, {about['date']}\n\n{about['machine']}; {'; '.join(about['compilers'])}.", file=file)
    print(f"Command: `{about['command']}`. Nanoseconds per call, by number of modes.", file=file)
    worst = max(c["error"] for c in columns)
    print(f"Largest deviation of any column from the reference: {worst:.0e}.", file=file)
    for kind, title in (
        ("equations", "Mass matrix, quadratic velocity vector and accelerations"),
        ("accelerations", "Accelerations alone"),
    ):
        for key, word in (("minimum_ns", "minimum"), ("median_ns", "median")):
            print(f"\n## {title}, {word} of {rounds} rounds\n\n{table(kind, key)}", file=file)
    if exudyn:
        print("\n## Exudyn, one right-hand side inside its own solver, µs\n", file=file)
        print("| M |" + "".join(f" {e['modes']} |" for e in exudyn), file=file)
        print("|---|" + "---|" * len(exudyn), file=file)
        print("| µs |" + "".join(f" {e['microseconds']:.1f} |" for e in exudyn), file=file)
