// A text is a scene or has an error; never both.
#include "reading_limits.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
    const rb::LoadOptions options = rb::fuzz_options(data, size);
    rb::SourceMap sources;
    rb::Diagnostics diagnostics;
    rb::Scene scene;
    const bool done = rb::load_scene(options, sources, diagnostics, scene);
    if (done != (diagnostics.error_count() == 0)) std::abort();
    for (const rb::Diagnostic& d : diagnostics.all()) rb::format(d, sources);
    if (done) rb::dump(scene);
    return 0;
}
