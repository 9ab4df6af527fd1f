"""Intel: ocloc, the compiler of Intel's OpenCL driver, on the C99 text as OpenCL C."""
import os
import re
import shutil

import receiver
from common import TIMES, folder, models, row, run, statements, subject

GPUS = ["skl", "tgllp", "dg2-g10"]
LANES = 8  # of a kernel: each operation is one instruction
OPTIONS = {"ocloc": [], "ocloc -cl-fast-relaxed-math": ["-options", "-cl-fast-relaxed-math"]}

# C99's functions are OpenCL's without the f
HEAD = "".join(f"#define {name}f {name}\n" for name in ("exp2", "fabs", "fmax", "fmin", "pow", "sqrt"))


def kernel(kind, function, floats, evaluates):
    read = statements(function, floats, TIMES, evaluates, lambda i: f"p[{i}]")
    return (f"__attribute__((intel_reqd_sub_group_size({LANES})))\n"
            f"__kernel void {kind}_{function}(__global const float* restrict all, __global float* restrict out) {{\n"
            f"    const int at = get_global_id(0);\n    __global const float* p = all + at * {TIMES * floats};\n    {read}\n"
            "    out[2 * at] = F;\n    out[2 * at + 1] = inputs;\n}\n")


def program():
    """All models and two kernels of each."""
    text = ""
    for model in models():
        function, name, floats = subject(model, "c", f"of_{model['name']}")  # `constant` is OpenCL's own
        text += function + kernel("evaluating", name, floats, True) + kernel("reading", name, floats, False)
    return HEAD + text.replace("#include <math.h>\n", "")


def instructions(file, gpu, options):
    """Of each kernel, from the listings that the compiler leaves."""
    dump = folder() / "intel"
    shutil.rmtree(dump, ignore_errors=True)
    dump.mkdir()
    seen = dict(os.environ, IGC_ShaderDumpEnable="1", IGC_DumpToCustomDir=str(dump))
    run(["ocloc", "compile", "-file", file, "-device", gpu, "-out_dir", dump, "-q", *options], env=seen)
    counts = {}
    for listing in dump.glob("*.asm"):
        text = listing.read_text()
        counts[re.search(r"^//\.kernel (\w+)", text, re.M)[1]] = int(re.search(r"^//\.instCount (\d+)", text, re.M)[1])
    return counts


def measure():
    receiver.apt("intel-opencl-icd", "libigc-tools")
    version = run(["dpkg-query", "-W", "-f=${source:Upstream-Version}", "intel-opencl-icd"])
    file = folder() / "intel.cl"
    file.write_text(program())
    rows = []
    for tool, options in OPTIONS.items():
        for gpu in GPUS:
            counts = instructions(file, gpu, options)
            for model in models():
                evaluating, reading = (counts[f"{kind}_of_{model['name']}"] for kind in ("evaluating", "reading"))
                rows.append(row(model, gpu, "compute", (evaluating - reading) / TIMES, tool, version))
    return rows
