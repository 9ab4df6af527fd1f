#include "conform/verify.hpp"

#include "conform/program.hpp"
#include "conform/tool.hpp"
#include "error.hpp"
#include "figure/figure.hpp"

#include <fmt/format.h>

#include <dlfcn.h>

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
    /// Whether its compiler may move factors.
    virtual bool rearranges() const = 0;
    virtual std::vector<float> run(std::size_t which, const verify_case& c, const verify_data& data) = 0;
};

class shader_receiver final : public receiver {
public:
    shader_receiver(std::string_view language, bool precise, std::span<const verify_case> cases)
        : language_(emit::find_language(language)), precise_(precise), runner_(open_runner(language)) {
        std::vector<program> programs;
        for (const verify_case& c : cases)
            programs.push_back(program_of(c));
        runner_->prepare(programs);
    }
    std::string name() const override { return std::string(language_.id) + (precise_ ? " precise" : ""); }
    std::string device() const override { return runner_->name(); }
    bool rearranges() const override { return !precise_; }
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
};

/// Every case in one C file, as a shared library of this process.
class c_receiver final : public receiver {
public:
    c_receiver(std::string compiler, std::span<const verify_case> cases) : compiler_(std::move(compiler)) {
        if (!has_tool(compiler_)) throw render::no_device(fmt::format("{} is not there", compiler_));
        const std::string source = (scratch_.path / "cases.c").string(),
                          library = (scratch_.path / "cases.so").string();
        write_file(source, text_of(cases));
        const tool_end end = run_tool({compiler_, "-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra",
                                       "-Werror", "-Wno-unused-function", "-Wno-unused-parameter", "-fPIC",
                                       "-shared", "-o", library, source, "-lm"});
        if (end.status != 0)
            throw failure(fmt::format("{}: {}", compiler_, end.said.substr(0, end.said.find('\n'))));
        library_ = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library_ == nullptr) throw failure(fmt::format("{}: {}", compiler_, dlerror()));
    }
    ~c_receiver() override {
        if (library_ != nullptr) dlclose(library_);
    }
    c_receiver(const c_receiver&) = delete;
    c_receiver& operator=(const c_receiver&) = delete;

    std::string name() const override { return fmt::format("c {}", compiler_); }
    std::string device() const override {
        const std::string said = run_tool({compiler_, "--version"}).said;
        return said.substr(0, said.find('\n'));
    }
    bool rearranges() const override { return false; }
    std::vector<float> run(std::size_t which, const verify_case& c, const verify_data& data) override {
        using function = void (*)(const float*, float*, unsigned long);
        void* const symbol = dlsym(library_, fmt::format("fresnel_case_{}", which).c_str());
        if (symbol == nullptr) throw failure(fmt::format("{}: {}", compiler_, dlerror()));
        std::vector<float> values(data.rows * static_cast<std::size_t>(c.results));
        reinterpret_cast<function>(symbol)(data.inputs.data(), values.data(), data.rows);
        return values;
    }

private:
    static std::string text_of(std::span<const verify_case> cases) {
        const emit::language& c99 = emit::find_language("c");
        std::string text = emit::verify_text(c99, cases);
        const auto x = [](int k) { return fmt::format("x[{}]", k); };
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const verify_case& c = cases[i];
            text += fmt::format("\nvoid fresnel_case_{0}(const float* x, float* y, unsigned long rows);\n"
                                "void fresnel_case_{0}(const float* x, float* y, unsigned long rows) {{\n"
                                "    for (; rows-- > 0; x += {1}, y += {2}) {{\n",
                                i, c.columns(), c.results);
            const std::string value = emit::verify_call(c99, c, x);
            if (c.results == 1) text += fmt::format("        y[0] = {};\n", value);
            if (c.results == 3)
                text += fmt::format("        const fresnel_float3 v = {};\n        y[0] = v.x, y[1] = v.y, "
                                    "y[2] = v.z;\n",
                                    value);
            if (c.results == 4)
                text += fmt::format("        const fresnel_boundary v = {};\n        y[0] = v.R_s, y[1] = "
                                    "v.R_p, y[2] = v.T_s, y[3] = v.T_p;\n",
                                    value);
            text += "    }\n}\n";
        }
        return text;
    }

    scratch_folder scratch_;
    std::string compiler_;
    void* library_ = nullptr;
};

using maker = std::function<std::unique_ptr<receiver>()>;

std::vector<std::pair<std::string, maker>> makers(std::span<const verify_case> cases) {
    const auto shader = [cases](std::string_view language, bool precise) -> maker {
        return [=] { return std::make_unique<shader_receiver>(language, precise, cases); };
    };
    const auto c = [cases](const char* compiler) -> maker {
        return [=] { return std::make_unique<c_receiver>(compiler, cases); };
    };
    return {{"glsl precise", shader("glsl", true)}, {"glsl", shader("glsl", false)},
            {"hlsl precise", shader("hlsl", true)}, {"hlsl", shader("hlsl", false)},
            {"wgsl", shader("wgsl", false)},        {"c gcc", c("gcc")},
            {"c clang-19", c("clang-19")}};
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
            all.results.push_back({c, each->name(), emit::compare_bits(c, data, each->run(i, c, data)),
                                   emit::allowed_difference(c, each->rearranges())});
        }
    }
    return all;
}

} // namespace fresnel::conform
