/// \file
/// Pictures in memory and as PNG files.
#pragma once

#include "cob/classification.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cob::report {

using Colour = std::array<std::uint8_t, 3>;  ///< sRGB.

/// The colour that stands for a state in pictures and meshes.
Colour colour_of(BufferState state);

/// Rows from the top, pixels from the left.
struct Image {
    int width = 0, height = 0;
    std::vector<Colour> pixels;

    Image() = default;
    Image(int w, int h, Colour fill = {0, 0, 0})
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
    Colour& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    const Colour& at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

/// Two pictures beside each other, a light bar between them.
Image beside(const Image& left, const Image& right);

/// The bytes of a PNG file; the same for the same picture.
std::string encode_png(const Image& image);
/// Reads a PNG file. Throws InputError.
Image decode_png(const std::string& path);

/// Linear light in [0, 1] to sRGB (IEC 61966-2-1).
std::uint8_t to_srgb(double linear);

}  // namespace cob::report
