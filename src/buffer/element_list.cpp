#include "cob/classify.hpp"

#include "cob/error.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace cob {
namespace {

constexpr int most_levels = 20;
constexpr std::uint64_t most_elements = std::uint64_t{1} << 40;

/// The path of children from the root to an element of a square cut.
std::string path_from_root(const Root& root, Element element) {
    std::string path;
    while (element.level_i > 0) {
        const Element above = parent(root, element);
        const auto below = children(root, above);
        for (std::size_t k = 0; k < below.size(); ++k)
            if (below[k] == element) path.insert(path.begin(), static_cast<char>('0' + k));
        element = above;
    }
    return path;
}

/// The cell that `halvings` refinements make this patch of; of the shorter way of a quadrilateral, as many as it has.
Element cell_around(const Root& root, Element patch, int halvings) {
    if (root.corner_count() == 3) {
        for (; halvings > 0; --halvings) patch = parent(root, patch);
        return patch;
    }
    const int by_i = std::min<int>(halvings, patch.level_i), by_j = std::min<int>(halvings, patch.level_j);
    patch.i >>= by_i;
    patch.j >>= by_j;
    patch.level_i = static_cast<std::uint8_t>(patch.level_i - by_i);
    patch.level_j = static_cast<std::uint8_t>(patch.level_j - by_j);
    return patch;
}

/// Reads numbers and signs off the front of a text.
class AddressReader {
public:
    explicit AddressReader(const std::string& text) : text_(text), rest_(text) {}

    std::uint32_t number() {
        std::uint32_t value = 0;
        const auto [stop, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{}) refuse("no element address");
        rest_.remove_prefix(static_cast<std::size_t>(stop - rest_.data()));
        return value;
    }
    bool take(char sign) {
        if (rest_.empty() || rest_.front() != sign) return false;
        rest_.remove_prefix(1);
        return true;
    }
    void expect(char sign) {
        if (!take(sign)) refuse("no element address");
    }
    bool at_end() const { return rest_.empty(); }
    char next() {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        return c;
    }
    [[noreturn]] void refuse(const std::string& problem) const {
        throw InputError(problem, {"", 0, text_,
                                   "write POLYGON.ROOT, POLYGON.ROOT/PATH with digits 0 to 3, or "
                                   "POLYGON.ROOT:LEVEL_I,LEVEL_J:I,J"});
    }

private:
    const std::string& text_;
    std::string_view rest_;
};

}  // namespace

ElementList::ElementList(const Scene& scene, const Roots& roots, const Meshing& meshing)
    : scene_(scene), roots_(roots), meshing_(meshing) {
    if (meshing.level < 0 || meshing.level > most_levels)
        throw InputError("level out of range",
                         {"", 0, std::to_string(meshing.level), "give 0 to " + std::to_string(most_levels)});
    for (const Root& root : roots.all()) {
        const auto cut = cob::patches(scene, root, meshing.edge);
        patches_.insert(patches_.end(), cut.begin(), cut.end());
        if (patches_.size() > most_elements >> (2 * meshing.level))
            throw InputError("more than 2^40 elements", {"", 0, "", "choose a longer edge or a lower level"});
    }
}

Element ElementList::operator[](std::uint64_t number) const {
    Element element = patches_[number >> (2 * meshing_.level)];
    for (int shift = 2 * meshing_.level - 2; shift >= 0; shift -= 2)
        element = children(root_of(element), element)[number >> shift & 3];
    return element;
}

void ElementList::around(std::uint64_t number, std::vector<Element>& ancestors) const {
    ancestors.clear();
    Element element = patches_[number >> (2 * meshing_.level)];
    for (int halvings = std::max(element.level_i, element.level_j); halvings > 0; --halvings)
        ancestors.push_back(cell_around(root_of(element), element, halvings));
    for (int shift = 2 * meshing_.level - 2; shift >= 0; shift -= 2) {
        ancestors.push_back(element);
        element = children(root_of(element), element)[number >> shift & 3];
    }
}

void ElementList::consecutive_around(std::uint64_t number, std::vector<Element>& ancestors) const {
    ancestors.clear();
    Element element = patches_[number >> (2 * meshing_.level)];
    if (!(element == root_element(element.root))) ancestors.push_back(root_element(element.root));
    for (int shift = 2 * meshing_.level - 2; shift >= 0; shift -= 2) {
        ancestors.push_back(element);
        element = children(root_of(element), element)[number >> shift & 3];
    }
}

std::uint64_t ElementList::elements_in(std::uint64_t number, const Element& ancestor) const {
    const Element& patch = patches_[number >> (2 * meshing_.level)];
    // A triangle's two levels are equal, and a refinement raises both: four of one.
    const int by_i = patch.level_i + meshing_.level - ancestor.level_i;
    const int by_j = patch.level_j + meshing_.level - ancestor.level_j;
    return std::uint64_t{1} << (by_i + by_j);
}

std::string to_address(const Roots& roots, const Element& element) {
    const Root& root = roots[element.root];
    const RootId first = roots.of(root.polygon).first;
    std::string text = std::to_string(root.polygon) + "." + std::to_string(element.root - first);
    if (element.level_i == element.level_j) {
        const std::string path = path_from_root(root, element);
        return path.empty() ? text : text + "/" + path;
    }
    return text + ":" + std::to_string(element.level_i) + "," + std::to_string(element.level_j) + ":" +
           std::to_string(element.i) + "," + std::to_string(element.j);
}

Element parse_address(const Scene& scene, const Roots& roots, const std::string& text) {
    AddressReader reader(text);
    const std::uint32_t polygon = reader.number();
    reader.expect('.');
    const std::uint32_t which = reader.number();
    if (polygon >= static_cast<std::uint32_t>(scene.polygon_count())) reader.refuse("no such polygon in the scene");
    const auto [first, last] = roots.of(static_cast<PolygonId>(polygon));
    if (which >= static_cast<std::uint32_t>(last - first)) reader.refuse("no such root of the polygon");
    Element element = root_element(first + static_cast<RootId>(which));
    const Root& root = roots[element.root];

    if (reader.take('/')) {
        while (!reader.at_end()) {
            const char digit = reader.next();
            if (digit < '0' || digit > '3') reader.refuse("no element address");
            element = children(root, element)[static_cast<std::size_t>(digit - '0')];
        }
    } else if (reader.take(':')) {
        const std::uint32_t level_i = reader.number();
        reader.expect(',');
        const std::uint32_t level_j = reader.number();
        reader.expect(':');
        element.i = reader.number();
        reader.expect(',');
        element.j = reader.number();
        const bool inside = level_i <= 31 && level_j <= 31 && element.i >> level_i == 0 && element.j >> level_j == 0;
        if (root.corner_count() != 4 || !inside) reader.refuse("no such element of the root");
        element.level_i = static_cast<std::uint8_t>(level_i);
        element.level_j = static_cast<std::uint8_t>(level_j);
    }
    if (!reader.at_end()) reader.refuse("no element address");
    return element;
}

}  // namespace cob
