#include "figure/figure.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <png.h>

namespace fresnel {

void write_strip_png(const std::string& path, const std::vector<strip>& rows, int height) {
    const std::size_t width = rows.empty() ? 0 : rows.front().pixels.size();
    std::vector<std::uint8_t> bytes;
    for (const strip& row : rows)
        for (int y = 0; y < height; ++y)
            for (const auto& pixel : row.pixels)
                bytes.insert(bytes.end(), pixel.begin(), pixel.end());

    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(rows.size() * static_cast<std::size_t>(height));
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    if (bytes.size() != 3 * width * image.height ||
        png_image_write_to_memory(&image, nullptr, &size, 0, bytes.data(), 0, nullptr) == 0)
        throw failure(fmt::format("{}: rows of different length make no picture", path));
    std::string text(size, '\0');
    png_image_write_to_memory(&image, text.data(), &size, 0, bytes.data(), 0, nullptr);
    write_file(path, text.substr(0, size));
}

} // namespace fresnel
