#include "scene/remarks.hpp"

namespace cob {

std::vector<std::string> remarks_on(const Scene& scene, const ReadReport& report, const std::string& path) {
    std::vector<std::string> remarks;
    for (const std::string& warning : report.warnings) remarks.push_back("warning: " + warning);
    for (const InvalidPolygon& invalid : scene.invalid())
        remarks.push_back("skipped polygon " + std::to_string(invalid.polygon) + " (" + path + ":" +
                          std::to_string(invalid.line) + "): " + invalid.reason);
    return remarks;
}

}  // namespace cob
