#include "emit/lut_text.hpp"
#include "error.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <half.h>
#include <png.h>

#include <cmath>

namespace fresnel::emit {

namespace {

std::string description(const lut& table, const lut_names& names) {
    std::string text =
        fmt::format("Fresnel reflectance, {}; even in {}; {}; made by {}", table.subject.caption,
                    table.subject.critical > 0 ? "sqrt(cos_i - cos_c)" : std::string(table.map->name),
                    error_text(table), names.made_by);
    if (table.subject.critical > 0) text += fmt::format("; cos_c = {}", table.subject.critical);
    if (table.scaled()) text += fmt::format("; 0 to 1 stand for {} to {}", table.lo, table.hi);
    return text;
}

// ---- PNG ------------------------------------------------------------------------------------------------------

[[noreturn]] void stop_png(png_structp, png_const_charp message) {
    throw failure(fmt::format("the PNG cannot be made: {}", message));
}

void append(png_structp png, png_bytep data, png_size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

// Texels as big-endian integers, row after row.
std::string png_bytes(const lut& table) {
    std::string bytes;
    const bool wide = table.format == texel_format::r16;
    for (const float texel : table.texels) {
        const auto code = static_cast<unsigned>(std::lround(texel * (wide ? 65535.0f : 255.0f)));
        if (wide) bytes += static_cast<char>(code >> 8);
        bytes += static_cast<char>(code & 255u);
    }
    return bytes;
}

std::string png_text(const lut& table, const lut_names& names) {
    std::string file, bytes = png_bytes(table), words = description(table, names);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, stop_png, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &file, append, nullptr);
    const int depth = table.format == texel_format::r16 ? 16 : 8;
    png_set_IHDR(png, info, static_cast<png_uint_32>(table.columns), static_cast<png_uint_32>(table.rows),
                 depth, table.channels() == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::string key = "Description";
    png_text_struct text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key.data(), text.text = words.data(), text.text_length = words.size();
    png_set_text(png, info, &text, 1);
    png_write_info(png, info);
    const std::size_t stride = bytes.size() / table.rows;
    for (std::size_t row = 0; row < table.rows; ++row)
        png_write_row(png, reinterpret_cast<png_bytep>(bytes.data() + row * stride));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

// ---- OpenEXR --------------------------------------------------------------------------------------------------

/// A stream of OpenEXR's into a string.
class string_stream : public Imf::OStream {
public:
    string_stream() : Imf::OStream("table") {}
    void write(const char* bytes, int count) override {
        const auto n = static_cast<std::size_t>(count);
        if (text_.size() < at_ + n) text_.resize(at_ + n);
        text_.replace(at_, n, bytes, n);
        at_ += n;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t at) override { at_ = at; }
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::size_t at_ = 0;
};

// R alone, R G B, or R G B A, of which one channel is repeated and A is 1.
std::vector<std::string> exr_channels(const lut& table) {
    if (table.format == texel_format::rgba32f) return {"R", "G", "B", "A"};
    if (table.channels() == 3) return {"R", "G", "B"};
    return {"R"};
}

float exr_value(const lut& table, std::size_t texel, std::size_t channel) {
    if (channel == 3) return 1;
    return table.texels[texel * table.channels() + std::min(channel, table.channels() - 1)];
}

template <class Number>
std::string exr_text(const lut& table, const lut_names& names, Imf::PixelType type) {
    const std::vector<std::string> channels = exr_channels(table);
    const std::size_t count = table.columns * table.rows;
    Imf::Header header(static_cast<int>(table.columns), static_cast<int>(table.rows));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.insert("comments", Imf::StringAttribute(description(table, names)));
    Imf::FrameBuffer buffer;
    std::vector<std::vector<Number>> planes(channels.size());
    for (std::size_t c = 0; c < channels.size(); ++c) {
        for (std::size_t i = 0; i < count; ++i)
            planes[c].push_back(Number(exr_value(table, i, c)));
        header.channels().insert(channels[c], Imf::Channel(type));
        buffer.insert(channels[c], Imf::Slice(type, reinterpret_cast<char*>(planes[c].data()), sizeof(Number),
                                              sizeof(Number) * table.columns));
    }
    string_stream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(static_cast<int>(table.rows));
    }
    return stream.text();
}

} // namespace

std::string lut_image(const lut& table, const lut_names& names) {
    switch (table.format) {
    case texel_format::r8:
    case texel_format::r16:
        return png_text(table, names);
    case texel_format::r16f:
        return exr_text<Imath::half>(table, names, Imf::HALF);
    case texel_format::rgba32f:
        return exr_text<float>(table, names, Imf::FLOAT);
    case texel_format::c:
        break;
    }
    throw std::invalid_argument("a C array is no image");
}

} // namespace fresnel::emit
