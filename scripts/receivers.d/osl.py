"""OSL: oslc, which is inside Blender's Python module. Wants Python 3.11, as Debian 12 has."""
import json
import shutil
from pathlib import Path

from callers import statements
from receiver import Receiver, Skipped, add, pip, run

HERE = Path(__file__).parent


@add
class Oslc(Receiver):
    name, language, title, heavy = "osl-oslc", "osl", "OSL", True

    def install(self):
        python = shutil.which("python3.11")
        if not python:
            raise Skipped("no python3.11, which bpy 5.0.1 is built for")
        self.python = pip("bpy", "bpy==5.0.1", python=python).parents[2] / "bin/python"

    def version(self):
        code, said = run([self.python, "-c", "import bpy; print(bpy.app.version_string)"])
        if code != 0:
            raise Skipped(f"bpy does not start: {said.strip().splitlines()[-1]}")
        return f"oslc of Blender {said.strip().splitlines()[-1]}"

    def program(self, text):
        return (text + "\nshader harness(output color harness_out = 0) {\n    float harness_one = P[0];\n"
                "    color harness_three = color(P);\n    vector harness_direction = vector(P);\n"
                "    float harness_sum = 0.0;\n" + statements("osl", text) + "\n    harness_out = color(harness_sum);\n}\n")

    def compile(self, files):
        code, said = run([self.python, HERE / "programs" / "oslc.py", *files], cwd=files[0].parent)
        last = said.strip().splitlines()[-1] if said.strip() else ""
        if code != 0 or not last.startswith("["):
            raise SystemExit(f"receivers: oslc.py ended with {code}: {said[-500:]}")
        return json.loads(last)
