"""Mali, Adreno, VideoCore and Intel by Mesa's own compilers: its source package of Debian, built with its drm-shim, which
plays the device. draw.c draws with fragment shaders on it and prints what the driver says of them."""
import os
import re
import sys
from pathlib import Path

import receiver
from common import folder, models, row, run, statements, subject

TIMES = 8  # as many as have room in the varyings of OpenGL ES 3
NEEDED = ["dpkg-dev", "gcc", "g++", "meson", "ninja-build", "pkg-config", "python3-mako", "bison", "flex", "libdrm-dev",
          "libelf-dev", "libexpat1-dev", "libpciaccess-dev", "zlib1g-dev"]
KEYS = "/usr/share/keyrings/debian-archive-keyring.gpg"
OPTIONS = """buildtype=release libdir=lib tools=drm-shim,intel gallium-drivers=panfrost,freedreno,v3d,iris vulkan-drivers=
    platforms= glx=disabled egl=enabled gbm=enabled gles2=enabled llvm=disabled glvnd=false gallium-va=disabled
    gallium-vdpau=disabled video-codecs=""".split()


class Gpu:
    """A device that a shim plays: what its driver says of a fragment shader, and which of those numbers are the columns."""

    def __init__(self, name, driver, settings, says, **columns):
        self.name, self.driver, self.settings, self.says, self.columns = name, driver, settings, says, columns

    def numbers(self, message):
        """The columns of one shader; of several numbers the largest. None where the message is of another stage."""
        if not message.startswith(self.says):
            return None
        every = {number: float(value) for value, number in re.findall(r"([0-9.]+) ([\w-]+)", message)}
        return {column: max(every[number] for number in numbers) for column, numbers in self.columns.items()}


# Of Bifrost and Valhall the cycles of the arithmetic units alone: those that load inputs are busy with the method.
FRAGMENT = "MESA_SHADER_FRAGMENT shader:"
GPUS = [
    Gpu("t860", "panfrost", {"PAN_GPU_ID": "860"}, FRAGMENT, instructions=["inst"], inverse_throughput=["bundles"]),
    Gpu("g52", "panfrost", {"PAN_GPU_ID": "7212"}, FRAGMENT, instructions=["inst"], inverse_throughput=["arith"]),
    Gpu("g57", "panfrost", {"PAN_GPU_ID": "9093"}, FRAGMENT, instructions=["inst"],
        inverse_throughput=["fma", "cvt", "sfu"]),
    Gpu("a630", "freedreno", {"FD_GPU_ID": "630", "FD_MESA_DEBUG": "shaderdb"}, "FRAG shader:",
        instructions=["non-nops"]),
    Gpu("v3d42", "v3d", {}, FRAGMENT, instructions=["inst"]),
    Gpu("tgl", "iris", {"INTEL_STUB_GPU_PLATFORM": "tgl"}, "FS SIMD8 shader:", instructions=["inst"]),
]
SHIMS = {"iris": "intel"}  # that are not called as the driver is

# ---- Mesa ----------------------------------------------------------------------------------------------------


def place():
    return receiver.cache() / "mesa"


def source_list():
    """The places that this machine has Debian's packages from, as those of their sources."""
    known = run(["apt-get", "indextargets", "--format", "$(REPO_URI) $(RELEASE) $(COMPONENT)", "Created-By: Packages"])
    return "".join(f"deb-src [signed-by={KEYS}] {place}\n" for place in sorted(set(known.splitlines())))


def fetch():
    """Debian's source package, by a list and an index of its own; returns its folder."""
    here = place()
    if not list(here.glob("mesa-*/meson.build")):
        (here / "lists" / "partial").mkdir(parents=True, exist_ok=True)
        (here / "sources.list").write_text(source_list())
        apt = ["apt-get", "-qq", "-oAPT::Sandbox::User=root", f"-oDir::Cache={here}", f"-oDir::State::lists={here}/lists",
               f"-oDir::Etc::sourcelist={here}/sources.list", "-oDir::Etc::sourceparts=-"]
        receiver.install([*apt, "update"], "the list of Debian's source packages")
        receiver.install(["env", "-C", here, *apt, "source", "mesa"], "Mesa's source")
    return next(here.glob("mesa-*/meson.build")).parent


