"""Runs OSL text in Blender's Cycles on the inputs of a folder of cases.

    python cycles_run.py FOLDER RECEIVER [CASE...]

FOLDER is what `fresnel shader --verify --dump` wrote. Each CASE's values go into FOLDER/CASE.RECEIVER.out.f32, where
`fresnel shader --verify --compare` finds them too. A case's text is FOLDER/CASE.RECEIVER.osl where there is such a file,
otherwise the dump's. The last line that is printed is JSON: of each CASE how many rows were compared, how many differ
from the model's float32 in a bit and by how much at most; the same of rows with an input or a value that is not finite,
where OSL divides in a way of its own (x / 0 is 0, and so is what would not be finite); or what oslc says.
"""
import json
import sys
import tempfile
from pathlib import Path

import numpy as np

from cycles_scene import NotCompiled, attribute, emitting, grid, render, scene, script, set_attribute


def shader_text(case, text):
    """A shader around the functions of the text. Its colour is the magnitude of one result, and what kind of number it
    is, since a renderer drops what is not finite: 0, 1 for negative, 2 for NaN, 3 and 4 for infinity."""
    kind, parts = {1: ("float", ["r"]), 3: ("color", ["r[0]", "r[1]", "r[2]"]),
                   4: ("fresnel_boundary", ["r.R_s", "r.R_p", "r.T_s", "r.T_p"])}[case["results"]]
    if case["kind"] == "geometry" and case["results"] == 3:
        kind = "vector"
    columns = range(case["columns"])
    arguments = "".join(f"float input_{k} = 0.0, " for k in columns)
    read = "".join(f"    x[{k}] = input_{k};\n" for k in columns)
    chosen = "".join(f"    if (part == {i}.0)\n        value = {part};\n" for i, part in enumerate(parts))
    return (f"{text}\nshader harness({arguments}float part = 0.0, output color result = 0.0) {{\n"
            f"    float x[{case['columns']}];\n{read}    {kind} r = {case['call']['osl']};\n    float value = 0.0;\n{chosen}"
            "    float minus = atan2(value, -1.0) < 0.0 ? 1.0 : 0.0;\n"
            "    result = isnan(value) ? color(0.0, 2.0, 1.0) : isinf(value) ? color(0.0, 3.0 + minus, 1.0)\n"
            "                                                 : color(abs(value), minus, 1.0);\n}\n")


def decoded(pixels):
    value, kind, hit = pixels.T
    if not (hit == 1).all() or not np.isin(kind, range(5)).all():
        raise RuntimeError("the image does not hold what the shader wrote")
    value = np.where(kind == 1, -value, value)
    return np.select([kind == 2, kind == 3, kind == 4], [np.nan, np.inf, -np.inf], value).astype("<f4")


def compared(inputs, expected, values):
    both_nan = np.isnan(expected) & np.isnan(values)
    differs = ((expected.view("<u4") != values.view("<u4")) & ~both_nan).any(axis=1)
    finite = np.isfinite(inputs).all(axis=1) & np.isfinite(expected).all(axis=1)
    with np.errstate(invalid="ignore"):
        size = np.abs(expected.astype("f8") - values)[differs & finite]
    return {"compared": int(finite.sum()), "differing": int((differs & finite).sum()),
            "max_difference": float(np.where(np.isfinite(size), size, np.inf).max(initial=0)),
            "not_finite": int((~finite).sum()), "not_finite_differing": int((differs & ~finite).sum())}


def run(folder, receiver, case, work):
    inputs = np.fromfile(folder / case["inputs"], "<f4").reshape(-1, case["columns"])
    own = folder / f"{case['id']}.{receiver}.osl"
    text = (own if own.exists() else folder / case["text"]["osl"]).read_text()
    path = work / f"{case['id']}.osl"
    path.write_text(shader_text(case, text))
    parts = case["results"]
    size = int(np.ceil(np.sqrt(len(inputs) * parts)))
    s = scene(size)
    mesh = grid(s, size)
    columns = {f"input_{k}": np.repeat(inputs[:, k], parts) for k in range(case["columns"])}
    columns["part"] = np.tile(np.arange(parts), len(inputs))
    nodes, links, colour = emitting(mesh)
    node = script(nodes, path)
    for name, values in columns.items():
        set_attribute(mesh, name, values, size)
        links.new(attribute(nodes, name), node.inputs[name])
    links.new(node.outputs[0], colour)
    values = decoded(render(s, work / "out.exr")[:len(inputs) * parts])
    values.tofile(folder / f"{case['id']}.{receiver}.out.f32")
    expected = np.fromfile(folder / case["expected"], "<f4").reshape(-1, parts)
    return compared(inputs, expected, values.reshape(-1, parts))


def main(folder, receiver, *ids):
    cases = {c["id"]: c for c in json.loads((Path(folder) / "cases.json").read_text())}
    found = []
    with tempfile.TemporaryDirectory() as work:
        for name in ids or cases:
            try:
                found.append({"id": name} | run(Path(folder), receiver, cases[name], Path(work)))
            except NotCompiled as said:
                found.append({"id": name, "message": str(said)})
    print(json.dumps(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
