#include "golden/scene_writer.hpp"

#include "cob/tables.hpp"

#include <algorithm>
#include <set>

namespace cob {

namespace {

/// Whether a reader surely takes the name back as one word.
bool is_plain(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    });
}

/// Name of each material in use, by its index; empty: not in use.
std::vector<std::string> material_names(const Scene& scene, std::vector<std::int32_t>& order) {
    std::vector<std::string> names(scene.materials().size());
    std::set<std::string> taken;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        const std::int32_t material = scene.polygon(id).material;
        std::string& name = names[static_cast<std::size_t>(material)];
        if (!name.empty()) continue;
        name = scene.materials()[static_cast<std::size_t>(material)].name;
        for (std::size_t k = order.size(); !is_plain(name) || taken.count(name) != 0; ++k)
            name = "material" + std::to_string(k);
        taken.insert(name);
        order.push_back(material);
    }
    return names;
}

std::string words(const std::array<double, 3>& values) {
    return " " + to_text(values[0]) + " " + to_text(values[1]) + " " + to_text(values[2]) + "\n";
}

void append_face(std::string& text, const Scene& scene, PolygonId id) {
    const auto loop = scene.loop(id);
    text += "f";
    for (const VertexId corner : loop) text += " " + std::to_string(corner + 1);
    // An invalid polygon may have fewer than three corners left, and none; read back it is one again.
    const VertexId last = loop.empty() ? 0 : loop[loop.size() - 1];
    for (std::size_t k = loop.size(); k < 3 && !scene.positions().empty(); ++k) text += " " + std::to_string(last + 1);
    text += "\n";
}

}  // namespace

SceneText write_scene(const Scene& scene) {
    SceneText text;
    std::vector<std::int32_t> order;
    const std::vector<std::string> names = material_names(scene, order);
    for (const std::int32_t k : order) {
        const Material& material = scene.materials()[static_cast<std::size_t>(k)];
        text.mtl += "newmtl " + names[static_cast<std::size_t>(k)] + "\nKd" + words(material.reflectance) + "Ke" +
                    words(material.emitted_exitance);
    }

    text.obj = "mtllib scene.mtl\n";
    for (const Point& p : scene.positions()) text.obj += "v" + words({p.x, p.y, p.z});
    std::int32_t material = -1;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        if (scene.polygon(id).material != material) {
            material = scene.polygon(id).material;
            text.obj += "usemtl " + names[static_cast<std::size_t>(material)] + "\n";
        }
        append_face(text.obj, scene, id);
    }

    text.triangles = "triangle,polygon,x0,y0,z0,x1,y1,z1,x2,y2,z2\n";
    for (const Piece& piece : scene.pieces()) {
        const auto corners = scene.corners(piece);
        for (const auto& triangle : cut_into_triangles(scene, piece)) {
            const auto at = [&](std::size_t k) { return scene.position(corners[triangle[k]]); };
            append_row(text.triangles, TriangleRow{text.triangle_count++, piece.polygon, {at(0), at(1), at(2)}});
        }
    }
    return text;
}

}  // namespace cob
