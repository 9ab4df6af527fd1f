"""OSL executed: every function of the library, the Blender pack and the MaterialX nodes in Blender's Cycles."""
import csv
import io
import json
import re
import shutil
import subprocess
from pathlib import Path

import corpus
import receiver
from receiver import Receiver, Skipped, add, pip, run

PROGRAMS = Path(__file__).parent / "programs"
PACKAGES = ["bpy==5.0.1"]
NEEDED_GB = 3
TOGETHER = 12  # cases that one Blender runs

# What may differ from the model's float32 where OSL does not compute as C++ does: its pow, exp2 and log2 are
# approximations of its own; its dot product is fma(z, z', fma(x, x', y y')), so that a cosine differs by a last place,
# which near a critical angle or an index match is far more of a reflectance.
COSINE, TRANSCENDENTAL, DIRECTIONS, METAL = 1.2e-7, 5e-4, 2e-3, 1e-6


def fresnel(*arguments, text=None):
    done = subprocess.run([corpus.command(), *arguments], input=text, capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def python_of_bpy():
    """bpy has wheels for one version of Python."""
    found = shutil.which("python3.11")
    if not found:
        raise Skipped("no python3.11, the one Python that bpy 5.0 runs in")
    return found


def adapted(case, pack):
    """The text of a MaterialX node of the case's model, and a function of the model's own name that calls it."""
    kind = "color3" if case["results"] == 3 else "float"
    folder = Path(pack) / "libraries/fresnel/genosl"
    source = re.sub(r'#include "(lib/fresnel_[a-z]+\.osl)"', lambda include: (folder / include[1]).read_text(),
                    (folder / f"mx_fresnel_{case['name']}.osl").read_text())
    words = {1: "float", 3: "color"}
    names = [a["name"] for a in case["arguments"]]
    given = ", ".join(f"{words[a['width']]} {a['name']}" for a in case["arguments"])
    return (f"{source}\n{words[case['results']]} {case['call']['osl'].split('(')[0]}({given}) {{\n"
            f"    {words[case['results']]} result = 0.0;\n"
            f"    mx_fresnel_{case['name']}_cos_{kind}({', '.join(names)}, result);\n    return result;\n}}\n")


class Failure(Exception):
    pass


@add
class Cycles(Receiver):
    name, language, title, heavy = "cycles", "osl", "OSL executed", True

    def install(self):
        self.own = receiver.cache() / "bpy"
        if not (self.own / "installed").exists() and shutil.disk_usage(receiver.cache().parent).free < NEEDED_GB << 30:
            raise Skipped(f"less than {NEEDED_GB} GB are free for bpy")
        pip("bpy", *PACKAGES, python=python_of_bpy())
        self.work = receiver.cache() / "cycles"
        self.work.mkdir(parents=True, exist_ok=True)

    def version(self):
        return "Cycles of Blender 5.0.1"

    def blender(self, program, *arguments):
        """What a program of ours prints last, as JSON if it is."""
        code, said = run([self.own / "bin/python", PROGRAMS / program, *arguments])
        last = said.strip().splitlines()[-1] if said.strip() else ""
        if code != 0:
            raise Failure(f"{program} ended with {code}:\n" + "\n".join(said.strip().splitlines()[-8:]))
        return json.loads(last) if last.startswith("[") else last

    # ---- the library's functions

    def run_cases(self, folder, name, ids):
        """Runs cases and compares them; returns the rows of the table."""
        rows = []
        for i in range(0, len(ids), TOGETHER):
            rows += self.blender("cycles_run.py", folder, name, *ids[i:i + TOGETHER])
        messages = [f"{r['id']}: {r['message']}" for r in rows if "message" in r]
        if messages:
            raise Failure("\n".join(messages))
        return rows

    @staticmethod
    def bound(case):
        """Largest difference allowed; 0 is bit by bit."""
        if any(a["name"] == "direction" for a in case["arguments"]):
            return COSINE if case["name"] in ("incidence_cosine", "one_minus_cos") else DIRECTIONS
        return TRANSCENDENTAL if case["transcendental"] else 0

    def wrong(self, rows, cases):
        """What of the table is not as stated."""
        found = []
        for r in rows:
            bound = self.bound(cases[r["id"]])
            if r["compared"] == 0 or (r["differing"] if bound == 0 else r["max_difference"] > bound):
                found.append(f"{r['id']}: {r['differing']} of {r['compared']} differ, by {r['max_difference']:.3g} "
                             f"at most; allowed {bound:g}")
        return found

    def dump(self):
        folder = self.work / "cases"
        shutil.rmtree(folder, ignore_errors=True)
        code, _, error = fresnel("shader", "--verify", "--dump", str(folder))
        if code != 0:
            raise Failure(f"fresnel shader --verify --dump: {error}")
        return folder, {c["id"]: c for c in json.loads((folder / "cases.json").read_text())}

    def check_library(self, folder, cases):
        rows = self.run_cases(folder, "cycles", list(cases))
        exact = [r for r in rows if self.bound(cases[r["id"]]) == 0]
        self.said.append(f"{len(exact)} functions of + - * / sqrt on {sum(r['compared'] for r in exact)} inputs: "
                         f"{sum(r['differing'] for r in exact)} differ")
        for bound, what in ((TRANSCENDENTAL, "with OSL's pow, exp2, log2"), (COSINE, "cosines of directions"),
                            (DIRECTIONS, "others of directions")):
            group = [r for r in rows if self.bound(cases[r["id"]]) == bound]
            self.said.append(f"{len(group)} {what}: by {max(r['max_difference'] for r in group):.2g} at most")
        if len(rows) != len(cases):
            raise Failure(f"{len(rows)} of {len(cases)} functions were compared")
        return len(rows), self.wrong(rows, cases)

    def check_mutations(self, folder, cases):
        """Texts that are wrong a little must be seen to differ."""
        mutations = {"schlick": ("x2 * x2 * x", "x2 * x2"), "f82": ("17.651384", "17.651388"),
                     "conductor": ("(R_s + R_p) / 2.0", "(R_s + R_s) / 2.0")}
        accepted = []
        for name, (right, other) in mutations.items():
            text = (folder / cases[name]["text"]["osl"]).read_text()
            if right not in text:
                accepted.append(f"{name}: its text has no {right} to be changed")
                continue
            (folder / f"{name}.mutated.osl").write_text(text.replace(right, other, 1))
        changed = [n for n in mutations if (folder / f"{n}.mutated.osl").exists()]
        rows = self.run_cases(folder, "mutated", changed)
        seen = [message.split(":")[0] for message in self.wrong(rows, cases)]
        return len(seen), accepted + [f"{n} with another text is not seen to differ" for n in changed if n not in seen]

    # ---- the packs

    def check_materialx(self, folder, cases, packs):
        """The source text of the MaterialX nodes, as numbers and as colours."""
        ids = [c["id"] for c in cases.values() if c["kind"] in ("scalar", "rgb")]
        for name in ids:
            (folder / f"{name}.materialx.osl").write_text(adapted(cases[name], packs / "materialx"))
        rows = self.run_cases(folder, "materialx", ids)
        self.said.append(f"{len(rows)} MaterialX nodes")
        return self.wrong(rows, cases)

    def check_blender(self, folder, cases, packs):
        """The Blender pack in Script nodes, and one of its files changed."""
        pack = packs / "blender"
        broken = self.work / "broken"
        shutil.rmtree(broken, ignore_errors=True)
        broken.mkdir()
        text = (pack / "fresnel_f82_tint.osl").read_text()
        (broken / "fresnel_f82_tint.osl").write_text(text.replace("(f0, tint, cos_i);\n}", "(f0, f0, cos_i);\n}"))
        (broken / "fresnel_schlick.osl").write_text(
            (pack / "fresnel_schlick.osl").read_text().replace("incidence_cosine(Normal", "incidence_cosin(Normal"))
        found = self.blender("cycles_pack.py", folder, pack)
        bad = [f"blender/{f['file']} ({f['mode']}): {self.complaint(f, cases)}" for f in found if self.complaint(f, cases)]
        seen = [f["file"] for f in self.blender("cycles_pack.py", folder, broken) if self.complaint(f, cases)]
        bad += [f"broken {f.name} is not seen to be wrong" for f in broken.glob("*.osl") if f.name not in seen]
        self.said.append(f"{len({f['file'] for f in found})} Blender shaders")
        return len(found), len(set(seen)), bad

    @staticmethod
    def complaint(found, cases):
        model = found["file"].removesuffix(".osl").removeprefix("fresnel_")
        bound = TRANSCENDENTAL if cases[model]["transcendental"] else 0
        if "message" in found:
            return found["message"]
        if found["compared"] > 0 and (found["max_difference"] <= bound if bound else found["differing"] == 0):
            return ""
        return f"{found['differing']} of {found['compared']} differ, by {found['max_difference']:.3g} at most"

    # ---- Cycles' own metal

    def check_metal(self):
        """F82 with a tint and the conductor against Cycles' Metallic BSDF, which we did not write."""
        colours = {"f82": ((0.9, 0.6, 0.3), (1, 0.9, 0.8)), "conductor": ((0.2, 0.9, 1.2), (3.4, 2.4, 2.2))}
        bad, worst = [], {}
        for kind, (first, second) in colours.items():
            out = self.work / f"metal_{kind}.csv"
            self.blender("cycles_metal.py", out, kind, *[",".join(map(str, c)) for c in (first, second)])
            rows = list(csv.DictReader(open(out)))
            model, names = ("f82_tint", "f0,tint") if kind == "f82" else ("conductor", "n_t,k_t")
            difference = max(self.metal_difference(rows, model, names, c, first[i], second[i])
                             for i, c in enumerate("rgb"))
            worst[kind] = f"{difference:.2g} at {len(rows)} angles"
            if len(rows) < 1000 or difference > METAL:
                bad.append(f"Cycles' metal {kind}: differs by {difference:.3g} at {len(rows)} angles; allowed {METAL:g}")
        self.said.append("Cycles' Metallic BSDF against f82_tint " + worst["f82"] + ", conductor " + worst["conductor"])
        return bad

    @staticmethod
    def metal_difference(rows, model, names, channel, first, second):
        text = f"{names},cos_i\n" + "".join(f"{first},{second},{r['cos_i']}\n" for r in rows)
        code, said, error = fresnel("eval", model, "--csv", "-", text=text)
        if code != 0:
            raise Failure(f"fresnel eval {model}: {error}")
        ours = [float(r["R"]) for r in csv.DictReader(io.StringIO(said))]
        return max(abs(a - float(r[channel])) for a, r in zip(ours, rows, strict=True))

    def check(self):
        self.said, failures = [], []
        report = {"functions": 0, "files": 0, "names": 0, "refused": 0, "failures": failures}
        try:
            packs = self.work / "shaders"
            shutil.rmtree(packs, ignore_errors=True)
            fresnel("shader", "--write", str(packs))
            folder, cases = self.dump()
            report["functions"], wrong = self.check_library(folder, cases)
            failures += wrong
            report["refused"], wrong = self.check_mutations(folder, cases)
            failures += wrong + self.check_materialx(folder, cases, packs)
            report["files"], refused, wrong = self.check_blender(folder, cases, packs)
            report["refused"] += refused
            failures += wrong + self.check_metal()
        except Failure as failure:
            failures.append(str(failure))
        report["note"] = "; " + "; ".join(self.said)
        return report
