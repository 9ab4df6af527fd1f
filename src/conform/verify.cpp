#include "conform/verify.hpp"

#include "conform/program.hpp"
#include "error.hpp"
#include "figure/figure.hpp"
#include "figure/tool.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <dlfcn.h>

#include <limits>

namespace fresnel::conform {

namespace {

using emit::verify_case;
using emit::verify_data;

/// Something that runs cases.
class receiver {
public:
    virtual ~receiver() = default;
    virtual std::string name() const = 0;   ///< short, for the table
    virtual std::string device() const = 0; ///< what it is, for the report
    /// What its values may differ by.
    virtual double allowed(const verify_case& c) const = 0;
    virtual std::vector<float> run(std::size_t which, const verify_case& c, const verify_data& data) = 0;
};

class shader_receiver final : public receiver {
public:
    shader_receiver(std::string_view language, bool precise, std::span<const verify_case> cases)
        : language_(emit::find_language(language)), precise_(precise), runner_(open_runner(language)),
          exact_(rounds_exactly(language, *runner_)) {
        std::vector<program> programs;
        for (const verify_case& c : cases)
            programs.push_back(program_of(c));
        runner_->prepare(programs);
    }
    std::string name() const override { return std::string(language_.id) + (precise_ ? " precise" : ""); }
    std::string device() const override {
        return runner_->name() +
               (exact_ ? "" : "; its quotients and roots are not rounded exactly, so nothing is claimed");
    }
    double allowed(const verify_case& c) const override {
        return exact_ ? emit::allowed_difference(c, !precise_) : std::numeric_limits<double>::infinity();
    }
    std::vector<float> run(std::size_t, const verify_case& c, const verify_data& data) override {
        return runner_->run(program_of(c), data.inputs);
    }

private:
    program program_of(const verify_case& c) const {
        return {emit::verify_text(language_, {&c, 1}, {precise_, false}),
                emit::verify_call(language_, c, column), c.columns(), c.results};
    }

    const emit::language& language_;
    bool precise_;
    std::unique_ptr<shader_runner> runner_;
    bool exact_;
};

/// A compiler of texts that run in this process, or from it, and what it needs to hear and to be given.
struct native_compiler {
    std::string_view language, command;
    std::vector<std::string> options;
    std::string_view ending;  ///< of the file with all cases
    std::string_view rgb;     ///< the type of three channels
    std::string_view devices; ///< defines fresnel_devices(), how many there are to run on
    std::string_view loop;    ///< computes y from x in each row, by the statements {body}
    std::string_view version; ///< begins the line that says what the compiler is; empty: the first
};

constexpr std::string_view c_device = R"(
int fresnel_devices(void);
int fresnel_devices(void) {{ return 1; }}
)";
constexpr std::string_view c_loop = R"(
int fresnel_case_{id}(const float* x, float* y, unsigned long rows);
int fresnel_case_{id}(const float* x, float* y, unsigned long rows) {{
    for (; rows-- > 0; x += {columns}, y += {results}) {{
{body}    }}
    return 0;
}}
)";

native_compiler c_compiler(std::string_view command) {
    return {.language = "c",
            .command = command,
            .options = {"-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror",
                        "-Wno-unused-function", "-Wno-unused-parameter", "-fPIC", "-shared", "-lm"},
            .ending = ".c",
            .rgb = "fresnel_float3",
            .devices = c_device,
            .loop = c_loop,
            .version = ""};
}

constexpr std::string_view cuda_devices = R"(
extern "C" int fresnel_devices() {{
    int count = 0;
    return cudaGetDeviceCount(&count) == cudaSuccess ? count : 0;
}}
)";
constexpr std::string_view cuda_loop = R"(
__global__ void fresnel_kernel_{id}(const float* x, float* y, unsigned long rows) {{
    const unsigned long row = blockIdx.x * (unsigned long)blockDim.x + threadIdx.x;
    if (row >= rows) return;
    x += row * {columns};
    y += row * {results};
{body}}}
extern "C" int fresnel_case_{id}(const float* x, float* y, unsigned long rows) {{
    float *inputs = nullptr, *outputs = nullptr;
    const size_t in = rows * {columns} * sizeof(float), out = rows * {results} * sizeof(float);
    cudaMalloc(&inputs, in);
    cudaMalloc(&outputs, out);
    cudaMemcpy(inputs, x, in, cudaMemcpyHostToDevice);
    fresnel_kernel_{id}<<<(unsigned)((rows + 255) / 256), 256>>>(inputs, outputs, rows);
    cudaMemcpy(y, outputs, out, cudaMemcpyDeviceToHost);
    cudaFree(inputs);
    cudaFree(outputs);
    return cudaGetLastError();
}}
)";

native_compiler cuda_compiler() {
    return {.language = "cuda",
            .command = "nvcc",
            .options = {"-arch=native", "-O2", "-fmad=false", "-Xcompiler=-fPIC", "-shared"},
            .ending = ".cu",
            .rgb = "float3",
            .devices = cuda_devices,
            .loop = cuda_loop,
            .version = "Cuda compilation"};
}

