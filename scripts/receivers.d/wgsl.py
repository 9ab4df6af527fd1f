"""WGSL: Tint, inside the WebGPU of npm's webgpu without any device; naga, as WebAssembly, with spirv-val behind it."""
import json
from pathlib import Path

from callers import statements
from receiver import WEBGPU, WEBGPU_AS_READ, Receiver, add, need, npm, run

HERE = Path(__file__).parent


class Wgsl(Receiver):
    language, title = "wgsl", "WGSL"

    def program(self, text):
        return (text + "\n@fragment\nfn harness_main(@location(0) harness_three: vec3f) -> @location(0) vec4f {\n"
                "    let harness_one = harness_three.x;\n    var harness_sum = 0.0;\n"
                + statements(self.language, text, direction="harness_three") +
                "\n    return vec4f(harness_sum);\n}\n")


def tint_says(files):
    """A message for each file, as a script of ours prints them: one list."""
    code, said = run(["node", HERE / "tint.mjs", npm(WEBGPU), *files])
    last = said.strip().splitlines()[-1] if said.strip() else ""
    if code != 0 or not last.startswith("["):
        return [f"tint.mjs ended with {code}: {said}"] * len(files)
    return json.loads(last)


def naga_says(naga, files, extension):
    """A message for each file, translated into FILE + extension; the refused ones once more alone, for their messages."""
    made = [Path(f"{file}{extension}") for file in files]
    for file in made:
        file.unlink(missing_ok=True)
    run([naga, "--pairs", *(name for pair in zip(files, made) for name in pair)])
    return ["" if there.exists() else run([naga, file, there])[1].strip() or "refused"
            for file, there in zip(files, made)]


@add
class Tint(Wgsl):
    name = "wgsl-tint"

    def install(self):
        npm(WEBGPU)

    def version(self):
        return f"Tint of {WEBGPU_AS_READ}"

    def compile(self, files):
        return tint_says(files)


@add
class Naga(Wgsl):
    name = "wgsl-naga"

    def install(self):
        self.naga = need("fresnel-naga", "it")
        self.spirv_val = need("spirv-val", "spirv-tools")

    def version(self):
        return f"naga {run([self.naga, '--version'])[1].strip()} (to SPIR-V), spirv-val"

    def compile(self, files):
        said = naga_says(self.naga, files, ".spv")
        return [s or self.invalid(f"{file}.spv") for s, file in zip(said, files)]

    def invalid(self, file):
        code, said = run([self.spirv_val, file])
        return said if code else ""
