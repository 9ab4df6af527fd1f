#include "render/compute.hpp"

#include "error.hpp"
#include "render/unwatched.hpp"
#include "render/vulkan_context.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <cstring>

namespace fresnel::render {

namespace {

/// A storage buffer that this program can read and write.
class buffer {
public:
    buffer(VkDevice device, const VkPhysicalDeviceMemoryProperties& memories, std::size_t bytes)
        : buffer_(device, vkDestroyBuffer), memory_(device, vkFreeMemory) {
        VkBufferCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
        info.size = bytes, info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
        check(vkCreateBuffer(device, &info, nullptr, &buffer_.object), "a buffer");
        VkMemoryRequirements needs;
        vkGetBufferMemoryRequirements(device, buffer_, &needs);
        VkMemoryAllocateInfo allocation{};
        allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        allocation.allocationSize = needs.size;
        allocation.memoryTypeIndex = visible(memories, needs.memoryTypeBits);
        check(vkAllocateMemory(device, &allocation, nullptr, &memory_.object), "its memory");
        check(vkBindBufferMemory(device, buffer_, memory_, 0), "its memory");
        check(vkMapMemory(device, memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "its memory");
    }

    VkBuffer get() const { return buffer_; }
    void* data() const { return mapped_; }

private:
    static std::uint32_t visible(const VkPhysicalDeviceMemoryProperties& memories, std::uint32_t allowed) {
        constexpr VkMemoryPropertyFlags wanted =
            VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
        for (std::uint32_t i = 0; i < memories.memoryTypeCount; ++i)
            if ((allowed >> i & 1) != 0 && (memories.memoryTypes[i].propertyFlags & wanted) == wanted)
                return i;
        throw failure("Vulkan: no memory is visible from here");
    }

    owned<VkBuffer> buffer_;
    owned<VkDeviceMemory> memory_;
    void* mapped_ = nullptr;
};

class vulkan final : public compute_device {
public:
    explicit vulkan(std::string_view named) : context_(named) {
        vkGetPhysicalDeviceMemoryProperties(context_.physical(), &memories_);
        vkGetDeviceQueue(device_, context_.family(), 0, &queue_);
    }

    std::string name() const override {
        const std::uint32_t v = context_.properties().apiVersion;
        return fmt::format("{}, Vulkan {}.{}.{}", context_.properties().deviceName, VK_API_VERSION_MAJOR(v),
                           VK_API_VERSION_MINOR(v), VK_API_VERSION_PATCH(v));
    }

    std::vector<float> run(const std::string& shader, std::span<const float> inputs,
                           const evaluation& how) override {
        const unwatched driver;
        std::vector<float> results(how.rows * how.results);
        const buffer in(device_, memories_, inputs.size_bytes());
        const buffer out(device_, memories_, results.size() * sizeof(float));
        std::memcpy(in.data(), inputs.data(), inputs.size_bytes());
        constexpr VkDescriptorType both[] = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                             VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
        const pipeline_layout layout(device_, both);
        owned<VkShaderModule> module(device_, vkDestroyShaderModule);
        owned<VkPipeline> pipeline(device_, vkDestroyPipeline);
        make_pipeline(shader, layout.whole, module, pipeline);
        owned<VkDescriptorPool> pool(device_, vkDestroyDescriptorPool);
        const VkDescriptorSet set = describe(pool, layout.set, in.get(), out.get());
        submit(pipeline, layout.whole, set, static_cast<std::uint32_t>((how.rows + 63) / 64));
        std::memcpy(results.data(), out.data(), results.size() * sizeof(float));
        return results;
    }

private:
    void make_pipeline(const std::string& spirv, VkPipelineLayout layout, owned<VkShaderModule>& module,
                       owned<VkPipeline>& pipeline) const {
        std::vector<std::uint32_t> words(spirv.size() / 4);
        std::memcpy(words.data(), spirv.data(), words.size() * 4);
        if (words.empty() || words[0] != 0x07230203) throw refused_shader("not SPIR-V");
        VkShaderModuleCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        info.codeSize = words.size() * 4, info.pCode = words.data();
        check(vkCreateShaderModule(device_, &info, nullptr, &module.object), "a shader");
        VkComputePipelineCreateInfo compute{};
        compute.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        compute.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        compute.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        compute.stage.module = module, compute.stage.pName = "main";
        compute.layout = layout;
        check(vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &compute, nullptr, &pipeline.object),
              "a pipeline");
    }

    VkDescriptorSet describe(owned<VkDescriptorPool>& pool, VkDescriptorSetLayout layout, VkBuffer in,
                             VkBuffer out) const {
        const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
        VkDescriptorPoolCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
        info.maxSets = 1, info.poolSizeCount = 1, info.pPoolSizes = &size;
        check(vkCreateDescriptorPool(device_, &info, nullptr, &pool.object), "a pool");
        VkDescriptorSetAllocateInfo allocation{};
        allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        allocation.descriptorPool = pool, allocation.descriptorSetCount = 1, allocation.pSetLayouts = &layout;
        VkDescriptorSet set = VK_NULL_HANDLE;
        check(vkAllocateDescriptorSets(device_, &allocation, &set), "a set");
        const std::array<VkDescriptorBufferInfo, 2> buffers{
            {{in, 0, VK_WHOLE_SIZE}, {out, 0, VK_WHOLE_SIZE}}};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set, write.descriptorCount = 2, write.pBufferInfo = buffers.data();
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
        return set;
    }

    void submit(VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set,
                std::uint32_t groups) const {
        owned<VkCommandPool> pool(device_, vkDestroyCommandPool);
        VkCommandPoolCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        info.queueFamilyIndex = context_.family();
        check(vkCreateCommandPool(device_, &info, nullptr, &pool.object), "a command pool");
        VkCommandBufferAllocateInfo allocation{};
        allocation.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocation.commandPool = pool, allocation.commandBufferCount = 1;
        allocation.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        VkCommandBuffer commands = VK_NULL_HANDLE;
        check(vkAllocateCommandBuffers(device_, &allocation, &commands), "commands");
        VkCommandBufferBeginInfo begin{};
        begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
        check(vkBeginCommandBuffer(commands, &begin), "commands");
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, nullptr);
        vkCmdDispatch(commands, groups, 1, 1);
        // waiting for the queue alone does not let the host see what shaders wrote
        VkMemoryBarrier written{};
        written.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        written.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT, written.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                             &written, 0, nullptr, 0, nullptr);
        check(vkEndCommandBuffer(commands), "commands");
        VkSubmitInfo submission{};
        submission.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
        submission.commandBufferCount = 1, submission.pCommandBuffers = &commands;
        check(vkQueueSubmit(queue_, 1, &submission, VK_NULL_HANDLE), "a dispatch");
        check(vkQueueWaitIdle(queue_), "a dispatch");
    }

    vulkan_context context_;
    VkDevice device_ = context_.device();
    VkPhysicalDeviceMemoryProperties memories_{};
    VkQueue queue_ = VK_NULL_HANDLE;
};

} // namespace

std::unique_ptr<compute_device> open_vulkan() {
    const unwatched driver;
    const char* named = std::getenv("FRESNEL_VULKAN_DEVICE");
    return std::make_unique<vulkan>(named != nullptr ? named : "llvmpipe");
}

} // namespace fresnel::render
