#include "fuzz/target.hpp"

#include "cob/error.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <random>

namespace cob::fuzz {
namespace {

std::string outcome(const Target& target, std::string_view text) {
    try {
        return target.read(text);
    } catch (const InputError& error) {
        require(error.what()[0] != '\0', "a refusal says what");
        return "refused";
    }
}

const Target& this_target() {
    static const Target made = target();
    return made;
}

}  // namespace
}  // namespace cob::fuzz

using namespace cob::fuzz;

#ifdef COB_LIBFUZZER

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    outcome(this_target(), {reinterpret_cast<const char*>(data), size});
    return 0;
}

/// libFuzzer's own changes, and now and then a seed: an empty corpus finds no header by itself.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
    const std::vector<std::string>& seeds = this_target().seeds;
    const std::string& text = seeds[seed / 64 % seeds.size()];
    if ((size > 1 && seed % 64 != 0) || text.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

#else

namespace {

std::string mutated(const Target& target, std::mt19937_64& engine) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(engine() % n); };
    std::string text = target.seeds[below(target.seeds.size())];
    for (std::size_t change = below(6); change > 0 && !text.empty(); --change) {
        const std::size_t at = below(text.size());
        switch (below(5)) {
            case 0:
                text[at] = static_cast<char>(engine());
                break;
            case 1:
                text.erase(at, 1 + below(8));
                break;
            case 2:
                text.insert(at, target.words[below(target.words.size())]);
                break;
            case 3:
                text.insert(at, text.substr(below(text.size()), below(40)));
                break;
            default:
                text += target.seeds[below(target.seeds.size())];
                break;
        }
    }
    if (below(8) == 0) text.resize(below(text.size() + 1));
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    const Target& target = this_target();
    const long rounds = argc > 1 ? std::atol(argv[1]) : target.rounds;
    std::map<std::string, long> counts;
    for (long round = 0; round < rounds; ++round) {
        std::mt19937_64 engine(static_cast<std::uint64_t>(round));
        ++counts[outcome(target, mutated(target, engine))];
    }
    for (const auto& [name, count] : counts) std::printf("%ld %s\n", count, name.c_str());
    return std::all_of(target.outcomes.begin(), target.outcomes.end(),
                       [&](const std::string& name) { return counts[name] > rounds / 20; })
               ? 0
               : 1;
}

#endif
