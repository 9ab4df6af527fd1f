"""WGSL: Tint, inside the WebGPU of npm's webgpu without any device; naga, as WebAssembly, with spirv-val behind it."""
import json
from pathlib import Path

from callers import statements
from receiver import Receiver, add, need, npm, run

HERE = Path(__file__).parent


class Wgsl(Receiver):
    language, title = "wgsl", "WGSL"

    def program(self, text):
        return (text + "\n@fragment\nfn harness_main(@location(0) harness_three: vec3f) -> @location(0) vec4f {\n"
                "    let harness_one = harness_three.x;\n    var harness_sum = 0.0;\n"
                + statements(self.language, text, direction="harness_three") +
                "\n    return vec4f(harness_sum);\n}\n")

    def node(self, script, files):
        """A message for each file, as a script of ours prints them: one list."""
        code, said = run(["node", HERE / script, self.modules, *files])
        last = said.strip().splitlines()[-1] if said.strip() else ""
        if code != 0 or not last.startswith("["):
            return [f"{script} ended with {code}: {said}"] * len(files)
        return json.loads(last)


@add
class Tint(Wgsl):
    name = "wgsl-tint"

    def install(self):
        self.modules = npm("webgpu@0.6.2")

    def version(self):
        return "Tint of webgpu 0.6.2"

    def compile(self, files):
        return self.node("tint.mjs", files)


@add
class Naga(Wgsl):
    name = "wgsl-naga"

    def install(self):
        self.modules = npm("wgsl-wasm-transpiler-bundler@0.0.1")
        self.spirv_val = need("spirv-val", "spirv-tools")

    def version(self):
        return "naga 25.0.1 (to SPIR-V), spirv-val"

    def compile(self, files):
        messages = self.node("naga.mjs", files)
        for i, file in enumerate(files):
            if not messages[i]:
                code, said = run([self.spirv_val, f"{file}.spv"])
                messages[i] = said if code else ""
        return messages
