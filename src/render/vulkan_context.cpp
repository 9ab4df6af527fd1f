#include "render/vulkan_context.hpp"

#include "error.hpp"
#include "render/compute.hpp"

#include <fmt/format.h>

#include <vector>

namespace fresnel::render {

void check(VkResult result, std::string_view what) {
    if (result != VK_SUCCESS)
        throw failure(fmt::format("Vulkan: {}: error {}", what, static_cast<int>(result)));
}

vulkan_context::vulkan_context(std::string_view named, const void* features,
                               std::span<const char* const> extensions) {
    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .apiVersion = VK_API_VERSION_1_3};
    const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                    .pApplicationInfo = &application};
    VkInstance instance = VK_NULL_HANDLE;
    if (vkCreateInstance(&info, nullptr, &instance) != VK_SUCCESS)
        throw no_device("Vulkan finds no driver; mesa-vulkan-drivers has a software one");
    instance_.reset(instance);
    choose(named);
    find_family();
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                        .queueFamilyIndex = family_,
                                        .queueCount = 1,
                                        .pQueuePriorities = &priority};
    const VkDeviceCreateInfo wanted{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                    .pNext = features,
                                    .queueCreateInfoCount = 1,
                                    .pQueueCreateInfos = &queue,
                                    .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                    .ppEnabledExtensionNames = extensions.data()};
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical_, &wanted, nullptr, &device), "the device");
    device_.reset(device);
}

void vulkan_context::choose(std::string_view named) {
    std::uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance_.get(), &count, nullptr);
    std::vector<VkPhysicalDevice> all(count);
    vkEnumeratePhysicalDevices(instance_.get(), &count, all.data());
    for (const VkPhysicalDevice device : all) {
        vkGetPhysicalDeviceProperties(device, &properties_);
        physical_ = device;
        if (std::string_view(properties_.deviceName).find(named) != std::string_view::npos) return;
    }
    throw no_device(fmt::format("Vulkan has no device{}{}; mesa-vulkan-drivers has the software one",
                                named.empty() ? "" : " called ", named));
}

void vulkan_context::find_family() {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
    std::vector<VkQueueFamilyProperties> all(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, all.data());
    for (family_ = 0; family_ < count; ++family_)
        if ((all[family_].queueFlags & VK_QUEUE_COMPUTE_BIT) != 0) return;
    throw no_device("the Vulkan device does not compute");
}

pipeline_layout::pipeline_layout(VkDevice device, std::span<const VkDescriptorType> types)
    : set(device, vkDestroyDescriptorSetLayout), whole(device, vkDestroyPipelineLayout) {
    std::vector<VkDescriptorSetLayoutBinding> all;
    for (const VkDescriptorType type : types)
        all.push_back({.binding = static_cast<std::uint32_t>(all.size()),
                       .descriptorType = type,
                       .descriptorCount = 1,
                       .stageFlags = VK_SHADER_STAGE_ALL});
    const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                               .bindingCount = static_cast<std::uint32_t>(all.size()),
                                               .pBindings = all.data()};
    check(vkCreateDescriptorSetLayout(device, &info, nullptr, &set.object), "a layout");
    const VkPipelineLayoutCreateInfo pipeline{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                              .setLayoutCount = 1,
                                              .pSetLayouts = &set.object};
    check(vkCreatePipelineLayout(device, &pipeline, nullptr, &whole.object), "a layout");
}

} // namespace fresnel::render
