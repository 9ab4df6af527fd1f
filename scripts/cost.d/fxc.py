"""Microsoft: FXC in wine, by scripts/receivers.d."""
import sys

from common import folder, models, row, statements, subject
from microsoft import Fxc, is_size

PROFILES = {"ps_2_0": "fragment", "ps_3_0": "fragment", "vs_2_0": "vertex"}


def program(stage, model, evaluates):
    """One evaluation or none: FXC packs several side by side."""
    text, name, floats = subject(model, "hlsl")
    inputs = ", ".join(f"float4 v{i} : TEXCOORD{i}" for i in range((floats + 3) // 4))
    body = statements(name, floats, 1, evaluates, lambda i: f"v{i // 4}.{'xyzw'[i % 4]}")
    if stage == "vertex":
        head = f"void main(float4 at : POSITION, {inputs}, out float4 place : POSITION, out float2 made : TEXCOORD0)"
        last = "place = at;\n    made = float2(F, inputs);"
    else:
        head = f"float4 main({inputs}) : COLOR"
        last = "return float4(F, inputs, 0.0, 1.0);"
    return f"{text}\n{head} {{\n    {body}\n    {last}\n}}\n"


def measure():
    compiler = Fxc()
    compiler.install()
    rows = []
    for profile, stage in PROFILES.items():
        jobs = []
        for model in models():
            for evaluates in True, False:
                file = folder() / f"{profile}_{model['name']}_{int(evaluates)}.hlsl"
                file.write_text(program(stage, model, evaluates))
                jobs.append((profile, "main", file))
        results = compiler.jobs(jobs)
        for k, model in enumerate(models()):
            (message, slots), (_, base) = results[2 * k], results[2 * k + 1]
            if not message:
                rows.append(row(model, profile, stage, slots - base, "FXC", "10.1"))
            elif not is_size(message):  # what has no room in shader model 2 has no row
                print(f"cost: fxc: {model['name']} in {profile}: no row: {message.splitlines()[0]}", file=sys.stderr)
    return rows
