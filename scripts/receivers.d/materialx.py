"""MaterialX: the data library of shaders/materialx, by generation and by compilation of what is generated."""
import json
import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import corpus
import receiver
from receiver import SLANGC, Receiver, add, need, pip, run
from wgsl import naga_says, tint_says

PROGRAMS = Path(__file__).parent / "programs"
METAL_HEADER = Path(__file__).resolve().parents[2] / "tests" / "metal"
METAL = """#include <metal_stdlib>
#define thread
using namespace metal;
struct surfaceshader { float3 color, transparency; };
"""
PACKAGES = ["materialx==1.39.5", "shadewire==0.3.0", SLANGC]


def flattened(text):
    """MaterialX's WGSL text is GLSL with an interface block, which naga does not take: its members one by one."""
    block = re.search(r"layout \(location = 0\) (in|out) VertexData\n\{\n(.*?)\n\} vd;", text, re.S)
    if not block:
        return text
    members = [line.split() for line in block[2].strip().splitlines()]
    lines = [f"layout (location = {i}) {block[1]} {m[0]} vd_{m[1]}" for i, m in enumerate(members)]
    return text.replace(block[0], "\n".join(lines)).replace("vd.", "vd_")


@add
class MaterialX(Receiver):
    name, language, title = "materialx", "glsl", "MaterialX"

    def install(self):
        self.glslang = need("glslangValidator", "glslang-tools")
        self.spirv_val = need("spirv-val", "spirv-tools")
        self.naga = need("fresnel-naga", "it")
        self.packages = pip("materialx", *PACKAGES, options=("--no-deps",))
        self.python = receiver.cache() / "materialx/bin/python"
        self.work = receiver.cache() / "materialx-work"
        self.slangc = self.packages / "slangtorch/bin/slangc"
        self.slangc.chmod(0o755)
        bpy = receiver.cache() / "bpy"
        self.bpy = bpy / "bin/python" if (bpy / "installed").exists() else None
        self.skipped = []
        if self.bpy is None:
            self.skipped.append("osl: no oslc, which ./test --receivers installs")
        self.clang = shutil.which("clang++-19")
        if self.clang is None:
            self.skipped.append("msl: no clang++-19, which scripts/setup installs")

    def version(self):
        return "MaterialX 1.39.5 (glsl essl vulkan wgsl osl msl slang), glslang, naga, Tint, slangc"

    # ---- compilers of what is generated; each returns what was said against a file

    def said(self, *arguments):
        code, text = run(arguments)
        return text.strip() or "refused" if code else ""

    def plain(self, file):
        return self.said(self.glslang, file)

    def plain_are_accepted(self, files):
        """All at once: the compiler takes longer to start than to compile one."""
        return not self.said(self.glslang, *files)

    def spirv(self, file):
        made = f"{file}.spv"
        return self.said(self.glslang, "-V", file, "-o", made) or self.said(self.spirv_val, made)

    def wgsl(self, file):
        """To what naga reads; that is written as WGSL all at once."""
        flat = file.with_name("flat_" + file.name)
        flat.write_text(flattened(file.read_text()))
        return self.spirv(flat)

    def slang(self, file):
        stage = {"vert": "vertex", "frag": "fragment"}[file.suffix[1:]]
        source = file.with_name(f"{file.stem}_{stage}.slang")
        source.write_text(file.read_text())
        return self.said(self.slangc, source, "-target", "glsl", "-stage", stage, "-entry", f"{stage}Main", "-o",
                         f"{source}.glsl")

    def msl(self, file):
        """By clang and the tests' header of Metal's: the functions, without what MaterialX has around them."""
        text = file.read_text()
        end = text.index("    PixelOutputs FragmentMain()")
        source = file.with_suffix(".cpp")
        source.write_text(METAL + text[text.rindex("    float4 out1;\n", 0, end):end])
        return self.said(self.clang, "-std=c++14", "-fsyntax-only", "-nostdinc", "-isystem", METAL_HEADER,
                         "-Wno-unknown-attributes", source)

    def osl(self, files):
        """All at once: Blender takes a second to start."""
        library = self.packages / "MaterialX/libraries/stdlib/genosl/include"
        for header in library.glob("*.h"):
            shutil.copy(header, files[0].parent)
        texts = []
        for file in files:
            texts.append(file.with_suffix(".osl"))
            texts[-1].write_text(file.read_text())
        done = subprocess.run([self.bpy, PROGRAMS / "oslc.py", *texts], capture_output=True, text=True)
        last = done.stdout.strip().splitlines()[-1:]
        return json.loads(last[0]) if done.returncode == 0 and last else [f"oslc.py: {done.stderr}"] * len(files)

    def refusals(self, out):
        """What the compilers say against the files of a folder that MaterialX made."""
        jobs = {"glsl": self.plain, "essl": self.plain, "vulkan": self.spirv, "wgsl": self.wgsl, "slang": self.slang}
        if self.clang:
            jobs["msl"] = self.msl
        found, count = [], 0
        for target, compile_one in jobs.items():
            files = [f for f in sorted((out / target).glob("*")) if self.is_wanted(target, f)]
            count += len(files)
            if compile_one == self.plain and self.plain_are_accepted(files):
                continue
            with ThreadPoolExecutor(os.cpu_count()) as pool:
                said = list(pool.map(compile_one, files))
            found += [f"{target}/{f.name}: {s}" for f, s in zip(files, said) if s]
        flat = sorted((out / "wgsl").glob("flat_*.spv"))
        found += [f"wgsl/{f.name}: {s}" for f, s in zip(flat, naga_says(self.naga, flat, ".wgsl")) if s]
        written = sorted((out / "wgsl").glob("flat_*.wgsl"))
        found += [f"wgsl/{f.name}: {s}" for f, s in zip(written, tint_says(written)) if s]
        if self.bpy:
            files = sorted((out / "osl").glob("*.frag"))
            found += [f"osl/{f.name}: {s}" for f, s in zip(files, self.osl(files)) if s]
            count += len(files)
        return found, count

    @staticmethod
    def is_wanted(target, file):
        """The vertex stage is the same for every node; Slang takes a second for each file."""
        if target == "msl" and file.suffix != ".frag":
            return False
        one_node = file.name.startswith("ND_")
        return not one_node or (file.suffix == ".frag" and (target != "slang" or "boundary" in file.name))

    def generated(self, which, pack, name, documents):
        out = self.work / name
        shutil.rmtree(out, ignore_errors=True)
        code, said = run([self.python, PROGRAMS / "materialx_generate.py", which, pack, out, *documents])
        if code != 0:
            return {"definitions": 0, "names": [], "said": [f"materialx_generate.py ended with {code}: {said}"]}, out
        return json.loads(said.strip().splitlines()[-1]), out

    def shadewire(self, pack):
        """What the stricter reader says of definitions and graphs, and how many nodes it read."""
        code, said = run([self.python, PROGRAMS / "materialx_shadewire.py", pack])
        if code != 0:
            return 0, [f"materialx_shadewire.py ended with {code}: {said}"]
        found = json.loads(said.strip().splitlines()[-1])
        return found["read"], [f"shadewire: {s}" for s in found["said"]]

    # ---- broken libraries and documents

    def broken(self, pack):
        """Copies of the library with one fault each: its name, and the documents that use it."""
        wrong = self.work / "broken"
        shutil.rmtree(wrong, ignore_errors=True)

        def copy(name, file, right, other):
            folder = wrong / name
            shutil.copytree(pack, folder)
            path = folder / file
            text = path.read_text()
            if right not in text:
                raise SystemExit(f"receivers: {file} holds no {right}")
            path.write_text(text.replace(right, other, 1))
            return folder, sorted((folder / "examples").glob("*.mtlx"))

        library = "libraries/fresnel"
        yield "a bracket that is not closed, in GLSL", *copy(
            "bracket", f"{library}/genglsl/mx_fresnel_schlick.glsl", "(x2 * x2 * x)", "(x2 * x2 * x")
        yield "a function= that is not in the source", *copy(
            "function", f"{library}/genglsl/fresnel_genglsl_impl.mtlx", 'function="mx_fresnel_f82_cos_float"',
            'function="mx_fresnel_f28_cos_float"')
        yield "a file= that is not there", *copy(
            "file", f"{library}/genosl/fresnel_genosl_impl.mtlx", "mx_fresnel_f82.osl", "mx_fresnel_f28.osl")
        yield "an argument too many in the source", *copy(
            "argument", f"{library}/genglsl/mx_fresnel_hoffman.glsl", "hoffman_cos_float(float f0,",
            "hoffman_cos_float(float extra, float f0,")
        yield "a node of unknown category", *copy(
            "category", "examples/copper.mtlx", "fresnel_f82_tint", "fresnel_f28_tint")
        yield "an input of another type", *copy(
            "type", "examples/copper.mtlx", 'name="f0" type="color3"', 'name="f0" type="float"')
        yield "a graph that connects what is not there", *copy(
            "graph", f"{library}/fresnel_ng.mtlx", 'nodename="reflectance"', 'nodename="reflection"')
        yield "a graph that gives an input of another type", *copy(
            "input", f"{library}/fresnel_ng.mtlx", 'name="tint" type="color3" interfacename',
            'name="tint" type="vector2" interfacename')
        if self.clang:
            yield "a struct's constructor, in Metal", *copy(
                "metal", f"{library}/genglsl/mx_fresnel_dielectric_boundary.glsl", "fresnel_boundary result;",
                "fresnel_boundary result = fresnel_boundary(0.0, 0.0, 0.0, 0.0);")
        if self.bpy:
            yield "an unknown name, in OSL", *copy(
                "osl", f"{library}/genosl/mx_fresnel_schlick.osl", "float x = 1.0 - cos_i", "float x = 1.0 - cos_j")

    def accepted(self, pack):
        """Faults that were not seen, and how many there are."""
        found, count = [], 0
        for fault, folder, documents in self.broken(pack):
            count += 1
            made, out = self.generated("all", folder, "generated-broken", documents)
            if not made["said"] and not self.refusals_of_all(out) and not self.shadewire(folder)[1]:
                found.append(f"nothing is said against {fault}")
        return found, count

    def refusals_of_all(self, out):
        """Against the shader that holds all nodes, which is enough to see a fault."""
        found = [s for target in ("glsl", "vulkan") if (s := self.spirv(out / target / "all.frag")
                                                        if target == "vulkan" else self.plain(out / target / "all.frag"))]
        if self.clang and (s := self.msl(out / "msl/all.frag")):
            found.append(s)
        return found + ([s for s in self.osl([out / "osl/all.frag"]) if s] if self.bpy else [])

    # ---- the check

    def check(self):
        packs = self.work / "shaders"
        shutil.rmtree(packs, ignore_errors=True)
        self.work.mkdir(parents=True, exist_ok=True)
        subprocess.run([corpus.command(), "shader", "--write", packs], check=True, capture_output=True)
        pack = packs / "materialx"
        made, out = self.generated("each", pack, "generated", sorted((pack / "examples").glob("*.mtlx")))
        refused, files = self.refusals(out)
        accepted, faults = self.accepted(pack)
        read, unread = self.shadewire(pack)
        failures = made["said"] + refused + accepted + unread
        if read < 50:
            failures.append(f"shadewire read only {read} graphs")
        if made["definitions"] < 100:
            failures.append(f"only {made['definitions']} definitions of nodes were found")
        return {"functions": made["definitions"], "files": files, "names": 0, "refused": faults,
                "failures": [receiver.shortened(f) for f in failures], "note": f"; shadewire read {read} graphs; left out: {'; '.join(self.skipped) or 'nothing'}"}
