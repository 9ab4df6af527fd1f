"""What all receivers share: packages and their cache, the texts wrapped into programs, the broken texts."""
import contextlib
import fcntl
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import corpus

registered = []

# npm's package with Tint, and with Microsoft's FXC and DXC
WEBGPU = "webgpu@0.6.2"
WEBGPU_AS_READ = WEBGPU.replace("@", " ")

SLANGC = "slangtorch==1.3.22"  # PyPI's package with slangc


class Skipped(Exception):
    """The receiver cannot be had here; the message says why."""


# ---- packages ------------------------------------------------------------------------------------------------------------


def cache():
    root = Path(__file__).resolve().parents[2]
    return Path(os.environ.get("FRESNEL_CACHE", root / "build" / "receivers")).resolve()


@contextlib.contextmanager
def locked(name):
    """Holds others of that name off: tests run side by side."""
    cache().mkdir(parents=True, exist_ok=True)
    with open(cache() / f".{name}.lock", "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


def run(arguments, **options):
    """Returns the exit code and all that was printed."""
    try:
        done = subprocess.run([str(a) for a in arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, text=True, errors="replace", timeout=600, **options)
    except FileNotFoundError as missing:
        return 127, str(missing)
    except subprocess.TimeoutExpired as late:
        return 124, f"{arguments[0]} did not end in {late.timeout} seconds"
    return done.returncode, done.stdout


def need(program, package):
    """The path of a program, or Skipped with the package that holds it."""
    found = shutil.which(program)
    if not found:
        raise Skipped(f"no {program}; scripts/setup installs {package}")
    return found


def install(arguments, what):
    code, said = run(arguments)
    if code != 0:
        raise Skipped(f"{what} cannot be installed: {said.strip().splitlines()[-1] if said.strip() else code}")


def pip(folder, *packages, python=sys.executable, options=()):
    """A virtual environment of the cache with these packages; returns its folder of packages."""
    place = cache() / folder
    wanted = place / "installed"
    with locked(folder):
        if not wanted.exists() or wanted.read_text() != " ".join(packages):
            print(f"receivers: installing {' '.join(packages)}", file=sys.stderr, flush=True)
            install([python, "-m", "venv", "--clear", place], "a virtual environment")
            install([place / "bin/pip", "-q", "--disable-pip-version-check", "install", *options, *packages],
                    " ".join(packages))
            wanted.write_text(" ".join(packages))
    return next((place / "lib").glob("python3*/site-packages"))


def npm(*packages):
    """npm packages in the cache; returns node_modules."""
    place = cache() / "npm"
    need("node", "nodejs")
    with locked("npm"):
        missing = [p for p in packages if not (place / f"installed-{p}").exists()]
        if missing:
            print(f"receivers: installing {' '.join(missing)}", file=sys.stderr, flush=True)
            place.mkdir(parents=True, exist_ok=True)
            install([need("npm", "npm"), "install", "--no-audit", "--no-fund", "--prefix", place, *missing],
                    " ".join(missing))
            for p in missing:
                (place / f"installed-{p}").touch()
    return place / "node_modules"


def apt(*packages):
    """Debian packages that only the heavy receivers need."""
    def status(package):
        return run(["dpkg-query", "-W", "-f=${db:Status-Status}", package])[1]
    missing = [p for p in packages if status(p) != "installed"]
    if not missing:
        return
    if os.getuid() != 0 or not shutil.which("apt-get"):
        raise Skipped(f"as root: apt-get install {' '.join(missing)}")
    print(f"receivers: installing {' '.join(missing)}", file=sys.stderr, flush=True)
    with locked("apt"):
        run(["apt-get", "update", "-qq"])
        install(["apt-get", "install", "-y", "-qq", "--no-install-recommends", *missing], " ".join(missing))


# ---- texts ---------------------------------------------------------------------------------------------------------------


class Function:
    """A function of a text: its name, the types of its arguments and of its result."""

    def __init__(self, name, arguments, result):
        self.name, self.result = name, result
        self.arguments = arguments


def functions(language, text):
    """All that a text defines. Those inside `namespace NAME {`, at the start of a line, are called NAME::..."""
    text = re.sub(r"([,(])\n +", r"\1 ", text)  # a long head goes on in the next line
    if language == "wgsl":
        found = re.findall(r"^fn (\w+)\((.*)\) -> (\w+) \{$", text, re.M)
        return [Function(n, [a.split(": ")[1] for a in args.split(", ")], result) for n, args, result in found]
    inside, all_of_them = "", []
    for line in text.splitlines():
        if opens := re.match(r"namespace (\w+) \{$", line):
            inside = opens[1] + "::"
        found = re.match(r"(?:static inline |inline |FRESNEL_FUNCTION )?(\w+) (\w+)\((.*)\) \{$", line)
        if found:
            result, name, arguments = found.groups()
            result = inside + result if result == "fresnel_boundary" else result
            all_of_them.append(Function(inside + name, [a.split(" ")[0] for a in arguments.split(", ")], result))
    return all_of_them


class Broken:
    """A text with one fault in it, which a receiver must refuse."""

    def __init__(self, fault, text):
        self.fault, self.text = fault, text


def broken_texts(language, text, reserved):
    """The text of schlick with each fault that a receiver must see."""
    head = text.rindex("\n", 0, text.index(" schlick(")) + 1
    other = "struct other { x: f32 }\n" if language == "wgsl" else "struct other { float x; };\n"
    wrong = {"wgsl": "var wrong: other;", "c": "struct other wrong;"}.get(language, "other wrong;")
    first = text.index("return ", head)
    end = text.index(";", first)
    returned = text[first:end]

    def instead(statement):
        return text[:first] + statement + text[end:]

    return [Broken("a bracket that is not closed", instead(returned + ")")),
            Broken("an unknown name", instead(returned.replace("f0", "f1", 1))),
            Broken("an argument too few", instead("return incidence_cosine()")),
            Broken("a result of another type",
                   text[:head] + other + text[head:first] + wrong + " return wrong" + text[end:]),
            Broken("an unknown function", instead("return unknown_function(f0)")),
            Broken(f"a function called {reserved}", text.replace(" schlick(", f" {reserved}("))]


# ---- receivers -----------------------------------------------------------------------------------------------------------


class Receiver:
    """One compiler or validator of one language. A class of its own for each; `@receiver.add` makes it known."""

    name = ""          # as scripts/receivers takes it
    language = ""      # whose texts it compiles
    title = ""         # the language as a reader knows it
    heavy = False      # whether only ./test --receivers runs it
    reserved = "if"    # a word that no function may be called by
    extension = ""     # of the program's file, with the dot; the language's own if empty

    def install(self):
        """Finds the compiler or installs it; raises Skipped."""

    def version(self):
        """The compiler's name and version."""
        raise NotImplementedError

    def program(self, text):
        """A text as a whole program that calls every function of it."""
        return text

    def compile(self, files):
        """Compiles each file; returns a message for each, empty where all is well."""
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            return list(pool.map(self.compile_one, files))

    def compile_one(self, file):
        raise NotImplementedError

    # ---- the check

    def texts(self):
        folder, extension = corpus.folder(self.language), corpus.LANGUAGES[self.language]
        return {file.stem: file.read_text() for file in sorted(folder.glob(f"*.{extension}"))}

    def written(self, texts):
        """The programs of these texts as files."""
        folder = cache() / "programs" / self.name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        files = []
        for name, text in texts.items():
            files.append(folder / f"{name}{self.extension or '.' + corpus.LANGUAGES[self.language]}")
            files[-1].write_text(self.program(text))
        return files

    def broken(self, texts):
        return {f"broken_{i}": broken for i, broken in
                enumerate(broken_texts(self.language, texts["model_schlick"], self.reserved))}

    def failures(self, texts):
        messages = self.compile(self.written(texts))
        failed = [f"{name}: {message}" for name, message in zip(texts, messages) if message]
        if any(f.startswith("names: ") for f in failed):
            failed.append("names that are refused: " + " ".join(self.refused_names(texts["names"])))
        return failed

    def refused_names(self, text):
        """Which functions of a text are not accepted, found by halving it."""
        blocks = text.split("\n\n")
        first = next(i for i, block in enumerate(blocks) if "incidence_cosine(" in block and "{" in block) + 1
        first += blocks[first].startswith("#endif")  # of what all share
        groups = [blocks[first:]]
        refused = []
        while groups:
            parts = {f"part_{i}": "\n\n".join(blocks[:first] + group) + "\n" for i, group in enumerate(groups)}
            failed = [g for g, message in zip(groups, self.compile(self.written(parts))) if message]
            refused += [functions(self.language, g[0])[0].name for g in failed if len(g) == 1]
            groups = [half for g in failed if len(g) > 1 for half in (g[:len(g) // 2], g[len(g) // 2:])]
        return refused

    def accepted_broken(self, broken):
        messages = self.compile(self.written({name: b.text for name, b in broken.items()}))
        return [f"{self.name} accepts {b.fault}" for b, message in zip(broken.values(), messages) if not message]

    def check(self):
        texts = self.texts()
        broken = self.broken(texts)
        failures = self.failures(texts) + self.accepted_broken(broken)
        count = {name: len(functions(self.language, text)) for name, text in texts.items()}
        return {"functions": count["library"], "files": len(texts), "names": count["names"],
                "refused": len(broken), "failures": [shortened(f) for f in failures]}


def shortened(message, lines=12):
    parts = message.strip().splitlines()
    return "\n".join(parts[:lines] + ([f"... {len(parts) - lines} more lines"] if len(parts) > lines else []))


def add(kind):
    registered.append(kind())
    return kind
