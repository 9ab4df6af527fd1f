#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace fresnel::render {

/// Throws failure where something of Vulkan did not succeed.
void check(VkResult result, std::string_view what);

/// A Vulkan device of this machine with a queue that computes.
class vulkan_context {
public:
    /// The first device with `named` in its name. `features` is a chain of structures that the device is made with.
    /// Throws render::no_device.
    explicit vulkan_context(std::string_view named, const void* features = nullptr,
                            std::span<const char* const> extensions = {});

    VkPhysicalDevice physical() const { return physical_; }
    const VkPhysicalDeviceProperties& properties() const { return properties_; }
    VkDevice device() const { return device_.get(); }
    std::uint32_t family() const { return family_; }

private:
    struct destroyer {
        void operator()(VkInstance instance) const { vkDestroyInstance(instance, nullptr); }
        void operator()(VkDevice device) const { vkDestroyDevice(device, nullptr); }
    };

    void choose(std::string_view named);
    void find_family();

    std::unique_ptr<VkInstance_T, destroyer> instance_;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties_{};
    std::uint32_t family_ = 0;
    std::unique_ptr<VkDevice_T, destroyer> device_;
};

/// A Vulkan object of a device, destroyed at the end of its scope.
template <class Object>
class owned {
public:
    using destroyer = void (*)(VkDevice, Object, const VkAllocationCallbacks*);
    owned(VkDevice device, destroyer destroy) : device_(device), destroy_(destroy) {}
    ~owned() { destroy_(device_, object, nullptr); }
    owned(const owned&) = delete;
    owned& operator=(const owned&) = delete;
    operator Object() const { return object; }

    Object object = VK_NULL_HANDLE;

private:
    VkDevice device_;
    destroyer destroy_;
};

/// The layout of a pipeline with one set of descriptors, of these types in the order of their bindings.
struct pipeline_layout {
    pipeline_layout(VkDevice device, std::span<const VkDescriptorType> types);

    owned<VkDescriptorSetLayout> set;
    owned<VkPipelineLayout> whole;
};

} // namespace fresnel::render
