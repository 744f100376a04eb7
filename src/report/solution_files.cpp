#include "report/solution_files.hpp"

#include "arithmetic/text.hpp"
#include "radiosity/mesh.hpp"
#include "report/picture.hpp"

#include <cmath>
#include <cstring>

namespace cob::report {

using radiosity::Mesh;
using radiosity::MeshVertex;
using radiosity::Node;
using radiosity::NodeId;

namespace {

int state_number(const RadiositySolver& solver, NodeId leaf) {
    return static_cast<int>(solver.hidden(leaf) ? BufferState::occluded : solver.buffer_state(leaf));
}

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);  // the header names this machine's order
}

bool little_endian() {
    const std::uint16_t one = 1;
    unsigned char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 1;
}

}  // namespace

std::string solution_ply(const RadiositySolver& solver, double exposure) {
    const Mesh& mesh = solver.mesh();
    const std::vector<Rgb> exitance = solver.vertex_exitance();
    const std::vector<NodeId> leaves = mesh.leaves();
    std::string text = std::string("ply\nformat ") + (little_endian() ? "binary_little_endian" : "binary_big_endian") +
                       " 1.0\ncomment exitance in W/m2\nelement vertex " + std::to_string(mesh.vertices().size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\n"
                       "property double exitance_r\nproperty double exitance_g\nproperty double exitance_b\n"
                       "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face " +
                       std::to_string(leaves.size()) +
                       "\nproperty list uchar int vertex_indices\nproperty int polygon\nproperty uchar level\n"
                       "property uchar state\nend_header\n";
    for (std::size_t v = 0; v < exitance.size(); ++v) {
        const Point at = mesh.in_scene(mesh.vertices()[v].position);
        for (int axis = 0; axis < 3; ++axis) append(text, at[axis]);
        for (const double m : exitance[v]) append(text, m);
        for (const double m : exitance[v]) append(text, to_srgb(exposure * m));
    }
    for (const NodeId leaf : leaves) {
        const auto outline = solver.outline(leaf);
        append(text, static_cast<std::uint8_t>(outline.size()));
        for (const auto& place : outline) append(text, place[0]);
        append(text, solver.roots()[mesh.node(leaf).element.root].polygon);
        append(text, mesh.node(leaf).level);
        append(text, static_cast<std::uint8_t>(state_number(solver, leaf)));
    }
    return text;
}

std::string solution_vtp(const RadiositySolver& solver) {
    const Mesh& mesh = solver.mesh();
    const std::vector<Rgb> exitance = solver.vertex_exitance();
    const std::vector<NodeId> leaves = mesh.leaves();
    std::string points, at_points, corners, ends, at_cells, polygons, levels, states;
    for (std::size_t v = 0; v < exitance.size(); ++v) {
        const Point at = mesh.in_scene(mesh.vertices()[v].position);
        points += to_text(at.x) + " " + to_text(at.y) + " " + to_text(at.z) + "\n";
        at_points += to_text(exitance[v][0]) + " " + to_text(exitance[v][1]) + " " + to_text(exitance[v][2]) + "\n";
    }
    std::size_t end = 0;
    for (const NodeId leaf : leaves) {
        for (const auto& place : solver.outline(leaf)) {
            corners += std::to_string(place[0]) + " ";
            ++end;
        }
        corners += "\n";
        ends += std::to_string(end) + "\n";
        const Rgb m = solver.exitance(leaf);
        at_cells += to_text(m[0]) + " " + to_text(m[1]) + " " + to_text(m[2]) + "\n";
        polygons += std::to_string(solver.roots()[mesh.node(leaf).element.root].polygon) + "\n";
        levels += std::to_string(mesh.node(leaf).level) + "\n";
        states += std::to_string(state_number(solver, leaf)) + "\n";
    }
    const auto array = [](const std::string& type, const std::string& name, int components, const std::string& data) {
        return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
               std::to_string(components) + "\" format=\"ascii\">\n" + data + "</DataArray>\n";
    };
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
           "<PolyData>\n<Piece NumberOfPoints=\"" +
           std::to_string(exitance.size()) +
           "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
           "NumberOfPolys=\"" +
           std::to_string(leaves.size()) + "\">\n<PointData Vectors=\"exitance\">\n" +
           array("Float64", "exitance", 3, at_points) + "</PointData>\n<CellData>\n" +
           array("Float64", "element_exitance", 3, at_cells) + array("Int32", "polygon", 1, polygons) +
           array("UInt8", "level", 1, levels) + array("UInt8", "state", 1, states) + "</CellData>\n<Points>\n" +
           array("Float64", "points", 3, points) + "</Points>\n<Polys>\n" + array("Int32", "connectivity", 1, corners) +
           array("Int32", "offsets", 1, ends) + "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string solution_csv(const RadiositySolver& solver) {
    const Mesh& mesh = solver.mesh();
    std::string text = "element,polygon,root,level,level_i,level_j,i,j,inverted,x,y,z,area,r,g,b,state\n";
    std::size_t number = 0;
    for (const NodeId leaf : mesh.leaves()) {
        const Node& node = mesh.node(leaf);
        const Element& e = node.element;
        Point centre;
        for (int k = 0; k < node.corner_count(); ++k) {
            const auto v = static_cast<std::size_t>(node.corners[static_cast<std::size_t>(k)]);
            centre = centre + (1.0 / node.corner_count()) * mesh.vertices()[v].position;
        }
        centre = mesh.in_scene(centre);
        const Rgb m = solver.exitance(leaf);
        text += std::to_string(number++);
        for (const long long n :
             {static_cast<long long>(solver.roots()[e.root].polygon), static_cast<long long>(e.root),
              static_cast<long long>(node.level), static_cast<long long>(e.level_i), static_cast<long long>(e.level_j),
              static_cast<long long>(e.i), static_cast<long long>(e.j), static_cast<long long>(e.inverted)})
            text += "," + std::to_string(n);
        for (const double x : {centre.x, centre.y, centre.z}) text += "," + to_text(x);
        text += "," + scaled_text(mesh.area(leaf), 2 * mesh.exponent());
        for (const double x : m) text += "," + to_text(x);
        text += std::string(",") + (solver.hidden(leaf) ? "hidden" : to_text(solver.buffer_state(leaf))) + "\n";
    }
    return text;
}

}  // namespace cob::report
