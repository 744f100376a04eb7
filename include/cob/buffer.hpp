/// \file
/// The Close Object Buffer (the paper's sections 3 and 7; SPEC section 5): for each element, which polygons are close.
///
/// A CloseObjectBuffer takes 4 bytes an element and is built when it is first asked for, from the whole scene or from
/// the buffer of an element around it. Lists of close polygons stand in a pool of the builder.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/candidates.hpp"
#include "cob/classification.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace cob {

/// What an occluded buffer means for the elements inside its element (SPEC 5, choice 5).
enum class BufferMode : std::uint8_t {
    strict,   ///< A hint: they are tested from the scene.
    inherit,  ///< The paper's: they are occluded, too, without a test.
};
const char* to_text(BufferMode mode);

/// From which buffers an element's buffer is built (the paper's section 7).
enum class BufferLevels : std::uint8_t {
    element,  ///< None, one level: from the whole scene.
    polygon,  ///< Two levels: from the buffer over its whole root.
    tree,     ///< Every level: from the nearest element around it.
    /// One or two levels, by what the scene repays: from the buffer over the outermost of its root, its patch and what
    /// lies between the patch and it, of which the box has few polygons around; none such: from the whole scene.
    automatic,
};
/// "element", "polygon", "tree", "auto".
const char* to_text(BufferLevels levels);

/// The buffer of one element: a state and the place of its list. Before it is built, uninitialised.
class CloseObjectBuffer {
public:
    BufferState state() const { return static_cast<BufferState>(packed_ & 3); }
    bool is_built() const { return state() != BufferState::uninitialised; }

private:
    friend class BufferBuilder;

    std::uint32_t packed_ = 0;  ///< State in the low two bits, above them the list's place in the pool.
};
static_assert(sizeof(CloseObjectBuffer) == 4, "the paper's figure is 5 bytes an element");

struct BufferOptions {
    Rational margin = Rational(1, 8);  ///< Of the element's extents, on each side; >= 0 (SPEC 4).
    Rational height = Rational(1, 4);  ///< Of the shorter widened extent; > 0 (SPEC 4).
    BufferMode mode = BufferMode::strict;
    Arithmetic arithmetic = Arithmetic::exact;  ///< Or rational: the same without filters.
    bool all_lights = false;                    ///< Test every light for facing every box (BoxClassifier).
    /// A buffer with more polygons is not built from: where it is no hint, the scene's candidates name the few of them
    /// that matter faster, and the answers are the same (Omission::levels).
    std::size_t longest_list = 64;
};

/// What building cost; add them up per thread.
struct BufferStatistics {
    std::array<std::uint64_t, 4> built{};  ///< Buffers built, by the state they got.
    std::uint64_t inherited = 0;           ///< Of these, without a test: around them all was empty or occluded.
    std::uint64_t from_scene = 0;          ///< Of these, from the whole scene.
    std::uint64_t tested = 0;              ///< Candidates whose relation was evaluated.
    std::uint64_t light_tests = 0;         ///< Facing tests of lights.
    PredicateCounters predicates;
    BufferStatistics& operator+=(const BufferStatistics& other);
};

/// Builds buffers of elements on demand. Thread-safe: buffers of different elements may be built at the same time,
/// and their contents do not depend on the order.
class BufferBuilder {
public:
    /// Scene, roots and source must outlive it.
    BufferBuilder(const Scene& scene, const Roots& roots, const CandidateSource& source, BufferOptions options);
    ~BufferBuilder();

    /// From the whole scene.
    CloseObjectBuffer build(const Element& element, BufferStatistics* statistics = nullptr);
    /// From the buffer, already built, of an element that contains this one: its parent, its patch or its root. Equal
    /// to build(element) but, in BufferMode::inherit, where the parent's buffer is occluded.
    CloseObjectBuffer build(const Element& element, CloseObjectBuffer parent, BufferStatistics* statistics = nullptr);
    /// Keeps what was found elsewhere to be the element's classification; a list equal to that of the parent, an
    /// element around it, is not stored again.
    CloseObjectBuffer keep(const Classification& classification, CloseObjectBuffer parent = {});

    /// The polygons that the buffer stores, ascending; none unless it is close. Valid as long as the builder.
    View<PolygonId> polygons(CloseObjectBuffer buffer) const;

    const BufferOptions& options() const { return options_; }
    /// Bytes of all stored lists; a buffer that stores none costs sizeof(CloseObjectBuffer) alone.
    std::size_t list_bytes() const;

private:
    class Pool;

    const Scene& scene_;
    const Roots& roots_;
    const CandidateSource& source_;
    BufferOptions options_;
    std::unique_ptr<Pool> pool_;
};

}  // namespace cob
