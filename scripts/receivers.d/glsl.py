"""GLSL and GLSL ES: glslang's front end, and spirv-val over what it makes of them."""
from callers import statements
from receiver import Receiver, add, need, run


class Glslang(Receiver):
    versions = {}  # the first line of a program, and whether it becomes SPIR-V

    def install(self):
        self.glslang = need("glslangValidator", "glslang-tools")
        self.spirv_val = need("spirv-val", "spirv-tools")

    def version(self):
        said = run([self.glslang, "--version"])[1]
        number = next(line.split(":")[-1] for line in said.splitlines() if line.startswith("Glslang Version"))
        return f"glslang {number} ({', '.join(v.split(' ', 1)[1] for v in self.versions)}), spirv-val"

    def program(self, text):
        return (text + "\nLOCATION in vec3 harness_in;\nLOCATION out vec4 harness_out;\n\nvoid main() {\n"
                "    float harness_one = harness_in.x, harness_sum = 0.0;\n    vec3 harness_three = harness_in;\n"
                + statements(self.language, text, direction="harness_three") +
                "\n    harness_out = vec4(harness_sum);\n}\n")

    def compile_one(self, file):
        for version, spirv in self.versions.items():
            own = file.with_suffix(f".{version.split()[1]}.frag")
            layout = "layout(location = 0)" if spirv else ""
            own.write_text(f"{version}\n" + file.read_text().replace("LOCATION", layout))
            made = own.with_suffix(".spv")
            options = ["-V", "--keep-uncalled", "-o", made] if spirv else []
            code, said = run([self.glslang, *options, "-S", "frag", own])
            if code == 0 and spirv:
                code, said = run([self.spirv_val, made])
            if code != 0:
                return f"{version}: {said}"
        return ""


@add
class Glsl(Glslang):
    name, language, title = "glsl", "glsl", "GLSL"
    versions = {"#version 330 core": False, "#version 450": True}


@add
class Essl(Glslang):
    name, language, title = "essl", "essl", "GLSL ES"
    versions = {"#version 300 es": False, "#version 320 es": True}
