#!/usr/bin/env python3
"""Where the instructions of a step go: by function, by kind, and which functions copy and clear memory.

usage: where.py PROGRAM CORE [CALLS]     CORE: cortex-m4f or cortex-m7; CALLS: of the step in the program (default 33)
PROGRAM is `step` of a folder of `ffrf budget --folder FOLDER`, FOLDER/target/thumbv7em-none-eabihf/release/step. The emulator
executes one instruction at a time and tells the address of each. Needs qemu-system-arm, arm-none-eabi-nm and -objdump.
"""
import bisect
import collections
import re
import subprocess
import sys

BOARDS = {"cortex-m4f": ("mps2-an386", "cortex-m4"), "cortex-m7": ("mps2-an500", "cortex-m7")}
# What measures, and is not measured.
PROBE = re.compile(r"^(probe::|main$|Reset$|DefaultPreInit$|step::__cortex_m_rt_main)")
MEMORY = re.compile(r"aeabi_mem|compiler_builtins::mem")
KINDS = [
    ("sums, products, signs", r"v(mul|add|sub|fm|mla|mls|nm|fnm|neg|abs)"),
    ("divisions, roots", r"v(div|sqrt)"),
    ("loads of numbers", r"v(ldr|ldm|pop)"),
    ("stores of numbers", r"v(str|stm|push)"),
    ("other on numbers", r"v"),
    ("other loads", r"(ldr|ldm|pop)"),
    ("other stores", r"(str|stm|push)"),
    ("branches", r"(b|bl|bx|blx|b(eq|ne|cs|cc|hs|lo|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)|cbn?z)(\.[nw])?$"),
    ("addresses and counters", r""),
]


def tool(name, *arguments):
    return subprocess.run([name, *arguments], capture_output=True, text=True, check=True).stdout.splitlines()


program, core = sys.argv[1:3]
calls = int(sys.argv[3]) if len(sys.argv) > 3 else 33
functions = sorted(
    (int(fields[0], 16) & ~1, int(fields[1], 16), fields[3])
    for fields in (line.split(" ", 3) for line in tool("arm-none-eabi-nm", "-C", "-S", program))
    if len(fields) == 4 and fields[2] in "tTwW"
)
starts = [start for start, _, _ in functions]
instruction = re.compile(r"\s+([0-9a-f]+):\t[0-9a-f ]+\t(\S+)")
mnemonics = {int(m[1], 16): m[2] for m in map(instruction.match, tool("arm-none-eabi-objdump", "-d", program)) if m}


def function(address):
    place = bisect.bisect_right(starts, address) - 1
    inside = place >= 0 and address < functions[place][0] + functions[place][1]
    return functions[place][2] if inside else "?"


machine, cpu = BOARDS[core]
emulator = subprocess.Popen(
    ["qemu-system-arm", "-machine", machine, "-cpu", cpu, "-nographic", "-monitor", "none", "-serial", "null", "-icount", "shift=6"]
    + ["-semihosting-config", "enable=on,target=native", "-singlestep", "-d", "exec,nochain", "-kernel", program],
    stdout=subprocess.DEVNULL,
    stderr=subprocess.PIPE,
)
executed, memory = collections.Counter(), collections.Counter()
name_of, caller = {}, "?"
for line in emulator.stderr:
    found = re.search(rb"\[[0-9a-f]+/([0-9a-f]+)/", line)
    if not found:
        continue
    address = int(found[1], 16)
    if address not in name_of:
        name_of[address] = function(address)
    executed[address] += 1
    if MEMORY.search(name_of[address]):
        memory[caller] += 1
    else:
        caller = name_of[address]
emulator.wait()

by_function, by_kind = collections.Counter(), collections.Counter()
for address, count in executed.items():
    if PROBE.match(name_of[address]):
        continue
    by_function[name_of[address]] += count
    mnemonic = mnemonics.get(address, "?")
    by_kind[next(kind for kind, pattern in KINDS if re.match(pattern, mnemonic))] += count
total = sum(by_function.values())
for title, counts in (("function", by_function), ("kind", by_kind), ("copies and clears memory for", memory)):
    print(f"{'instructions':>12} {'share':>6}  {title}")
    for name, count in counts.most_common(30):
        if not PROBE.match(name):
            print(f"{count / calls:12.0f} {100 * count / total:5.1f} %  {name}")
print(f"{total / calls:12.0f} instructions a step")