/// Every case in one file, as a shared library of this process.
class native_receiver final : public receiver {
public:
    native_receiver(const native_compiler& compiler, std::span<const verify_case> cases)
        : compiler_(compiler) {
        const std::string command(compiler.command);
        if (!has_tool(command)) throw render::no_device(fmt::format("{} is not there", command));
        const std::string source = (scratch_.path / "cases").string() + std::string(compiler.ending),
                          library = (scratch_.path / "cases.so").string();
        write_file(source, text_of(cases));
        std::vector<std::string> line = {command, "-o", library, source};
        line.insert(line.end(), compiler.options.begin(), compiler.options.end());
        const tool_end end = run_tool(line);
        if (end.status != 0)
            throw failure(fmt::format("{}: {}", command, end.said.substr(0, end.said.find('\n'))));
        library_.reset(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL));
        if (!library_) throw failure(fmt::format("{}: {}", command, dlerror()));
        if (function<int()>("fresnel_devices")() == 0)
            throw render::no_device(fmt::format("{} is there, but no device that runs its code", command));
    }

    std::string name() const override { return fmt::format("{} {}", compiler_.language, compiler_.command); }
    std::string device() const override {
        const std::string said = run_tool({std::string(compiler_.command), "--version"}).said;
        const std::size_t at = said.find(compiler_.version), begin = at == std::string::npos ? 0 : at;
        return said.substr(begin, said.find('\n', begin) - begin);
    }
    double allowed(const verify_case& c) const override { return emit::allowed_difference(c, false); }
    std::vector<float> run(std::size_t which, const verify_case& c, const verify_data& data) override {
        auto* const run_rows =
            function<int(const float*, float*, unsigned long)>(fmt::format("fresnel_case_{}", which));
        std::vector<float> values(data.rows * static_cast<std::size_t>(c.results));
        const int code = run_rows(data.inputs.data(), values.data(), data.rows);
        if (code != 0) throw failure(fmt::format("{}: {} ended with error {}", name(), c.id, code));
        return values;
    }

private:
    template <class F>
    F* function(const std::string& name) const {
        void* const symbol = dlsym(library_.get(), name.c_str());
        if (symbol == nullptr) throw failure(fmt::format("{}: {}", compiler_.command, dlerror()));
        return reinterpret_cast<F*>(symbol);
    }

    std::string text_of(std::span<const verify_case> cases) const {
        const emit::language& l = emit::find_language(compiler_.language);
        std::string text = emit::verify_text(l, cases);
        text += fmt::format(fmt::runtime(compiler_.devices));
        const auto x = [](int k) { return fmt::format("x[{}]", k); };
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const verify_case& c = cases[i];
            text += fmt::format(fmt::runtime(compiler_.loop), fmt::arg("id", i),
                                fmt::arg("columns", c.columns()), fmt::arg("results", c.results),
                                fmt::arg("body", stores(c.results, emit::verify_call(l, c, x))));
        }
        return text;
    }

    std::string stores(int results, std::string_view value) const {
        if (results == 1) return fmt::format("        y[0] = {};\n", value);
        if (results == 3)
            return fmt::format("        const {} v = {};\n        y[0] = v.x, y[1] = v.y, y[2] = v.z;\n",
                               compiler_.rgb, value);
        return fmt::format("        const fresnel_boundary v = {};\n"
                           "        y[0] = v.R_s, y[1] = v.R_p, y[2] = v.T_s, y[3] = v.T_p;\n",
                           value);
    }

    scratch_folder scratch_;
    native_compiler compiler_;
    std::unique_ptr<void, int (*)(void*)> library_{nullptr, dlclose};
};

using maker = std::function<std::unique_ptr<receiver>()>;

std::vector<std::pair<std::string, maker>> makers(std::span<const verify_case> cases) {
    const auto shader = [cases](std::string_view language, bool precise) -> maker {
        return [=] { return std::make_unique<shader_receiver>(language, precise, cases); };
    };
    const auto native = [cases](const native_compiler& compiler) -> maker {
        return [=] { return std::make_unique<native_receiver>(compiler, cases); };
    };
    return {{"glsl precise", shader("glsl", true)},
            {"glsl", shader("glsl", false)},
            {"hlsl precise", shader("hlsl", true)},
            {"hlsl", shader("hlsl", false)},
            {"wgsl", shader("wgsl", false)},
            {"c gcc", native(c_compiler("gcc"))},
            {"c clang-19", native(c_compiler("clang-19"))},
            {"cuda nvcc", native(cuda_compiler())}};
}

} // namespace

bool verification::passed() const {
    for (const emit::verify_result& r : results)
        if (!r.passed()) return false;
    return !results.empty();
}

verification verify(std::span<const verify_case> cases, std::size_t rows,
                    const std::function<void(std::string_view, std::string_view)>& at) {
    verification all;
    std::vector<std::unique_ptr<receiver>> ready;
    for (const auto& [name, make] : makers(cases)) {
        try {
            ready.push_back(make());
            all.receivers.push_back(fmt::format("{}: {}", name, ready.back()->device()));
        } catch (const render::no_device& reason) {
            all.skipped.push_back({name, reason.what()});
        }
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const verify_case& c = cases[i];
        const verify_data data = emit::make_data(c, rows == 0 ? emit::default_rows(c) : rows);
        for (const auto& each : ready) {
            if (at) at(each->name(), c.id);
            all.results.push_back(
                {c, each->name(), emit::compare_bits(c, data, each->run(i, c, data)), each->allowed(c)});
        }
    }
    return all;
}

} // namespace fresnel::conform
