#include "emit/null_device.hpp"

#include "emit/vulkan_device.hpp"
#include "error.hpp"
#include "figure/leftover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fresnel::emit {

namespace {

constexpr std::array<std::string_view, 36> devices = {
    "polaris10", "navi21",  "gfx1100",    "tahiti",    "pitcairn",  "verde",     "oland",     "bonaire",
    "kaveri",    "hawaii",  "tonga",      "fiji",      "polaris11", "polaris12", "vegam",     "vega10",
    "vega12",    "vega20",  "raven",      "raven2",    "renoir",    "arcturus",  "aldebaran", "navi10",
    "navi12",    "navi14",  "navi22",     "navi23",    "navi24",    "vangogh",   "rembrandt", "gfx1036",
    "gfx1101",   "gfx1102", "gfx1103_r1", "gfx1103_r2"};

// ---- the child process ------------------------------------------------------------------------------------

// The file that tells the Vulkan loader of RADV: what the environment names, or Debian's.
std::string driver_manifest() {
    if (const char* named = std::getenv("VK_ICD_FILENAMES"))
        if (std::string_view(named).find("radeon") != std::string_view::npos) {
            if (std::filesystem::exists(named)) return named;
            throw failure(
                fmt::format("cost: the Vulkan driver RADV is not installed: VK_ICD_FILENAMES='{}' is no file "
                            "(package mesa-vulkan-drivers)",
                            named));
        }
    for (const char* folder :
         {"/usr/share/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/etc/vulkan/icd.d"}) {
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(folder, none))
            if (entry.path().filename().string().starts_with("radeon_icd")) return entry.path().string();
    }
    throw failure("cost: the Vulkan driver RADV is not installed (package mesa-vulkan-drivers)");
}

nlohmann::json to_json(const compiled_program& program) {
    nlohmann::json stages = nlohmann::json::object();
    for (const auto& [stage, shader] : program)
        stages[std::string(to_string(stage))] = {{"statistics", shader.statistics},
                                                 {"assembly", shader.assembly}};
    return stages;
}

compiled_program from_json(const nlohmann::json& stages) {
    compiled_program program;
    for (const shader_stage stage : {shader_stage::vertex, shader_stage::fragment, shader_stage::compute})
        if (const auto found = stages.find(to_string(stage)); found != stages.end())
            program[stage] = {found->at("statistics").get<std::map<std::string, double>>(),
                              found->at("assembly")};
    return program;
}

// In the child: what goes through the pipe.
std::string answer(std::string_view device, std::span<const shader_program> programs, bool with_assembly,
                   const std::string& manifest) {
    setenv("RADV_FORCE_FAMILY", std::string(device).c_str(), 1);
    for (const char* name : {"VK_ICD_FILENAMES", "VK_DRIVER_FILES"})
        setenv(name, manifest.c_str(), 1);
    for (const char* name : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE", "NODEVICE_SELECT"})
        setenv(name, "1", 1);
    for (const char* name : {"RADV_DEBUG", "RADV_PERFTEST", "ACO_DEBUG", "VK_INSTANCE_LAYERS"})
        unsetenv(name);
    try {
        const compilation made = compile_here(programs, with_assembly);
        nlohmann::json all = nlohmann::json::array();
        for (const compiled_program& program : made.programs)
            all.push_back(to_json(program));
        return nlohmann::json{{"driver", made.driver}, {"programs", all}}.dump();
    } catch (const std::exception& error) {
        return nlohmann::json{{"error", fmt::format("cost: {}", error.what())}}.dump();
    }
}

void write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = write(file, text.data(), text.size());
        if (written <= 0) _exit(3);
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string read_all(int file) {
    std::string text;
    std::array<char, 65536> part;
    for (ssize_t got; (got = read(file, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(got));
    return text;
}

} // namespace

std::string_view to_string(shader_stage stage) {
    return stage == shader_stage::vertex     ? "vertex"
           : stage == shader_stage::fragment ? "fragment"
                                             : "compute";
}

double compiled_shader::operator[](const std::string& name) const {
    const auto found = statistics.find(name);
    if (found == statistics.end())
        throw failure(fmt::format("cost: the driver gives no statistic '{}'", name));
    return found->second;
}

std::span<const std::string_view> null_devices() { return devices; }

compilation compile_for(std::string_view device, std::span<const shader_program> programs,
                        bool with_assembly) {
    if (std::find(devices.begin(), devices.end(), device) == devices.end())
        throw bad_input(fmt::format("--gpu '{}': is none of {}", device, fmt::join(devices, ", ")));
    const std::string manifest = driver_manifest();
    // what the driver says on standard error is read only where it fails
    const int said = memfd_create("driver", MFD_CLOEXEC);
    std::array<int, 2> ends{};
    if (said < 0 || pipe2(ends.data(), O_CLOEXEC) != 0)
        throw failure("cost: no pipe to the compiler's process");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw failure("cost: the compiler's process cannot be started");
    if (child == 0) {
        leave_leftovers_to_the_parent();
        close(ends[0]);
        dup2(said, STDERR_FILENO);
        write_all(ends[1], answer(device, programs, with_assembly, manifest));
        _exit(0);
    }
    close(ends[1]);
    const std::string text = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    lseek(said, 0, SEEK_SET);
    const std::string complaint = read_all(said);
    close(said);

    const nlohmann::json made = nlohmann::json::parse(text, nullptr, false);
    if (!made.is_object())
        throw failure(fmt::format("cost: RADV as {} ended early: {}", device,
                                  complaint.substr(0, complaint.find('\n'))));
    if (made.contains("error")) throw failure(made.at("error").get<std::string>());
    compilation all{made.at("driver"), {}};
    for (const nlohmann::json& program : made.at("programs"))
        all.programs.push_back(from_json(program));
    return all;
}

} // namespace fresnel::emit
