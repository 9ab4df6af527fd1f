"""What the compilers of scripts/cost share: the models' texts, programs around them, rows of the table."""
import functools
import json
import os
import subprocess
from pathlib import Path

import receiver

ROOT = Path(__file__).resolve().parents[2]
COMMAND = Path(os.environ.get("FRESNEL_BUILD_DIR", ROOT / "build" / "release")) / "fresnel"
COLUMNS = ["model", "gpu", "stage", "n_i", "instructions", "latency", "inverse_throughput", "registers", "tool", "version"]
TIMES = 16


def run(arguments, **options):
    """What a program prints, without its complaints."""
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise SystemExit(f"cost: {' '.join(map(str, arguments))}: {(done.stderr or done.stdout).strip()}")
    return done.stdout


def folder():
    place = receiver.cache() / "programs" / "cost"
    place.mkdir(parents=True, exist_ok=True)
    return place


@functools.cache
def models():
    return json.loads(run([COMMAND, "models", "--json"]))


def subject(model, language, name=None):
    """The text of a model with n_i = 1, its name there, and how many floats it takes."""
    name = name or model["name"]
    names = [p["name"] for p in model["parameters"]]
    fixed = ["--fix", "n_i=1"] if "n_i" in names else []
    text = run([COMMAND, "shader", model["name"], "--lang", language, "--name", name, *fixed])
    return text, name, len(names) + 1 - len(fixed) // 2


def statements(name, floats, times, evaluates, read, literal="{}f"):
    """Sums of results and of inputs, as in src/emit/cost.cpp."""
    lines = [f"float F = {literal.format('0.0')}, inputs = {literal.format('1.0')};"]
    for t in range(times):
        values = [read(t * floats + i) for i in range(floats)]
        called = f"{name}({', '.join(values)})"
        lines.append(f"F += {called if evaluates else values[-1]};")
        lines += [f"inputs += {value};" for value in values]
    return "\n    ".join(lines)


def row(model, gpu, stage, instructions, tool, version, inverse_throughput=None, registers=None):
    n_i = "1" if any(p["name"] == "n_i" for p in model["parameters"]) else ""

    def cell(value):
        return "" if value is None else f"{round(value, 2):g}"
    return dict(zip(COLUMNS, [model["name"], gpu, stage, n_i, cell(instructions), "", cell(inverse_throughput),
                              cell(registers), tool, version]))
