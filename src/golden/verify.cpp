#include "cob/golden.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/manifest.hpp"
#include "cob/verify/compare.hpp"

#include <future>

namespace cob {

verify::Report verify_answers(const std::string& set, const std::string& answers, const verify::Options& options) {
    if (!is_folder(answers))
        throw InputError("no such folder", {answers, 0, "", "name the folder of the answer tables"});
    try {
        // Reading, hashing and comparing go side by side: none of them needs the others.
        auto segments = std::async(std::launch::async, [&] { return verify::compare_segments(set, answers, options); });
        auto checksums = std::async(std::launch::async, [&] { check_files(set, read_set_manifest(set)); });
        std::exception_ptr error;
        verify::Report report;
        try {
            report = verify::compare_boxes(set, answers, options);
        } catch (...) {
            error = std::current_exception();
        }
        checksums.get();  // First: a damaged set explains whatever else is wrong.
        if (error) std::rethrow_exception(error);
        verify::append(report, segments.get());
        verify::require_answers(report, answers);
        return report;
    } catch (const verify::Error& error) {
        throw InputError(error.what());
    }
}

}  // namespace cob
