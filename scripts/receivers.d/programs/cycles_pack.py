"""Runs the shaders of the Blender pack in Cycles, in a Script node as their users do, on the inputs of a folder of cases.

    python cycles_pack.py FOLDER PACK [FILE...]

FOLDER is what `fresnel shader --verify --dump` wrote, PACK the folder with the shaders. The last line that is printed is
JSON: for each shader (the first one as a text inside the .blend file too) its file, how many values were compared, how many differ and by how much at most; or what Blender
says of it.
"""
import json
import sys
import tempfile
from pathlib import Path

import numpy as np

from cycles_scene import NotCompiled, attribute, emitting, grid, render, scene, script, set_attribute

SIZE = 256


class Columns:
    """Inputs as attributes of the faces, one number each, and the nodes that read them."""

    def __init__(self, mesh, nodes, links):
        self.mesh, self.nodes, self.links = mesh, nodes, links

    def connect(self, socket, name, columns):
        if len(columns) == 1:
            set_attribute(self.mesh, name, columns[0], SIZE)
            self.links.new(attribute(self.nodes, name), socket)
            return
        combined = self.nodes.new("ShaderNodeCombineXYZ")
        for i, values in enumerate(columns):
            set_attribute(self.mesh, f"{name}_{i}", values, SIZE)
            self.links.new(attribute(self.nodes, f"{name}_{i}"), combined.inputs[i])
        self.links.new(combined.outputs[0], socket)


def sockets(node):
    """By the names of the parameters; one that is the name of the function too has an underscore."""
    return {socket.identifier.rstrip("_"): socket for socket in node.inputs}


def rows_of(folder, case):
    """What is finite of a case: its inputs and the values to expect."""
    inputs = np.fromfile(folder / case["inputs"], "<f4").reshape(-1, case["columns"])
    expected = np.fromfile(folder / case["expected"], "<f4").reshape(-1, case["results"])
    fit = np.isfinite(inputs).all(axis=1) & np.isfinite(expected).all(axis=1)
    return inputs[fit][:SIZE * SIZE], expected[fit][:SIZE * SIZE]


def normals(cos_i):
    """Normals to which the camera's direction, (0, 0, -1), has exactly this cosine."""
    return [np.sqrt((1 - cos_i) * (1 + cos_i)), np.zeros_like(cos_i), cos_i]


def connect_inputs(columns, node, case, inputs):
    """Connects a case's inputs to the sockets; returns whether each channel has its own."""
    own, at = sockets(node), 0
    channels = True
    for argument in case["arguments"]:
        width, name = argument["width"], argument["name"]
        values = [inputs[:, at + i] for i in range(width)]
        at += width
        if name == "cos_i":
            columns.connect(own["Normal"], "Normal", normals(values[0]))
        elif own[name].type == "VALUE":
            channels = channels and width == 1
            columns.connect(own[name], name, values[:1])
        else:
            columns.connect(own[name], name, values if width == 3 else values * 3)
    return channels


def compare(folder, cases, path, text, work):
    """Runs one shader, from its file or from a text in the .blend file."""
    model = path.stem.removeprefix("fresnel_")
    case = cases.get(f"{model}_rgb", cases[model])
    inputs, expected = rows_of(folder, case)
    s = scene(SIZE)
    mesh = grid(s, SIZE)
    nodes, links, colour = emitting(mesh)
    node = script(nodes, path, text)
    channels = connect_inputs(Columns(mesh, nodes, links), node, case, inputs)
    links.new(node.outputs["F"], colour)
    pixels = render(s, work / "out.exr")[:len(inputs)]
    width = 3 if channels and case["results"] == 3 else 1
    got, expected = pixels[:, :width], expected[:, :width]
    return {"compared": got.size, "differing": int((got.view("<u4") != expected.view("<u4")).sum()),
            "max_difference": float(np.abs(got.astype("f8") - expected).max())}


def main(folder, pack, *files):
    cases = {c["id"]: c for c in json.loads((Path(folder) / "cases.json").read_text())}
    found = []
    with tempfile.TemporaryDirectory() as work:
        files = files or sorted(p.name for p in Path(pack).glob("fresnel_*.osl"))
        for file in files:
            path = Path(work) / file
            path.write_text((Path(pack) / file).read_text())
            for text in (None, path.read_text()) if file == files[0] else (None,):
                one = {"file": file, "mode": "EXTERNAL" if text is None else "INTERNAL"}
                try:
                    one |= compare(Path(folder), cases, path, text, Path(work))
                except NotCompiled as said:
                    one["message"] = str(said)
                found.append(one)
    print(json.dumps(found))


if __name__ == "__main__":
    main(*sys.argv[1:])
