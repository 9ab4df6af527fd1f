"""Godot 4: its engine as WebAssembly in a headless browser compiles the pack's shaders and evaluates every function."""
import json

import receiver
from receiver import Receiver, Skipped, add, need, run

import corpus


@add
class Godot(Receiver):
    name, title, heavy = "godot", "Godot shading language", True

    def install(self):
        self.node = need("node", "nodejs")

    def version(self):
        return "Godot"

    def check(self):
        script = receiver.Path(__file__).resolve().parents[1] / "browser" / "godot.mjs"
        folder = receiver.cache() / "programs" / self.name
        code, said = run([self.node, script, corpus.command(), folder])
        if code == 77:
            raise Skipped(said.strip().splitlines()[-1].removeprefix("skipped: "))
        report = folder / "godot.json"
        if not report.exists():
            return {"functions": 0, "files": 0, "names": 0, "refused": 0, "failures": [receiver.shortened(said)]}
        found = json.loads(report.read_text())
        return {"version": found["version"], "functions": found["functions"], "files": found["files"], "names": 0,
                "refused": found["refused"], "failures": found["failures"],
                "note": f", values within {found['worst']:.1e} of the model"}
