// The fields of a study file.

#include "measure/study.h"

namespace tyndall::measure {

void describe(StructBuilder<Reference>& d) {
    d.doc("What a scene's pictures are held against: a film that is traced and kept, or a file.");
    d.field("spp", &Reference::spp, "Samples a pixel.").range(2, 1 << 24);
    d.field("min_order", &Reference::min_order, "Light that was scattered fewer times is left out.").range(0, 1 << 20);
    d.field("max_order", &Reference::max_order, "Light that was scattered more often is left out; -1 = none is.")
        .range(-1, 1 << 20);
    d.field("surfaces", &Reference::surfaces, "Off: surfaces are black, for the media's light alone.");
    d.field("media", &Reference::media, "Off: media only absorb and emit.");
    d.field("set", &Reference::set, "Changes for the tracer alone, beside those of the scene.");
    d.field("subtract", &Reference::subtract,
            "Changes that leave of the trace what is not compared: that film is subtracted, and the variances add up.");
    d.field("file", &Reference::file,
            "A scene-linear picture in place of a trace: beside the study, or references:NAME.");
    d.field("noise", &Reference::noise,
            "Of a file without a variance: standard deviation of a pixel over its value; -1 = unknown.")
        .range(-1, 10);
}

void describe(StructBuilder<StudyWord>& d) {
    d.doc("What a technique's changes mean by {name} on a scene.");
    d.field("name", &StudyWord::name, "The word between the braces.");
    d.field("text", &StudyWord::text, "What stands for it, such as \"/entities/Fog/medium\".");
}

void describe(StructBuilder<StudyScene>& d) {
    d.doc("A scene and how its pictures are taken.");
    d.field("name", &StudyScene::name, "Names the plot.");
    d.field("doc", &StudyScene::doc, "What is compared, in a sentence for the report.");
    d.field("scene", &StudyScene::scene, "Scene file, relative to the study.");
    d.field("camera", &StudyScene::camera, "Entity with a camera; empty = the scene's choice.");
    d.field("size", &StudyScene::size, "Width and height of what is timed and compared.").unit("px").range(1, 16384);
    d.field("supersample", &StudyScene::supersample,
            "The picture is rendered this many times larger and filtered down before it is compared: a traced pixel is "
            "a mean over its area.")
        .range(1, 16);
    d.field("frames", &StudyScene::frames, "Frames to run before the picture is taken.").range(1, 10000);
    d.field("words", &StudyScene::words,
            "What techniques' changes mean here by a word in braces: scenes name their entities differently.");
    d.field("set", &StudyScene::set, "Changes to the scene file, as \"/json/pointer=value\", for renderer and tracer.");
    d.field("subtract", &StudyScene::subtract,
            "Changes that leave what is not compared: that picture is subtracted from the technique's.");
    d.field("reference", &StudyScene::reference, "What the pictures are held against.");
}

void describe(StructBuilder<Sweep>& d) {
    d.doc("One value after the other at one place of the scene file.");
    d.field("name", &Sweep::name, "For tables and plots; otherwise the last part of the pointer.");
    d.field("set", &Sweep::set, "JSON pointer into the scene file.");
    d.field("values", &Sweep::values, "Numbers ...");
    d.field("texts", &Sweep::texts, "... or values as JSON text, such as \"half\" or \"[1, 0, 0]\".");
}

void describe(StructBuilder<StudyPoint>& d) {
    d.doc("Parameters that were chosen by hand.");
    d.field("name", &StudyPoint::name, "For tables and plots.");
    d.field("size", &StudyPoint::size,
            "Width and height of what is timed; only where nothing is compared. 0 = the scene's.")
        .unit("px")
        .range(0, 16384);
    d.field("set", &StudyPoint::set, "Changes to the scene file.");
}

void describe(StructBuilder<Technique>& d) {
    d.doc("A way to render. Each of its points with each combination of its sweeps' values is a run.");
    d.field("name", &Technique::name, "Names its runs.");
    d.field("doc", &Technique::doc, "A sentence for the report.");
    d.field("set", &Technique::set, "Changes to the scene file.");
    d.field("scenes", &Technique::scenes, "Scenes of the study on which it runs; empty = all.");
    d.field(
        "refused_if", &Technique::refused_if,
        "What the log says where the scene is not rendered so, but in another way: the row tells the line and has no "
        "numbers.");
    d.field("points_are", &Technique::points_are, "What the points' names are values of, such as lights.");
    d.field("points", &Technique::points, "Sets of parameters; empty = one without changes.");
    d.field("sweep", &Technique::sweep, "What is varied; the last one fastest.");
}

void describe(StructBuilder<StudyBench>& d) {
    d.doc("How runs are timed.");
    d.field("frames", &StudyBench::frames, "Frames of which the median is taken.").range(1, 100000);
    d.field("warmup", &StudyBench::warmup, "Frames before those.").range(0, 100000);
}

void describe(StructBuilder<Study>& d) {
    d.doc("Techniques with their parameters on scenes, timed and held against traced references.");
    d.field("tyndall_study", &Study::tyndall_study, "Version of the format.").range(1, 1);
    d.field("title", &Study::title, "Head of the report.");
    d.field("doc", &Study::doc, "What is asked and how it is answered.");
    d.field("scenes", &Study::scenes, "Where it is measured.");
    d.field("techniques", &Study::techniques, "What is measured.");
    d.field("baseline", &Study::baseline,
            "A technique of one run that is timed only: what others cost is the time above its. Empty = whole frames.");
    d.field("clock", &Study::clock,
            "Time of the plots: from the frame's beginning to its end, or of all processors together, which other "
            "programs on the machine disturb less.",
            {"frame", "processor"});
    d.field("plots", &Study::plots,
            "Metrics of which less is better, a plot each; frame_NAME is that of a frame without supersampling.");
    d.field("against", &Study::against, "Parameters with numbers, over each of which the time is plotted.");
    d.field("compare", &Study::compare, "Off: runs are only timed, and nothing is traced.");
    d.field("bench", &Study::bench, "How runs are timed.");
}

}  // namespace tyndall::measure
