/// \file
/// All elements of a scene in one order, and their classification through one, two or every level of buffers
/// (SPEC sections 3 and 5).
#pragma once

#include "cob/buffer.hpp"
#include "cob/candidates.hpp"
#include "cob/classification.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cob {

/// How a scene is cut into elements.
struct Meshing {
    double edge = 0;  ///< Longest side of a patch; 0 or less: every root is one patch (SPEC 3).
    int level = 0;    ///< Refinements below the patches, 0 to 20.
};

/// The elements of a scene, numbered: ascending by root, then as patches() gives them, then depth first as children()
/// gives them. Stores the patches only.
class ElementList {
public:
    /// Scene and roots must outlive it. Throws InputError for more than 2^40 elements.
    ElementList(const Scene& scene, const Roots& roots, const Meshing& meshing);

    std::uint64_t size() const { return static_cast<std::uint64_t>(patches_.size()) << (2 * meshing_.level); }
    Element operator[](std::uint64_t number) const;
    /// The elements around element `number`, from the outside in, without itself: its root, the cells of 2, 4, 8, ...
    /// patches a side around its patch (fewer where the root is cut less that way), its patch, and what was refined
    /// between that and it.
    void around(std::uint64_t number, std::vector<Element>& ancestors) const;
    /// Of these the root, the patch and what was refined: those of which all elements are consecutive.
    void consecutive_around(std::uint64_t number, std::vector<Element>& ancestors) const;
    /// How many elements make up this one, which is one of consecutive_around() their number.
    std::uint64_t elements_in(std::uint64_t number, const Element& ancestor) const;

    const Scene& scene() const { return scene_; }
    const Roots& roots() const { return roots_; }
    const Root& root_of(const Element& element) const { return roots_[element.root]; }
    const Meshing& meshing() const { return meshing_; }
    const std::vector<Element>& patches() const { return patches_; }

private:
    const Scene& scene_;
    const Roots& roots_;
    Meshing meshing_;
    std::vector<Element> patches_;
};

/// An element's address, "POLYGON.ROOT" or "POLYGON.ROOT/PATH": the ROOT-th root of the polygon, from 0, and for each
/// refinement below it the number of the child, 0 to 3. Elements inside patches that are cut unequally have none:
/// then "POLYGON.ROOT:LEVEL_I,LEVEL_J:I,J".
std::string to_address(const Roots& roots, const Element& element);
/// Reads either form. Throws InputError where the text is no address or the scene has no such element.
Element parse_address(const Scene& scene, const Roots& roots, const std::string& text);

struct ClassifyOptions {
    BufferOptions buffer;
    /// In BufferMode::inherit, where the buffers around an element say more than what is near, automatic is polygon.
    BufferLevels levels = BufferLevels::automatic;
    bool relations = true;  ///< Find all neighbours; false: only what the state and its lists need.
    bool apart = false;     ///< No polygon is near the box of another (Omission::buffers): all is empty without a test.
    bool questions = true;  ///< Say what box was asked about; false: where `apart` needs none, none is made.
};

/// An element's classification.
struct ClassifiedElement {
    Element element;
    BoxQuestion question;  ///< Only with ClassifyOptions::questions.
    Classification found;  ///< As built from the whole scene; neighbours are complete only with `relations`.
    /// Where it has a buffer around it that is occluded and the mode is inherit: occluded, the state that it inherits.
    std::optional<BufferState> inherited;
};

/// What classifying cost.
struct ClassifyStatistics {
    std::array<std::uint64_t, 4> elements{};  ///< By state, as built from the whole scene.
    std::uint64_t inherited = 0;              ///< Elements made occluded by a buffer around them, without a test.
    std::uint64_t inherited_otherwise = 0;    ///< Of these, those that are not occluded when built from the scene.
    std::uint64_t around = 0;                 ///< Buffers built around the elements; at block borders some twice.
    std::uint64_t tested = 0;                 ///< Candidates tested for the elements and the buffers around them.
    std::uint64_t compared = 0;               ///< Candidates tested only to compare inherited states.
    std::uint64_t light_tests = 0;            ///< Facing tests of lights.
    PredicateCounters predicates;
    ClassifyStatistics& operator+=(const ClassifyStatistics& other);
};

/// Classifies elements one after another; consecutive ones share the buffers around them. One thread each.
class ElementClassifier {
public:
    /// All must outlive it.
    ElementClassifier(const ElementList& elements, const CandidateSource& source, const ClassifyOptions& options);
    /// Fills the result anew.
    void operator()(std::uint64_t number, ClassifiedElement& result);
    ClassifyStatistics statistics() const;

private:
    /// A buffer around the element, and what it hands down.
    struct Around {
        Element element;
        Classification found;
        std::vector<PolygonId> candidates;
    };

    void renew_around(std::uint64_t number);
    void renew_automatic(std::uint64_t number);
    void take_candidates(Around& around) const;
    bool hands_down(const Around* around) const;
    void classify(const Box& box, const Around* around, Classification& found, bool compared);

    const ElementList& elements_;
    const CandidateSource& source_;
    const ClassifyOptions& options_;
    BoxClassifier classifier_;
    ClassifyStatistics statistics_;
    std::vector<Element> wanted_;  ///< The elements around the present one.
    std::vector<Around> around_;   ///< Their buffers; the first depth_ are valid.
    std::size_t depth_ = 0;
    std::vector<Element> crowded_;  ///< Automatic: the elements outside of the one that has a buffer.
    bool inherits_ = false;         ///< One of them is occluded, and the mode is inherit.
};

}  // namespace cob
