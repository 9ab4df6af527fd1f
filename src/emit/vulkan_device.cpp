#include "emit/vulkan_device.hpp"

#include "error.hpp"
#include "render/vulkan_context.hpp"

#include <fmt/format.h>
#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/ResourceLimits.h>

#include <algorithm>
#include <array>
#include <deque>
#include <memory>

namespace fresnel::emit {

namespace {

// ---- GLSL to SPIR-V ---------------------------------------------------------------------------------------

glslang_stage_t kind_of(shader_stage stage) {
    return stage == shader_stage::vertex     ? GLSLANG_STAGE_VERTEX
           : stage == shader_stage::fragment ? GLSLANG_STAGE_FRAGMENT
                                             : GLSLANG_STAGE_COMPUTE;
}

// Where the pipeline's layout has what: uniforms of a program for OpenGL get a block and places by themselves.
constexpr std::uint32_t first_buffer = 0, first_texture = 2, first_block = 10, bindings = 12;

using parsed_shader = std::unique_ptr<glslang_shader_t, decltype(&glslang_shader_delete)>;

parsed_shader parse(shader_stage stage, const std::string& text) {
    const glslang_input_t input{.language = GLSLANG_SOURCE_GLSL,
                                .stage = kind_of(stage),
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
    parsed_shader shader(glslang_shader_create(&input), glslang_shader_delete);
    glslang_shader_set_options(shader.get(), GLSLANG_SHADER_AUTO_MAP_BINDINGS |
                                                 GLSLANG_SHADER_AUTO_MAP_LOCATIONS |
                                                 GLSLANG_SHADER_VULKAN_RULES_RELAXED);
    glslang_shader_shift_binding(shader.get(), GLSLANG_RESOURCE_TYPE_SSBO, first_buffer);
    glslang_shader_shift_binding(shader.get(), GLSLANG_RESOURCE_TYPE_SAMPLER, first_texture);
    glslang_shader_shift_binding(shader.get(), GLSLANG_RESOURCE_TYPE_TEXTURE, first_texture);
    glslang_shader_shift_binding(shader.get(), GLSLANG_RESOURCE_TYPE_UBO, first_block);
    if (glslang_shader_preprocess(shader.get(), &input) == 0 ||
        glslang_shader_parse(shader.get(), &input) == 0)
        throw failure(
            fmt::format("the {} shader: {}", to_string(stage), glslang_shader_get_info_log(shader.get())));
    return shader;
}

// All stages at once, so that what one hands on is what the next takes.
std::map<shader_stage, std::vector<std::uint32_t>> spirv(const std::map<shader_stage, std::string>& sources) {
    [[maybe_unused]] static const bool ready = glslang_initialize_process() != 0;
    std::vector<parsed_shader> shaders;
    const std::unique_ptr<glslang_program_t, decltype(&glslang_program_delete)> program(
        glslang_program_create(), glslang_program_delete);
    for (const auto& [stage, text] : sources) {
        shaders.push_back(parse(stage, text));
        glslang_program_add_shader(program.get(), shaders.back().get());
    }
    if (glslang_program_link(program.get(), GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT) == 0 ||
        glslang_program_map_io(program.get()) == 0)
        throw failure(fmt::format("the stages do not fit: {}", glslang_program_get_info_log(program.get())));
    std::map<shader_stage, std::vector<std::uint32_t>> made;
    std::size_t before = 0; // glslang puts the words of a stage after those of the last
    for (const auto& [stage, text] : sources) {
        glslang_program_SPIRV_generate(program.get(), kind_of(stage));
        std::vector<std::uint32_t> words(glslang_program_SPIRV_get_size(program.get()));
        glslang_program_SPIRV_get(program.get(), words.data());
        made[stage].assign(words.begin() + static_cast<std::ptrdiff_t>(before), words.end());
        before = words.size();
    }
    return made;
}

// ---- Vulkan -----------------------------------------------------------------------------------------------

using render::check, render::owned;

VkShaderStageFlagBits bit_of(shader_stage stage) {
    return stage == shader_stage::vertex     ? VK_SHADER_STAGE_VERTEX_BIT
           : stage == shader_stage::fragment ? VK_SHADER_STAGE_FRAGMENT_BIT
                                             : VK_SHADER_STAGE_COMPUTE_BIT;
}

/// Vertex attributes, a vec4 each, one after the other in one buffer.
struct vertex_input {
    explicit vertex_input(int attributes) : binding{.stride = static_cast<std::uint32_t>(16 * attributes)} {
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(attributes); ++i)
            described.push_back({.location = i, .format = VK_FORMAT_R32G32B32A32_SFLOAT, .offset = 16 * i});
        info = {.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
                .vertexBindingDescriptionCount = attributes > 0 ? 1u : 0u,
                .pVertexBindingDescriptions = &binding,
                .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(described.size()),
                .pVertexAttributeDescriptions = described.data()};
    }
    vertex_input(const vertex_input&) = delete;
    vertex_input& operator=(const vertex_input&) = delete;

    VkVertexInputBindingDescription binding;
    std::vector<VkVertexInputAttributeDescription> described;
    VkPipelineVertexInputStateCreateInfo info{};
};

/// One target of four floats.
struct color_target {
    color_target() = default;
    color_target(const color_target&) = delete;
    color_target& operator=(const color_target&) = delete;

    VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                            .colorAttachmentCount = 1,
                                            .pColorAttachmentFormats = &format};
    VkPipelineColorBlendAttachmentState written{.colorWriteMask = 0xf};
    VkPipelineColorBlendStateCreateInfo blend{.sType =
                                                  VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                              .attachmentCount = 1,
                                              .pAttachments = &written};
};

/// The device of this process.
class null_device {
public:
    null_device() {
        VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
        VkPhysicalDeviceProperties2 about{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                          .pNext = &driver};
        vkGetPhysicalDeviceProperties2(context_.physical(), &about);
        driver_ = driver.driverInfo;
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
        std::deque<owned<VkShaderModule>> modules;
        for (const auto& [stage, words] : spirv(program.sources)) {
            const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                                .codeSize = 4 * words.size(),
                                                .pCode = words.data()};
            owned<VkShaderModule>& module = modules.emplace_back(device_, vkDestroyShaderModule);
            check(vkCreateShaderModule(device_, &info, nullptr, &module.object), "vkCreateShaderModule");
            stages.push_back({.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                              .stage = bit_of(stage),
                              .module = module,
                              .pName = "main"});
        }
        constexpr VkPipelineCreateFlags capture_texts =
            VK_PIPELINE_CREATE_CAPTURE_INTERNAL_REPRESENTATIONS_BIT_KHR;
        const VkPipelineCreateFlags flags =
            VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR | (with_assembly ? capture_texts : 0);
        owned<VkPipeline> pipeline(device_, vkDestroyPipeline);
        pipeline.object = stages.front().stage == VK_SHADER_STAGE_COMPUTE_BIT
                              ? compute(stages.front(), flags)
                              : graphics(stages, program.attributes, flags);
        return describe(pipeline, with_assembly);
    }

private:
    static render::vulkan_context open() {
        VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR executables{
            .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR,
            .pipelineExecutableInfo = VK_TRUE};
        const VkPhysicalDeviceVulkan13Features features{
            .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
            .pNext = &executables,
            .dynamicRendering = VK_TRUE};
        constexpr const char* extensions[] = {VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME};
        return render::vulkan_context({}, &features, extensions);
    }

    // Whatever a program wants: buffers, textures with their samplers, uniform blocks.
    static std::array<VkDescriptorType, bindings> every_type() {
        std::array<VkDescriptorType, bindings> all{};
        for (std::uint32_t i = 0; i < bindings; ++i)
            all[i] = i < first_texture ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                     : i < first_block ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                       : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        return all;
    }

    VkPipeline compute(const VkPipelineShaderStageCreateInfo& stage, VkPipelineCreateFlags flags) const {
        const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                               .flags = flags,
                                               .stage = stage,
                                               .layout = layout_.whole};
        VkPipeline pipeline;
        check(vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
              "vkCreateComputePipelines");
        return pipeline;
    }

    // Triangles of these attributes into one float target, no depth, no blending.
    VkPipeline graphics(const std::vector<VkPipelineShaderStageCreateInfo>& stages, int attributes,
                        VkPipelineCreateFlags flags) const {
        const vertex_input input(attributes);
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
        const color_target target;
        const VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                                .pNext = &target.rendering,
                                                .flags = flags,
                                                .stageCount = static_cast<std::uint32_t>(stages.size()),
                                                .pStages = stages.data(),
                                                .pVertexInputState = &input.info,
                                                .pInputAssemblyState = &assembly,
                                                .pViewportState = &view,
                                                .pRasterizationState = &raster,
                                                .pMultisampleState = &samples,
                                                .pColorBlendState = &target.blend,
                                                .layout = layout_.whole};
        VkPipeline pipeline;
        check(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
              "vkCreateGraphicsPipelines");
        return pipeline;
    }

    compiled_program describe(VkPipeline pipeline, bool with_assembly) const {
        const VkPipelineInfoKHR info{.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, .pipeline = pipeline};
        std::array<VkPipelineExecutablePropertiesKHR, 8> properties{};
        for (auto& p : properties)
            p.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
        std::uint32_t count = properties.size();
        check(read_properties_(device_, &info, &count, properties.data()), "reading the executables");
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
        check(read_statistics_(device_, &info, &count, all.data()), "reading the statistics");
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
        check(read_texts_(device_, &info, &count, all.data()), "reading the sizes of the texts");
        std::vector<std::string> texts(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            texts[i].resize(all[i].dataSize);
            all[i].pData = texts[i].data();
        }
        check(read_texts_(device_, &info, &count, all.data()), "reading the texts");
        for (std::uint32_t i = 0; i < count; ++i)
            if (std::string_view(all[i].name) == "Assembly") return texts[i].substr(0, texts[i].find(char{}));
        return {};
    }

    render::vulkan_context context_ = open();
    VkDevice device_ = context_.device();
    std::string driver_;
    render::pipeline_layout layout_{device_, every_type()};
    PFN_vkGetPipelineExecutablePropertiesKHR read_properties_{};
    PFN_vkGetPipelineExecutableStatisticsKHR read_statistics_{};
    PFN_vkGetPipelineExecutableInternalRepresentationsKHR read_texts_{};
};

} // namespace

compilation compile_here(std::span<const shader_program> programs, bool with_assembly) {
    const null_device device;
    compilation all{device.driver(), {}};
    for (const shader_program& program : programs)
        all.programs.push_back(device.compile(program, with_assembly));
    return all;
}

} // namespace fresnel::emit
