/// \file
/// Leaving out: what a scene does not need is not done, and no answer depends on that. Each omission rests on an exact
/// fact about the scene or, during a run, about one box or one pair of patches, and each can be turned off singly.
#pragma once

#include "cob/arithmetic.hpp"
#include "cob/buffer.hpp"
#include "cob/geometry.hpp"
#include "cob/scene.hpp"

#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

namespace cob {

enum class Omission : std::uint8_t {
    convex,   ///< No segments: no polygon's plane divides the scene, so nothing stands between any two points.
    shaft,    ///< No segments between a shooter and a patch with nothing in the shaft between them.
    filter,   ///< No exact arithmetic where binary64 is certain.
    lights,   ///< No facing test of a light outside the box.
    buffers,  ///< No buffers: no polygon is near the box of another.
    grey,     ///< One channel instead of three: all materials in use are grey.
    black,    ///< Patches that neither reflect nor emit are never looked at as shooters.
    tree,     ///< No tree over few polygons.
    levels,   ///< No buffer built from one around it where many polygons are around that one.
};
inline constexpr std::array<Omission, 9> all_omissions{Omission::convex, Omission::shaft,   Omission::filter,
                                                       Omission::lights, Omission::buffers, Omission::grey,
                                                       Omission::black,  Omission::tree,    Omission::levels};

const char* to_text(Omission omission);

class OmissionSet {
public:
    OmissionSet() = default;
    static OmissionSet all();
    /// Of names separated by commas. Throws InputError where one is unknown.
    static OmissionSet parse(const std::string& names);

    bool has(Omission omission) const { return bits_[static_cast<std::size_t>(omission)]; }
    OmissionSet& add(Omission omission) {
        bits_.set(static_cast<std::size_t>(omission));
        return *this;
    }
    std::string to_text() const;  ///< As parse() reads it.

private:
    std::bitset<all_omissions.size()> bits_;
};

struct OmissionOptions {
    OmissionSet keep;                                           ///< What is done although the scene does not need it.
    Rational margin = Rational(1, 8), height = Rational(1, 4);  ///< Of the boxes (SPEC 4).
};

/// What a run leaves out of one scene, and why.
class Omissions {
public:
    struct Decision {
        Omission omission = Omission::convex;
        bool possible = false;  ///< The fact that it rests on holds, or is looked for case by case.
        bool kept = false;      ///< Done all the same, because the caller wants it so.
        std::string reason;     ///< One line.
        bool left_out() const { return possible && !kept; }
    };

    /// Decides everything that can be known before a run.
    Omissions(const Scene& scene, const Roots& roots, const OmissionOptions& options);

    bool operator()(Omission omission) const { return of(omission).left_out(); }
    const Decision& of(Omission omission) const { return decisions_[static_cast<std::size_t>(omission)]; }
    const std::array<Decision, all_omissions.size()>& decisions() const { return decisions_; }
    /// What of it concerns the building of one buffer: filter, lights, levels.
    void apply_to(BufferOptions& options) const;

private:
    std::array<Decision, all_omissions.size()> decisions_;
};

/// Neither reflects nor emits.
inline bool is_black(const Material& material) {
    return !material.emits() && material.reflectance == std::array<double, 3>{};
}

/// Scenes of at most that many polygons get no tree.
inline constexpr PolygonId few_polygons = 32;

}  // namespace cob
