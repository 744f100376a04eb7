// The pictures of a study.
#include "cob/files.hpp"
#include "report/picture.hpp"
#include "report/study_report.hpp"

namespace cob::report {

std::vector<StudyPicture> draw_study(const Scene& scene, const Camera& camera, const StudySettings& settings, int shots,
                                     int threads, const std::string& folder, const Progress& alive) {
    std::vector<StudyPicture> pictures;
    PictureOptions picture;
    picture.width = 640;
    picture.height = 480;
    picture.antialiasing = 2;
    picture.threads = threads;
    picture.progress = alive;
    for (const Refinement refinement : {Refinement::none, Refinement::both}) {
        RadiosityOptions options;
        options.refinement = refinement;
        options.patch_edge = settings.patch_edge;
        options.buffer.minimum_edge = options.gradient.minimum_edge = settings.minimum_edge;
        options.stop.shots = shots;
        options.threads = threads;
        RadiositySolver solver(scene, options);
        while (solver.step())
            if (alive) alive(static_cast<std::uint64_t>(solver.counters().shots), 0);
        const Pictures drawn = render_pictures(solver, camera, picture);
        picture.exposure = drawn.exposure;  // the same for both
        const std::string elements = std::to_string(solver.element_count()) + " elements";
        const auto add = [&](const char* name, const Image& image, const std::string& caption) {
            const std::string path = folder + "/" + name;
            write_file(path, encode_png(image));
            pictures.push_back({path, caption});
        };
        if (refinement == Refinement::none) {
            add("none.png", drawn.plain, "Without refinement: " + elements + ".");
        } else {
            add("both.png", drawn.plain, "With the buffer and gradients: " + elements + ".");
            add("mesh.png", drawn.mesh, "The same with its mesh.");
        }
    }
    return pictures;
}

}  // namespace cob::report
