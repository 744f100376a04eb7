// Checkpoints: any bytes with a right checksum and the fingerprint of the scene and the options. What is accepted can
// be gone on from.
#include "cob/solver.hpp"
#include "fuzz/target.hpp"
#include "radiosity/scenes.hpp"

#include <array>
#include <cstdint>

namespace cob::fuzz {
namespace {

constexpr std::size_t fingerprint_size = 8;

const Scene& scene() {
    static const Scene made = scenes::plate_over_table();
    return made;
}

RadiosityOptions options() {
    RadiosityOptions options;
    options.patch_edge = 1;
    options.stop.shots = 4;
    options.threads = 1;
    return options;
}

/// A checkpoint's first line, which names the version, and what follows the second, its checksum.
std::array<std::string, 2> parts_after(int shots) {
    RadiositySolver solver(scene(), options());
    for (int shot = 0; shot < shots; ++shot) solver.step();
    const std::string text = solver.checkpoint();
    const std::size_t first = text.find('\n') + 1;
    return {text.substr(0, first), text.substr(text.find('\n', first) + 1)};
}

std::string checksum(const std::string& body) {
    std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (const char c : body) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return std::to_string(hash) + "\n";
}

std::string read(std::string_view text) {
    static const std::array<std::string, 2> genuine = parts_after(0);
    const std::string body = genuine[1].substr(0, fingerprint_size) + std::string(text);
    RadiositySolver solver(scene(), options());
    solver.resume(genuine[0] + checksum(body) + body);
    solver.step();
    solver.checkpoint();
    return "resumed runs";
}

}  // namespace

Target target() {
    Target target{{},
                  {"\1", std::string(4, '\0'), std::string(8, '\xff'), std::string("\3\0\0\0", 4)},
                  {"resumed runs", "refused"},
                  300,
                  read};
    for (const int shots : {0, 1, 3}) target.seeds.push_back(parts_after(shots)[1].substr(fingerprint_size));
    return target;
}

}  // namespace cob::fuzz
