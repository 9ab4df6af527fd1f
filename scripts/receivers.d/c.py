"""C99 and C++ by gcc and clang; CUDA and HIP by clang, for a GPU of each; MSL by clang with a header of ours."""
from pathlib import Path

from callers import statements
from receiver import Receiver, Skipped, add, need, pip, run

STUBS = Path(__file__).parent / "stubs"
WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Wshadow", "-Wpedantic", "-Werror"]



class Compiled(Receiver):
    """By several compilers, each with its options; a text passes if all accept it."""

    compilers = {}  # program: the ways it is called

    def install(self):
        for compiler in self.compilers:
            need(compiler, compiler)

    def version(self):
        return ", ".join(f"{compiler} {run([compiler, '-dumpfullversion', '-dumpversion'])[1].strip()} ({way[0]})"
                         for compiler, ways in self.compilers.items() for way in ways)

    head = ""  # what stands before the function that calls all others

    def program(self, text):
        return (text + "\n" + self.head + "float harness_all(float harness_one, TRIPLE harness_three) {\n"
                .replace("TRIPLE", "fresnel_float3" if self.language == "c" else "float3") +
                "    float harness_sum = 0.0f;\n" +
                statements(self.language, text, direction="harness_three") + "\n    return harness_sum;\n}\n")

    def compile_one(self, file):
        for compiler, ways in self.compilers.items():
            for way in ways:
                code, said = run([compiler, way[0], *WARNINGS, *way[1:], file, "-o", "/dev/null"])
                if code != 0:
                    return f"{compiler} {way[0]}: {said}"
        return ""


@add
class C(Compiled):
    name, language, title, extension = "c", "c", "C", ".c"
    head = "float harness_all(float harness_one, fresnel_float3 harness_three);\n"
    compilers = {"gcc": [["-std=c99", "-fsyntax-only"]], "clang-19": [["-std=c99", "-fsyntax-only"], ["-std=c23", "-fsyntax-only"]]}


@add
class Cpp(Compiled):
    name, language, title, extension = "cpp", "c", "C, as C++", ".cpp"
    head = "float harness_all(float harness_one, fresnel_float3 harness_three);\n"
    compilers = {"g++": [["-std=c++11", "-fsyntax-only"]], "clang++-19": [["-std=c++20", "-fsyntax-only"]]}


@add
class Cuda(Compiled):
    name, language, title, extension = "cuda-clang", "cuda", "CUDA", ".cu"
    head = "__device__ "
    compilers = {"clang++-19": [["--cuda-gpu-arch=sm_61", "-x", "cuda", "-std=c++17", "-O1", "-nocudainc", "-nocudalib",
                                 "--cuda-device-only", "-S", "-fno-builtin", "-D__CUDACC__", "-Wno-pragma-once-outside-header", "-include", STUBS / "cuda_runtime.h"]]}


@add
class Nvcc(Compiled):
    name, language, title, heavy, extension = "cuda-nvcc", "cuda", "CUDA", True, ".cu"
    head = "__device__ "
    packages = [f"nvidia-{p}" for p in ("cuda-nvcc", "nvvm", "cuda-crt", "cuda-runtime")]

    def install(self):
        place = pip("nvcc", *self.packages) / "nvidia" / "cu13"
        self.nvcc = place / "bin/nvcc"
        if not self.nvcc.exists():
            raise Skipped("the packages hold no nvcc for this machine")
        for tool in [*place.glob("bin/*"), *place.glob("nvvm/bin/*")]:
            tool.chmod(0o755)

    def version(self):
        said = run([self.nvcc, "--version"])[1]
        return "nvcc " + said.split(" release ")[1].split(",")[0] + " (sm_86)"

    def program(self, text):
        return super().program(text.replace("#pragma once\n", "", 1))  # it warns of that in a file that is not included

    def compile_one(self, file):
        code, said = run([self.nvcc, "-arch=sm_86", "-std=c++17", "-Werror=all-warnings", "-Wno-deprecated-gpu-targets",
                          "-cubin", "-o", file.with_suffix(".cubin"), file])
        return said if code else ""


@add
class Hip(Compiled):
    name, language, title, extension = "hip", "cuda", "HIP", ".hip"
    head = "__device__ "
    compilers = {"clang++-19": [["--offload-arch=gfx1030", "-x", "hip", "-std=c++17", "-O1", "-nogpuinc", "-nogpulib",
                                 "--cuda-device-only", "-S", "-Wno-pragma-once-outside-header", "-I", STUBS]]}


@add
class Msl(Compiled):
    """There is no Metal compiler to be had outside Apple's machines: the language is C++14 with vectors, so clang with
    a header of ours that declares the part of metal_stdlib that shaders use."""

    name, language, title, extension = "msl", "msl", "MSL", ".cpp"
    head = "float harness_all(float harness_one, float3 harness_three);\n"
    compilers = {"clang++-19": [["-std=c++14", "-fsyntax-only", "-nostdinc", "-Wno-unused-parameter", "-Wno-pragma-once-outside-header",
                                 "-isystem", STUBS / "metal"]]}

    def version(self):
        return super().version() + ", with a header of ours: no Metal compiler can be had"
