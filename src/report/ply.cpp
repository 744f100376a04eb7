#include "report/ply.hpp"

#include "cob/error.hpp"
#include "report/image.hpp"

#include <cstring>
#include <limits>

namespace cob {
namespace {

/// Least significant byte first, as the header says, on any machine.
template <class Bits>
void append_bits(std::string& bytes, Bits bits) {
    for (std::size_t k = 0; k < sizeof bits; ++k) bytes += static_cast<char>(bits >> (8 * k) & 0xff);
}

void append_double(std::string& bytes, double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    append_bits(bytes, bits);
}

}  // namespace

PlyWriter::PlyWriter(const std::string& path, std::uint64_t corners, std::uint64_t faces) : file_(path) {
    if (corners > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
        throw InputError("too many elements for a PLY file",
                         {path, 0, std::to_string(faces), "leave it out: --no-ply"});
    file_.write(
        "ply\nformat binary_little_endian 1.0\n"
        "comment state: 0 uninitialised, 1 empty, 2 close, 3 occluded\n"
        "element vertex " +
        std::to_string(corners) +
        "\nproperty double x\nproperty double y\nproperty double z\n"
        "element face " +
        std::to_string(faces) +
        "\nproperty list uchar int vertex_indices\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar state\nend_header\n");
}

void PlyWriter::append_corners(std::string& bytes, const Corners& corners) {
    for (int k = 0; k < corners.count; ++k) {
        const Point& point = corners.points[static_cast<std::size_t>(k)].nearest();
        for (int axis = 0; axis < 3; ++axis) append_double(bytes, point[axis]);
    }
}

void PlyWriter::write_face(int corner_count, BufferState state) {
    faces_ += static_cast<char>(corner_count);
    for (int k = 0; k < corner_count; ++k) append_bits(faces_, static_cast<std::uint32_t>(next_corner_++));
    for (const std::uint8_t channel : report::colour_of(state)) faces_ += static_cast<char>(channel);
    faces_ += static_cast<char>(state);
    if (faces_.size() > (std::size_t{1} << 20)) {
        file_.write(faces_);
        faces_.clear();
    }
}

void PlyWriter::commit() {
    file_.write(faces_);
    file_.commit();
}

}  // namespace cob
