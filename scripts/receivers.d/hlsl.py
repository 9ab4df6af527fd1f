"""HLSL by glslang's front end and by slangc; Slang by slangc."""
from callers import TABLE_OF_HLSL, statements
from receiver import SLANGC, Receiver, Skipped, add, need, pip, run


class Program(Receiver):
    """A pixel shader that calls every function; the same text serves HLSL and Slang."""

    def program(self, text):
        return (text + "\n" + TABLE_OF_HLSL + "float4 main(float3 harness_three : TEXCOORD0) : SV_Target {\n"
                "    float harness_one = harness_three.x, harness_sum = 0.0;\n"
                + statements(self.language, text, direction="harness_three") +
                "\n    return float4(harness_sum, 0.0, 0.0, 1.0);\n}\n")


@add
class HlslGlslang(Program):
    name, language, title = "hlsl-glslang", "hlsl", "HLSL"

    def install(self):
        self.glslang = need("glslangValidator", "glslang-tools")
        self.spirv_val = need("spirv-val", "spirv-tools")

    def version(self):
        said = run([self.glslang, "--version"])[1]
        return "glslang " + next(line.split(":")[-1] for line in said.splitlines() if "Glslang Version" in line)

    def compile_one(self, file):
        made = file.with_suffix(".spv")
        code, said = run([self.glslang, "-D", "-V", "--keep-uncalled", "-S", "frag", "-e", "main", "-o", made, file])
        if code == 0:
            code, said = run([self.spirv_val, made])
        return said if code else ""


class WithSlangc:
    """A receiver whose compiler is slangc, from PyPI."""

    def install(self):
        self.slangc = pip("slang", SLANGC, options=["--no-deps"]) / "slangtorch/bin/slangc"
        if not self.slangc.exists():
            raise Skipped(f"{SLANGC} holds no slangc for this machine")

    def version(self):
        return "slangc " + run([self.slangc, "-version"])[1].strip()


class Slangc(WithSlangc, Program):
    """Half a second for each file, so that most go into one, each in a namespace of its own."""

    options = []
    reserved = "operator"  # it reads the other keywords as names where only a name can stand

    def texts(self):
        apart = super().texts()
        alone = {name: text for name, text in apart.items() if name.startswith(("model_", "sample_", "table_"))}
        self.together = len(alone) - 1
        # what stands in front
        guards = [f"FRESNEL_{self.language.upper()}_{part}" for part in ("COMMON", "BOUNDARY", "TWOFOLD")]
        together = "".join(f"namespace in_{name} {{\n{text}\n}}\n" +
                           "".join(f"#undef {guard}\n" for guard in guards if guard in text)
                           for name, text in alone.items())
        return {"model_schlick": apart["model_schlick"], "alone": together} | {
            name: text for name, text in apart.items() if name not in alone}

    def check(self):
        report = super().check()
        return report | {"files": report["files"] + self.together}

    def compile_one(self, file):
        made = file.with_suffix(".out.glsl")
        code, said = run([self.slangc, file, *self.options, "-target", "glsl", "-entry", "main", "-o", made])
        return said if code or "warning" in said else ""


@add
class HlslSlangc(Slangc):
    name, language, title = "hlsl-slangc", "hlsl", "HLSL"
    options = ["-lang", "hlsl", "-profile", "ps_5_0"]


@add
class Slang(Slangc):
    name, language, title = "slang", "slang", "Slang"
    options = ["-stage", "fragment"]
