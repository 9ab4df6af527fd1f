"""The programs of `fresnel shader --technique` and the passes of Unity's shaders, by FXC and slangc."""
import re
import shutil
from pathlib import Path

import corpus
from hlsl import WithSlangc
from microsoft import OLD_SAMPLERS, Microsoft
from receiver import WEBGPU_AS_READ, Broken, Receiver, add, cache, run, shortened

TECHNIQUES = ["none", "one-minus-cos", "per-vertex", "per-pixel", "lut", "highlights", "semitransparent"]
STUBS = Path(__file__).resolve().parents[2] / "tests" / "unity"


def programs(language, models, few):
    """Each of the models per pixel, and a few by every technique; what stands around a model is the same for all."""
    every = [(model, "per-pixel") for model in models]
    every += [(model, technique) for technique in TECHNIQUES if technique not in ("per-pixel", "lut") for model in few]
    every += [("schlick", "lut"), ("schlick --fix f0=1,0.78,0.34", "lut")]
    return {re.sub(r"[^\w-]+", "_", f"{technique}_{model}"): corpus.shader(f"{model} --technique {technique}", language)
            for model, technique in every}


def without_a_uniform(text):
    """A program with a fault: a uniform that nobody declares."""
    at = text.rindex("ambient_color")
    return text[:at] + "ambient_colour" + text[at + len("ambient_color"):]


class Programs:
    """Texts with two entry points each, in a folder of their own."""

    def write(self, texts, extension):
        folder = cache() / "programs" / self.name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        files = []
        for name, text in texts.items():
            files.append(folder / f"{name}{extension}")
            files[-1].write_text(text)
        return files

    def report(self, texts, messages, broken, broken_messages):
        failures = [f"{name}: {message}" for name, message in zip(texts, messages) if message]
        failures += [f"{self.name} accepts {b.fault}" for b, message in zip(broken, broken_messages) if not message]
        return {"functions": 0, "files": len(texts), "names": 0, "refused": len(broken),
                "failures": [shortened(f) for f in failures]}


# ---- programs ----------------------------------------------------------------------------------------------------------


@add
class ProgramsFxc(Programs, Microsoft):
    name, title, which, library = "programs-fxc", "HLSL and Cg programs", "fxc", "d3dcompiler_47.dll"
    stages = {"hlsl": [("vs_5_0", "vertex_main"), ("ps_5_0", "fragment_main")],
              "cg": [("vs_3_0", "vertex_main"), ("ps_3_0", "fragment_main")]}

    def version(self):
        return f"FXC of {WEBGPU_AS_READ} (vs/ps_5_0, vs/ps_3_0)"

    def compile_texts(self, texts, stages):
        files = self.write(texts, ".hlsl")
        found = self.jobs([(profile, entry, file) for file in files for profile, entry in stages])
        return ["\n".join(m for m, _ in found[i:i + len(stages)] if m) for i in range(0, len(found), len(stages))]

    def check(self):
        texts, messages, broken, broken_messages = {}, [], [], []
        for language, stages in self.stages.items():
            old = OLD_SAMPLERS if language == "cg" else ""
            printed = programs(language, corpus.models(), ["schlick", "dielectric", "f82"])
            own = {f"{language}_{name}": old + text for name, text in printed.items()}
            messages += self.compile_texts(own, stages)
            texts.update(own)
            fault = Broken("a program with an unknown uniform", without_a_uniform(own[f"{language}_per-pixel_schlick"]))
            broken.append(fault)
            broken_messages += self.compile_texts({"broken": fault.text}, stages)
        return self.report(texts, messages, broken, broken_messages)


@add
class ProgramsSlang(WithSlangc, Programs, Receiver):
    name, language, title = "programs-slang", "slang", "Slang programs"

    def compile_one(self, file):
        for stage in "vertex", "fragment":
            code, said = run([self.slangc, file, "-target", "hlsl", "-profile", "sm_5_0", "-stage", stage,
                              "-entry", f"{stage}_main", "-o", file.with_suffix(f".{stage}.hlsl")])
            if code or "warning" in said:
                return said
        return ""

    def check(self):
        texts = programs("slang", ["schlick"], ["schlick"])  # a second for each; its functions are compiled elsewhere
        messages = self.compile(self.write(texts, ".slang"))
        fault = Broken("a program with an unknown uniform", without_a_uniform(texts["per-pixel_schlick"]))
        return self.report(texts, messages, [fault], self.compile(self.write({"broken": fault.text}, ".slang")))


# ---- Unity -------------------------------------------------------------------------------------------------------------


def included(file, folders, seen):
    """A text with its includes put in place, each once."""
    lines = []
    for line in file.read_text().splitlines():
        found = re.match(r'\s*#include "(.*)"', line)
        if not found:
            lines.append(line)
            continue
        path = next((p.resolve() for p in [file.parent / found[1], *(f / found[1] for f in folders)] if p.exists()), None)
        if path is None:
            lines.append(line)  # the compiler says that it is missing
        elif path not in seen:
            seen.add(path)
            lines += included(path, folders, seen)
    return lines


def strict(lines):
    """What FXC's strict mode wants: no pragmas of Unity's, textures and samplers apart."""
    text = "\n".join(line for line in lines if not line.strip().startswith("#pragma ")) + "\n"
    for kind, new in ("2D", "Texture2D"), ("CUBE", "TextureCube"):
        text = re.sub(rf"\bsampler{kind} (\w+);", rf"{new} \1; SamplerState sampler\1;", text)
        text = re.sub(rf"\btex{kind}\((\w+), ", r"\1.Sample(sampler\1, ", text)
    return text


@add
class UnityFxc(ProgramsFxc):
    """Each pass of each shader, against the stub of Unity's includes that the tests use."""

    name, title = "unity-fxc", "Unity's passes"

    def version(self):
        return f"FXC of {WEBGPU_AS_READ} (vs_5_0, ps_5_0)"

    @staticmethod
    def passes(printed, folder):
        """The texts of the passes by the functions that they begin with, from what unity_passes prints."""
        found = {}
        for line in printed.splitlines():
            path, vertex, fragment = line.split()
            name = "_".join(Path(path).relative_to(folder).parts[-2:])
            entries = (("vs_5_0", vertex), ("ps_5_0", fragment))
            found.setdefault(entries, {})[name] = strict(included(Path(path), [STUBS], set()))
        return found

    def check(self):
        folder = cache() / "programs" / "unity"
        shutil.rmtree(folder, ignore_errors=True)
        code, said = run([corpus.build_folder() / "unity_passes", folder])
        if code != 0:
            raise SystemExit(f"receivers: unity_passes: {said}")
        texts, messages = {}, []
        for entries, passes in self.passes(said, folder).items():
            texts.update(passes)
            messages += self.compile_texts(passes, entries)
        lit = texts["BuiltIn_Lit.ForwardBase.hlsl"]
        broken = [Broken("an undeclared property", lit.replace("_Bias, _Scale, _Power;", "_Bias, _Scale;")),
                  Broken("an unknown function", lit.replace("bias_scale_power(_Bias", "bias_scale_pow(_Bias"))]
        entries = [("vs_5_0", "surface_vertex"), ("ps_5_0", "surface_fragment")]
        refused = self.compile_texts({f"broken_{i}": b.text for i, b in enumerate(broken)}, entries)
        return self.report(texts, messages, broken, refused)
