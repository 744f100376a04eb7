#include "report/image.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cob::report {

Colour colour_of(BufferState state) {
    switch (state) {
        case BufferState::uninitialised:
            return {158, 158, 158};
        case BufferState::empty:
            return {86, 180, 233};
        case BufferState::close:
            return {230, 159, 0};
        case BufferState::occluded:
            return {120, 28, 80};
    }
    return {};
}

Image beside(const Image& left, const Image& right) {
    constexpr int bar = 8;
    Image both(left.width + bar + right.width, std::max(left.height, right.height), {235, 235, 235});
    for (int y = 0; y < left.height; ++y)
        for (int x = 0; x < left.width; ++x) both.at(x, y) = left.at(x, y);
    for (int y = 0; y < right.height; ++y)
        for (int x = 0; x < right.width; ++x) both.at(left.width + bar + x, y) = right.at(x, y);
    return both;
}

std::string encode_png(const Image& image) {
    png_image header;
    std::memset(&header, 0, sizeof header);
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    if (png_image_write_get_memory_size(header, size, 0, image.pixels.data(), 0, nullptr) == 0)
        throw std::runtime_error(std::string("PNG: ") + header.message);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0)
        throw std::runtime_error(std::string("PNG: ") + header.message);
    bytes.resize(size);
    return bytes;
}

Image decode_png(const std::string& path) {
    const std::string bytes = read_file(path);
    png_image header;
    std::memset(&header, 0, sizeof header);
    header.version = PNG_IMAGE_VERSION;
    const auto refuse = [&] {
        png_image_free(&header);
        throw InputError("not a readable PNG picture", {path, 0, header.message, "render it again"});
    };
    if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) refuse();
    header.format = PNG_FORMAT_RGB;
    Image image(static_cast<int>(header.width), static_cast<int>(header.height));
    if (png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr) == 0) refuse();
    return image;
}

std::uint8_t to_srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double s = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * s));
}

}  // namespace cob::report
