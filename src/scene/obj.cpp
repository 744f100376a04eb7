// Vertices, faces and the names of materials; everything else in the file is passed over.
#include "scene/obj.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/scene.hpp"
#include "scene/materials.hpp"
#include "scene/statements.hpp"

#include <charconv>
#include <limits>
#include <utility>

namespace cob {
namespace {

/// Statements that mean something but nothing here; all others that are not read are counted.
bool is_known(std::string_view keyword) {
    return keyword == "vn" || keyword == "vt" || keyword == "g" || keyword == "o" || keyword == "s";
}

class ObjReader {
public:
    ObjReader(const std::string& path, const ReadOptions& options, ReadReport& report)
        : path_(path), report_(report), library_(path, options, report) {
        input_.name = path;
    }

    Scene::Input read(std::string_view text) {
        StatementReader reader(text);
        for (Statement statement; reader.next(statement);) {
            if (statement.keyword == "v")
                read_vertex(statement);
            else if (statement.keyword == "f")
                read_face(statement);
            else if (statement.keyword == "usemtl")
                use_material(statement.rest);
            else if (statement.keyword == "mtllib")
                library_.read_libraries(statement.rest);
            else if (!is_known(statement.keyword))
                count_skipped(report_, statement.keyword);
        }
        check_indices();
        resolve_materials();
        return std::move(input_);
    }

private:
    /// x y z, then a weight or a colour or both, which must be numbers but do not matter here.
    void read_vertex(const Statement& statement) {
        constexpr std::size_t most = 8;
        Point point;
        std::string_view rest = statement.rest;
        std::size_t count = 0;
        for (std::string_view token; !(token = take_token(rest)).empty(); ++count) {
            const auto value = parse_binary64(token);
            if (!value)
                throw InputError("not a finite number", {path_, statement.line, std::string(token),
                                                         "write decimal or hex-float numbers within +-1.797e308"});
            if (count == most) break;
            if (count < 3) point[static_cast<int>(count)] = *value;
        }
        if (count < 3 || count == most)
            throw InputError("bad vertex", {path_, statement.line, std::string(statement.rest),
                                            "give x y z, then optionally a weight or a colour"});
        if (count == 4 || count == 7) count_skipped(report_, "v(weight)");
        input_.positions.push_back(point);
    }

    /// Corners as v, v/vt, v//vn or v/vt/vn; only v matters.
    void read_face(const Statement& statement) {
        Scene::Face face;
        face.line = static_cast<std::uint32_t>(statement.line);
        face.material = material_;
        std::string_view rest = statement.rest;
        for (std::string_view token; !(token = take_token(rest)).empty();)
            face.corners.push_back(read_corner(token, statement.line));
        input_.faces.push_back(std::move(face));
    }

    VertexId read_corner(std::string_view token, std::size_t line) const {
        const auto bad = [&](const char* problem) {
            return InputError(problem, {path_, line, std::string(token),
                                        "number vertices from 1, or from -1 backwards: v, v/vt, v//vn or v/vt/vn"});
        };
        std::array<std::int64_t, 3> numbers{};
        std::size_t count = 0;
        for (std::string_view part = token;; ++count) {
            const std::size_t slash = part.find('/');
            const std::string_view digits = part.substr(0, slash);
            if (count == 3) throw bad("bad corner of a face");
            const bool may_be_empty = count == 1 && slash != std::string_view::npos;
            if (!(digits.empty() && may_be_empty)) {
                const auto [stop, error] =
                    std::from_chars(digits.data(), digits.data() + digits.size(), numbers[count]);
                if (error != std::errc() || stop != digits.data() + digits.size()) throw bad("bad corner of a face");
            }
            if (slash == std::string_view::npos) break;
            part.remove_prefix(slash + 1);
        }
        const std::int64_t known = static_cast<std::int64_t>(input_.positions.size());
        const std::int64_t index = numbers[0] > 0 ? numbers[0] - 1 : known + numbers[0];
        constexpr std::int64_t most = std::numeric_limits<VertexId>::max();
        if (numbers[0] == 0 || index < 0 || index > most) throw bad("vertex does not exist");
        return static_cast<VertexId>(index);
    }

    /// Faces may name vertices that follow later in the file, but not ones that never come.
    void check_indices() const {
        for (const Scene::Face& face : input_.faces)
            for (const VertexId corner : face.corners)
                if (static_cast<std::size_t>(corner) >= input_.positions.size())
                    throw InputError("vertex does not exist",
                                     {path_, face.line, std::to_string(std::int64_t{corner} + 1),
                                      "the file has " + std::to_string(input_.positions.size()) + " vertices"});
    }

    /// Libraries may follow later in the file, so names are kept until its end.
    void use_material(std::string_view name) {
        const auto [found, is_new] = used_.emplace(name, static_cast<std::int32_t>(used_names_.size()));
        if (is_new) used_names_.emplace_back(name);
        material_ = found->second;
    }

    void resolve_materials() {
        std::vector<std::int32_t> index;
        for (const std::string& name : used_names_) index.push_back(library_.find(name));
        for (Scene::Face& face : input_.faces)
            face.material = face.material < 0 ? 0 : index[static_cast<std::size_t>(face.material)];
        input_.materials = library_.take();
    }

    const std::string& path_;
    ReadReport& report_;
    MaterialLibrary library_;
    Scene::Input input_;
    std::map<std::string, std::int32_t, std::less<>> used_;
    std::vector<std::string> used_names_;
    std::int32_t material_ = -1;  ///< Into used_names_; -1 before the first usemtl.
};

}  // namespace

Scene::Input parse_obj(std::string_view text, const std::string& path, const ReadOptions& options, ReadReport& report) {
    return ObjReader(path, options, report).read(text);
}

Scene read_obj(const std::string& path, const ReadOptions& options, ReadReport* report) {
    ReadReport unread;
    Scene::Input input = parse_obj(read_file(path), path, options, report ? *report : unread);
    return Scene::build(std::move(input), {options.skip_invalid});
}

}  // namespace cob
