"""HLSL by FXC and DXC, Microsoft's own compilers: the libraries of npm's webgpu, in wine, behind a driver of ours."""
import json
import os
import shutil
from pathlib import Path

import corpus
from callers import TABLE_OF_HLSL, call, statements
from receiver import WEBGPU, WEBGPU_AS_READ, Receiver, Skipped, add, apt, cache, functions, install, locked, npm, run

HERE = Path(__file__).parent
OLD_SAMPLERS = "#define sampler2D sampler\n#define samplerCUBE sampler\n"  # those of shader model 3 have one name in strict mode


class Microsoft(Receiver):
    language, title, heavy = "hlsl", "HLSL", True
    which = ""     # as hlslc takes it
    library = ""   # in the npm package
    profiles = {}  # profile: the semantic of a pixel's colour

    def install(self):
        apt("wine64", "wine", "g++-mingw-w64-x86-64-posix")
        libraries = npm(WEBGPU) / "webgpu/dist/win32-x64"
        self.place = cache() / "microsoft"
        self.place.mkdir(parents=True, exist_ok=True)
        self.environment = dict(os.environ, WINEPREFIX=str(self.place / "wine"), WINEDEBUG="-all", DISPLAY="")
        with locked("microsoft"):
            # under a name of its own, or wine takes its own library for it
            self.own = self.place / f"ms_{self.library}"
            shutil.copy(libraries / self.library, self.own)
            self.driver = self.place / "hlslc.exe"
            source = HERE / "hlslc.cpp"
            if not self.driver.exists() or self.driver.stat().st_mtime < source.stat().st_mtime:
                install(["x86_64-w64-mingw32-g++-posix", "-O1", "-std=c++17", "-static", "-o", self.driver, source],
                        "hlslc.exe")
            if not (self.place / "wine" / "system.reg").exists():
                code, said = run(["wineboot", "-i"], env=self.environment)
                if code != 0:
                    raise Skipped(f"wine does not start: {said.strip()[-200:]}")

    def jobs(self, all_of_them):
        """Compiles (profile, entry, file) or, for FXC, (profile, entry, file, listing) each; returns the message and the
        instruction slots of each."""
        listed = self.place / f"{self.which}.list"
        listed.write_text("".join(" ".join(map(str, job)) + "\n" for job in all_of_them))
        code, said = run(["wine", self.driver, self.which, self.own, listed], env=self.environment, cwd=self.place)
        results = []
        for part in said.replace("\r", "").split("== ")[1:]:
            head, _, message = part.partition("\n")
            results.append(("", int(head[3:])) if head.startswith("OK") else (message.strip() or "refused", 0))
        if len(results) != len(all_of_them):
            raise SystemExit(f"receivers: hlslc ended with {code} after {len(results)} of {len(all_of_them)}: {said[-500:]}")
        return results

    def program(self, text):
        return (text + "\n" + TABLE_OF_HLSL + "float4 main(float3 harness_three : TEXCOORD0) : SEMANTIC {\n"
                "    float harness_one = harness_three.x, harness_sum = 0.0;\n"
                + statements("hlsl", text, direction="harness_three") +
                "\n    return float4(harness_sum, 0.0, 0.0, 1.0);\n}\n")

    def compile(self, files):
        messages = [""] * len(files)
        for profile, semantic in self.profiles.items():
            all_of_them = []
            for file in files:
                own = file.with_suffix(f".{profile}.hlsl")
                own.write_text(file.read_text().replace("SEMANTIC", semantic))
                all_of_them.append((profile, "main", own))
            for i, (message, _) in enumerate(self.jobs(all_of_them)):
                if message and not messages[i]:
                    messages[i] = f"{profile}: {message}"
        return messages


