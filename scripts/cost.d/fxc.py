"""Microsoft: FXC in wine, by scripts/receivers.d."""
import sys
from pathlib import Path

from common import COMMAND, ROOT, folder, models, row, run, statements, subject
from microsoft import OLD_SAMPLERS, Fxc, is_size

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


# ---- listings --------------------------------------------------------------------------------------------------

LISTINGS = ROOT / "docs" / "listings"
FIGURES = Path(__file__).with_name("programs")  # what figures of Wloka 2002 do, with our functions
LISTED = [("figure-6", "vs_1_1"), ("per-vertex", "vs_1_1"), ("per-vertex", "ps_2_0"), ("figure-9", "ps_2_0"),
          ("per-pixel", "vs_1_1"), ("per-pixel", "ps_2_0"), ("figure-11", "ps_2_0"), ("lut", "ps_2_0")]


def listed_text(name):
    """The text that is compiled, and the command that prints it."""
    figure = FIGURES / f"{name}.hlsl"
    arguments = "--all --lang hlsl" if figure.exists() else f"schlick --technique {name} --fix f0=0.02 --lang cg"
    text = run([COMMAND, "shader", *arguments.split()])
    command = f"fresnel shader {arguments}"
    if figure.exists():
        return f"{text}\n{figure.read_text()}", f"({command}; cat {figure.relative_to(ROOT)})"
    return OLD_SAMPLERS + text, command


def write_listings(compiler):
    """Writes docs/listings: what FXC makes of whole programs."""
    jobs, commands = [], []
    for name, profile in LISTED:
        text, command = listed_text(name)
        entry = {"vs": "vertex_main", "ps": "fragment_main"}[profile[:2]]
        file = folder() / f"{name}.hlsl"
        file.write_text(text)
        jobs.append((profile, entry, file, folder() / f"{name}.{profile}.txt"))
        commands.append(f"// {command} > {name}.hlsl; fxc -O3 -T {profile} -E {entry} {name}.hlsl\n")
    for (_, _, _, listing), command, (message, _) in zip(jobs, commands, compiler.jobs(jobs)):
        if message:
            raise SystemExit(f"cost: fxc: {listing.stem}: {message}")
        (LISTINGS / listing.name).write_text(command + listing.read_text())


# ---- the table -------------------------------------------------------------------------------------------------


def measure():
    compiler = Fxc()
    compiler.install()
    write_listings(compiler)
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
