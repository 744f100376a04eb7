/// \file
/// Elements as a PLY mesh that ParaView, MeshLab and Blender open.
#pragma once

#include "cob/buffer.hpp"
#include "cob/files.hpp"
#include "cob/geometry.hpp"

#include <cstdint>
#include <string>

namespace cob {

/// Writes a binary PLY: every element has corners of its own (in binary64, rounded) and one face with `red`, `green`,
/// `blue` and `state` (0 uninitialised, 1 empty, 2 close, 3 occluded). All corners come first, then all faces, in the
/// order of the elements. The file appears on commit().
class PlyWriter {
public:
    PlyWriter(const std::string& path, std::uint64_t corners, std::uint64_t faces);

    /// Appends an element's corners as they stand in the file; threads may do so at the same time.
    static void append_corners(std::string& bytes, const Corners& corners);
    void write_corners(const std::string& bytes) { file_.write(bytes); }
    /// The next element's face.
    void write_face(int corner_count, BufferState state);
    void commit();

private:
    OutputFile file_;
    std::string faces_;
    std::int32_t next_corner_ = 0;
};

}  // namespace cob
