"""What the receivers compile: the texts that the command prints, in one folder for each language."""
import json
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import receiver

LANGUAGES = {"glsl": "glsl", "essl": "essl", "hlsl": "hlsl", "msl": "metal", "wgsl": "wgsl", "osl": "osl",
             "cuda": "cuh", "c": "h", "slang": "slang"}

# Beside every model as it is: constants of each kind, folded in different ways, and the fits to a material.
SAMPLES = [
    "schlick --fix f0=0.04", "schlick --fix f0=1,0.78,0.34", "schlick_f90 --fix f90=1",
    "schlick_f90 --fix f0=0.04,0.05,0.06 --fix f90=1", "dielectric --fix n_i=1", "dielectric --fix n_i=1 --fix n_t=1.5",
    "conductor --fix n_i=1.333", "conductor --fix n_i=1 --fix n_t=0.2,0.9,1.2 --fix k_t=3,2.4,2.2",
    "conductor --fix k_t=0", "conductor_precise --fix k_t=1,2,3", "schlick_internal --fix eta=0.75",
    "hoffman --fix power=5 --fix f90=1", "bias_scale_power --fix bias=0 --fix scale=1 --fix power=5",
    "lazanyi --fix alpha=6", "constant --fix f0=0.5", "spherical_gaussian --fix f0=1", "f82 --fix f82=0.9",
    "f82_tint --fix tint=1,0.5,0.25",
    "schlick --material gold", "gulbrandsen --material gold", "f82 --material gold", "f82_tint --material copper",
    "schlick --material gold --space acescg --name gold",
]

# Tables, whose functions read textures; tests compile those of the other languages.
TABLES = [
    "dielectric --fix n_t=1.5", "gold", "dielectric --by eta --format rgba32f", "gold --format r8 --map cos",
    "dielectric --fix n_i=1.5 --fix n_t=1",
]
TABLE_LANGUAGES = ["hlsl", "slang", "osl"]


def build_folder():
    root = Path(__file__).resolve().parents[2]
    return Path(os.environ.get("FRESNEL_BUILD_DIR", root / "build" / "release"))


def command():
    return build_folder() / "fresnel"


def folder(language):
    return receiver.cache() / "corpus" / language


def printed(arguments, language):
    done = subprocess.run([command(), *arguments.split(), "--lang", language], capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"receivers: fresnel {arguments} --lang {language}: {done.stderr.strip()}")
    return done.stdout


def shader(arguments, language):
    return printed(f"shader {arguments}", language)


def tables(language):
    """The functions that read tables, by name."""
    return {f"table_{i}_{table.split()[0]}": printed(f"lut {table} --size 32", language)
            for i, table in enumerate(TABLES)}


def models():
    listed = subprocess.run([command(), "models", "--json"], capture_output=True, text=True, check=True).stdout
    return [model["name"] for model in json.loads(listed)]


def write_language(language, names):
    extension = LANGUAGES[language]
    into = folder(language)
    into.mkdir(parents=True, exist_ok=True)
    (into / f"library.{extension}").write_text(shader("--all", language))
    for name in names:
        (into / f"model_{name}.{extension}").write_text(shader(name, language))
    for i, sample in enumerate(SAMPLES):
        (into / f"sample_{i:02}_{sample.split()[0]}.{extension}").write_text(shader(sample, language))
    for name, text in (tables(language) if language in TABLE_LANGUAGES else {}).items():
        (into / f"{name}.{extension}").write_text(text)


def makers():
    """What prints the texts, and when each of it was made: of this build, not of another one."""
    files = [command(), build_folder() / "receivers_corpus", *sorted(Path(__file__).parent.glob("*.*"))]
    return "".join(f"{file.resolve()} {file.stat().st_mtime_ns}\n" for file in files)


def is_current():
    stamp = receiver.cache() / "corpus" / "stamp"
    return stamp.exists() and stamp.read_text() == makers()


def make(anew=False):
    """Writes the texts of all languages, unless they are what this build printed."""
    for program in (command(), build_folder() / "receivers_corpus"):
        if not program.exists():
            raise SystemExit(f"receivers: '{program}': must be built first")
    with receiver.locked("corpus"):
        if is_current() and not anew:
            return
        names = models()
        words = Path(__file__).with_name("words.txt")
        subprocess.run([build_folder() / "receivers_corpus", words, receiver.cache() / "corpus"], check=True)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda language: write_language(language, names), LANGUAGES))
        (receiver.cache() / "corpus" / "stamp").write_text(makers())
