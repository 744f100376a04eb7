#include "report/stress_scene.hpp"

#include "cob/error.hpp"

namespace cob::stress {

Scene scene_of(const Shapes& shapes, double reflectance) {
    Scene::Input input;
    input.name = "stress";
    input.materials.resize(2);
    for (Material& material : input.materials) material.reflectance = {reflectance, reflectance, reflectance};
    input.materials[1].emitted_exitance = {1, 1, 1};
    for (const Loop& loop : shapes.loops) {
        Scene::Face face;
        for (const Point& p : loop) {
            face.corners.push_back(static_cast<VertexId>(input.positions.size()));
            input.positions.push_back(p);
        }
        input.faces.push_back(face);
    }
    for (const PolygonId light : shapes.lights) input.faces[static_cast<std::size_t>(light)].material = 1;
    return Scene::build(std::move(input));
}

Shapes mapped(Shapes shapes, const std::function<Point(const Point&)>& map) {
    for (Loop& loop : shapes.loops)
        for (Point& p : loop) p = map(p);
    return shapes;
}

Shapes still_life() {
    Shapes shapes;
    std::vector<Loop>& loops = shapes.loops;
    loops.push_back({{0, 0, 0}, {32, 0, 0}, {32, 32, 0}, {0, 32, 0}});      // floor
    loops.push_back({{0, 32, 0}, {32, 32, 0}, {32, 32, 24}, {0, 32, 24}});  // wall on the floor's side
    loops.push_back({{8, 8, 0}, {8, 16, 0}, {8, 16, 8}, {8, 8, 8}});        // block: its four sides and its top
    loops.push_back({{16, 8, 0}, {16, 8, 8}, {16, 16, 8}, {16, 16, 0}});
    loops.push_back({{8, 8, 0}, {8, 8, 8}, {16, 8, 8}, {16, 8, 0}});
    loops.push_back({{8, 16, 0}, {16, 16, 0}, {16, 16, 8}, {8, 16, 8}});
    loops.push_back({{8, 8, 8}, {16, 8, 8}, {16, 16, 8}, {8, 16, 8}});
    loops.push_back({{18, 4, 0}, {28, 4, 0}, {28, 12, 0}, {18, 12, 0}});    // sheet on the floor
    loops.push_back({{17, 17, 1}, {31, 17, 1}, {31, 31, 1}, {17, 31, 1}});  // sheet above the floor
    loops.push_back({{0, 16, 2}, {8, 16, 2}, {8, 32, 4}, {0, 32, 4}});      // tilted, from the block to the wall
    loops.push_back({{20, 8, 0}, {27, 9, 7}, {24, 16, 3}});                 // triangle with a corner on the sheet
    loops.push_back({{2, 2, 5}, {7, 2, 5}, {7, 4, 5}, {4, 4, 5}, {4, 7, 5}, {2, 7, 5}});  // L, at the top of boxes
    loops.push_back({{12, 12, 24}, {12, 20, 24}, {20, 20, 24}, {20, 12, 24}});            // light, facing down
    shapes.lights = {12};
    return shapes;
}

Questions ask(const Scene& scene, int level, const Rational& margin, const Rational& height, std::size_t boxes,
              std::size_t segments) {
    const Roots roots(scene);
    Questions questions;
    std::vector<ExactPoint> points;

    // Boxes over elements, evenly picked.
    std::vector<Element> elements;
    for (const Root& root : roots.all())
        for (const Element& element : descendants(root, root_element(root.id), level)) elements.push_back(element);
    const std::size_t stride = std::max<std::size_t>(1, elements.size() / std::max<std::size_t>(1, boxes));
    for (std::size_t e = 0; e < elements.size(); e += stride) {
        const Root& root = roots[elements[e].root];
        questions.boxes.push_back(box_question(scene, root, elements[e], margin, height));
        points.push_back(point_in(scene, root, elements[e], 0.25, 0.5));
        points.push_back(corners(scene, root, elements[e]).points[0]);
    }

    // Segments between their points: every pair in turn, with strides that visit all differences first.
    for (std::size_t apart = 1; apart < points.size() && questions.segments.size() < segments; ++apart)
        for (std::size_t p = apart % 5; p + apart < points.size() && questions.segments.size() < segments; p += 5)
            if (points[p] != points[p + apart]) questions.segments.push_back({points[p], points[p + apart], -1, -1});
    return questions;
}

Answers answer(const Scene& scene, const Questions& questions, Arithmetic arithmetic, Source source) {
    Answers answers;
    const std::unique_ptr<CandidateSource> candidates = make_candidates(scene, source);
    for (const BoxQuestion& question : questions.boxes) {
        const Box box(question);
        for (PolygonId polygon = 0; polygon < scene.polygon_count(); ++polygon)
            if (polygon != question.polygon)
                answers.relations.push_back(relate(scene, polygon, box, arithmetic, &answers.predicates));
    }
    const VisibilityOracle oracle(scene, *candidates);
    for (const Segment& segment : questions.segments)
        answers.visibility.push_back(arithmetic == Arithmetic::exact
                                         ? oracle(segment, &answers.predicates)
                                         : oracle(segment, arithmetic, &answers.predicates).visibility);
    return answers;
}

}  // namespace cob::stress
