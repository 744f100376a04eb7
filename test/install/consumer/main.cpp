// A consumer of the installed package: one exact question through the public headers.
#include <cob/arithmetic.hpp>

#include <cstdio>

int main() {
    const auto third = cob::parse_exact("1/3");
    if (!third || *third * 3 != 1) return 1;
    std::puts(cob::to_text(*third).c_str());
    return 0;
}
