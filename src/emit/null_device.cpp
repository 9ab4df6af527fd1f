#include "emit/null_device.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/ResourceLimits.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
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

// ---- GLSL to SPIR-V ---------------------------------------------------------------------------------------

std::vector<std::uint32_t> spirv(shader_stage stage, const std::string& text) {
    [[maybe_unused]] static const bool ready = glslang_initialize_process() != 0;
    const glslang_input_t input{.language = GLSLANG_SOURCE_GLSL,
                                .stage = stage == shader_stage::vertex     ? GLSLANG_STAGE_VERTEX
                                         : stage == shader_stage::fragment ? GLSLANG_STAGE_FRAGMENT
                                                                           : GLSLANG_STAGE_COMPUTE,
                                .client = GLSLANG_CLIENT_VULKAN,
                                .client_version = GLSLANG_TARGET_VULKAN_1_1,
                                .target_language = GLSLANG_TARGET_SPV,
                                .target_language_version = GLSLANG_TARGET_SPV_1_3,
                                .code = text.c_str(),
                                .default_version = 450,
                                .default_profile = GLSLANG_CORE_PROFILE,
                                .messages = GLSLANG_MSG_DEFAULT_BIT,
                                .resource =
                                    reinterpret_cast<const glslang_resource_t*>(GetDefaultResources())};
    const std::unique_ptr<glslang_shader_t, decltype(&glslang_shader_delete)> shader(
        glslang_shader_create(&input), glslang_shader_delete);
    if (glslang_shader_preprocess(shader.get(), &input) == 0 ||
        glslang_shader_parse(shader.get(), &input) == 0)
        throw failure(fmt::format("cost: the {} shader: {}", to_string(stage),
                                  glslang_shader_get_info_log(shader.get())));
    const std::unique_ptr<glslang_program_t, decltype(&glslang_program_delete)> program(
        glslang_program_create(), glslang_program_delete);
    glslang_program_add_shader(program.get(), shader.get());
    if (glslang_program_link(program.get(), GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT) == 0)
        throw failure(fmt::format("cost: the {} shader: {}", to_string(stage),
                                  glslang_program_get_info_log(program.get())));
    glslang_program_SPIRV_generate(program.get(), input.stage);
    std::vector<std::uint32_t> words(glslang_program_SPIRV_get_size(program.get()));
    glslang_program_SPIRV_get(program.get(), words.data());
    return words;
}

// ---- Vulkan -----------------------------------------------------------------------------------------------

void require(VkResult result, std::string_view what) {
    if (result != VK_SUCCESS)
        throw failure(fmt::format("cost: Vulkan: {} failed ({})", what, static_cast<int>(result)));
}

VkShaderStageFlagBits bit_of(shader_stage stage) {
    return stage == shader_stage::vertex     ? VK_SHADER_STAGE_VERTEX_BIT
           : stage == shader_stage::fragment ? VK_SHADER_STAGE_FRAGMENT_BIT
                                             : VK_SHADER_STAGE_COMPUTE_BIT;
}

/// The device of this process. It is never destroyed: the process ends with it.
class null_device {
public:
    null_device() {
        const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                            .apiVersion = VK_API_VERSION_1_3};
        const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                        .pApplicationInfo = &application};
        VkInstance instance;
        require(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
        std::uint32_t count = 1;
        VkPhysicalDevice physical;
        if (vkEnumeratePhysicalDevices(instance, &count, &physical) != VK_SUCCESS || count == 0)
            throw failure("cost: RADV offers no device without hardware");
        VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
        VkPhysicalDeviceProperties2 about{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                          .pNext = &driver};
        vkGetPhysicalDeviceProperties2(physical, &about);
        driver_ = driver.driverInfo;
        create(physical);
        make_layout();
        read_properties_ = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(
            vkGetDeviceProcAddr(device_, "vkGetPipelineExecutablePropertiesKHR"));
        read_statistics_ = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
            vkGetDeviceProcAddr(device_, "vkGetPipelineExecutableStatisticsKHR"));
        read_texts_ = reinterpret_cast<PFN_vkGetPipelineExecutableInternalRepresentationsKHR>(
            vkGetDeviceProcAddr(device_, "vkGetPipelineExecutableInternalRepresentationsKHR"));
    }

    const std::string& driver() const { return driver_; }

    compiled_program compile(const shader_program& program, bool with_assembly) const {
        std::vector<VkPipelineShaderStageCreateInfo> stages;
        for (const auto& [stage, text] : program.sources) {
            const std::vector<std::uint32_t> words = spirv(stage, text);
            const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                                .codeSize = 4 * words.size(),
                                                .pCode = words.data()};
            VkShaderModule module;
            require(vkCreateShaderModule(device_, &info, nullptr, &module), "vkCreateShaderModule");
            stages.push_back({.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                              .stage = bit_of(stage),
                              .module = module,
                              .pName = "main"});
        }
        constexpr VkPipelineCreateFlags capture_texts =
            VK_PIPELINE_CREATE_CAPTURE_INTERNAL_REPRESENTATIONS_BIT_KHR;
        const VkPipelineCreateFlags flags =
            VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR | (with_assembly ? capture_texts : 0);
        const VkPipeline pipeline = stages.front().stage == VK_SHADER_STAGE_COMPUTE_BIT
                                        ? compute(stages.front(), flags)
                                        : graphics(stages, program.attributes, flags);
        compiled_program made = describe(pipeline, with_assembly);
        vkDestroyPipeline(device_, pipeline, nullptr);
        for (const auto& stage : stages)
            vkDestroyShaderModule(device_, stage.module, nullptr);
        return made;
    }