def compile_all(source, into, installed):
    own = dict(os.environ, PATH=f"/usr/bin:{os.environ['PATH']}")  # meson's Python is the one that has mako
    options = [f"-D{option}" for option in OPTIONS]
    try:
        if not (into / "build.ninja").exists():
            run(["meson", "setup", into, source, f"-Dprefix={installed}", *options], env=own)
        run(["ninja", "-C", into, f"-j{os.cpu_count()}", "install"], env=own)
    except SystemExit as failed:
        raise receiver.Skipped(f"Mesa cannot be built: {str(failed).splitlines()[-1]}")


def build():
    """Mesa in place()/installed, and draw beside it; ten minutes the first time. Returns the version."""
    receiver.apt(*NEEDED)
    with receiver.locked("mesa"):
        place().mkdir(parents=True, exist_ok=True)
        source = fetch()
        installed = place() / "installed"
        if not (installed / "complete").exists():
            print("cost: building Mesa (ten minutes)", file=sys.stderr, flush=True)
            compile_all(source, place() / "build", installed)
            (installed / "complete").touch()
        run(["gcc", "-Wall", "-Wextra", "-Werror", "-O1", f"-I{installed}/include", Path(__file__).with_name("draw.c"), "-o",
             place() / "draw", f"-L{installed}/lib", "-lEGL", "-lGLESv2", "-lgbm", f"-Wl,-rpath,{installed}/lib"])
    return f"Mesa {source.name.removeprefix('mesa-')}"


# ---- the programs --------------------------------------------------------------------------------------------


def vertex_program(vectors):
    """Hands attributes on."""
    declared = "".join(f"in vec4 a{i};\nout vec4 v{i};\n" for i in range(vectors))
    return (f"#version 300 es\n{declared}void main() {{\n" + "".join(f"    v{i} = a{i};\n" for i in range(vectors))
            + "    gl_Position = a0;\n}\n")


def fragment_program(model, evaluates):
    text, name, floats = subject(model, "essl")
    vectors = (TIMES * floats + 3) // 4
    declared = "".join(f"in vec4 v{i};\n" for i in range(vectors))
    body = statements(name, floats, TIMES, evaluates, lambda i: f"v{i // 4}.{'xyzw'[i % 4]}", "{}")
    return vectors, (f"#version 300 es\n{text}\n{declared}out vec4 color;\nvoid main() {{\n    {body}\n"
                     "    color = vec4(F, inputs, 0.0, 1.0);\n}\n")


def write_programs():
    """A vertex program for all, and two fragment programs of each model."""
    most, files = 0, []
    for model in models():
        for evaluates in True, False:
            vectors, text = fragment_program(model, evaluates)
            files.append(folder() / f"{model['name']}_{int(evaluates)}.frag")
            files[-1].write_text(text)
            most = max(most, vectors)
    vertex = folder() / "all.vert"
    vertex.write_text(vertex_program(most))
    return vertex, files


def drawn(gpu, vertex, files):
    """What the driver says of each fragment shader, as columns."""
    installed = place() / "installed" / "lib"
    own = dict(os.environ, LIBGL_DRIVERS_PATH=str(installed / "dri"), MESA_SHADER_CACHE_DISABLE="1", **gpu.settings,
               LD_PRELOAD=str(installed / f"lib{SHIMS.get(gpu.driver, gpu.driver)}_noop_drm_shim.so"))
    said = run([place() / "draw", vertex, *files], env=own)
    numbers = []
    for part in said.split("== ")[1:]:
        found = [n for n in map(gpu.numbers, part.splitlines()) if n]
        if not found:
            raise SystemExit(f"cost: mesa: {gpu.name}: nothing is said of {part.splitlines()[0]}")
        numbers.append(found[0])
    return numbers


def measure():
    version = build()
    vertex, files = write_programs()
    rows = []
    for gpu in GPUS:
        numbers = drawn(gpu, vertex, files)
        for k, model in enumerate(models()):
            cost = {column: (numbers[2 * k][column] - numbers[2 * k + 1][column]) / TIMES for column in gpu.columns}
            rows.append(row(model, gpu.name, "fragment", tool=gpu.driver, version=version, **cost))
    return rows