@add
class Fxc(Microsoft):
    name, which, library = "hlsl-fxc", "fxc", "d3dcompiler_47.dll"
    profiles = {"ps_5_0": "SV_Target"}
    old = {"ps_2_0": 64, "vs_2_0": 256, "ps_3_0": 512}  # and the arithmetic slots they have

    def version(self):
        return f"FXC of {WEBGPU_AS_READ} (ps_5_0)"

    def check(self):
        """Beside the whole texts in shader model 5: each function alone in 2 and 3, where it fits."""
        report = super().check()
        text = self.texts()["library"]
        every = functions("hlsl", text)
        file = cache() / "programs" / self.name / "old.hlsl"
        file.write_text(text + "".join(entry(i, function) for i, function in enumerate(every)))
        report["slots"] = {label(function): {} for function in every}
        for profile in self.old:
            stage = profile[:2]
            results = self.jobs([(profile, f"{stage}_{i}", file) for i in range(len(every))])
            for function, (message, slots) in zip(every, results):
                report["slots"][label(function)][profile] = slots
                if message and not is_size(message):
                    report["failures"].append(f"{profile} {label(function)}: {message}")
        said, table_slots = self.tables()
        report["failures"] += said
        fits = {p: sum(1 for slots in report["slots"].values() if slots[p]) for p in self.old}
        report["note"] = "; " + ", ".join(f"{n} of {len(every)} fit {p}" for p, n in fits.items())
        report["note"] += f"; {len(table_slots)} tables in {min(table_slots)} to {max(table_slots)} slots of ps_2_0"
        report["files"] += len(corpus.TABLES)
        (cache() / "reports" / "hlsl_slots.json").write_text(json.dumps(report["slots"], indent=1))
        return report


    def tables(self):
        """The functions that read tables, in shader models 2 and 3, and one that must be refused: what is said against
        them, and their slots in ps_2_0."""
        texts = corpus.tables("cg")
        texts["broken"] = texts["table_0_dielectric"].replace("float2(u,", "float2(unknown,")
        all_of_them = []
        for name, text in texts.items():
            file = cache() / "programs" / self.name / f"{name}.cg.hlsl"
            function = functions("hlsl", text)[0]
            file.write_text(OLD_SAMPLERS + "sampler2D harness_table;\n" + text + table_entry(function))
            all_of_them += [(profile, "main", file) for profile in ("ps_2_0", "ps_3_0")]
        results = self.jobs(all_of_them)
        said = [f"{profile} {file.stem}: {message}" for (profile, _, file), (message, _) in zip(all_of_them, results)
                if message and file.stem != "broken.cg"]
        if not all(message for message, _ in results[-2:]):
            said.append("hlsl-fxc accepts a table's function with an unknown name")
        return said, [slots for (_, slots) in results[:-2:2]]


def is_size(message):
    """Whether a function is refused for needing more slots than the profile has, and for nothing else."""
    return all("X5608" in line or "X5609" in line for line in message.splitlines())


def label(function):
    return f"{function.result} {function.name}({', '.join(function.arguments)})"


def entry(i, function):
    """A vertex and a pixel program that do nothing but call it."""
    inputs, texts = [], []
    for k, kind in enumerate(function.arguments):
        inputs.append(f"{kind} a{k} : TEXCOORD{k}")
        texts.append(f"a{k}")
    called = f"{function.name}({', '.join(texts)})"
    colour = {"float": f"float4({called}, 0.0, 0.0, 1.0)", "float2": f"float4({called}, 0.0, 1.0)",
              "float3": f"float4({called}, 1.0)"}.get(function.result, "float4(all.R_s, all.R_p, all.T_s, all.T_p)")
    before = f"    fresnel_boundary all = {called};\n" if function.result == "fresnel_boundary" else ""
    listed = ", ".join(inputs)
    return (f"\nfloat4 ps_{i}({listed}) : COLOR {{\n{before}    return {colour};\n}}\n"
            f"\nvoid vs_{i}({listed}, float4 at : POSITION, out float4 to : POSITION, out float4 c : COLOR) {{\n"
            f"{before}    to = at;\n    c = {colour};\n}}\n")


def table_entry(function):
    """A pixel program that reads a table."""
    value = call("hlsl", function, "harness_three.x", "harness_three", "harness_three")
    colour = f"float4({value}, 1.0)" if function.result == "float3" else f"float4({value}, 0.0, 0.0, 1.0)"
    return f"\nfloat4 main(float3 harness_three : TEXCOORD0) : COLOR {{\n    return {colour};\n}}\n"


@add
class Dxc(Microsoft):
    name, which, library = "hlsl-dxc", "dxc", "dxcompiler.dll"
    profiles = {"lib_6_3": "SV_Target", "ps_6_0": "SV_Target"}

    def version(self):
        return f"DXC of {WEBGPU_AS_READ} (lib_6_3, ps_6_0)"
