"""NVIDIA: nvcc and cuobjdump from PyPI."""
import os
import re

import receiver
from common import TIMES, folder, models, row, run, statements, subject

GPU = "sm_86"
OPTIONS = {"nvcc": [], "nvcc --use_fast_math": ["--use_fast_math"]}
PACKAGES = ["nvidia-nvvm", *(f"nvidia-cuda-{p}" for p in ("nvcc", "crt", "runtime", "cuobjdump", "nvdisasm"))]


def tools():
    """The folder of the programs, whose helpers lie beside them."""
    place = receiver.pip("cuda", *PACKAGES) / "nvidia" / "cu13" / "bin"
    if not (place / "nvcc").exists():
        raise receiver.Skipped("the packages hold no nvcc for this machine")
    for tool in place.iterdir():
        tool.chmod(0o755)
    os.environ["PATH"] = f"{place}:{os.environ['PATH']}"
    return place


def kernel(name, function, floats, times, evaluates):
    count = max(1, times) * floats
    read = statements(function, floats, times, evaluates, lambda i: f"p[{i}]")
    return (f'extern "C" __global__ void {name}(const float* __restrict__ all, float* out) {{\n'
            f"    const int at = threadIdx.x;\n    const float* p = all + at * {count};\n    {read}\n"
            "    out[2 * at] = F;\n    out[2 * at + 1] = inputs;\n}\n")


def sass_instructions(listing):
    """Instructions of each kernel up to its first unconditional EXIT; what comes after are the slow paths of divisions."""
    counts = {}
    for part in re.split(r"Function : ", listing)[1:]:
        name = part.split("\n", 1)[0].strip()
        counts[name] = 0
        for opcode in re.findall(r"/\*[0-9a-f]{4,}\*/\s+(.*?)\s*;", part):
            if not opcode.startswith("NOP"):
                counts[name] += 1
            if opcode == "EXIT":
                break
    return counts


def measure():
    place = tools()
    version = re.search(r"V([0-9.]+)", run([place / "nvcc", "--version"]))[1]
    source, made = folder() / "k.cu", folder() / "k.cubin"
    rows = []
    for tool, options in OPTIONS.items():
        for model in models():
            text, name, floats = subject(model, "cuda")
            text += kernel("evaluating", name, floats, TIMES, True) + kernel("reading", name, floats, TIMES, False)
            text += kernel("one", name, floats, 1, True)
            source.write_text(text)
            run([place / "nvcc", "-std=c++17", f"-arch={GPU}", *options, "-cubin", "-o", made, source])
            counts = sass_instructions(run([place / "cuobjdump", "-sass", made]))
            usage = run([place / "cuobjdump", "-res-usage", made])
            registers = int(re.search(r"Function one:\s*REG:(\d+)", usage)[1])
            rows.append(row(model, GPU, "compute", (counts["evaluating"] - counts["reading"]) / TIMES, tool, version,
                            registers=registers))
    return rows