private:
    void create(VkPhysicalDevice physical) {
        VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{
            .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR,
            .pipelineExecutableInfo = VK_TRUE};
        const VkPhysicalDeviceVulkan13Features features{
            .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
            .pNext = &executables,
            .dynamicRendering = VK_TRUE};
        const float priority = 1;
        const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                            .queueFamilyIndex = 0,
                                            .queueCount = 1,
                                            .pQueuePriorities = &priority};
        const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
        const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                      .pNext = &features,
                                      .queueCreateInfoCount = 1,
                                      .pQueueCreateInfos = &queue,
                                      .enabledExtensionCount = 1,
                                      .ppEnabledExtensionNames = &extension};
        require(vkCreateDevice(physical, &info, nullptr, &device_), "vkCreateDevice");
    }

    // Buffers 0 and 1, textures 2 to 5, uniform buffer 6: whatever a program wants of them.
    void make_layout() {
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (std::uint32_t i = 0; i < 7; ++i)
            bindings.push_back({.binding = i,
                                .descriptorType = i < 2   ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                                  : i < 6 ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                                          : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                .descriptorCount = 1,
                                .stageFlags = VK_SHADER_STAGE_ALL});
        const VkDescriptorSetLayoutCreateInfo set{.sType =
                                                      VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                  .bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                                  .pBindings = bindings.data()};
        VkDescriptorSetLayout set_layout;
        require(vkCreateDescriptorSetLayout(device_, &set, nullptr, &set_layout),
                "vkCreateDescriptorSetLayout");
        const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                              .setLayoutCount = 1,
                                              .pSetLayouts = &set_layout};
        require(vkCreatePipelineLayout(device_, &info, nullptr, &layout_), "vkCreatePipelineLayout");
    }

    VkPipeline compute(const VkPipelineShaderStageCreateInfo& stage, VkPipelineCreateFlags flags) const {
        const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                               .flags = flags,
                                               .stage = stage,
                                               .layout = layout_};
        VkPipeline pipeline;
        require(vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
                "vkCreateComputePipelines");
        return pipeline;
    }

    // Triangles into one float target, no depth, no blending.
    VkPipeline graphics(const std::vector<VkPipelineShaderStageCreateInfo>& stages, int attributes,
                        VkPipelineCreateFlags flags) const {
        const VkVertexInputBindingDescription binding{.stride = static_cast<std::uint32_t>(16 * attributes)};
        std::vector<VkVertexInputAttributeDescription> described;
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(attributes); ++i)
            described.push_back({.location = i, .format = VK_FORMAT_R32G32B32A32_SFLOAT, .offset = 16 * i});
        const VkPipelineVertexInputStateCreateInfo input{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
            .vertexBindingDescriptionCount = attributes > 0 ? 1u : 0u,
            .pVertexBindingDescriptions = &binding,
            .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(described.size()),
            .pVertexAttributeDescriptions = described.data()};
        const VkPipelineInputAssemblyStateCreateInfo assembly{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
            .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
        const VkViewport viewport{.width = 64, .height = 64, .maxDepth = 1};
        const VkRect2D scissor{.extent = {64, 64}};
        const VkPipelineViewportStateCreateInfo view{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
            .viewportCount = 1,
            .pViewports = &viewport,
            .scissorCount = 1,
            .pScissors = &scissor};
        const VkPipelineRasterizationStateCreateInfo raster{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1};
        const VkPipelineMultisampleStateCreateInfo samples{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
            .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
        const VkPipelineColorBlendAttachmentState target{.colorWriteMask = 0xf};
        const VkPipelineColorBlendStateCreateInfo blend{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
            .attachmentCount = 1,
            .pAttachments = &target};
        const VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
        const VkPipelineRenderingCreateInfo rendering{.sType =
                                                          VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                                      .colorAttachmentCount = 1,
                                                      .pColorAttachmentFormats = &format};
        const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                                .pNext = &rendering,
                                                .flags = flags,
                                                .stageCount = static_cast<std::uint32_t>(stages.size()),
                                                .pStages = stages.data(),
                                                .pVertexInputState = &input,
                                                .pInputAssemblyState = &assembly,
                                                .pViewportState = &view,
                                                .pRasterizationState = &raster,
                                                .pMultisampleState = &samples,
                                                .pColorBlendState = &blend,
                                                .layout = layout_};
        VkPipeline pipeline;
        require(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
                "vkCreateGraphicsPipelines");
        return pipeline;
    }

    compiled_program describe(VkPipeline pipeline, bool with_assembly) const {
        const VkPipelineInfoKHR info{.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, .pipeline = pipeline};
        std::array<VkPipelineExecutablePropertiesKHR, 8> properties{};
        for (auto& p : properties)
            p.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
        std::uint32_t count = properties.size();
        require(read_properties_(device_, &info, &count, properties.data()), "reading the executables");
        compiled_program made;
        for (std::uint32_t i = 0; i < count; ++i)
            for (const shader_stage stage :
                 {shader_stage::vertex, shader_stage::fragment, shader_stage::compute})
                if ((properties[i].stages & static_cast<VkShaderStageFlags>(bit_of(stage))) != 0) {
                    made[stage].statistics = statistics(pipeline, i);
                    if (with_assembly) made[stage].assembly = assembly(pipeline, i);
                }
        return made;
    }

    std::map<std::string, double> statistics(VkPipeline pipeline, std::uint32_t executable) const {
        const VkPipelineExecutableInfoKHR info{.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
                                               .pipeline = pipeline,
                                               .executableIndex = executable};
        std::array<VkPipelineExecutableStatisticKHR, 64> all{};
        for (auto& s : all)
            s.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
        std::uint32_t count = all.size();
        require(read_statistics_(device_, &info, &count, all.data()), "reading the statistics");
        std::map<std::string, double> read;
        for (std::uint32_t i = 0; i < count; ++i)
            if (all[i].format == VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR)
                read[all[i].name] = static_cast<double>(all[i].value.u64);
        return read;
    }

    std::string assembly(VkPipeline pipeline, std::uint32_t executable) const {
        const VkPipelineExecutableInfoKHR info{.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
                                               .pipeline = pipeline,
                                               .executableIndex = executable};
        std::array<VkPipelineExecutableInternalRepresentationKHR, 8> all{};
        for (auto& r : all)
            r.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INTERNAL_REPRESENTATION_KHR;
        std::uint32_t count = all.size();
        require(read_texts_(device_, &info, &count, all.data()), "reading the sizes of the texts");
        std::vector<std::string> texts(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            texts[i].resize(all[i].dataSize);
            all[i].pData = texts[i].data();
        }
        require(read_texts_(device_, &info, &count, all.data()), "reading the texts");
        for (std::uint32_t i = 0; i < count; ++i)
            if (std::string_view(all[i].name) == "Assembly") return texts[i].c_str();
        return {};
    }

    std::string driver_;
    VkDevice device_{};
    VkPipelineLayout layout_{};
    PFN_vkGetPipelineExecutablePropertiesKHR read_properties_{};
    PFN_vkGetPipelineExecutableStatisticsKHR read_statistics_{};
    PFN_vkGetPipelineExecutableInternalRepresentationsKHR read_texts_{};
};

// ---- the child process ------------------------------------------------------------------------------------

// The file that tells the Vulkan loader of RADV.
std::string driver_manifest() {
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
        const null_device gpu;
        nlohmann::json made = nlohmann::json::array();
        for (const shader_program& program : programs)
            made.push_back(to_json(gpu.compile(program, with_assembly)));
        return nlohmann::json{{"driver", gpu.driver()}, {"programs", made}}.dump();
    } catch (const std::exception& error) {
        return nlohmann::json{{"error", error.what()}}.dump();
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
    const int said = memfd_create("driver", 0);
    std::array<int, 2> ends{};
    if (said < 0 || pipe(ends.data()) != 0) throw failure("cost: no pipe to the compiler's process");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw failure("cost: the compiler's process cannot be started");
    if (child == 0) {
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
